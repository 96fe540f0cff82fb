"""The numbers of a scenario on a road without a junction.

The text nearly always fixes a moment: the gap when the braking begins, the cut-in so far ahead,
the step off the kerb, the place of the impact. Everybody's movement is laid around these moments
in time, and where one starts follows.
"""

from dataclasses import replace

import numpy as np

from scegen.claims.boxes import gap_m
from scegen.concretization.along.crossing import cross
from scegen.concretization.along.frame import Frame, fitted, frame_of, road_of
from scegen.concretization.along.overtaking import overtake
from scegen.concretization.along.parked import opens, park, passes_s
from scegen.concretization.along.performing import is_timed_last, perform_known
from scegen.concretization.along.placing import place_all
from scegen.concretization.along.reactions import react, traffic_of
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import offset_all
from scegen.concretization.along.story import FIRST_ACT_S, Story
from scegen.concretization.along.straying import come_back
from scegen.concretization.along.telling import story_of
from scegen.concretization.along.writing import (
    ends_s,
    written_door,
    written_parked,
    written_runner,
    written_walk,
)
from scegen.concretization.answering import note_answers
from scegen.concretization.boxes import apart
from scegen.concretization.limits import LEAD_IN_S
from scegen.concretization.occluders import hide
from scegen.concretization.roads import plan
from scegen.concretization.things import made_of, shape_of
from scegen.concretization.traffic import goes_wrong
from scegen.concretization.written import written_scenario
from scegen.errors import MotionInfeasibleError
from scegen.motion.paths import build_paths
from scegen.motion.trigger_steps import put_between_steps
from scegen.road import build_network
from scegen.road.model import RoadNetwork
from scegen.scenario.acts import ActKind
from scegen.scenario.concrete import ConcreteScenario, door_of
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Drive, LogicalScenario, Reverses
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.vocabulary import HazardKind, JunctionKind

_WIDER = (1.0, 1.3, 1.7, 2.2, 3.0)
_FIRST_ACTS_S = (FIRST_ACT_S, FIRST_ACT_S / 2, LEAD_IN_S)
_LATER_S, _LATEST_S = 8.0, 80.0
_LOOK_S, _NEARER_M = 0.1, 0.05
_AFTER_S = 3.0
"""The recording goes on this long after the last thing has happened."""
_SPARE = 1.35
_LONGEST_S = 100.0
_PLAIN_M = 100.0


def lay(story: Story) -> None:
    """Moments, then places, then what follows from places.

    What is usual is widened until nobody is hit.

    Raises:
        MotionInfeasibleError: an act never comes about, or there is nobody to overtake.
    """
    last = [act for act in story.acts if is_timed_last(story, act)]
    waiting = perform_known(story, [a for a in story.acts if a not in last], placed=False)
    kept, begins, ends = story.runners, story.begins_s, story.ends_s
    for wider in _WIDER:
        story.runners = {n: replace(r, steps=[*r.steps], moves=[*r.moves]) for n, r in kept.items()}
        story.begins_s, story.ends_s, story.walks = dict(begins), dict(ends), {}
        offset_all(story)
        place_all(story, wider=wider)
        never = perform_known(story, waiting, placed=True)
        if never:
            act = never[0]
            raise MotionInfeasibleError(
                f"what sets its act '{act.id}' off never comes about",
                where=act.participant,
                hint="Change the value of its trigger, or the speeds or distances of the two.",
            )
        overtake(story)
        perform_known(story, [a for a in last if a.id not in story.begins_s], placed=True)
        come_back(story)
        react(story)
        cross(story)
        react(story)
        if not goes_wrong(traffic_of(story)):
            break


def _laid(functional: FunctionalScenario, logical: LogicalScenario) -> Story:
    """The story, with what happens first so early that everybody begins where it is said to be."""
    usual: Story | None = None
    for first_act_s in _FIRST_ACTS_S:
        story = story_of(functional, logical)
        story.first_act_s = first_act_s
        lay(story)
        if story.in_order():
            return story
        usual = usual or story
    return usual or story


def closest_s(story: Story, at_least_s: float) -> float:
    """When the last of those who come near the ego is nearest to it, or touches it."""
    latest = at_least_s
    for other in story.runners.values():
        # Who stands, comes towards it or is to be hit is met, however far away it is first.
        met = other.stands or other.forward != story.ego.forward
        met |= story.contact_wanted(other.id, story.ego.id)
        until = _LATEST_S if met else at_least_s + _LATER_S
        latest = max(latest, 0.0 if other is story.ego else _nearest_s(story.ego, other, until))
    return latest


def _nearest_s(first: Runner, second: Runner, until_s: float) -> float:
    """When two are nearest along the road; the contact, if they touch."""
    times = np.arange(0.0, until_s, _LOOK_S)
    one, other = first.track(times)[0], second.track(times)[0]
    touch = apart(one, other, 0.0) <= 0.0
    gap = gap_m(one, other)
    # Who keeps a distance is as near at first as later.
    return float(times[np.argmax(touch if touch.any() else gap < gap.min() + _NEARER_M)])


def tells_along(functional: FunctionalScenario, logical: LogicalScenario) -> bool:
    """Whether a scenario is one along a road: no junction, nobody reverses, turns or pulls out."""
    if functional.junction.kind is not JunctionKind.STRAIGHT:
        return False
    if functional.junction.auxiliary is not None:
        return True
    if any(p.pulls_out for p in functional.participants):
        return False
    ego = logical.assignment(functional.ego.id)
    if not isinstance(ego, Drive):
        return False
    stopping = {a.participant for a in functional.acts if a.kind is ActKind.STOP and a.when is None}
    backing = {a.participant for a in functional.acts if a.kind is ActKind.REVERSE} - stopping
    reversing = {n for h in functional.hazards if h.kind is HazardKind.REVERSING for n in h.by}
    return reversing <= backing and not any(
        d.reverses not in {None, Reverses.BACKS_UP}
        or (d.reverses is not None and d.participant not in backing)
        or d.entry == d.exit
        for d in logical.drives
    )


def compose_along(
    functional: FunctionalScenario, logical: LogicalScenario, *, seed: int
) -> ConcreteScenario:
    """The first concrete scenario of one along a road.

    Raises:
        MotionInfeasibleError: what is said of lanes, places and times cannot all be had.
    """
    story = _laid(functional, logical)
    story.seed = seed
    park(story)
    closest = closest_s(story, max(ends_s(story), passes_s(story)))
    lasts = min(closest + _AFTER_S, _LONGEST_S)
    planned = plan(story.functional, logical, _PLAIN_M, story.lane_count)
    frame = frame_of(story, planned, closest, min(_SPARE * lasts, _LONGEST_S))
    parameters = fitted(road_of(planned, frame), story, frame.joint_m)
    network = build_network(parameters)
    made = _written(story, frame, parameters, network, lasts)
    return hide(story.functional, made, network)


def _written(
    story: Story, frame: Frame, road: RoadParameters, network: RoadNetwork, lasts_s: float
) -> ConcreteScenario:
    people = []
    for name in (participant.id for participant in story.functional.participants):
        if name in story.parked:
            people.append(written_parked(story, frame, name))
        elif name in story.runners:
            people.append(written_runner(story, frame, network, name))
        elif name in story.walks:
            people.append(written_walk(story, frame, network, story.walks[name]))
    doors = opens(story.functional)
    people += [written_door(story, doors[p.id], p) for p in people if p.id in doors]
    things = (r.id for r in story.runners.values() if r.thing and not r.opens)
    objects = []
    for name in things:
        runner, thing = story.runners[name], story.things[name]
        pose = frame.pose(network, runner.x_m(0.0), runner.y_m(0.0))
        objects.append(made_of(name, shape_of(thing), thing.called, pose))
    _note(story)
    # Those by a thing or a door with that named.
    caused = tuple(
        hazard.but(by=tuple(door_of(n) if n in doors else n for n in hazard.by))
        for hazard in story.hazards
    )
    concrete = written_scenario(
        story, road, people, objects, caused, seed=story.seed, duration_s=lasts_s
    )
    return put_between_steps(concrete, build_paths(concrete, network))


def _note(story: Story) -> None:
    """Say who drives how fast and why, and who brakes for whom."""
    said = {p.id for p in story.functional.participants if p.speed_mps is not None}
    for runner in story.runners.values():
        if runner.thing:
            continue
        reason = "as the description says" if runner.id in said else "usual speed"
        story.note(f"{runner.id}.speed_mps", runner.speed_mps, reason)
    note_answers(story, story.runners)
    for walk in story.walks.values():
        reason = "as the description says" if walk.id in said else "usual pace"
        story.note(f"{walk.id}.speed_mps", walk.speed_mps, reason)
