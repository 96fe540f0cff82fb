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
_BULLETS = frozenset("-*•–")
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
    """
    found = {k: "" for m in _ITEM.finditer(text) for k in range(m.start("item"), m.end("item"))}
    between = list(_BETWEEN.finditer(text))
    for mark in between:
        if mark.start() not in found:
            titled = _titled(text, mark.start(), lonely=len(between) == 1)
            found[mark.start()] = ":" if titled else ","
    found |= dict.fromkeys(_bars(text), ".")
    for dots in _LEADERS.finditer(text):  # "VUT ....... 70 km/h"
        found |= dict.fromkeys(range(dots.start(), dots.end()), "") | {dots.end() - 1: ":"}
    if ":" in text:
        for key in _KEYS.finditer(text):
            found |= {key.start(1): "."} if _somebody(key.group(2)) else {key.end(): ""}
    heading = ""
    for line in _BREAK.finditer(text):
        own = text.rfind("\n", 0, line.start()) + 1
        if own < line.start() and not _ITEM.match(text, own):
            heading = text[own : line.start()]
        at = line.start() + line.group().index("\n")
        found |= {k: "" for k in range(line.start(), line.end()) if text[k] == "\n"}
        item = _ITEM.match(text, text.rfind("\n", 0, line.end()) + 1)
        if item is not None and item["item"][0] in _BULLETS and _is_name(heading):
            found[at] = ","
        elif line.start() and text[line.start() - 1] not in _ENDED and _apart(text, line):
            found[at] = ":" if _titled(text, at, lonely=True) else "."
    return found


def _bars(text: str) -> list[int]:
    """``Ego: 50 km/h | lead: 30 km/h``: where entries end; the other bars say nothing."""
    lines = re.finditer(r"[^\n]*:[^\n]*", text)
    return [m.start() for line in lines for m in re.finditer(r"\|", line.group())]


def _is_name(words: str) -> bool:
    """``Ego:`` above the items of a list, ``VUT`` before a dash: somebody, and nothing more."""
    return len(words.split()) <= _MAX_NAME and _somebody(words.strip(" \t:"))


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


def _titled(text: str, start: int, *, lonely: bool) -> bool:
    """``Cut-in - ego 120 km/h, …``: whether a few words before a lonely mark are a title.

    So is somebody's name that opens an item: ``- VUT – left turn``.
    """
    item = _ITEM.match(text, text.rfind("\n", 0, start) + 1)
    if item is not None and item.end() <= start and _is_name(text[item.end() : start]):
        return True
    return lonely and start <= _MAX_TITLE and _MARK.search(text, 0, start) is None
