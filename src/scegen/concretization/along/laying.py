"""Everybody's places: laid backwards from the moments that the text fixes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scegen.claims.boxes import gap_m
from scegen.concretization.along.crossing import Walk, cross
from scegen.concretization.along.moments import perform_waiting, time_what_is_known
from scegen.concretization.along.overtaking import come_back, overtake
from scegen.concretization.along.parked import shift_to_pass, strips_m
from scegen.concretization.along.placing import place_all
from scegen.concretization.along.reactions import contacts, react
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import offset_all
from scegen.concretization.along.story import Story
from scegen.concretization.boxes import apart
from scegen.errors import MotionInfeasibleError

_WIDER = (1.0, 1.3, 1.7, 2.2, 3.0)
_LATER_S, _LATEST_S = 8.0, 80.0
_LOOK_S, _NEARER_M = 0.1, 0.05


def lay(story: Story) -> list[Walk]:
    """Moments, then places, then what follows from places; returns those who go across.

    What is usual is widened until nobody is hit.

    Raises:
        MotionInfeasibleError: an act never comes about, or there is nobody to overtake.
    """
    waiting, following = time_what_is_known(story)
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
        place_all(story, wider=wider)
        never = perform_waiting(story, waiting)
        if never:
            act = never[0]
            raise MotionInfeasibleError(
                f"what sets its act '{act.id}' off never comes about",
                where=act.participant,
                hint="Change the value of its trigger, or the speeds or distances of the two.",
            )
        _rest_as_said(story)
        overtake(story)
        perform_waiting(story, [act for act in following if act.id not in story.begins_s])
        come_back(story)
        touching = react(story)
        walks = cross(story, strips_m(story))
        touching += react(story)
        unwanted = [p for p in touching if not story.contact_wanted(*p)]
        unwanted += [
            (a, b) for _, a, b in contacts(story)
            if not story.contact_wanted(a, b) and (a, b) not in unwanted
        ]  # fmt: skip
        if not unwanted:
            break
    return walks


def _rest_as_said(story: Story) -> None:
    """Who stops so far behind another brakes later where its place leaves it too much room."""
    for spacing in story.functional.spacings:
        pair = spacing.participant, spacing.reference
        if spacing.since == "begin" or not story.runners.keys() >= {*pair}:
            continue
        act = story.act(spacing.at)
        runner = story.runners[act.participant]
        step = next((s for s in runner.steps if s.act == act.id), None)
        if step is None or step.timed or not story.is_loose(act.id):
            continue
        rest = np.array([_LATEST_S])
        one, other = (story.runners[name].track(rest)[0] for name in pair)
        too_far_m = float(gap_m(one, other)[0]) - spacing.value.middle
        late_s = too_far_m / max(runner.speed_at_mps(step.begins_s), 0.1)
        if 0.0 < late_s < _LATER_S and step.target_mps == 0.0:
            later = replace(step, begins_s=step.begins_s + late_s)
            runner.steps = [later if s is step else s for s in runner.steps]
            story.begins_s[act.id] += late_s
            story.ends_s[act.id] += late_s


def closest_s(story: Story, at_least_s: float) -> float:
    """When the last of those who come near the ego is nearest to it, or touches it."""
    latest = at_least_s
    for other in story.runners.values():
        # Who stands or comes towards it is met, however far away it is first.
        met = other.stands or other.forward != story.ego.forward
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
