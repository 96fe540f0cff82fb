"""Running the command line: within the tests, for speed, or as a process of its own."""

import gc
import os
import subprocess
import sys
import traceback
from contextlib import chdir
from io import BytesIO, TextIOWrapper
from pathlib import Path
from unittest.mock import patch

import scegen
from scegen.cli import main

SOURCE = str(Path(scegen.__file__).parents[1])
PROGRAM = "from scegen.cli import main; main()"


def as_process(arguments, folder, environment, program=PROGRAM, stdin=b""):
    """What a program prints, and its exit code, where it starts from nothing."""
    done = subprocess.run(
        [sys.executable, "-c", program, *map(str, arguments)],
        capture_output=True,
        input=stdin,
        cwd=folder,
        env={**environment, "PYTHONPATH": SOURCE},
        check=False,
    )
    told = (stream.decode().replace("\r\n", "\n") for stream in (done.stdout, done.stderr))
    return subprocess.CompletedProcess(done.args, done.returncode, *told)


def in_process(arguments, folder, environment, capfd, stdin=b""):
    """The same, without loading everything again."""
    arguments = [str(argument) for argument in arguments]
    thresholds = gc.get_threshold()
    capfd.readouterr()
    with (
        chdir(folder),
        patch.dict(os.environ, environment, clear=True),
        patch.object(sys, "argv", ["scegen", *arguments]),
        patch.object(sys, "stdin", TextIOWrapper(BytesIO(stdin))),
    ):
        try:
            main()
            code = 0
        except SystemExit as end:
            code = end.code or 0
        except BaseException:  # noqa: BLE001 - as Python ends where nobody catches
            traceback.print_exc()
            code = 1
    gc.set_threshold(*thresholds)
    out, err = capfd.readouterr()
    return subprocess.CompletedProcess(arguments, code, out, err)
