"""One command, one file; and loading them all is nothing."""

import subprocess
import sys

from typer.main import get_command

from scegen.cli.app import app


def commands(group, module="scegen.cli"):
    for name, command in group.commands.items():
        place = f"{module}.{name}"
        if hasattr(command, "commands"):
            yield from commands(command, place)
        else:
            yield place, command.callback.__module__


def test_every_command_has_a_file_of_its_name():
    places = dict(commands(get_command(app)))
    assert len(places) > 10
    assert places == {place: place for place in places}


def test_help_loads_nothing_that_takes_long():
    code = (
        "import sys; sys.argv = ['scegen', '--help']\n"
        "from scegen.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "print(*{name.partition('.')[0] for name in sys.modules})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    told, _, loaded = done.stdout.rstrip("\n").rpartition("\n")
    assert "generate" in told
    heavy = {"clingo", "clorm", "jinja2", "lxml", "PIL", "numba", "numpy", "pydantic"}
    heavy |= {"pydantic_ai", "resvg_py", "scenariogeneration", "shapely", "text_to_num", "yaml"}
    assert not heavy & set(loaded.split())
