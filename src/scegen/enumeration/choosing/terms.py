"""What an expression may speak of: participants' attributes and the words they take.

Every term has a type; a word's type is the vocabulary it comes from, so that a misspelt or
misplaced word is found before anything is enumerated.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from scegen.scenario.logical import (
    Assignment,
    ConflictKind,
    Crossing,
    Drive,
    InLine,
    LogicalScenario,
    Reverses,
    Standing,
    Walking,
)
from scegen.scenario.vocabulary import Maneuver, ParticipantKind, Role, Side

Value = int | str | bool | None
"""None: the participant has no such attribute; nothing compares with it but ``none``."""
Row = tuple[LogicalScenario, str]
"""A scenario, and the participant of whom ``count(…)`` speaks ("" outside of it)."""
Evaluate = Callable[[Row], Value]

NONE = "none"
TURNS = frozenset({Maneuver.STRAIGHT, Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN})


@dataclass(frozen=True, slots=True)
class Type:
    """``number``, ``truth``, or ``word`` of a vocabulary."""

    name: str
    words: frozenset[str] = frozenset()


NUMBER, TRUTH = Type("number"), Type("truth")


def _words(*words: str) -> Type:
    return Type("word", frozenset({str(word) for word in words} | {NONE}))


KINDS = _words(*ConflictKind)


@dataclass(frozen=True, slots=True)
class Attribute:
    """An attribute of a participant: its type, and how an assignment tells it."""

    type: Type
    read: Callable[[Assignment], Value]


def attributes(kinds: dict[str, str], roles: dict[str, str]) -> dict[str, Attribute]:
    """The attributes by name, for participants of these kinds and roles."""
    sides = _words(*Side)
    return {
        "entry": Attribute(NUMBER, lambda a: a.entry if isinstance(a, Drive) else None),
        "exit": Attribute(NUMBER, lambda a: a.exit if isinstance(a, Drive) else None),
        "move": Attribute(NUMBER, lambda a: a.move if isinstance(a, Drive) else None),
        "rank": Attribute(NUMBER, lambda a: a.rank if isinstance(a, Drive) else None),
        "arm": Attribute(NUMBER, lambda a: None if isinstance(a, Drive) else a.arm),
        "turn": Attribute(_words(*TURNS), lambda a: _word(_turn(a))),
        "maneuver": Attribute(_words(*Maneuver), lambda a: _word(_maneuver(a))),
        "reverses": Attribute(
            _words(*Reverses), lambda a: _word(a.reverses if isinstance(a, Drive) else None)
        ),
        "beside": Attribute(_words(*kinds), lambda a: a.beside if isinstance(a, InLine) else None),
        "lane": Attribute(NUMBER, lambda a: a.lane if isinstance(a, InLine) else None),
        "beside_on": Attribute(
            sides, lambda a: _word(a.beside_on if isinstance(a, InLine) else None)
        ),
        "changes_to": Attribute(
            sides, lambda a: _word(a.changes_to if isinstance(a, Drive) else None)
        ),
        "start": Attribute(sides, lambda a: _word(a.start if isinstance(a, Crossing) else None)),
        "side": Attribute(
            sides, lambda a: _word(a.side if isinstance(a, Standing | Walking) else None)
        ),
        "kind": Attribute(_words(*ParticipantKind), lambda a: kinds[a.participant]),
        "role": Attribute(_words(*Role), lambda a: roles[a.participant]),
    }


def _turn(assignment: Assignment) -> Maneuver | None:
    return assignment.turn if isinstance(assignment, Drive) else None


def _maneuver(assignment: Assignment) -> Maneuver | None:
    if isinstance(assignment, Drive):
        return assignment.maneuver
    others = {
        "crossing": Maneuver.CROSS, "standing": Maneuver.STAY, "walking": Maneuver.STRAIGHT
    }  # fmt: skip
    return others[assignment.type]


def _word(word: str | None) -> str | None:
    return None if word is None else str(word)


def conflicts(scenario: LogicalScenario, kind: str | None, name: str | None) -> int:
    """Number of conflicts, of one kind, with one participant."""
    return sum(
        (kind is None or c.kind == kind) and (name is None or name in {c.first, c.second})
        for c in scenario.conflicts
    )


def conflict(scenario: LogicalScenario, first: str, second: str) -> str:
    """How two participants meet."""
    for met in scenario.conflicts:
        if {met.first, met.second} == {first, second}:
            return met.kind.value
    return NONE


def yields(scenario: LogicalScenario, name: str, other: str | None) -> bool:
    """Whether a participant must give way, to one or to anybody."""
    return any(
        c.yields == name and (other is None or other in {c.first, c.second})
        for c in scenario.conflicts
    )
