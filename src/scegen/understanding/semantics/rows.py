"""Rows of data: under which conditions a clause says what. Of a family, the first that fits holds.

Rows stand from the most specific to the most general; one without effects says that nothing
follows. With ``also`` the next rows are asked as well. The keys:

* ``if``: conditions, all of which must hold;
* ``hazard`` of ``by`` (those who act; ``maybe WHO``: it may be nobody) and ``to``;
* ``maneuver``, ``light`` (how it meets that) of ``of``; ``place``: where ``of`` comes from, seen
  by ``from`` (the ego), with ``unsaid`` only where nothing is said of the two;
* ``puts`` (of `PUTS`) those of ``of`` where each phrase of ``where``, its ``object`` or its
  ``subject`` says;
* ``lanes``, ``crossing``: why the road has lanes, a junction; ``implies``: what else is there;
* ``act`` of ``of``: what they do; ``always``: also where nothing sets it off;
* ``marks`` of ``of``; ``drop``: a danger that is none after all; ``unplace``; ``note``;
* ``as``: another event; ``targets``, ``actors``: who is in it; ``rewrite``; ``rules_out``: ways;
* ``then``: further families; ``words``, ``reason``: what it rests on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any, TypeAlias

from scegen.understanding.frames.loader import read
from scegen.understanding.semantics.conditions import Test, condition
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.effects import Effect, effects_of
from scegen.understanding.semantics.patterns import listed

_FILES = ("acts", "constructions", "dangers", "movements", "nouns", "omissions", "positions")
_KEYS = frozenset({"if", "hazard", "by", "to", "maneuver", "light", "of", "place", "from", "lanes",
                   "crossing", "drop", "unplace", "marks", "note", "then", "words", "reason",
                   "also", "puts", "where",
                   "as", "targets", "actors", "rewrite", "rules_out", "implies",
                   "unsaid", "act", "always"})  # fmt: skip

_PLAIN = ("negated", "passive", "nominal", "phrases")
"""What a row may ask of an event that is known before any other condition is tried."""
Effects: TypeAlias = Callable[[dict[str, Any]], Iterable[Effect]]
_PATH = re.compile(r"path (?!\^)")


@dataclass(frozen=True, slots=True)
class Row:
    """One row: all its conditions and all its effects; whether further rows are asked.

    Which verbs it is for, and what of `_PLAIN` it asks, is looked up and not tested.
    """

    events: frozenset[str] | None
    plain: dict[str, bool]
    tests: tuple[Test, ...]
    effects: tuple[Effect, ...]
    also: bool


def _then(family: str) -> Effect:
    def effect(clause: Clause, context: Context) -> None:
        say(family, clause, context)

    return effect


def _row(
    row: dict[str, Any], where: str, effects: Effects = effects_of, keys: frozenset[str] = _KEYS
) -> Row:
    unknown = sorted(row.keys() - keys)
    if unknown:
        raise KeyError(f"{where}: {unknown[0]!r} is no part of a row")
    try:
        said = list(row.get("if", ()))
        first = said[0].partition(" ") if said and " or " not in said[0] else ("", "", "")
        events = listed(first[2]) if first[0] == "event" else None
        said = said[1:] if events else said
        plain = {
            t.removeprefix("not "): t in _PLAIN for t in said if t.removeprefix("not ") in _PLAIN
        }
        if any(all(map(_PATH.match, text.split(" or "))) for text in said):
            plain["phrases"] = True
        tests = [condition(text) for text in said if text.removeprefix("not ") not in plain]
        by = row.get("by", "drivers")
        if "hazard" in row and not by.startswith("maybe "):
            tests.append(condition(f"some {by}"))
        does = (*effects(row), *map(_then, row.get("then", ())))
        return Row(events, plain, tuple(tests), does, bool(row.get("also")))
    except KeyError as error:
        raise KeyError(f"{where}: {error} in {row}") from error


@lru_cache(maxsize=1)
def families() -> dict[str, tuple[Row, ...]]:
    """All rows of the package by family, read once.

    Raises:
        KeyError: names the family, and what in it means nothing.
    """
    found: dict[str, tuple[Row, ...]] = {}
    for name in _FILES:
        found |= read_rows(name)
    return found


def read_rows(
    name: str, effects: Effects = effects_of, keys: frozenset[str] = _KEYS
) -> dict[str, tuple[Row, ...]]:
    """The rows of a file by family, as ``dangers.brake``.

    Args:
        name: of the file.
        effects: what a row does.
        keys: what a row may have.
    """
    found: dict[str, tuple[Row, ...]] = {}
    for events, rows in read(name).items():
        made = tuple(_row(row, f"{name}.yaml, {events}", effects, keys) for row in rows)
        found.update((f"{name}.{event.strip()}", made) for event in events.split(","))
    return found


@cache
def _asked(family: str, event: str, *held: bool) -> tuple[Row, ...]:
    """The rows of a family that may fit an event; none is asked after one that renames it.

    Args:
        family: file and event.
        event: its name.
        held: what holds of it of `_PLAIN`.
    """
    known = dict(zip(_PLAIN, held, strict=True))
    rows = [r for r in families().get(family, ()) if r.events is None or event in r.events]
    return tuple(r for r in rows if all(known[name] == asked for name, asked in r.plain.items()))


def say(family: str, clause: Clause, context: Context) -> bool:
    """Adds what the rows of a family make of a clause.

    Args:
        family: file and event, as ``dangers.brake``.
        clause: what happens.
        context: the scenario in the making.

    Returns:
        Whether a row fits.
    """
    fitted = False
    event = clause.event
    plain = event.negated, event.passive, event.nominal, bool(event.pps)
    for row in _asked(family, event.name, *plain):
        for test in row.tests:
            if not test(clause, context):
                break
        else:
            fitted = True
            for effect in row.effects:
                effect(clause, context)
            if not row.also:
                break
    return fitted
