"""The numbers of a scenario on a road without a junction.

The text nearly always fixes a moment: the gap when the braking begins, the cut-in so far ahead,
the step off the kerb, the place of the impact. Everybody's movement is laid around these moments
in time, and where one starts follows.
"""

from __future__ import annotations

from scegen.concretization.along.acts import all_acts
from scegen.concretization.along.asked import dangers
from scegen.concretization.along.casting import cast
from scegen.concretization.along.crossing import Walk, cross
from scegen.concretization.along.lanes import choose_lanes
from scegen.concretization.along.parked import park, shift_to_pass, strips_m
from scegen.concretization.along.passing import apart_m
from scegen.concretization.along.reactions import contacts, react
from scegen.concretization.along.runner import Runner, gap_m
from scegen.concretization.along.sideways import come_back, offset_all, overtake
from scegen.concretization.along.story import Story, contact_wanted
from scegen.concretization.along.ties import tie_up
from scegen.concretization.along.writing import (
    Frame,
    ends_s,
    frame_of,
    road_of,
    slug_name,
    walk_motion,
    written_parked,
    written_runner,
    written_walk,
)
from scegen.concretization.objects import (
    caused_by_nobody,
    causes_it,
    free_name,
    made_of,
    shape_of,
)
from scegen.concretization.occluders import hide
from scegen.concretization.roads import plan
from scegen.errors import MotionInfeasibleError
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.motion.paths import build_paths
from scegen.motion.standing import crossing_path
from scegen.motion.ties import clear_of_ties
from scegen.road import build_network
from scegen.road.defaults import LANE_WIDTH_M
from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.concrete import Change, ConcreteParticipant, ConcreteScenario, RoadParameters
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, ParticipantKind

_AFTER_S = 3.0
"""The recording goes on this long after the last thing has happened."""
_SPARE = 1.35
_LONGEST_S = 100.0
_WIDER = (1.0, 1.3, 1.7, 2.2, 3.0)
_PLAIN_M = 100.0


def tells_along(functional: FunctionalScenario, logical: LogicalScenario) -> bool:
    """Whether a scenario is one along a road: no junction, nobody reverses, turns or pulls out."""
    if functional.junction.kind is not JunctionKind.STRAIGHT:
        return False
    if any(p.pulls_out for p in functional.participants):
        return False
    ego = logical.assignment(functional.ego.id)
    if not isinstance(ego, Drive):
        return False
    backing = {a.participant for a in functional.acts if a.kind is ActKind.REVERSE}
    return not any(
        (d.reverses is not None and d.participant not in backing)
        or d.turn is Maneuver.U_TURN
        or d.entry == d.exit
        for d in logical.drives
    )


def compose_along(
    functional: FunctionalScenario,
    logical: LogicalScenario,
    *,
    seed: int,
    road: RoadParameters | None = None,
) -> ConcreteScenario:
    """The first concrete scenario of one along a road.

    Raises:
        MotionInfeasibleError: what is said of lanes, places and times cannot all be had.
    """
    story = _story(functional, logical, road)
    waiting = story.time_what_is_known()
    walks = _lay(story, waiting)
    parked = park(story, walks)
    lasts = _closest_s(story, ends_s(story, walks)) + _AFTER_S
    frame = frame_of(story, walks, parked, [], min(_SPARE * lasts, _LONGEST_S))
    parameters = road_of(road or plan(functional, logical, _PLAIN_M, story.lane_count), frame)
    network = build_network(parameters, slug_name(story))
    standing = [written_parked(frame, p, functional.participant(p.id)) for p in parked]
    made = _written(story, frame, parameters, network, walks, seed, lasts, standing)
    return hide(functional, made, network)


def _story(
    functional: FunctionalScenario, logical: LogicalScenario, road: RoadParameters | None
) -> Story:
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


def _lay(story: Story, waiting: list[Act]) -> list[Walk]:
    """Places, then what follows from places; what is usual is widened until nobody is hit."""
    kept = {name: (list(r.steps), list(r.moves), r.offset_m) for name, r in story.runners.items()}
    begins, ends = dict(story.begins_s), dict(story.ends_s)
    walks: list[Walk] = []
    for wider in _WIDER:
        for name, (steps, moves, offset) in kept.items():
            runner = story.runners[name]
            runner.steps, runner.moves, runner.offset_m = list(steps), list(moves), offset
        story.begins_s, story.ends_s = dict(begins), dict(ends)
        offset_all(story)
        shift_to_pass(story)
        tie_up(story, wider=wider)
        never = story.perform_waiting(waiting)
        if never:
            act = never[0]
            raise MotionInfeasibleError(
                f"what sets its act '{act.id}' off never comes about",
                where=act.participant,
                hint="Change the value of its trigger, or the speeds or distances of the two.",
            )
        overtake(story)
        come_back(story)
        touching = react(story)
        walks = cross(story, strips_m(story))
        touching += react(story)
        unwanted = [p for p in touching if not contact_wanted(story, *p)]
        unwanted += [
            (a, b) for a, b, _ in contacts(story)
            if not contact_wanted(story, a, b) and (a, b) not in unwanted
        ]  # fmt: skip
        if not unwanted:
            break
    return walks


def _closest_s(story: Story, at_least_s: float) -> float:
    """When the last of those who come near each other are nearest, or touch."""
    latest = at_least_s
    names = list(story.runners)
    for n, first in enumerate(names):
        for second in names[n + 1 :]:
            a, b = story.runners[first], story.runners[second]
            if {first, second} & {story.ego.id}:
                latest = max(latest, _nearest_s(a, b, at_least_s + 8.0))
    return min(latest, _LONGEST_S - _AFTER_S)


def _nearest_s(first: Runner, second: Runner, until_s: float) -> float:
    """When two are nearest along the road; the contact, if they touch."""
    best, when = 1e9, 0.0
    for n in range(int(until_s / 0.1)):
        time_s = n * 0.1
        if apart_m(first, second, time_s) <= 0:
            return time_s
        gap = gap_m(first, second, time_s)
        if gap < best - 0.05:
            best, when = gap, time_s
    return when


def _written(
    story: Story, frame: Frame, road: RoadParameters, network: RoadNetwork, walks: list[Walk],
    seed: int, lasts_s: float, parked: list[ConcreteParticipant],
) -> ConcreteScenario:  # fmt: skip
    standing = {p.id: p for p in parked}
    by_walk = {walk.id: walk for walk in walks}
    people = []
    for participant in story.functional.participants:
        if participant.id in story.runners:
            people.append(written_runner(story, frame, participant))
        elif participant.id in by_walk:
            walk = by_walk[participant.id]
            path = crossing_path(network, walk_motion(frame, walk), walk.id)
            people.append(written_walk(story, frame, walk, path.length_m))
        else:
            people.append(standing[participant.id])
    objects = tuple(
        _thing(story, frame, network, name) for name, r in story.runners.items() if r.box
    )
    concrete = ConcreteScenario(
        name=slug_name(story),
        description=story.functional.description,
        seed=seed,
        logical=story.logical,
        road=road,
        participants=tuple(people),
        objects=objects,
        environment=story.functional.environment,
        hazards=_caused(story),
        duration_s=round(lasts_s * 20) / 20,
        provenance=_provenance(story, walks),
    )
    return clear_of_ties(concrete, build_paths(concrete, network))


def _caused(story: Story) -> tuple[Hazard, ...]:
    """The dangers, those by a thing with the thing named."""
    found = []
    for hazard in story.hazards:
        if hazard.kind is HazardKind.OBSTACLE and story.things and not hazard.by:
            thing = story.things[0]
            to = hazard.to or (thing.in_way_of or story.ego.id,)
            found.append(hazard.model_copy(update={"by": (thing.id,), "to": to}))
        else:
            found.append(hazard)
    return tuple(found)


def _thing(story: Story, frame: Frame, network: RoadNetwork, name: str) -> StaticObject:
    """A thing in somebody's lane, at its pose in the world."""
    runner = story.runners[name]
    thing = next(t for t in story.things if t.id == name)
    road = network.arm_road(frame.ego_arm)
    x = runner.x_m(0.0) - frame.begin_m
    here = road.line.pose(0.0, 0.0)
    y = runner.y_m(0.0, LANE_WIDTH_M)
    pose = Pose(here.x_m, here.y_m, here.heading_rad).shifted(forward_m=x, left_m=y)
    return made_of(name, shape_of(thing.kind), thing.called, pose)


def _provenance(story: Story, walks: list[Walk]) -> tuple[Change, ...]:
    """Who drives how fast and why, and who brakes for whom."""
    said = {p.id for p in story.functional.participants if p.speed_mps is not None}
    changes = []
    for runner in story.runners.values():
        if runner.box is not None:
            continue
        reason = "as the description says" if runner.id in said else "usual speed"
        changes.append(_change(f"{runner.id}.speed_mps", runner.speed_mps, reason))
        for step in runner.steps:
            if step.act is None and step.reacts_to is not None:
                reason = f"brakes for {step.reacts_to}, as a driver who sees it does"
                changes.append(_change(f"{runner.id}.rate_mps2", step.rate_mps2, reason))
    for walk in walks:
        reason = "as the description says" if walk.id in said else "usual pace"
        changes.append(_change(f"{walk.id}.speed_mps", walk.speed_mps, reason))
    return tuple(changes)


def _change(parameter: str, after: float, reason: str) -> Change:
    return Change(parameter=parameter, by="concretization", after=round(after, 3), reason=reason)
