"""Those who go across the road: where their way lies, and when they set off to be met."""

from dataclasses import replace
from itertools import chain
from math import ceil
from typing import NamedTuple

from scegen.claims.moments import STANDS_MPS
from scegen.concretization.along.reactions import react
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import edge_y_m, strip_m
from scegen.concretization.along.story import Story
from scegen.concretization.others import STOPS_SHORT_M, Walk, abreast_m
from scegen.concretization.profile import NEVER_S
from scegen.concretization.walkers import (
    OWES,
    STOOD_S,
    Met,
    aim_m,
    goes_far_m,
    pace_mps,
    rests_m,
    setback_m,
    stop_of,
    stops,
)
from scegen.scenario.acts import LETS_BY, Act, ActKind, AfterStart, WhenMeasure
from scegen.scenario.in_line import goes_first, words_between
from scegen.scenario.logical import Crossing
from scegen.scenario.spacings import LENGTHWISE, START, Measure, Spacing
from scegen.scenario.vocabulary import Approach, Side

_MEETS_S = 6.0
_HOLDS_S = 0.6
"""The pace is held so long before the encounter."""
_LEAST_LEAD_S, _TOLD_LEAD_S = 1.0, 2.0
BEFORE_WALKER_M = 0.9
"""Who stands, or is parked and hides somebody, does so that far before that one's line."""
_LOOK_S, _SLOW_MPS = 0.05, 0.5
_AFTER_S = 0.2
"""Who runs after another sets off so much later."""


class _Told(NamedTuple):
    """A distance along the road that is said of one who crosses and of whom it meets.

    It is that as an act of its own begins or ends, else at a time: as the other brakes, at first.
    """

    measure: Measure
    value: float
    act: Act | None
    since: str = "begin"
    at_s: float = 0.0


def cross(story: Story) -> None:
    """Let all go across who do, one after another."""
    names = [crossing.participant for crossing in story.logical.crossings]
    led = {name: sum(_runs_before(story, other, name) for other in names) for name in names}
    for crossing in sorted(story.logical.crossings, key=lambda c: led[c.participant]):
        story.walks[crossing.participant] = walk = _walk(story, crossing)
        for other in story.walks.values():
            if _runs_before(story, other.id, walk.id) and other.act is walk.act is None:
                other.sets_off_s = min(other.sets_off_s or 0.0, (walk.sets_off_s or 0.0) - _AFTER_S)
        react(story)


def _walk(story: Story, crossing: Crossing) -> Walk:
    participant = story.functional.participant(crossing.participant)
    body = participant.body
    width = edge_y_m(story, left=True) - edge_y_m(story, left=False)
    meets = story.runners[_meets(story, participant.id)]
    from_left = (crossing.start is Side.LEFT) == (crossing.arm == story.ego_arm)
    act = story.first_act(participant.id, ActKind.CROSS)
    pace = pace_mps(story, participant, width)
    who = participant.id, participant.kind, body, crossing, pace, act
    walk = Walk(*who, from_left, meets=meets.id)
    into = -1 if from_left else 1
    edge, strip = edge_y_m(story, left=from_left), strip_m(story, left=from_left)
    middle = (meets.y_m(0.0) - edge) * into - body.centre_ahead_m
    met = Met(meets.id, meets.body, meets.speed_mps, middle, into * meets.sign)
    to_aim = aim_m(story, walk, met)
    walk.stop = stop_of(story, walk.id)
    far, stands = goes_far_m(act), stops(story, walk.id)
    if far is None and stands:
        centre = -edge * into - body.centre_ahead_m
        far = STOPS_SHORT_M + rests_m(story, walk, met, centre_m=centre)
    steady = to_aim if far is None else min(to_aim, far - walk.gains_m)
    # It is as fast as that as they meet: it has gained its pace, and does not slow down yet.
    least = max(_HOLDS_S * pace - steady, to_aim - width if far is None else -steady)
    before = [w for w in story.walks.values() if _runs_before(story, w.id, walk.id)]
    behind = [w.setback_m + w.body.length_m + body.length_m for w in before]
    walk.setback_m = max(walk.gains_m + least, setback_m(story, walk, strip), *behind)
    told = _spacing(story, walk, meets.id)
    said = story.between(participant.id, meets.id, Measure.LATERAL_OFFSET_M)
    if said is not None and said.at == START:  # it waits so far aside of the other
        left = said.value.middle * (1 if said.participant == participant.id else -1)
        walk.setback_m = max(0.0, (edge - meets.y_m(0.0) - meets.sign * left) * into)
    takes = walk.runs_s(to_aim + walk.setback_m)
    if far is not None:
        walk.stops_after_m = walk.setback_m + far
        if stands:
            takes = walk.rests_s() + STOOD_S
    _time(story, walk, meets, told, takes)
    first = next(iter(story.walks.values()), None)
    if first is not None and crossing.arm in story.functional.junction.crosswalks:
        walk.x_m = first.x_m
    walk.x_m += abreast_m(len(story.walks))
    walk.from_y_m = edge - into * walk.setback_m
    return walk


def _runs_before(story: Story, name: str, other: str) -> bool:
    """``a man runs after the dog``: of two who cross one is said to be ahead of the other."""
    return words_between(story.functional, name, other) == {Approach.AHEAD}


def _meets(story: Story, name: str) -> str:
    """Whose way it crosses: who lets it go first, or should, who suffers it, else the ego."""
    for act in story.functional.acts:
        if act.kind in LETS_BY and act.into == name and act.participant in story.runners:
            return act.participant
    owing = (n for n in story.runners if name in story.endangered_by(n, OWES))
    suffering = (n for n in story.endangered_by(name) if n in story.runners)
    return next(chain(owing, suffering), story.ego.id)


def _time(story: Story, walk: Walk, meets: Runner, told: _Told | None, takes: float) -> None:
    """When it sets off and where its line lies, so that it ``takes`` as long as the other does."""
    half = walk.body.width_m / 2
    when = walk.act.when if walk.act is not None else None
    least_s = _LEAST_LEAD_S if told is None or told.act is None else _TOLD_LEAD_S
    walk.sets_off_s = max(ceil((_MEETS_S - takes) / _LOOK_S) * _LOOK_S, least_s)
    if isinstance(when, AfterStart):
        walk.sets_off_s = when.delay_s.middle
    if told is None:
        arrival, unbraked = walk.sets_off_s + takes, _unbraked(story, meets)
        touched = unbraked.speed_at_mps(arrival) > 0.0 or story.contact_wanted(walk.id, meets.id)
        clear = half if touched else half + BEFORE_WALKER_M  # who stands stays where it is
        walk.x_m = unbraked.x_m(arrival) + meets.towards * (meets.leading_m + clear)
        return
    seen_s = STANDS_MPS / walk.rate_mps2  # until then it still stands, to whoever looks on
    moment = told.at_s if told.act is None else walk.sets_off_s + seen_s
    if told.act is not None and told.act is walk.stop:
        moment += walk.rests_s() if told.since == "end" else walk.slows_s()
    meets = meets if told.act is None else _unbraked(story, meets)
    away = told.value * (1.0 if told.measure is Measure.GAP_M else meets.speed_at_mps(moment))
    apart_m = meets.leading_m + away + half
    if told.act is not None and goes_first(story.functional, meets.id, walk.id):
        apart_m = meets.leading_m - meets.body.length_m - away - half
    walk.x_m = meets.x_m(moment) + meets.towards * apart_m
    if told.act is None and not walk.timed:
        arrival = meets.profile.time_s(abs(meets.x_m(moment) - meets.x_m(0.0)) + away)
        if arrival >= NEVER_S and moment > 0.0:  # it brakes: when it would have been there
            arrival = moment + away / max(meets.speed_at_mps(moment), _SLOW_MPS)
        walk.sets_off_s = max(0.0, arrival - takes) if arrival < NEVER_S else _LEAST_LEAD_S


def _unbraked(story: Story, meets: Runner) -> Runner:
    """Who is met as it drives until it brakes for whom it meets: when is found later."""
    loose = story.loose(meets.steps, meets.speed_mps)
    return replace(meets, steps=[step for step in meets.steps if step is not loose])


def _spacing(story: Story, walk: Walk, other: str) -> _Told | None:
    """The first that is told of the two: what sets it off, or makes it stop, before the rest.

    So is how far the other is then from one who is parked before its line.
    """
    for act in filter(None, (walk.act, walk.stop)):
        if isinstance(act.when, WhenMeasure):
            return _Told(act.when.measure, _to_its_line(story, act.when), act)
    own = {a.id: a for a in (walk.act, walk.stop) if a is not None}
    for said in story.functional.spacings:
        pair = {said.participant, said.reference}
        its = pair == {walk.id, other} and said.since == "begin"
        line = {walk.id, *story.parked}
        then = said.at in own and other in pair and not pair.isdisjoint(line)
        if said.measure in LENGTHWISE and (its or then):
            at_s, away = story.begins_s.get(said.at, 0.0), _to_its_line(story, said)
            return _Told(said.measure, away, own.get(said.at), said.since, at_s)
    for act in (a for a in story.acts if a.participant == other and a.id in story.begins_s):
        when = act.when  # "the ego brakes when it is 20 m away"
        if isinstance(when, WhenMeasure) and walk.id in {when.participant, when.reference}:
            at_s = story.begins_s[act.id]
            return _Told(when.measure, _to_its_line(story, when), None, at_s=at_s)
    return None


def _to_its_line(story: Story, told: Spacing | WhenMeasure) -> float:
    """What is told as it is to the line of who crosses, beyond one who is parked."""
    away = told.value.middle
    for name in {told.participant, told.reference} & story.parked.keys():
        if told.measure is Measure.GAP_M:
            away += story.parked[name].body.length_m + BEFORE_WALKER_M
    return away
