"""Who is parked beside the lanes: before whom it hides, else along the way; and doors that open.

To everybody along the road one that opens a door on the side of the traffic is the ground over
which that swings, from the moment on at which it opens.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from scegen.concretization.along.crossing import BEFORE_WALKER_M
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import (
    on_left,
    standings_beside,
    strip_middle_m,
)
from scegen.concretization.along.story import Story
from scegen.concretization.others import Walk
from scegen.concretization.profile import NEVER_S
from scegen.concretization.tale import outward
from scegen.motion.doors import REACH_M, hinge_ahead_m
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Standing
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import START, Measure
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Side

_BETWEEN_M = 1.2
_PASSED_AT_S = 5.0
_DOOR = BODIES[ParticipantKind.DOOR]
_OPENS_S = 0.8
_IN_THE_WAY_M = 0.3
"""By so much it reaches into the way of who comes along: one rides or drives as near as that."""


@dataclass(frozen=True, slots=True)
class Parked:
    """One who is parked: the middle of its box lies at ``x_m`` of the road."""

    id: str
    body: Body
    standing: Standing
    x_m: float


def park(story: Story) -> list[Parked]:
    """Places for all who are parked, in rows.

    Before those whom they hide, around one that opens its door, and others along the way.
    """
    hiding = {name for hazard in story.of_kind(HazardKind.OCCLUSION) for name in hazard.by}
    doors = opens(story.functional).keys() & story.runners.keys() - hiding
    beside = standings_beside(story)
    opened = {on_left(story, s): s.participant for s in beside if s.participant in doors}
    rows: dict[tuple[bool, str], list[Standing]] = {}
    for standing in beside:
        left, name = on_left(story, standing), standing.participant
        walk = _hidden(story, standing, hiding)
        before = opened.get(left) if name not in hiding else None
        before = before or (walk.id if walk is not None else "")
        rows.setdefault((left and bool(before), before), []).append(standing)
    return [p for (_, name), row in rows.items() for p in _in_a_row(story, row, name)]


def _in_a_row(story: Story, row: list[Standing], before: str) -> Iterator[Parked]:
    """In the order in which they are passed, from the one on whose place something depends."""
    bodies = [story.functional.participant(s.participant).body for s in row]
    first, middle, sense = 0, story.ego.x_m(_PASSED_AT_S), 1
    walk = story.walks.get(before)
    if walk is not None:
        sense = -story.runners[walk.meets].sign
        away = (walk.body.width_m + bodies[0].length_m) / 2 + BEFORE_WALKER_M
        middle = walk.x_m + sense * away
    elif before:
        door = story.runners[before]
        first = next(n for n, s in enumerate(row) if s.participant == before)
        middle, sense = middle_m(door, bodies[first]), door.sign
    else:
        first, middle = _said_m(story, row, bodies) or (first, middle)
    for n, standing in enumerate(row):
        between = bodies[min(n, first) + 1 : max(n, first)]
        away = (bodies[n].length_m + bodies[first].length_m) / 2 + _BETWEEN_M
        away += sum(body.length_m + _BETWEEN_M for body in between)
        x = middle + sense * ((n > first) - (n < first)) * away
        yield Parked(standing.participant, bodies[n], standing, x)


def passes_s(story: Story, parked: list[Parked]) -> float:
    """When the ego has passed all of whom it is said how far ahead they stand."""
    said = [p.x_m - story.ego.x_m(0.0) for p in parked if _ahead_m(story, p.id) is not None]
    moments = map(story.ego.profile.time_s, said)
    return max((moment for moment in moments if moment < NEVER_S), default=0.0)


def _said_m(story: Story, row: list[Standing], bodies: list[Body]) -> tuple[int, float] | None:
    """Of whom in a row it is said how far from the ego it is at first, and its place."""
    for n, standing in enumerate(row):
        ahead_m = _ahead_m(story, standing.participant)
        if ahead_m is not None:
            return n, story.ego.ends_m(0.0)[1] + ahead_m + bodies[n].length_m / 2
    return None


def _ahead_m(story: Story, name: str) -> float | None:
    """How far ahead of the ego's front somebody is said to stand at first."""
    said = story.between(name, story.ego.id, Measure.GAP_M)
    return said.value.middle if said is not None and said.at == START else None


def _hidden(story: Story, standing: Standing, hiding: set[str]) -> Walk | None:
    """Whom one hides: who sets off from its side; from anywhere if it is said to hide somebody."""
    hides = standing.participant in hiding
    same = [w for w in story.walks.values() if w.from_left == on_left(story, standing)]
    found = [*same, *(story.walks.values() if hides else ())]
    return found[0] if found and (hides or not hiding) else None


def opens(functional: FunctionalScenario) -> dict[str, Act]:
    """Who is parked and opens a door, and the act."""
    parked = {p.id for p in functional.participants if p.parked}
    acts = (act for act in functional.acts if act.participant in parked)
    return {act.participant: act for act in acts if act.kind is ActKind.OPEN_DOOR}


def cast_doors(story: Story) -> None:
    """Add those who open a door to those along the road; lanes come later."""
    for standing in story.logical.standings:
        name = standing.participant
        if name not in opens(story.functional) or name in story.runners:
            continue
        forward = beside_outermost(story, standing) or is_one_way(story)
        box = replace(_DOOR, length_m=_DOOR.width_m, width_m=REACH_M)
        story.add(name, ParticipantKind.DOOR, box, forward=forward, thing=True)


def is_one_way(story: Story) -> bool:
    """Whether everybody on the road goes the same way."""
    return story.functional.junction.carriageway is Carriageway.ONE_WAY


def beside_outermost(story: Story, standing: Standing) -> bool:
    """Whether one stands on the side of the outermost lane of who enters as the ego does."""
    keeps = story.functional.junction.driving_side.value
    return (standing.arm == story.ego_arm) == (standing.side.value == keeps)


def inner_doors(story: Story) -> set[str]:
    """Who opens a door beside the innermost lane: on the other side of a one-way road."""
    names = opens(story.functional).keys() if is_one_way(story) else ()
    stand = (s for s in story.logical.standings if s.participant in names)
    return {s.participant for s in stand if not beside_outermost(story, s)}


def hang_doors(story: Story) -> None:
    """Put doors beside the lane next to them, and those whom they endanger within their reach."""
    functional, runners = story.functional, story.runners
    for name in opens(functional).keys() & runners.keys():
        door, vehicle = runners[name], functional.participant(name).body
        inner = name in inner_doors(story)
        inward = outward(functional, Side.LEFT) * (1 if inner else -1)
        middle = strip_middle_m(story, name)
        tip = REACH_M - (middle - vehicle.width_m / 2) - door.lane_width_m / 2
        door.lane, door.offset_m = 1 if inner else story.lane_count, inward * (tip - REACH_M / 2)
        for other in (runners[n] for n in endangered(functional, name) if n in runners):
            said = any(
                spacing.measure is Measure.LATERAL_GAP_M
                and other.id in {spacing.participant, spacing.reference}
                for spacing in functional.spacings
            )
            most = tip - _IN_THE_WAY_M + other.body.width_m / 2
            if other.lane == door.lane and other.forward == door.forward and not said:
                other.offset_m = inward * min(inward * other.offset_m, most)


def endangered(functional: FunctionalScenario, name: str) -> set[str]:
    """Who comes along where somebody opens a door: who suffers it, or is to touch it."""
    found = {to for hazard in functional.hazards if name in hazard.by for to in hazard.to}
    between = functional.outcome.between if functional.outcome is not None else ()
    touching = {*between} - {name} if name in between else set()
    return found or touching or {functional.ego.id}


def door_before(story: Story, who: str) -> Runner | None:
    """The door that opens before somebody, None if none does."""
    names = opens(story.functional).keys() & story.runners.keys()
    endangering = (n for n in sorted(names) if who in endangered(story.functional, n))
    return next((story.runners[name] for name in endangering), None)


def middle_m(door: Runner, vehicle: Body) -> float:
    """Where the middle of the vehicle lies along the road whose door it is."""
    return door.x_m(0.0) + door.sign * (_DOOR.width_m / 2 - hinge_ahead_m(vehicle))


def opening_s(act: Act) -> float:
    """How long a door takes to open."""
    return _OPENS_S if act.duration_s is None else act.duration_s.middle
