"""Those who go across the road: where their way lies, and when they set off to be met."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import chain
from math import ceil, floor

import numpy as np

from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import edge_y_m
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import goes_on_when_free
from scegen.concretization.limits import HARD_BRAKING_MPS2, REACTION_S
from scegen.concretization.others import Walker, abreast_m, gained
from scegen.concretization.profile import NEVER_S, SpeedChange
from scegen.concretization.walkers import (
    BEHIND_KERB_M,
    BRAKES,
    OWES,
    aim_m,
    brakes,
    goes_far_m,
    pace_mps,
    setback_m,
)
from scegen.road.cross_section import CROSSWALK_WIDTH_M
from scegen.scenario.acts import LETS_BY, Act, ActKind, AfterStart, WhenMeasure
from scegen.scenario.logical import Crossing
from scegen.scenario.spacings import LENGTHWISE, Measure
from scegen.scenario.vocabulary import HazardKind, Side

_MEETS_S = 6.0
_HOLDS_S = 0.6
"""The pace is held so long before the encounter."""
_LEAST_LEAD_S = 1.0
BEFORE_WALKER_M = 0.9
"""Who is parked and hides somebody stands so far before that one's line."""
_STOPS_SHORT_M = 0.8
_STAYS_M = 0.3
_BEFORE_CROSSWALK_M = 0.3
_STANDS_S = 0.5
"""Who waits for one who crosses stands at least so long."""
_LOOK_S, _LATEST_S = 0.05, 40.0


@dataclass
class Walk(Walker):
    """One who goes across: at ``x_m`` of the road, ``sets_off_s`` after the start.

    ``setback_m`` is how far outside the carriageway it starts, ``arrives_s`` when it is in the way
    of whom it meets, ``stops_after_m`` where its way ends if it does not go across.
    """

    from_left: bool
    meets: str
    x_m: float = 0.0
    setback_m: float = 0.0
    sets_off_s: float = 0.0
    arrives_s: float = 0.0
    stops_after_m: float | None = None
    timed: bool = False
    act: str | None = None


def cross(story: Story, strips: dict[str, float]) -> list[Walk]:
    """The walks of all who go across; ``strips`` is how wide those are beside each side's lanes."""
    walks: list[Walk] = []
    for crossing in story.logical.crossings:
        walks.append(_walk(story, crossing, strips, walks))
    return walks


def _walk(story: Story, crossing: Crossing, strips: dict[str, float], walks: list[Walk]) -> Walk:
    participant = story.functional.participant(crossing.participant)
    body = participant.body
    width = edge_y_m(story, left=True) - edge_y_m(story, left=False)
    meets = story.runners[_meets(story, participant.id)]
    from_left = (crossing.start is Side.LEFT) == (crossing.arm == story.ego_arm)
    act = story.first_act(participant.id, ActKind.CROSS)
    pace = pace_mps(story, participant, width)
    who = participant.id, participant.kind, body, crossing, pace
    walk = Walk(*who, from_left, meets=meets.id, act=None if act is None else act.id)
    far, into = goes_far_m(act), -1 if from_left else 1
    edge, strip = edge_y_m(story, left=from_left), strips.get("left" if from_left else "right", 0.0)
    middle = (meets.y_m(0.0) - edge) * into - body.centre_ahead_m
    met = meets.id, meets.body, meets.speed_mps
    to_aim = aim_m(story, walk, *met, middle_m=middle, to_left=into * meets.sign)
    steady = to_aim if far is None else min(to_aim, far - walk.gains_m)
    # It is as fast as that as they meet: it has gained its pace, and does not slow down yet.
    least = max(_HOLDS_S * pace - steady, to_aim - width if far is None else -steady)
    walk.setback_m = max(walk.gains_m + least, setback_m(walk, strip))
    soon_s = _until_met_s(story, participant.id, meets, act)
    if soon_s is not None:  # so near that the other does not come by first
        way = float(gained(pace, walk.rate_mps2, np.array([soon_s]))[0][0]) - to_aim
        nearest = max(strip, body.front_m + BEHIND_KERB_M)
        if way > nearest or story.contact_wanted(participant.id, meets.id):
            walk.setback_m = max(min(walk.setback_m, way), nearest)
    said = story.between(participant.id, meets.id, Measure.LATERAL_OFFSET_M)
    if said is not None:  # it waits so far aside of the other
        left = said.value.middle * (1 if said.participant == participant.id else -1)
        walk.setback_m = max(0.0, (edge - meets.y_m(0.0) - meets.sign * left) * into)
    takes, number = walk.runs_s(to_aim + walk.setback_m), len(walks)
    _time(story, walk, meets, act, takes)
    if walks and crossing.arm in story.functional.junction.crosswalks:
        walk.x_m = walks[0].x_m
        if not walk.timed:
            walk.sets_off_s = max(walks[0].arrives_s - takes, _LEAST_LEAD_S)
    walk.arrives_s = walk.sets_off_s + takes
    walk.x_m += abreast_m(number)
    if far is not None:
        walk.stops_after_m = walk.setback_m + far
    elif HazardKind.STOPPING in story.kinds_by(walk.id):
        walk.stops_after_m = walk.setback_m + abs(meets.y_m(0.0) - edge) + _STAYS_M
    for runner in (meets, *(r for r in story.runners.values() if r is not meets and not r.stands)):
        _brake_before(story, walk, runner)
    return walk


def _meets(story: Story, name: str) -> str:
    """Whose way it crosses: who lets it go first, or should, who suffers it, else the ego."""
    for act in story.functional.acts:
        if act.kind in LETS_BY and act.into == name and act.participant in story.runners:
            return act.participant
    owing = (n for n in story.runners if name in story.endangered_by(n, OWES))
    suffering = (n for n in story.endangered_by(name) if n in story.runners)
    return next(chain(owing, suffering), story.ego.id)


def _until_met_s(story: Story, name: str, meets: Runner, act: Act | None) -> float | None:
    """How long the other takes to its line from when it sets off, where that is said."""
    spacing = _spacing(story, name, meets.id, act)
    if spacing is None or not spacing[2] or meets.speed_mps <= 0.0:
        return None
    measure, value, _ = spacing
    return value / meets.speed_mps if measure is Measure.GAP_M else value


def _time(story: Story, walk: Walk, meets: Runner, act: Act | None, takes: float) -> None:
    """When it sets off and where its line lies, so that it ``takes`` as long as the other does."""
    half = walk.body.width_m / 2
    when = act.when if act is not None else None
    spacing = _spacing(story, walk.id, meets.id, act)
    walk.sets_off_s = max(ceil((_MEETS_S - takes) / _LOOK_S) * _LOOK_S, _LEAST_LEAD_S)
    if isinstance(when, AfterStart):
        walk.sets_off_s, walk.timed = when.delay_s.middle, True
    if spacing is None:
        arrival = walk.sets_off_s + takes
        walk.x_m = meets.x_m(arrival) + meets.towards * (meets.leading_m + half)
        return
    measure, value, as_it_sets_off = spacing
    if as_it_sets_off and not walk.timed:
        walk.sets_off_s = max(_MEETS_S - takes, 2.0)
    moment = walk.sets_off_s if as_it_sets_off else 0.0
    away = value if measure is Measure.GAP_M else value * meets.speed_at_mps(moment)
    walk.x_m = meets.x_m(moment) + meets.towards * (meets.leading_m + away + half)
    if not as_it_sets_off and not walk.timed:
        arrival = meets.profile.time_s(away)
        walk.sets_off_s = max(0.0, arrival - takes) if arrival < NEVER_S else _LEAST_LEAD_S


def _hidden_behind_m(story: Story, when: WhenMeasure) -> float:
    """How much farther its line lies than the near end of one who is parked before it."""
    along = {name for name, runner in story.runners.items() if not runner.opens}
    for standing in story.logical.standings:
        name = standing.participant
        if name in {when.participant, when.reference} - along and when.measure is Measure.GAP_M:
            return story.functional.participant(name).body.length_m + BEFORE_WALKER_M
    return 0.0


def _spacing(
    story: Story, name: str, other: str, act: Act | None
) -> tuple[Measure, float, bool] | None:
    """A distance along the road that is said between the two; whether as it sets off, or first."""
    when = act.when if act is not None else None
    if isinstance(when, WhenMeasure):
        return when.measure, when.value.middle + _hidden_behind_m(story, when), True
    said = story.between(name, other, *LENGTHWISE)
    own = said is not None and act is not None and said.at == act.id
    return None if said is None else (said.measure, said.value.middle, own)


def _brake_before(story: Story, walk: Walk, meets: Runner) -> None:
    """Who is said to brake for somebody, or would hit it, stops short of its line.

    Not where the two are to touch. Who is not said to brake does so as a driver who sees it step
    out.
    """
    if story.contact_wanted(walk.id, meets.id):
        return
    said = meets.id == walk.meets and brakes(story, meets.id)
    own = next((s for s in meets.steps if s.target_mps < meets.speed_mps and not s.timed), None)
    if (own is not None and (not said or own.reacts_to is not None)) or not (
        said or _touches(walk, meets, story)
    ):
        return
    most = min(meets.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
    rate = own.rate_mps2 if own is not None else min(HARD_BRAKING_MPS2[0], most)
    target = own.target_mps if own is not None else 0.0
    meets.steps = [s for s in meets.steps if s is not own]
    said_m = story.rests_at(own.act) if own is not None and own.act else None
    short = walk.body.width_m / 2 + (_STOPS_SHORT_M if said_m is None else said_m.value.middle)
    if said_m is None and walk.crossing.arm in story.functional.junction.crosswalks:
        short = max(short, CROSSWALK_WIDTH_M / 2 + _BEFORE_CROSSWALK_M)
    stop = walk.x_m - meets.towards * (short + meets.leading_m)
    room = abs(stop - (meets.at_m or 0.0))
    if not said:
        seen = room - meets.profile.way_m(walk.sets_off_s + REACTION_S)
        rate = min(max(rate, meets.speed_mps**2 / (2 * max(seen, 0.1))), most)
    begins = meets.profile.time_s(max(room - meets.speed_mps**2 / (2 * rate), 0.0))
    if begins >= NEVER_S:
        return
    if said_m is not None:  # to the metre: players begin in the middle of a step before
        begins = floor(begins / _LOOK_S) * _LOOK_S
        gone = meets.profile.way_m(begins - _LOOK_S / 2)
        rate = meets.speed_at_mps(begins) ** 2 / (2 * (room - gone))
    hazard = next(iter(sorted(story.kinds_by(meets.id) & BRAKES)), None)
    act = own.act if own is not None else None
    answers = None if said else walk.id
    answer = SpeedChange(target, rate, begins, act=act, hazard=hazard, reacts_to=answers)
    meets.steps.append(answer)
    _go_on(story, walk, meets)


def _go_on(story: Story, walk: Walk, meets: Runner) -> None:
    """Who waits for somebody goes on as soon as that one is out of its way."""
    edge = edge_y_m(story, left=walk.from_left)
    wide = (meets.body.width_m + walk.body.length_m) / 2
    across = abs(edge - meets.y_m(0.0)) + walk.setback_m + wide
    gone_s = walk.sets_off_s + walk.runs_s(across) + _LEAST_LEAD_S
    # Who is said to wait comes to rest; who lets another go first need not.
    waits = {act.id for act in story.functional.acts if act.kind is ActKind.WAIT}
    for n, step in enumerate(meets.steps):
        if step.act is not None and goes_on_when_free(story.act(step.act).when):
            before = [s for s in meets.steps if s is not step]
            free = [gone_s, *(s.begins_s + _LEAST_LEAD_S for s in before)]
            rests = [s.begins_s + meets.speed_mps / s.rate_mps2 for s in before if s.act in waits]
            begins = max([*free, *(at_rest + _STANDS_S for at_rest in rests)])
            meets.steps[n] = replace(step, begins_s=begins)
            story.begins_s[step.act] = begins


def _touches(walk: Walk, meets: Runner, story: Story) -> bool:
    """Whether one who drives on as it does hits the one who crosses."""
    into = -1 if walk.from_left else 1
    begins = edge_y_m(story, left=walk.from_left) - into * walk.setback_m
    wide = (meets.body.width_m + walk.body.length_m) / 2
    near = (meets.body.length_m + walk.body.width_m) / 2
    times = np.arange(0.0, _LATEST_S, _LOOK_S)
    way, _ = gained(walk.speed_mps, walk.rate_mps2, times - walk.sets_off_s)
    way = way if walk.stops_after_m is None else np.minimum(way, walk.stops_after_m)
    y = begins + into * (way + walk.body.centre_ahead_m)
    there, _ = meets.track(times)
    return bool(np.any((np.abs(there.x - walk.x_m) < near) & (np.abs(there.y - y) < wide)))
