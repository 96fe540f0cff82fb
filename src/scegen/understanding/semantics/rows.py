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

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from scegen.understanding.frames.loader import read
from scegen.understanding.semantics.conditions import Test, condition
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.effects import Effect, effects_of
from scegen.understanding.semantics.needs import Known, marks_of

_FILES = ("acts", "constructions", "dangers", "movements", "nouns", "omissions", "positions")
_KEYS = frozenset({"if", "hazard", "by", "to", "maneuver", "light", "of", "place", "from", "lanes",
                   "crossing", "drop", "unplace", "marks", "note", "then", "words", "reason",
                   "also", "puts", "where",
                   "as", "targets", "actors", "rewrite", "rules_out", "implies",
                   "unsaid", "act", "always"})  # fmt: skip

Effects: TypeAlias = Callable[[dict[str, Any]], Iterable[Effect]]


Live: TypeAlias = tuple[tuple[Test, ...], tuple[Effect, ...], bool]
"""What of a row is left to test, its effects, and whether further rows are asked."""


@dataclass(frozen=True, slots=True)
class Row:
    """One row: all its conditions and all its effects; whether further rows are asked."""

    conditions: tuple[tuple[Known, Test], ...]
    effects: tuple[Effect, ...]
    also: bool


class Families:
    """Rows by family, as ``dangers.brake``, looked up by what stands in a clause.

    Args:
        rows: of each family, in their order.
    """

    def __init__(self, rows: dict[str, tuple[Row, ...]]) -> None:
        self.rows = rows
        self._named = {
            family: frozenset[str]().union(*(c.marks for row in own for c, _ in row.conditions))
            for family, own in rows.items()
        }
        marks = sorted(frozenset[str]().union(*self._named.values()))
        self._bits = {mark: 1 << k for k, mark in enumerate(marks)}
        self._masks = {f: sum(self._bits[m] for m in named) for f, named in self._named.items()}
        self._live = lru_cache(maxsize=16384)(self._asked)

    def asked(self, family: str, clause: Clause, context: Context) -> tuple[Live, ...]:
        """The rows that may fit a clause, none after one that surely does."""
        if family not in self._masks:
            return ()
        if clause.marks is None:
            marks = marks_of(clause.event, context.tokens)
            clause.marks = sum(self._bits[mark] for mark in marks if mark in self._bits)
        return self._live(family, clause.event.name, clause.marks & self._masks[family])

    def _asked(self, family: str, event: str, marks: int) -> tuple[Live, ...]:
        held = {f"event {event}", *(m for m in self._named[family] if marks & self._bits[m])}
        found: list[Live] = []
        for row in self.rows[family]:
            told = [(known.holds(held), test) for known, test in row.conditions]
            if any(holds is False for holds, _ in told):
                continue
            tests = tuple(test for holds, test in told if holds is None)
            found.append((tests, row.effects, row.also))
            if not tests and not row.also:
                break
        while found and not found[-1][1]:
            found.pop()  # it only says that nothing follows
        return tuple(found)


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
        by = row.get("by", "drivers")
        if "hazard" in row and not by.startswith("maybe "):
            said.append(f"some {by}")
        where_put = row.get("where", "subject")
        if "also" in row and not where_put.startswith("subject"):
            said.append(where_put if where_put.startswith("object ") else f"path {where_put}")
        conditions = tuple((Known.of(text), condition(text)) for text in said)
        does = (*effects(row), *map(_then, row.get("then", ())))
        return Row(conditions, does, bool(row.get("also")))
    except KeyError as error:
        raise KeyError(f"{where}: {error} in {row}") from error


@lru_cache(maxsize=1)
def families() -> Families:
    """All rows of the package by family, read once.

    Raises:
        KeyError: names the family, and what in it means nothing.
    """
    return read_rows(*_FILES)


def read_rows(*names: str, effects: Effects = effects_of, keys: frozenset[str] = _KEYS) -> Families:
    """The rows of some files by family, as ``dangers.brake``.

    Args:
        names: of the files.
        effects: what a row does.
        keys: what a row may have.
    """
    found: dict[str, tuple[Row, ...]] = {}
    for name in names:
        for events, rows in read(name).items():
            made = tuple(_row(row, f"{name}.yaml, {events}", effects, keys) for row in rows)
            found.update((f"{name}.{event.strip()}", made) for event in events.split(","))
    return Families(found)


def say(family: str, clause: Clause, context: Context) -> bool:
    """Adds what the rows of a family make of a clause.

    Args:
        family: file and event, as ``dangers.brake``.
        clause: what happens.
        context: the scenario in the making.

    Returns:
        Whether a row fits that says something.
    """
    fitted = False
    for tests, effects, also in families().asked(family, clause, context):
        for test in tests:
            if not test(clause, context):
                break
        else:
            fitted = True
            for effect in effects:
                effect(clause, context)
            if not also:
                break
    return fitted
