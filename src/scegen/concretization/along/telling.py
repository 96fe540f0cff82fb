"""From the two levels above to a story: who is cast, what lies in the way, which acts."""

from __future__ import annotations

from scegen.concretization.along.acts import all_acts
from scegen.concretization.along.casting import cast
from scegen.concretization.along.lanes import choose_lanes
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import Story
from scegen.concretization.asked import dangers
from scegen.concretization.objects import caused_by_nobody, causes_it, free_name, shape_of
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.scenario.concrete import RoadParameters
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind


def story_of(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters | None = None
) -> Story:
    """Everybody with its speed and lane, and what is done; no places and no moments yet.

    Raises:
        MotionInfeasibleError: what is said of lanes cannot all be had.
    """
    limit = functional.junction.speed_limit_mps or implied_limit_mps(functional)
    runners = cast(functional, logical, limit)
    things = _things(functional, logical, runners)
    for thing in things:
        blocked = runners[thing.in_way_of or ""]
        body = shape_of(thing.kind).body
        runners[thing.id] = Runner(
            thing.id,
            ParticipantKind.CAR,
            blocked.forward,
            -1,
            0.0,
            box=body,
            keeps_left=blocked.keeps_left,
        )
    acts = all_acts(functional, logical, runners)
    people = {name: runner for name, runner in runners.items() if runner.box is None}
    count = choose_lanes(functional, logical, people, acts)
    if road is not None:
        count = road.arms[0].lanes_in
    for thing in things:
        runners[thing.id].lane = runners[thing.in_way_of or ""].lane
    grip = friction_of(functional.environment) * GRAVITY_MPS2
    return Story(functional, logical, runners, acts, count, limit, grip, tuple(things))


def _things(
    functional: FunctionalScenario, logical: LogicalScenario, runners: dict[str, Runner]
) -> list[Thing]:
    """What lies in somebody's lane: what is said, and what a danger needs that nobody causes."""
    found = [thing for thing in functional.objects if thing.in_way_of in runners]
    for hazard in dangers(functional, logical):
        if hazard.kind is not HazardKind.OBSTACLE or not caused_by_nobody(functional, hazard):
            continue
        thing = causes_it(functional, hazard)
        if thing in found or (thing is None and (found or logical.standings)):
            continue
        who = next((n for n in hazard.to if n in runners), _who_reacts(functional, logical))
        name = free_name(functional, ThingKind.OBSTACLE, set(runners))
        thing = thing or Thing(id=name, kind=ThingKind.OBSTACLE)
        found.append(thing.model_copy(update={"in_way_of": thing.in_way_of or who}))
    return found


def _who_reacts(functional: FunctionalScenario, logical: LogicalScenario) -> str:
    """Who does something that one does because of a thing in its way; else the ego."""
    for hazard in dangers(functional, logical):
        if hazard.by and (HAZARDS[hazard.kind].acts or hazard.kind is HazardKind.DELAYED_BRAKING):
            return hazard.by[0]
    sideways = {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE}
    return next(
        (d.participant for d in logical.drives if d.maneuver in sideways), functional.ego.id
    )
