"""The command line that makes the same files again, byte for byte."""

from __future__ import annotations

import shlex
from dataclasses import fields

from scegen.pipeline.options import Options

_NAMES = {"depth": "check"}
_DEFAULTS = Options()


def command_line(options: Options, source: str, output: str) -> str:
    """``scegen generate`` with these options, ready for a shell.

    Args:
        options: of the run.
        source: the file that it began from.
        output: the folder that it makes.
    """
    words = ["scegen", "generate", source, "-o", output]
    for field in fields(options):
        value = getattr(options, field.name)
        if field.name == "force" or value == getattr(_DEFAULTS, field.name):
            continue
        words += [f"--{_NAMES.get(field.name, field.name)}", str(value)]
    return shlex.join(words)
