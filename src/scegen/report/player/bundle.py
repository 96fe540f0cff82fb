"""The player in one piece, for pages that open without a server.

The modules are joined in the order of their imports. That is all there is to building them: they
share one scope then, so names at their top are unique over all of them.
"""

import re
from functools import cache

from scegen.report.one_file import asset

ENTRY = "player.js"
_IMPORT = re.compile(r'^import \{[^}]*\} from "\./(?P<name>[\w-]+\.js)";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=function|class|const)", re.MULTILINE)


@cache
def player_js() -> str:
    """All modules as the text of one, which defines ``mount``."""
    parts: dict[str, str] = {}

    def add(name: str) -> None:
        text = asset(__package__, name)
        for found in _IMPORT.finditer(text):
            if found["name"] not in parts:
                add(found["name"])
        parts[name] = _EXPORT.sub("", _IMPORT.sub("", text))

    add(ENTRY)
    return "\n".join(parts.values())


@cache
def player_css() -> str:
    """The player's style sheet; it needs the theme's custom properties."""
    return asset(__package__, "player.css")
