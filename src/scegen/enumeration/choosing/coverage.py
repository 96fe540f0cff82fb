"""Coverage: which meetings of two movements, in kind and right of way, a set of scenarios holds.

A meeting is told without arm numbers, so that a junction turned on itself counts once: what the
first does, what the second does, where it comes from seen from the first, the kind of conflict,
and who yields.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Assignment, Conflict, Drive, LogicalScenario

SAME_ARM = "same arm"


@dataclass(frozen=True, slots=True, order=True)
class Meeting:
    """``second`` comes from ``seen``, seen from ``first``; ``yields`` is first, second, neither."""

    first: str
    second: str
    seen: str
    kind: str
    yields: str

    def in_words(self) -> str:
        """Such as ``left × straight from opposite: crossing, first yields``."""
        outcome = "neither yields" if self.yields == "neither" else f"{self.yields} yields"
        place = f"from {self.seen}" if self.seen != SAME_ARM else "on the same arm"
        return f"{self.first} × {self.second} {place}: {self.kind}, {outcome}"


@dataclass(frozen=True, slots=True)
class Coverage:
    """In how many scenarios of all, and of the chosen, each meeting occurs."""

    possible: Counter[Meeting]
    chosen: Counter[Meeting]

    @property
    def missing(self) -> tuple[Meeting, ...]:
        """Possible, but in none of the chosen."""
        return tuple(meeting for meeting in sorted(self.possible) if not self.chosen[meeting])


def coverage(
    functional: FunctionalScenario,
    everything: Iterable[LogicalScenario],
    chosen: Iterable[LogicalScenario],
) -> Coverage:
    """What the chosen scenarios cover of what all together hold."""
    return Coverage(_tally(functional, everything), _tally(functional, chosen))


def meetings(functional: FunctionalScenario, scenario: LogicalScenario) -> frozenset[Meeting]:
    """The meetings in one scenario."""
    return frozenset(meeting_of(functional, scenario, c) for c in scenario.conflicts)


def meeting_of(
    functional: FunctionalScenario, scenario: LogicalScenario, conflict: Conflict
) -> Meeting:
    """The meeting that one of the scenario's conflicts is."""
    first, second = scenario.assignment(conflict.first), scenario.assignment(conflict.second)
    return _meeting(conflict, first, second, arm_angles_deg(functional.junction))


def _tally(
    functional: FunctionalScenario, scenarios: Iterable[LogicalScenario]
) -> Counter[Meeting]:
    return Counter(met for scenario in scenarios for met in meetings(functional, scenario))


@lru_cache(maxsize=65_536)
def _meeting(
    conflict: Conflict, first: Assignment, second: Assignment, angles: tuple[float, ...]
) -> Meeting:
    """Told from the side that comes first in the alphabet, so each is told once."""
    yields = {conflict.first: "first", conflict.second: "second"}.get(
        conflict.yields or "", "neither"
    )
    told = Meeting(
        _movement(first), _movement(second), _seen(first, second, angles), conflict.kind, yields
    )
    swapped = {"first": "second", "second": "first"}.get(yields, yields)
    other = Meeting(told.second, told.first, _seen(second, first, angles), conflict.kind, swapped)
    return min(told, other)


def _movement(assignment: Assignment) -> str:
    if isinstance(assignment, Drive):
        plain = assignment.maneuver is assignment.turn
        words = assignment.turn if plain else f"{assignment.maneuver} {assignment.turn}"
        return str(words).replace("_", " ")
    return {"crossing": "crosses", "standing": "stands", "walking": "walks along"}[assignment.type]


def _seen(first: Assignment, second: Assignment, angles: tuple[float, ...]) -> str:
    here, there = _arm(first), _arm(second)
    if here == there:
        return SAME_ARM
    return " or ".join(sorted(seen_from(angles, here, there)))


def _arm(assignment: Assignment) -> int:
    return assignment.entry if isinstance(assignment, Drive) else assignment.arm
