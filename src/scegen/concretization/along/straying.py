"""Who strays among those who come towards it: when they meet, and how it gets back."""

from collections.abc import Iterator
from functools import partial
from math import copysign

import numpy as np

from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.spacing import first_s, is_level, just_misses, level
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import BRAKING
from scegen.concretization.profile import NEVER_S
from scegen.concretization.tale import at_odds
from scegen.scenario.acts import WhenMeasure
from scegen.scenario.spacings import Spacing

_LONG_BACK_S = 2.5
_CLEAR_BEFORE_S, _CLEAR_AFTER = 0.9, 0.6
"""Who strays has left the way of who comes so long before they are level: after this share of its
change back."""
_ASTRAY_S = 3.8
"""Who goes astray on purpose meets somebody so long after it is there, or would."""
_THERE_S = 0.1
"""Who is hit in the lane of the oncoming has been there so long."""
_STILL_THERE = 0.35
"""The share of a change back after which one is still in the way of who brakes for it."""


def come_back(story: Story) -> None:
    """Who strays into the lane of those who come towards it is back as they meet."""
    for runner in (r for r in story.runners.values() if r.moves and r.moves[-1].lane == 0):
        last = runner.moves[-1]
        time_s, name = min(_meetings(story, runner, last.begins_s), default=(NEVER_S, ""))
        if time_s >= NEVER_S or (last.act is not None and story.goes_round(story.act(last.act))):
            time_s = last.ends_s + _ASTRAY_S
        elif story.contact_wanted(runner.id, name):
            continue
        if story.innermost and name and _dodge(story.runners[name]) is not None:
            continue  # beyond a median it stays there: the other gets out of its way
        back = max(last.ends_s + 0.1, time_s - _CLEAR_BEFORE_S - _CLEAR_AFTER * last.lasts_s)
        lane, offset = max(1, runner.lane), 0.0
        if story.innermost:  # beyond a median, it dodges into the lane beside
            lane, beside = 0, round(abs(runner.offset_m) / runner.lane_width_m) + 1
            beside = beside if beside < story.lane_count else beside - 2
            offset = (1 if not runner.keeps_left else -1) * beside * runner.lane_width_m
        runner.moves.append(Move(back, last.lasts_s, lane, offset, last.act, last.hazard))
    _meet_after(story)


def _meetings(story: Story, runner: Runner, from_s: float) -> Iterator[tuple[float, str]]:
    """When one is level with those who come towards it, and with whom."""
    for other in (r for r in story.runners.values() if r.forward != runner.forward):
        are_level = partial(is_level, runner, other, 0.0)
        moment = first_s(are_level, from_s)
        if are_level(np.array([moment]))[0]:
            yield moment, other.id


def _meet_after(story: Story) -> None:
    """Who comes towards one in its lane meets it when it is back: just then, if that is a danger.

    Those whose place the text gives stay where they are.
    """
    told: list[Spacing | WhenMeasure] = list(story.functional.spacings)
    told += [act.when for act in story.acts if isinstance(act.when, WhenMeasure)]
    said = {name for each in told for name in (each.participant, each.reference)}
    # The ego's own straying counts more than what others do towards it.
    for stray in sorted(story.runners.values(), key=lambda r: r is story.ego):
        half_m, inward = stray.body.width_m / 2, copysign(1.0, stray.lane_y_m(1))
        over = (m for m in stray.moves if m.lane == 0 or inward * stray.y_m(m.ends_s) < half_m)
        out = next(over, None)
        if out is None:
            continue
        there = (0, out.offset_m)
        later = (m for m in stray.moves if m.begins_s > out.begins_s)
        back = next((m for m in later if (min(m.lane, 1), m.offset_m) != there), None)
        free = [r for r in story.runners.values() if not {r.id, stray.id} & said]
        facing = [
            (not at_odds(story.functional, stray.id, r.id), r.at_m or 0.0, r, clears) for r in free
            if r.forward != stray.forward and not r.stands and (clears := back or _dodge(r))
        ]  # fmt: skip
        if not facing:
            continue
        *_, other, clears = min(facing, key=lambda each: (each[0], each[1] * stray.sign))
        moment = _meeting_when_back_s(story, stray, other, out, clears)
        moved, fixed = (stray, other) if other is story.ego else (other, stray)
        shift = level(moved, fixed, moment) - (moved.at_m or 0.0)
        for runner in free:
            if runner.forward == moved.forward:
                runner.at_m = (runner.at_m or 0.0) + shift


def _meeting_when_back_s(
    story: Story, stray: Runner, other: Runner, out: Move, back: Move
) -> float:
    """When the two are level: in its lane if they are to touch, just not if it is a danger.

    One that brakes for it would be level with it there, if it did not. ``back`` may be the move by
    which the other leaves that lane.
    """
    if story.contact_wanted(stray.id, other.id):  # they touch before they are level
        closing = max(stray.speed_at_mps(out.ends_s) + other.speed_at_mps(out.ends_s), 1.0)
        touch_s = (stray.body.length_m + other.body.length_m) / 2 / closing
        return max((out.ends_s + back.begins_s) / 2, out.ends_s + _THERE_S + touch_s)
    if stray.id in story.endangered_by(other.id, *BRAKING):
        return back.begins_s + _STILL_THERE * back.lasts_s
    if at_odds(story.functional, stray.id, other.id):
        goes, meets = (stray, other) if back in stray.moves else (other, stray)
        kept = goes.at_m

        def put(moment_s: float) -> None:
            goes.at_m = level(goes, meets, moment_s)

        found = just_misses((goes, meets), put, back.ends_s + 1.0, back.begins_s)
        goes.at_m = kept
        return found
    return back.ends_s + _LONG_BACK_S


def _dodge(other: Runner) -> Move | None:
    """The move by which one changes lanes for good."""
    return next((m for m in other.moves[-1:] if m.lane not in (0, other.lane)), None)
