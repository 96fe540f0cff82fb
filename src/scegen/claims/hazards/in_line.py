"""How who causes a danger stands to who suffers it, of two in one line; following too closely.

Amounts that the text gives take the place of thresholds; these conditions hold all the same.
"""

import numpy as np

from scegen.claims.boxes import boxes, free_width_m, offset, same_way, seen
from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.series import at, filled, first, greatest, least_lasting
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats

_SAME_WAY = 0.9


def comes_in_ahead(view: View, by: str, to: str, _: Floats) -> Part:
    """Its front is ahead of the other's middle when it comes from beside into that one's way.

    Of those who do not touch one is wholly ahead then. Open where it never comes in, or touches
    the other before.
    """
    touch_s = filled(view.of_pair("contact_s", by, to), np.inf)
    frame, box = boxes(view, to), boxes(view, by)
    beside = free_width_m(frame, box) > 0.0
    inside = ~beside & (same_way(frame, box) > _SAME_WAY)
    comes_in = inside & np.diff(inside, axis=1, prepend=False)
    comes_in &= np.maximum.accumulate(beside, axis=1)
    comes_in &= view.time_of(np.arange(view.steps)) <= (touch_s + view.dt_s)[:, None]
    front, step = greatest(np.where(comes_in, seen(frame, box).front, -np.inf))
    ahead = np.where(front > -np.inf, front, np.inf)
    return at_least("front ahead as it comes in", ahead, limits.AHEAD, view.time_of(step))


def merges_ahead(view: View, by: str, to: str, time_s: Floats) -> Part:
    """The same for one that changes lanes; where roads join, either may come first."""
    if view.ways[by].changes:
        return comes_in_ahead(view, by, to, time_s)
    return at_least("front ahead", np.full(view.count, np.inf), limits.AHEAD, time_s)


def leads(view: View, by: str, to: str, time_s: Floats) -> Part:
    """It does not drive behind the other then."""
    return _not_behind(at(view.gap_m(by, to), view.step_of(time_s)), time_s)


def leads_once(view: View, by: str, to: str, time_s: Floats) -> Part:
    """It does not drive behind the other all the time."""
    return _not_behind(view.gap_m(by, to).min(axis=1), time_s)


def _not_behind(gap_m: Floats, time_s: Floats) -> Part:
    """By how much it is behind; open for two who are not in one line."""
    ahead = np.where(np.isnan(gap_m), np.inf, -gap_m)
    return at_least("not behind the other", ahead, limits.AHEAD, time_s)


def tailgating(view: View, by: str, to: str) -> list[Part]:
    """Keeps less than the least gap of adaptive cruise control, for a second."""
    steps = round(limits.TAILGATING_FOR_S / view.dt_s)
    held, begins = least_lasting(view.headway_s(by, to), steps)
    return [at_most("headway", held, limits.TAILGATING, view.time_of(begins))]


def faces(view: View, by: str, to: str, time_s: Floats) -> Part:
    """Who comes towards it has not gone past yet when it has come over the centre line."""
    frame, box = boxes(view, by), boxes(view, to)
    towards = same_way(frame, box)[:, 0] < -_SAME_WAY
    past = first(offset(frame, box)[0] < 0.0)
    passes = np.where(towards & (past < view.steps), view.time_of(past), np.inf)
    outs = [
        view.reaches_s(by, (change.start_m + change.end_m) / 2)
        for change in view.ways[by].changes
        if change.change.lane_after == 0
    ]
    out = np.min([*outs, np.full(view.count, np.inf)], axis=0)
    left = np.where(np.isfinite(out), passes - np.where(np.isfinite(out), out, 0.0), np.nan)
    return at_least("over the line before the other is past", left, limits.IN_TIME, time_s)


TAILGATING = Predicate(tailgating)
