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

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from scegen.understanding.chunks import Event
from scegen.understanding.draft import Draft
from scegen.understanding.frames.loader import read
from scegen.understanding.road.junctions import JunctionReading
from scegen.understanding.semantics.conditions import condition
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.effects import EFFECTS, Effect, effects_of
from scegen.understanding.semantics.facts import Test

_FILES = ("acts", "constructions", "dangers", "movements", "nouns", "omissions", "positions",
          "standing")  # fmt: skip
_KEYS = frozenset(EFFECTS) | {"if", "by", "to", "of", "from", "then", "words", "reason", "also",
                              "where", "targets", "actors", "unsaid", "always", "into"}  # fmt: skip

Effects: TypeAlias = Callable[[dict[str, Any]], Iterable[Effect]]


_OF_THE_VERB = frozenset({"event", "lemma", "form", "negated", "passive", "nominal"})
"""Words of conditions that the verb alone decides."""
_PATH = re.compile(r"path (?!\^)")
_NOWHERE = Context(Draft(), JunctionReading(), [])


@dataclass(frozen=True, slots=True)
class Row:
    """One row: what it asks of the verb, and what else; its effects; whether more rows are asked.

    ``phrased``: it can only hold where the verb has phrases.
    """

    of_the_verb: tuple[Test, ...]
    phrased: bool
    tests: tuple[Test, ...]
    effects: tuple[Effect, ...]
    also: bool


class Families:
    """Rows by family, as ``dangers.brake``; what they ask of the verb is looked up."""

    def __init__(self, rows: dict[str, tuple[Row, ...]]) -> None:
        self.rows = rows
        self._for_verb = lru_cache(maxsize=16384)(self._of_verb)

    def asked(self, family: str, event: Event) -> tuple[Row, ...]:
        """The rows that may fit a clause with such a verb."""
        if family not in self.rows:
            return ()
        facts = event.negated, event.passive, event.nominal
        own = event.name, event.lemma, event.form
        return self._for_verb(family, *own, bool(event.pps), *facts)

    def _of_verb(
        self, family: str, name: str, lemma: str, form: str, phrases: bool, *facts: bool
    ) -> tuple[Row, ...]:
        event = Event(name, 0, 0, form, lemma)
        event.negated, event.passive, event.nominal = facts
        alone = Clause(event, [], [])
        return tuple(
            row
            for row in self.rows[family]
            if phrases >= row.phrased and all(test(alone, _NOWHERE) for test in row.of_the_verb)
        )


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
        tests: dict[bool, list[Test]] = {True: [], False: []}
        for text in said:
            tests[_of_the_verb(text)].append(condition(text))
        phrased = any(all(map(_PATH.match, text.split(" or "))) for text in said)
        does = (*effects(row), *map(_then, row.get("then", ())))
        return Row(tuple(tests[True]), phrased, tuple(tests[False]), does, bool(row.get("also")))
    except KeyError as error:
        raise KeyError(f"{where}: {error} in {row}") from error


def _of_the_verb(text: str) -> bool:
    """Whether the verb alone decides a condition."""
    parts = (part.removeprefix("not ").partition(" ")[0] for part in text.split(" or "))
    return _OF_THE_VERB.issuperset(parts)


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
    for row in families().asked(family, clause.event):
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
