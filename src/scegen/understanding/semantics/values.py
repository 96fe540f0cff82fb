"""Ways that words of a clause name, with these words: what `maneuver` of a row may stand for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.chunks import Event, NounPhrase
from scegen.understanding.entity import Basis
from scegen.understanding.semantics import lanes, ways
from scegen.understanding.semantics.context import Clause, Context

Named: TypeAlias = Callable[[Clause, Context], dict[Maneuver, Basis]]
_EXITS = {
    "first": Maneuver.EXIT_1, "second": Maneuver.EXIT_2, "third": Maneuver.EXIT_3,
    "fourth": Maneuver.EXIT_4, "fifth": Maneuver.EXIT_5, "sixth": Maneuver.EXIT_6,
}  # fmt: skip
_REACH = 3


def _ways(clause: Clause, context: Context) -> dict[Maneuver, Basis]:
    return ways.directions(clause.event, context.tokens)


def _aside(clause: Clause, context: Context) -> dict[Maneuver, Basis]:
    return {m: b for m, b in _ways(clause, context).items() if m is not Maneuver.STRAIGHT}


def alike(clause: Clause, context: Context) -> dict[Maneuver, Basis]:
    """``the car ahead, which is turning as well``: the same way as the one before."""
    event = clause.event
    near = context.lows(event.i - _REACH, event.j + _REACH)
    if not {"too", "also", "likewise"} & set(near) and "as well" not in " ".join(near):
        return {}
    turned = [e.maneuvers & ways.SIDEWAYS for e in context.draft.entities if e not in clause.actors]
    told = [way for way in turned if len(way) == 1]
    return dict.fromkeys(told[-1], clause.words) if told else {}


def _either(clause: Clause, _: Context) -> dict[Maneuver, Basis]:
    """A turn whose side is not said."""
    denied = {ways.DIRECTIONS[d] for d in clause.event.denied_ways if d in ways.DIRECTIONS}
    return dict.fromkeys((ways.SIDEWAYS - denied) or {Maneuver.STRAIGHT}, clause.words)


def _exit(clause: Clause, _: Context) -> dict[Maneuver, Basis]:
    place = next((p for p in clause.places() if p.kind == "exit"), None)
    named = next((m.value for m in place.mods if m.value in _EXITS), None) if place else None
    return {_EXITS[named]: Basis(place.i, place.j)} if place and named else {}


VALUES: dict[str, Named] = {
    "ways": _ways,
    "aside": _aside,
    "alike": alike,
    "either": _either,
    "exit": _exit,
}


def _upto(event: Event, noun: NounPhrase | None) -> Basis | None:
    return Basis(event.i, max(event.j, noun.j)) if noun is not None else None


def _child(clause: Clause, _: Context) -> Basis | None:
    event = clause.event
    return Basis(event.i, event.children[0].j) if event.children else None


def _onward(clause: Clause, _: Context) -> Basis | None:
    term = next((d for d in clause.event.dirs if d.value == "straight"), None)
    return Basis(term.i, term.j) if term is not None else None


WORDS: dict[str, Callable[[Clause, Context], Basis | None]] = {
    "goal": lambda clause, _: _upto(clause.event, lanes.into_lane(clause.event)),
    "object": lambda clause, _: _upto(clause.event, clause.event.object),
    "child": _child,
    "onward": _onward,
    "through": lambda clause, context: ways.through(clause.event, context),
}
"""Words that a row may rest on, by what they are in the clause."""
