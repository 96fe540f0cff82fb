"""How who causes a danger stands to who suffers it, of two in one line; following too closely.

Amounts that the text gives take the place of thresholds; these conditions hold all the same.
"""

import numpy as np

from scegen.claims.boxes import boxes, offset, same_way
from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.series import at, filled, first, least_lasting
from scegen.claims.view import View
from scegen.measures.bodies import body_of
from scegen.measures.boxes import track_box
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.batch.kernels import kernel
from scegen.motion.batch.touching import place_in, reach_in

_SAME_WAY = 0.9


def comes_in_ahead(view: View, by: str, to: str, _: Floats) -> Part:
    """Its front is ahead of the other's middle when it comes from beside into that one's way.

    Of those who do not touch one is wholly ahead then. Open where it never comes in, or touches
    the other before.
    """
    touch_s = filled(view.of_pair("contact_s", by, to), np.inf)
    who = view.index[by], view.index[to]
    front, step = _front_as_it_comes(view.laid, *who, view.scene.bodies, touch_s, view.dt_s)
    ahead = np.where(front > -np.inf, front, np.inf)
    return at_least("front ahead as it comes in", ahead, limits.AHEAD, view.time_of(step))


@kernel
def _front_as_it_comes(
    tracks: Floats, by: int, to: int, bodies: Floats, touch_s: Floats, dt_s: float
) -> tuple[Floats, Ints]:
    """How far its front is ahead of the other's middle, at the most, m, and in which step (c,).

    -inf where it does not come in from beside before they touch.
    """
    farthest, step = np.full(tracks.shape[0], -np.inf), np.zeros(tracks.shape[0], dtype=np.int64)
    own, other = body_of(bodies, by), body_of(bodies, to)
    for c in range(tracks.shape[0]):
        was_beside, was_inside = False, False
        for t in range(tracks.shape[3]):
            if t * dt_s > touch_s[c] + dt_s:
                break
            frame, box = track_box(tracks[c, to], other, t), track_box(tracks[c, by], own, t)
            (x, y), (along, across) = place_in(frame, box), reach_in(frame, box)
            half = frame.half_width
            beside = max(y - across - half, -half - (y + across)) > 0.0
            inside = not beside and frame.cos * box.cos + frame.sin * box.sin > _SAME_WAY
            was_beside = was_beside or beside
            if was_beside and inside and not was_inside and x + along > farthest[c]:
                farthest[c], step[c] = x + along, t
            was_inside = inside
    return farthest, step


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
