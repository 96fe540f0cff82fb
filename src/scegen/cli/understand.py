"""scegen understand: text to functional scenario."""

from typing import Annotated

import typer

from scegen.cli.console import working, write_bytes
from scegen.cli.llm import Asked, Listener, asks_models
from scegen.cli.options import JsonFlag, OutputFile
from scegen.cli.parse_report import show_refusal, show_report, tell_unsupported
from scegen.errors import InputError


@asks_models
def understand(
    source: Annotated[
        str, typer.Argument(metavar="TEXT|FILE|-", help="A description; - reads standard input.")
    ],
    json: JsonFlag = False,
    output: OutputFile = None,
    report: Annotated[
        bool, typer.Option("--report", help="Show the text with what became of its words.")
    ] = False,
    *,
    models: Asked,
) -> None:
    """Understand a description: text to functional scenario, with the words it rests on."""
    from scegen.pipeline.source import functional_of
    from scegen.scenario.files import to_json, to_yaml

    with working() as progress:
        listener = Listener(models.settings(), progress)
        try:
            functional = functional_of(source, listener)
        except InputError as error:
            if report:
                show_refusal(listener.text, error, as_json=json)
            raise
    listener.tell()
    if report:
        understood = listener.understanding
        show_report(functional, understood.disagreements if understood else (), as_json=json)
        return
    tell_unsupported(functional)
    text = to_json(functional) if json else to_yaml(functional)
    write_bytes(text.encode(), output)
