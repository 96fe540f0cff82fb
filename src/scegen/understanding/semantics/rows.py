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
* ``act`` of ``of``: what they do, letting ``into`` go first; ``always``: also where nothing sets it
  off;
* ``adds``: who does it is somebody unnamed, who comes from there, seen by the ego;
* ``marks`` of ``of``; ``drop``: a danger that is none after all; ``unplace``; ``note``;
* ``as``: another event; ``targets``, ``actors``: who is in it; ``rewrite``; ``rules_out``: ways;
* ``then``: further families; ``words``, ``reason``: what it rests on.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from scegen.understanding.frames.loader import read
from scegen.understanding.semantics.conditions import condition, needed
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.cues import cues
from scegen.understanding.semantics.effects import EFFECTS, Effect, effects_of
from scegen.understanding.semantics.facts import Test

_FILES = ("acts", "constructions", "dangers", "movements", "nouns", "omissions", "positions",
          "standing")  # fmt: skip
_KEYS = frozenset(EFFECTS) | {"if", "by", "to", "of", "from", "then", "words", "reason", "also",
                              "where", "targets", "actors", "unsaid", "always", "into"}  # fmt: skip

Effects: TypeAlias = Callable[[dict[str, Any]], Iterable[Effect]]


@dataclass(frozen=True, slots=True)
class Row:
    """One row: what it asks, with the cues of which each needs one; its effects; ``also``."""

    tests: tuple[Test, ...]
    needs: frozenset[frozenset[str]]
    effects: tuple[Effect, ...]
    also: bool


class Families:
    """Rows by family, as ``dangers.brake``; which of them cues leave is looked up."""

    def __init__(self, rows: dict[str, tuple[Row, ...]]) -> None:
        self.rows = rows
        self._cues = {
            family: frozenset().union(*(need for row in found for need in row.needs))
            for family, found in rows.items()
        }
        self._left = lru_cache(maxsize=16384)(self._left_by)

    def asked(self, family: str, clause: Clause, context: Context) -> tuple[Row, ...]:
        """The rows that may fit a clause."""
        if family not in self.rows:
            return ()
        return self._left(family, self._cues[family] & (clause.cues or cues(clause, context)))

    def _left_by(self, family: str, told: frozenset[str]) -> tuple[Row, ...]:
        return tuple(row for row in self.rows[family] if not any(map(told.isdisjoint, row.needs)))


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
        needs = frozenset(filter(None, map(needed, said)))
        does = (*effects(row), *map(_then, row.get("then", ())))
        return Row(tuple(map(condition, said)), needs, does, bool(row.get("also")))
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
    """The rows of some files by family, as ``dangers.brake``."""
    found: dict[str, tuple[Row, ...]] = {}
    for name in names:
        for events, rows in read(name).items():
            made = tuple(_row(row, f"{name}.yaml, {events}", effects, keys) for row in rows)
            found.update((f"{name}.{event.strip()}", made) for event in events.split(","))
    return Families(found)


def say(family: str, clause: Clause, context: Context) -> bool:
    """Adds what the rows of a family make of a clause.

    Returns:
        Whether a row fits that says something.
    """
    fitted = False
    for row in families().asked(family, clause, context):
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
