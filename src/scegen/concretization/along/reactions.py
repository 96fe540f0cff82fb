"""Who comes up behind somebody brakes as a driver does, as late as the text leaves it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import ceil, floor

import numpy as np

from scegen.claims.boxes import Boxes, free
from scegen.concretization.along.runner import Runner, Step, gap_m
from scegen.concretization.along.story import Story, contact_wanted
from scegen.concretization.amounts import BRAKING, CLOSEST_M, answering_rates_mps2
from scegen.concretization.boxes import apart
from scegen.concretization.limits import REACTION_S
from scegen.motion.following import STANDS_BEHIND_M, Change, brakes, goes_on
from scegen.scenario.acts import AfterAct
from scegen.scenario.vocabulary import HazardKind

_LATEST_S = 40.0
_STEP_S = 0.05
_TIMES_S = np.arange(0.0, _LATEST_S, _STEP_S)
_TOO_LATE_S = 0.8
"""Who brakes for one it is to hit all the same begins so long before."""
_ROUNDS = 12
_ROUNDING, _SOFTER = 1e-6, 0.8
_KEEPS_M = 0.75 * STANDS_BEHIND_M
"""Who follows keeps this free; simulators step, and bends are not as long in every lane."""


def react(story: Story) -> list[tuple[str, str]]:
    """Let everybody brake who would run into somebody; returns the pairs that touch all the same.

    Those nearest to the danger first, so that those behind them answer what they do.
    """
    touching: list[tuple[str, str]] = []
    for runner in story.runners.values():
        _set_aside_loose(story, runner)
    for _ in range(len(story.runners)):
        found = _first_contact(story, touching)
        if found is None:
            break
        who, other, _ = found
        if not _brake_for(story, story.runners[who], story.runners[other]):
            touching.append((who, other))
    return touching


def contacts(story: Story) -> Iterator[tuple[str, str, float]]:
    """(who runs into somebody, into whom, when), for every pair that touches."""
    names = list(story.runners)
    tracks = {name: runner.track(_TIMES_S)[0] for name, runner in story.runners.items()}
    for n, first in enumerate(names):
        for second in names[n + 1 :]:
            a, b = story.runners[first], story.runners[second]
            time_s = None if a.stands and b.stands else _contact_s(tracks[first], tracks[second])
            if time_s is not None:
                who, other = _who_runs_in(a, b, time_s)
                if not _same_way(story, who, other) and brakes_for(story, other, who):
                    who, other = other, who
                yield who, other, time_s


def _first_contact(story: Story, without: list[tuple[str, str]]) -> tuple[str, str, float] | None:
    found = [
        (who, other, at)
        for who, other, at in contacts(story)
        if (who, other) not in without and not contact_wanted(story, who, other)
        and (_same_way(story, who, other) or brakes_for(story, who, other))
    ]  # fmt: skip
    return min(found, key=lambda f: f[2], default=None)


def _same_way(story: Story, first: str, second: str) -> bool:
    return story.runners[first].forward == story.runners[second].forward


def brakes_for(story: Story, who: str, other: str) -> bool:
    """Whether the braking of one is said to be a danger to the other."""
    return any(h.kind in BRAKING and who in h.by and other in h.to for h in story.hazards)


def _contact_s(first: Boxes, second: Boxes) -> float | None:
    """When two touch first."""
    touch = apart(first, second, 0.0) <= 0.0
    return float(_TIMES_S[np.argmax(touch)]) if touch.any() else None


def _who_runs_in(first: Runner, second: Runner, time_s: float) -> tuple[str, str]:
    """Who is behind, as the two drove until then."""
    if first.backs or second.backs:
        return (first.id, second.id) if first.backs else (second.id, first.id)
    before = max(0.0, time_s - 1.0)
    ahead = (first.x_m(before) - second.x_m(before)) * second.sign > 0
    return (second.id, first.id) if ahead else (first.id, second.id)


def _loose_step(story: Story, who: Runner) -> Step | None:
    """The braking of an act of which nothing says when it begins: the answer to who is ahead."""
    for step in who.steps:
        slows = step.act is not None and step.target_mps < who.speed_mps and not step.timed
        if slows and story.is_loose(act := story.act(step.act or "")) and not story.rests_at(act):
            return step
    return None


def _set_aside_loose(story: Story, who: Runner) -> None:
    """Let who would run into somebody ahead without it brake for that one, not just sometime."""
    step = _loose_step(story, who)
    if step is None:
        return
    kept = who.steps
    who.steps = [s for s in kept if s is not step]
    own = who.track(_TIMES_S)[0]
    for other in story.runners.values():
        contact = None if other is who else _contact_s(own, other.track(_TIMES_S)[0])
        if contact is None or _who_runs_in(who, other, contact)[0] != who.id:
            continue
        if contact_wanted(story, who.id, other.id):
            late = max(step.begins_s, contact - _TOO_LATE_S)
            who.steps = [*who.steps, replace(step, begins_s=late, reacts_to=other.id)]
            _put_off(story, step.act or "", late - step.begins_s)
        elif _brake_for(story, who, other, step):
            return
        break
    if step not in who.steps and not any(s.act == step.act for s in who.steps):
        who.steps = kept


def _brake_for(story: Story, who: Runner, other: Runner, loose: Step | None = None) -> bool:
    """Add the latest braking that keeps them apart; whether there is one."""
    own = loose or _loose_step(story, who)
    if own is None and not story.concern(who.id, other.id) and _follow(story, who, other):
        return True
    kinds = [h.kind for h in story.hazards if h.kind in BRAKING and who.id in h.by]
    thing = HazardKind.OBSTACLE if other.thing else None
    hazard = next(iter(kinds), thing)
    rest = [s for s in who.steps if s is not own]
    before = who.steps
    sees_s = ceil((_sees_s(who, other) + REACTION_S) / _STEP_S) * _STEP_S
    rates = _rates_mps2(story, who, own, hard=bool(kinds))
    for rate in rates:
        found = _latest_s(who, other, rest, rate, sees_s, own)
        if found is not None:
            begins = _steps(found) * _STEP_S
            enough = rate
            if len(rates) > 1:
                enough = _just_enough(who, other, rest, begins, rate, own)
            who.steps = [*rest, _braking(begins, enough, who, other, own, hazard)]
            if own is not None and own.act is not None:
                _put_off(story, own.act, begins - own.begins_s)
            return True
    who.steps = before
    return False


def _put_off(story: Story, name: str, by_s: float) -> None:
    """Note that an act happens so much later, and let those that follow upon it do so, too."""
    story.begins_s[name] = story.begins_s.get(name, 0.0) + by_s
    story.ends_s[name] = story.ends_s.get(name, 0.0) + by_s
    for act in story.acts:
        if isinstance(act.when, AfterAct) and act.when.act == name and act.id in story.begins_s:
            runner = story.runners[act.participant]
            runner.steps = [
                replace(s, begins_s=s.begins_s + by_s) if s.act == act.id else s
                for s in runner.steps
            ]
            _put_off(story, act.id, by_s)


def _follow(story: Story, who: Runner, other: Runner) -> bool:
    """Let one that nothing is told of follow another, as drivers in traffic do; whether it can."""
    alone = not (who.steps or who.moves or other.moves)
    if not alone or not other.steps or not _same_way(story, who.id, other.id):
        return False
    driver, steps, speed = story.driver(who.id), list[Step](), other.speed_mps
    for step in sorted(other.steps, key=lambda s: s.begins_s):
        ahead = Change(step.begins_s, step.target_mps, step.rate_mps2)
        if step.target_mps < speed:
            gap = gap_m(who, other, step.begins_s)
            found = None if steps else brakes(driver, who.speed_mps, gap, speed, ahead)
        else:
            found = goes_on(driver, who.speed_mps, ahead) if steps else None
        if found is None:
            return False
        begins = _steps(found.begins_s) * _STEP_S
        steps.append(Step(begins, found.to_mps, found.rate_mps2, reacts_to=other.id))
        speed = step.target_mps
    hardest = min(who.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
    who.steps = steps
    if max(s.rate_mps2 for s in steps) <= hardest and _keeps(who, other, _KEEPS_M):
        return True
    who.steps = []
    return False


def _just_enough(
    who: Runner, other: Runner, rest: list[Step], begins_s: float, rate: float, own: Step | None
) -> float:
    """As hard as leaves the same room, for one that begins in the step of a player before."""
    low, high = rate * _SOFTER, rate
    for _ in range(_ROUNDS):
        middle = (low + high) / 2
        who.steps = [*rest, _braking(begins_s, middle, who, other, own, None)]
        enough = _keeps(who, other, CLOSEST_M, begins_s)
        low, high = (low, middle) if enough else (middle, high)
    return high


def _rates_mps2(story: Story, who: Runner, own: Step | None, *, hard: bool) -> list[float]:
    """How hard it may brake, the usual first; as the text says, if it does."""
    if own is not None and story.act(own.act or "").rate_mps2 is not None:
        return [own.rate_mps2]
    most = min(who.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
    return answering_rates_mps2(most, hard=hard)


def _sees_s(who: Runner, other: Runner) -> float:
    """When the other becomes a danger: as it slows down, or comes into the lane."""
    moments = [s.begins_s for s in other.steps if s.target_mps < other.speed_mps]
    comes = [m for m in other.moves if m.lane == who.lane and other.forward == who.forward]
    return min([*moments, *(m.begins_s for m in comes or other.moves)], default=other.appears_s)


def _braking(
    begins_s: float,
    rate: float,
    who: Runner,
    other: Runner,
    own: Step | None,
    hazard: HazardKind | None,
) -> Step:
    """Down to the other's last speed, or to the one that the text gives; to rest if it comes."""
    slowest = min([other.speed_mps, *(s.target_mps for s in other.steps)])
    slowest = slowest if other.speed_mps > 0.0 and who.forward == other.forward else 0.0
    if own is not None:
        target = min(own.target_mps, slowest)
        return Step(begins_s, target, rate, own.act, own.hazard, reacts_to=other.id)
    return Step(begins_s, slowest, rate, None, hazard, reacts_to=other.id)


def _latest_s(
    who: Runner,
    other: Runner,
    rest: list[Step],
    rate: float,
    earliest_s: float,
    own: Step | None,
) -> float | None:
    """The latest moment at which braking so hard still leaves a little room; None if none does."""

    def keeps(room_m: float, begins_s: float) -> bool:
        step = _braking(begins_s, rate, who, other, own, None)
        who.steps = [*rest, step]
        return _keeps(who, other, room_m, max(earliest_s, 0.0))

    # Braking before one speeds up by an act of one's own would be undone by it.
    gains = (s.begins_s for s in rest if s.target_mps > who.speed_mps)
    low, high = max(earliest_s, *gains, 0.0), _LATEST_S
    if not keeps(CLOSEST_M / 2, low):
        return None
    while _steps(low) < _steps(high):
        middle = (low + high) / 2
        low, high = (middle, high) if keeps(CLOSEST_M, middle) else (low, middle)
    return low


def _steps(time_s: float) -> int:
    """Whole steps until a time."""
    return floor(time_s / _STEP_S + _ROUNDING)


def _keeps(who: Runner, other: Runner, room_m: float, time_s: float = 0.0) -> bool:
    """Whether two have so much free length from a time on while one is in the other's line."""
    times = np.arange(time_s, _LATEST_S, 2 * _STEP_S)
    clear = free(who.track(times)[0], other.track(times)[0])
    gap = np.maximum(clear.front, clear.rear)
    return not np.any((gap < room_m) & (np.maximum(clear.left, clear.right) < 0.0))
