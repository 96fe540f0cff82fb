"""Which way a verb of motion leads, by the words around it."""

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.chunks import Event, NounPhrase, Place
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics import lanes
from scegen.understanding.semantics.context import Clause, Context, span
from scegen.understanding.words.quantities import after_a_measure
from scegen.understanding.words.tokens import Token, low_at

DIRECTIONS = {"left": Maneuver.LEFT, "right": Maneuver.RIGHT, "straight": Maneuver.STRAIGHT}
_GOALS = frozenset({"side", "leg", "access", "road", "junction"})
"""What lies at one side of a junction ("the left fork"): who goes there, or takes it, turns."""
_OTHER = {"left": "right", "right": "left"}
SIDEWAYS = frozenset({Maneuver.LEFT, Maneuver.RIGHT})


def directions(event: Event, tokens: list[Token]) -> dict[Maneuver, Basis]:
    """Directions that belong to a verb of motion, with their words."""
    found = {
        DIRECTIONS[t.value]: span(event, t.i, t.j)
        for t in event.dirs
        if t.value in DIRECTIONS and low_at(tokens, t.j) != "of"  # "right of the centre line"
    }
    goal = event.object if isinstance(event.object, Place) else None
    takes = goal is not None and goal.kind in _GOALS and event.lemma in word_list("taking")
    named = (p.target for p in event.pps)
    lanes = {n.j for n in named if isinstance(n, Place) and n.kind == "lane"}
    for prep in event.pps:
        target = prep.target
        over = low_at(tokens, prep.word.i - 1) == "over"
        if prep.word.i in lanes or after_a_measure(tokens, prep.word.i - over):
            continue  # "in the next lane to the left", "comes 1 m (over) to the left"
        leads_there = takes or prep.value in {"to", "into", "for"}
        if leads_there and isinstance(target, Place) and target.kind in _GOALS:
            across = _came_from(event) & {_OTHER.get(d, "") for d in target.dirs}
            seen = target.has("possessive") and (prep.on_mention is not None or _goes_on(event))
            if target.owner is not None or seen or _our_side(target, event):
                continue  # "to the right of the bus", "the lorry to its left": where it is
            for value in target.dirs:
                if value in _OTHER:
                    crosses = across and event.name != "turn"  # "from the left, turns to the right"
                    way = Maneuver.STRAIGHT if crosses else DIRECTIONS[value]
                    found[way] = span(event, target.i, target.j)
    there = event.name in {"move", "enter", "turn"}
    if goal is not None and (takes or (goal.kind in _GOALS and there)):
        sides = (d for d in goal.dirs if d in _OTHER)
        found |= {DIRECTIONS[d]: span(event, goal.i, goal.j) for d in sides}
    return found


def _goes_on(event: Event) -> bool:
    """``a cyclist riding to its right``: where it rides all the time."""
    going = (event.name, event.form) == ("move", "ing") and not event.finite
    return going or _drives_along(event)


def _drives_along(event: Event) -> bool:
    """``a van drives to its left``: beside it, of somebody new."""
    new = any(m.opened_by("indef") for m in event.subject)
    return event.name == "move" and new and event.lemma in word_list("driving_along")


def _our_side(side: Place, event: Event) -> bool:
    """``a van comes down the ramp to our left``: where that is, for whoever tells it."""
    ours = side.has("possessive", "first_person")
    return ours and not any(e.ego for m in event.subject for e in m.entities)


def _came_from(event: Event) -> set[str]:
    """``from left to right``: right across, no turn."""
    sides = [p.target for p in event.pps if p.value == "from" and isinstance(p.target, Place)]
    return {d for side in sides for d in side.dirs}


FACTS: dict[str, Callable[[Clause, Context], bool]] = {
    "drives_along": lambda clause, _: _drives_along(clause.event),
    "turns_across": lambda clause, c: (
        Maneuver(c.across) in directions(clause.event, c.tokens)  # across oncoming traffic
    ),
    "leads_somewhere": lambda clause, c: bool(directions(clause.event, c.tokens)),
    "leads_aside": lambda clause, c: bool(SIDEWAYS & set(directions(clause.event, c.tokens))),
    "onward": lambda clause, _: any(d.value == "straight" for d in clause.event.dirs),
    "denies_a_way": lambda clause, _: bool(clause.event.denied_ways & set(DIRECTIONS)),
}
"""Words of conditions that ask for a way."""


Named: TypeAlias = Callable[[Clause, Context], dict[Maneuver, Basis]]


def _either(clause: Clause, _: Context) -> dict[Maneuver, Basis]:
    """A turn whose side is not said."""
    denied = {DIRECTIONS[d] for d in clause.event.denied_ways if d in DIRECTIONS}
    return dict.fromkeys((SIDEWAYS - denied) or {Maneuver.STRAIGHT}, clause.words)


def _exit(clause: Clause, context: Context) -> dict[Maneuver, Basis]:
    exits = [p for p in clause.places() if p.kind == "exit"][:1]
    counted = [(p, lanes.lane_number(p, context.tokens)) for p in exits]
    return {Maneuver(f"exit_{n}"): Basis(way.i, way.j) for way, n in counted if n}


VALUES: dict[str, Named] = {
    "ways": lambda clause, c: directions(clause.event, c.tokens),
    "aside": lambda clause, c: {
        m: b for m, b in directions(clause.event, c.tokens).items() if m is not Maneuver.STRAIGHT
    },
    "across": lambda clause, c: {Maneuver(c.across): clause.words},
    "either": _either,
    "exit": _exit,
}


def _upto(event: Event, noun: NounPhrase | None) -> Basis | None:
    return Basis(event.i, max(event.j, noun.j)) if noun is not None else None


WORDS: dict[str, Callable[[Clause, Context], Basis | None]] = {
    "goal": lambda clause, _: _upto(clause.event, lanes.into_lane(clause.event)),
    "object": lambda clause, _: _upto(clause.event, clause.event.object),
    "child": lambda clause, _: next(
        (Basis(clause.event.i, e.j) for e in clause.event.children), None
    ),
    "next": lambda clause, _: Basis(clause.event.i, clause.event.j + 1),
    "onward": lambda clause, _: next(
        (Basis(d.i, d.j) for d in clause.event.dirs if d.value == "straight"), None
    ),
}
"""Words that a row may rest on, by what they are in the clause."""
