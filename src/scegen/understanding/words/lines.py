"""Lines, lists and dashes: the marks that the layout of a text stands for."""

from __future__ import annotations

import re

from scegen.understanding.lexicon import load
from scegen.understanding.words.lemmas import lemmas

_ITEM = re.compile(
    r"(?:^|(?<=\n))[ \t]*(?P<item>[-*•–][ \t]+|\(?(?:\d{1,2}|[a-z])(?:\.|\))[ \t]+(?=[^\W\d]))"
)
"""``- ego``, ``2. the car``, ``b) it``: what opens an item of a list."""
_BREAK = re.compile(r"[^\S\n]*\n\s*")
_ENTRY = re.compile(r"[^\n.,;:!?]{1,40}(?:[:|]|\.{3})")
_KEYS = re.compile(r"(?<=:)[^\n;:!?]*(,)\s*([^\n.,;:!?]{1,40})(?=:)")
_WORD = re.compile(r"[^\W\d_]+")
_LEADERS = re.compile(r"(?<=\s)\.{3,}(?=\s)|(?<=\S)\s*\.{4,}")
_ENDED = frozenset(".,;:!?")
_BETWEEN = re.compile(
    r"(?<=\s)[-–—]{1,2}(?=\s+[^\d\s])|—(?!\d)|(?<=\s)/(?=\s)(?!\s*(?:h|s|sec|hour)\b)"
)
_MARK = re.compile(r"[.,;:!?](?=\s)|[|&]|\s/\s|\d\s?(?:k?m|mph|kph|m?s|ft|%)")
_MAX_TITLE = 60
"""So many characters a title may have."""
_MAX_NAME = 3
"""So many words a heading may have that names somebody."""


def laid_out(text: str) -> dict[int, str]:
    """What stands at an offset of the text, by its layout: a mark, or nothing for bullets.

    A line that ends openly ends a sentence where a list, an entry ("Ego: 50 km/h") or a paragraph
    follows; a dash or slash between words is a comma, and the colon after a title.

    Args:
        text: any string.
    """
    found = {k: "" for m in _ITEM.finditer(text) for k in range(m.start("item"), m.end("item"))}
    for mark in _BETWEEN.finditer(text):
        if mark.start() not in found:
            found[mark.start()] = ":" if _titled(text, mark.start(), mark.end()) else ","
    found |= dict.fromkeys(_bars(text), ".")
    for dots in _LEADERS.finditer(text):  # "VUT ....... 70 km/h"
        found |= dict.fromkeys(range(dots.start(), dots.end()), "") | {dots.end() - 1: ":"}
    if ":" in text:
        for key in _KEYS.finditer(text):
            found |= {key.start(1): "."} if _somebody(key.group(2)) else {key.end(): ""}
    for line in _BREAK.finditer(text):
        before = text[: line.start()].rstrip()
        at = line.start() + line.group().index("\n")
        found |= {k: "" for k in range(line.start(), line.end()) if text[k] == "\n"}
        if _of_whom(text, line):
            found[at] = ","
        elif before and before[-1] not in _ENDED and _apart(text, line):
            found[at] = ":" if _titled(text, at, at + 1) else "."
    return found


def _bars(text: str) -> list[int]:
    """``Ego: 50 km/h | lead: 30 km/h``: where entries end; the other bars say nothing."""
    lines = re.finditer(r"[^\n]*:[^\n]*", text)
    return [m.start() for line in lines for m in re.finditer(r"\|", line.group())]


def _of_whom(text: str, line: re.Match[str]) -> bool:
    """Whether a list goes on that has somebody for its heading: ``Ego:`` above its items."""
    listed = list(_ITEM.finditer(text, 0, line.end() + 3))
    if not listed or listed[-1].start("item") != line.end():
        return False
    lines = text[: line.end()].splitlines()
    heading = next((t for t in reversed(lines) if t.strip() and not _ITEM.match(t)), "")
    return len(heading.split()) <= _MAX_NAME and _somebody(heading.strip(" \t:"))


def _somebody(name: str) -> bool:
    """Whether a few words end with somebody's name or place: ``lead car``, ``oncoming``."""
    word = _WORD.findall(name.lower())[-1:]
    node = load().root.following.get(lemmas(word[0])[0][0]) if word else None
    return node is not None and bool(node.cats & {"actor", "dir", "det"})


def _apart(text: str, line: re.Match[str]) -> bool:
    """Whether what follows a line is no continuation of it."""
    after = line.end()
    own = text.rfind("\n", 0, line.start()) + 1
    listed = _ITEM.match(text, after) is not None
    listed = listed or _ITEM.match(text, text.rfind("\n", 0, after) + 1) is not None
    entry = _ENTRY.match(text, after) is not None or _ENTRY.match(text, own) is not None
    short = line.start() - own <= _MAX_TITLE and text[after : after + 1].isupper()
    return listed or entry or short or line.group().count("\n") > 1


def _titled(text: str, start: int, end: int) -> bool:
    """``Cut-in - ego 120 km/h, …``: whether a few words before a lonely mark are a title.

    So is somebody's name that opens an item: ``- VUT – left turn``.
    """
    for item in (m for m in _ITEM.finditer(text) if m.end() <= start):
        name = text[item.end("item") : start]
        if "\n" not in name and len(name.split()) <= _MAX_NAME and _somebody(name):
            return True
    bare = start <= _MAX_TITLE and _MARK.search(text, 0, start) is None
    marks = sum(1 for _ in _BETWEEN.finditer(text)) if text[start:end] != "\n" else 1
    return bare and marks == 1
