"""Who comes up behind somebody brakes as a driver does, as late as the text leaves it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import ceil, floor

import numpy as np

from scegen.concretization.along.runner import Runner, gap_m
from scegen.concretization.along.spacing import keep_apart
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import BRAKING, CHANGES_MPS, CLOSEST_M, SLOWING, falls_back
from scegen.concretization.braking import (
    Contact,
    answer_each,
    answer_of,
    apart_by,
    brake_late,
    had_ahead,
    last_that,
    touch_s,
)
from scegen.concretization.limits import REACTION_S
from scegen.concretization.profile import SpeedChange
from scegen.motion.following import STANDS_BEHIND_M, Change, brakes, goes_on
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.acts import AfterAct

_LATEST_S = 40.0
_TIMES_S = np.arange(0.0, _LATEST_S, STEP_S)
_TOO_LATE_S = 0.8
"""Who brakes for one it is to hit all the same begins so long before."""
_ROUNDING = 1e-6
_SOFTEST_MPS2 = 0.5
_KEEPS_M = 0.75 * STANDS_BEHIND_M
"""Who follows keeps this free; simulators step, and bends are not as long in every lane."""


def react(story: Story) -> list[tuple[str, str]]:
    """Let everybody brake who would run into somebody; returns those who touch all the same."""
    for runner in story.runners.values():
        _set_aside_loose(story, runner)
        _brake_as_hard_as_needed(story, runner)
    return answer_each(partial(_unwanted, story), partial(_brake_for, story), len(story.runners))


def contacts(story: Story) -> Iterator[Contact]:
    """Who runs into whom when, for every pair that touches."""
    names = list(story.runners)
    tracks = {name: story.track(name, _TIMES_S)[0] for name in names}
    for n, first in enumerate(names):
        for second in names[n + 1 :]:
            if story.runners[first].stands and story.runners[second].stands:
                continue
            time_s = touch_s(_TIMES_S, tracks[first], tracks[second])
            if time_s is not None:
                contact = _running_in(story, Contact(time_s, first, second))
                turned = Contact(time_s, contact.other, contact.who)
                swaps = not _same_way(story, first, second) and brakes_for(story, *turned[1:])
                yield turned if swaps else contact


def _unwanted(story: Story) -> Iterator[Contact]:
    """The contacts that somebody should brake for; whoever is to crash before is halted by it."""
    crashed: dict[str, float] = {}
    for contact in sorted(contacts(story)):
        time_s, who, other = contact
        if story.contact_wanted(who, other):
            crashed = {who: time_s, other: time_s} | crashed
            continue
        answers = _same_way(story, who, other) or brakes_for(story, who, other)
        if answers and who not in crashed:
            yield contact


def _same_way(story: Story, first: str, second: str) -> bool:
    return story.runners[first].forward == story.runners[second].forward


def brakes_for(story: Story, who: str, other: str) -> bool:
    """Whether the braking of one is said to be a danger to the other."""
    return other in story.endangered_by(who, *BRAKING)


def _running_in(story: Story, contact: Contact) -> Contact:
    """The contact as one of who is behind, as the two drove until then.

    Who reverses runs in, unless the other comes faster.
    """
    time_s, first, second = contact
    turned = Contact(time_s, second, first)
    one, other = story.runners[first], story.runners[second]
    if one.backs or other.backs:
        slower = one.speed_at_mps(time_s) < other.speed_at_mps(time_s)
        return turned if slower else contact
    return turned if had_ahead(story, turned)[0] else contact


def _set_aside_loose(story: Story, who: Runner) -> None:
    """Let who would run into somebody ahead without it brake for that one, not just sometime."""
    step = story.loose(who.steps, who.speed_mps)
    if step is None:
        return
    kept = who.steps
    who.steps = [s for s in kept if s is not step]
    own = who.track(_TIMES_S)[0]
    for other in story.runners.values():
        at = None if other is who else touch_s(_TIMES_S, own, other.track(_TIMES_S)[0])
        if at is None or _running_in(story, Contact(at, who.id, other.id)).who != who.id:
            continue
        if story.contact_wanted(who.id, other.id):
            late = max(step.begins_s, at - _TOO_LATE_S)
            who.steps = [*who.steps, replace(step, begins_s=late, reacts_to=other.id)]
            _put_off(story, step.act or "", late - step.begins_s)
        elif _brake_for(story, Contact(at, who.id, other.id), step):
            return
        break
    if step not in who.steps and not any(s.act == step.act for s in who.steps):
        who.steps = [_eased(story, who, s) if s is step else s for s in kept]


def _brake_as_hard_as_needed(story: Story, who: Runner) -> None:
    """Of one whose braking begins as is said, but not how hard: to come near what is ahead."""
    ends = {a.when.act for a in story.acts if isinstance(a.when, AfterAct)}
    for step in who.steps:
        act = story.act(step.act) if step.act is not None else None
        if act is None or act.kind not in SLOWING or act.id in ends or story.is_loose(act.id):
            continue
        if any(each is not None for each in (act.rate_mps2, act.duration_s, act.distance_m)):
            continue
        before, rest = who.steps, [s for s in who.steps if s is not step]
        who.steps = rest
        ahead = [c for c in contacts(story) if c.who == who.id]
        who.steps = before
        if step.hazard is not None or not ahead or story.contact_wanted(*min(ahead)[1:]):
            continue
        contact = min(ahead)

        def leaves(rate: float) -> bool:
            who.steps = [*rest, replace(step, rate_mps2=rate)]  # noqa: B023
            return apart_by(story, contact, _TIMES_S, CLOSEST_M)  # noqa: B023

        hardest = min(who.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
        if leaves(hardest):
            leaves(last_that(leaves, hardest, _SOFTEST_MPS2))
            story.ends_s[act.id] = who.profile.settles_s(step.begins_s)
        else:
            who.steps = before
        return


def _eased(story: Story, who: Runner, step: SpeedChange) -> SpeedChange:
    """One who brakes behind another that is no slower falls back; it does not stop."""
    if step.hazard is not None or not falls_back(story.act(step.act or "")):
        return step
    meanwhile = step.begins_s + REACTION_S
    follows = (
        had_ahead(story, Contact(meanwhile, who.id, other.id))[0]
        for other in story.runners.values()
        if other is not who and not other.stands and _same_way(story, who.id, other.id)
    )
    if not any(follows):
        return step
    return replace(step, target_mps=max(0.0, who.speed_at_mps(step.begins_s) - CHANGES_MPS))


def _brake_for(story: Story, contact: Contact, loose: SpeedChange | None = None) -> bool:
    """Add the latest braking that keeps them apart; whether there is one."""
    who, other = story.runners[contact.who], story.runners[contact.other]
    own = loose or story.loose(who.steps, who.speed_mps)
    if own is None and not story.concern(who.id, other.id) and _follow(story, who, other):
        return True
    before = who.steps
    rest = [s for s in before if s is not own]
    slowest = min([other.speed_mps, *(s.target_mps for s in other.steps)])
    slowest = slowest if other.speed_mps > 0.0 and who.towards == other.towards else 0.0

    most = min(who.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
    answer, rates = answer_of(story, contact, own, slowest, most, thing=other.thing)

    def brake(begins_s: float, rate: float) -> None:
        who.steps = [*rest, replace(answer, begins_s=begins_s, rate_mps2=rate)]

    sees_s = ceil((_sees_s(who, other) + REACTION_S) / STEP_S) * STEP_S
    # Braking before one speeds up by an act of one's own would be undone by it.
    gains = (s.begins_s for s in rest if s.target_mps > who.speed_mps)
    leaves = partial(apart_by, story, contact, _TIMES_S, comes_on=other.backs)
    found = brake_late(leaves, contact.time_s, rates, max(sees_s, *gains, 0.0), brake)
    if found is None:
        who.steps = before
    elif own is not None and own.act is not None:
        _put_off(story, own.act, found[0] - own.begins_s)
    return found is not None


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
    driver, steps, speed = story.driver(who.id), list[SpeedChange](), other.speed_mps
    for step in sorted(other.steps, key=lambda s: s.begins_s):
        ahead = Change(step.begins_s, step.target_mps, step.rate_mps2)
        if step.target_mps < speed:
            gap = gap_m(who, other, step.begins_s)
            found = None if steps else brakes(driver, who.speed_mps, gap, speed, ahead)
        else:
            found = goes_on(driver, who.speed_mps, ahead) if steps else None
        if found is None:
            return False
        begins = floor(found.begins_s / STEP_S + _ROUNDING) * STEP_S
        steps.append(SpeedChange(found.to_mps, found.rate_mps2, begins, reacts_to=other.id))
        speed = step.target_mps
    hardest = min(who.body.max_deceleration_mps2, 0.95 * story.grip_mps2)
    who.steps = steps
    if max(s.rate_mps2 for s in steps) <= hardest and keep_apart(
        who, other, _KEEPS_M, 0.0, _LATEST_S
    ):
        return True
    who.steps = []
    return False


def _sees_s(who: Runner, other: Runner) -> float:
    """When the other becomes a danger: as it slows down, or comes into the lane."""
    moments = [s.begins_s for s in other.steps if s.target_mps < other.speed_mps]
    comes = [m for m in other.moves if m.lane == who.lane and other.forward == who.forward]
    return min([*moments, *(m.begins_s for m in comes or other.moves)], default=other.appears_s)
