"""What an expression may speak of: participants' attributes and the words they take.

Every term has a type; a word's type is the vocabulary it comes from, so that a misspelt or
misplaced word is found before anything is enumerated.
"""

from collections.abc import Callable
from dataclasses import dataclass

from scegen.scenario.logical import Assignment, ConflictKind, Drive, LogicalScenario, Reverses
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
    fields = {
        "entry": NUMBER,
        "exit": NUMBER,
        "move": NUMBER,
        "arm": NUMBER,
        "turn": _words(*TURNS),
        "reverses": _words(*Reverses),
        "beside": _words(*kinds),
        "lane": NUMBER,
        "beside_on": sides,
        "changes_to": sides,
        "start": sides,
        "side": sides,
    }
    return {
        **{name: Attribute(type_, _field(name)) for name, type_ in fields.items()},
        "rank": Attribute(NUMBER, lambda a: a.rank if isinstance(a, Drive) else None),
        "maneuver": Attribute(_words(*Maneuver), _maneuver),
        "kind": Attribute(_words(*ParticipantKind), lambda a: kinds[a.participant]),
        "role": Attribute(_words(*Role), lambda a: roles[a.participant]),
    }


def _field(name: str) -> Callable[[Assignment], Value]:
    """A field that some assignments have and others have not."""

    def read(assignment: Assignment) -> Value:
        value = getattr(assignment, name, None)
        return str(value) if isinstance(value, str) else value

    return read


def _maneuver(assignment: Assignment) -> str:
    if isinstance(assignment, Drive):
        return str(assignment.maneuver)
    others = {
        "crossing": Maneuver.CROSS, "standing": Maneuver.STAY, "walking": Maneuver.STRAIGHT
    }  # fmt: skip
    return str(others[assignment.type])


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
