"""Who brakes along a road: for whom its braking is that is told, how hard, or as traffic does."""

from dataclasses import replace
from functools import partial
from math import floor, inf

import numpy as np

from scegen.claims.boxes import gap_m
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.spacing import keep_apart
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import (
    CHANGES_MPS,
    CLOSEST_M,
    falls_back,
    goes_on_when_free,
    hardest_mps2,
)
from scegen.concretization.answering import answer, brake_for, last_that
from scegen.concretization.limits import REACTION_S
from scegen.concretization.profile import SpeedChange
from scegen.concretization.tale import at_odds
from scegen.concretization.traffic import Contact, Traffic, had_ahead, leaves_room, runs_first_into
from scegen.motion.following import STANDS_BEHIND_M, Change, brakes, goes_on
from scegen.motion.trigger_steps import STEP_S
from scegen.road.cross_section import CROSSWALK_WIDTH_M
from scegen.scenario.acts import SLOWING, AfterAct

_LATEST_S = 40.0
_TIMES_S = np.arange(0.0, _LATEST_S, STEP_S)
_TOO_LATE_S = 0.8
"""Who brakes for one it is to hit all the same begins so long before."""
_BEFORE_CROSSWALK_M = 0.3
_ROUNDING = 1e-6
_SOFTEST_MPS2, _TOO_SOFT = 0.5, 0.8
_KEEPS_M = 0.75 * STANDS_BEHIND_M
"""Who follows keeps this free; simulators step, and bends are not as long in every lane."""


def react(story: Story) -> None:
    """Let everybody brake who would run into somebody."""
    traffic = traffic_of(story)
    for runner in story.runners.values():
        _set_aside_loose(traffic, story, runner)
        _brake_as_hard_as_needed(traffic, story, runner)
    answer(traffic)


def traffic_of(story: Story) -> Traffic:
    """All who are along the road or go across it."""
    runners = story.runners
    return Traffic(
        tale=story,
        movers={name: runner for name, runner in runners.items() if not runner.stands},
        touchable=[*runners, *story.walks],
        times_s=_TIMES_S,
        track=story.track,
        seen_s=story.seen_s,
        in_line=lambda one, other: runners[one].forward == runners[other].forward,
        backs=frozenset(name for name, runner in runners.items() if runner.backs),
        follows=partial(_follow, story),
        rests_m=partial(_rests_m, story),
        put_off=partial(_put_off, story),
    )


def _rests_m(story: Story, contact: Contact, act: str | None) -> float:
    """As far as is said, or as before the crosswalk on which somebody walks."""
    said = story.rests_at(act)
    if said is not None and {said.participant, said.reference} == {*contact[1:]}:
        return said.value.middle
    marked = story.functional.junction.crosswalks
    walk = story.walks.get(contact.other)
    if walk is None or walk.crossing.arm not in marked:
        return -inf
    return (CROSSWALK_WIDTH_M - walk.body.width_m) / 2 + _BEFORE_CROSSWALK_M


def _without(traffic: Traffic, who: Runner, step: SpeedChange) -> Contact | None:
    """Into whom one runs first if it does not take a step; it is left without."""
    who.steps = [s for s in who.steps if s is not step]
    return runs_first_into(traffic, who.id)


def _set_aside_loose(traffic: Traffic, story: Story, who: Runner) -> None:
    """Let who would run into somebody ahead without it brake for that one, not just sometime."""
    kept = who.steps
    step = story.loose(kept, who.speed_mps)
    if step is None:
        return
    contact = _without(traffic, who, step)
    if contact is not None and story.contact_wanted(who.id, contact.other):
        late = max(step.begins_s, contact.time_s - _TOO_LATE_S)
        who.steps = [*who.steps, replace(step, begins_s=late, reacts_to=contact.other)]
        _put_off(story, step.act or "", late - step.begins_s)
    elif contact is None or not brake_for(traffic, contact, step):
        who.steps = [_eased(traffic, story, who, s) if s is step else s for s in kept]


def _brake_as_hard_as_needed(traffic: Traffic, story: Story, who: Runner) -> None:
    """Of one whose braking begins as is said, but not how hard: near what is ahead, or into it."""
    ends = {a.when.act for a in story.acts if isinstance(a.when, AfterAct)}
    for step in who.steps:
        act = story.act(step.act) if step.act is not None else None
        if act is None or act.kind not in SLOWING or act.id in ends:
            continue
        if story.loose([step], who.speed_mps) is not None:
            continue  # it answers somebody, and begins in time for that
        if any(each is not None for each in (act.rate_mps2, act.duration_s, act.distance_m)):
            continue
        before = who.steps
        contact = _without(traffic, who, step)
        rest, who.steps = who.steps, before
        if step.hazard or contact is None:
            continue

        def leaves(rate: float, contact: Contact = contact, step: SpeedChange = step) -> bool:
            who.steps = [*rest, replace(step, rate_mps2=rate)]  # noqa: B023
            return leaves_room(traffic, contact, CLOSEST_M)

        hardest = hardest_mps2(who.body, story.grip_mps2)
        if story.contact_wanted(*contact[1:]):
            if leaves(step.rate_mps2):
                touches = last_that(lambda rate: not leaves(rate), 0.0, step.rate_mps2)
                leaves(_TOO_SOFT * touches)
        elif leaves(hardest):
            leaves(last_that(leaves, hardest, _SOFTEST_MPS2))
        else:
            who.steps = before
        story.ends_s[act.id] = who.profile.settles_s(step.begins_s)
        return


def _eased(traffic: Traffic, story: Story, who: Runner, step: SpeedChange) -> SpeedChange:
    """One who brakes behind another that is no slower falls back; it does not stop."""
    if step.hazard is not None or not falls_back(story.act(step.act or "")):
        return step
    meanwhile = step.begins_s + REACTION_S
    follows = (
        had_ahead(traffic, Contact(meanwhile, who.id, other.id))[0]
        for other in story.runners.values()
        if other is not who and not other.stands and other.forward == who.forward
    )
    if not any(follows):
        return step
    return replace(step, target_mps=max(0.0, who.speed_at_mps(step.begins_s) - CHANGES_MPS))


def _put_off(story: Story, name: str, by_s: float) -> None:
    """Note that an act happens so much later, and let those that follow upon it do so, too."""
    story.begins_s[name] = story.begins_s.get(name, 0.0) + by_s
    story.ends_s[name] = story.ends_s.get(name, 0.0) + by_s
    for act in story.acts:
        follows = isinstance(act.when, AfterAct) and act.when.act == name
        if follows and not goes_on_when_free(act.when) and act.id in story.begins_s:
            runner = story.runners[act.participant]
            runner.steps = [
                replace(s, begins_s=s.begins_s + by_s) if s.act == act.id else s
                for s in runner.steps
            ]
            _put_off(story, act.id, by_s)


def _follow(story: Story, contact: Contact) -> bool:
    """Let one that nothing is told of follow another, as drivers in traffic do; whether it can."""
    if contact.other not in story.runners or at_odds(story.functional, *contact[1:]):
        return False
    who, other = (story.runners[name] for name in contact[1:])
    alone = not (who.steps or who.moves or other.moves)
    if not alone or not other.steps or other.forward != who.forward:
        return False
    driver, steps, speed = story.driver(who.id), list[SpeedChange](), other.speed_mps
    for step in sorted(other.steps, key=lambda s: s.begins_s):
        ahead = Change(step.begins_s, step.target_mps, step.rate_mps2)
        if step.target_mps < speed:
            at = np.array([step.begins_s])
            gap = float(gap_m(who.track(at)[0], other.track(at)[0])[0])
            found = None if steps else brakes(driver, who.speed_mps, gap, speed, ahead)
        else:
            found = goes_on(driver, who.speed_mps, ahead) if steps else None
        if found is None:
            return False
        begins = floor(found.begins_s / STEP_S + _ROUNDING) * STEP_S
        steps.append(SpeedChange(found.to_mps, found.rate_mps2, begins, reacts_to=other.id))
        speed = step.target_mps
    hardest = hardest_mps2(who.body, story.grip_mps2)
    who.steps = steps
    if max(s.rate_mps2 for s in steps) <= hardest and keep_apart(who, other, _KEEPS_M):
        return True
    who.steps = []
    return False
