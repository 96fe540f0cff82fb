"""Doors that open on the side of the traffic: what of the parked vehicle is then in the way.

To everybody along the road such a vehicle is the ground over which its door swings, from the moment
on at which it opens.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import strip_middle_m
from scegen.concretization.along.story import Story
from scegen.concretization.tale import outward
from scegen.motion.doors import REACH_M, hinge_ahead_m
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Standing
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import ParticipantKind, Side

_DOOR = BODIES[ParticipantKind.DOOR]
_OPENS_S = 0.8
_IN_THE_WAY_M = 0.3
"""By so much it reaches into the way of who comes along: one rides or drives as near as that."""


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
