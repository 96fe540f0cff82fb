"""When an act has ended: a change of speed is over, a stop has been left, a move aside is done.

Who drives backwards has done so once it slows down.
"""

import numpy as np

from scegen.claims.moments import act_begins, act_run, is_level, passed, rest
from scegen.claims.series import at, first
from scegen.claims.sideways import ASIDE_MPS, aside_over, straightened
from scegen.claims.told import Told
from scegen.claims.tolerances import STANDS_MPS
from scegen.claims.view import View
from scegen.motion.batch.arrays import SPEED, Ints
from scegen.scenario.acts import GAINING, LEAVING, SLOWING, Act, ActKind

SWERVES_M = 0.3
"""Less to the side is no swerve."""
_TURNS_BACK_S = 1.0
"""Who swerves out and comes back later than this does so by something else."""


def act_ends(told: Told, act: Act, view: View) -> Ints:
    """The step in which an act has ended; its beginning where it takes no time (c,)."""
    begins = act_begins(told, act, view)
    if act.kind in SLOWING | GAINING:
        run = act_run(told, act, view)
        return np.where(run.happens, run.end, view.steps)
    if act.kind is ActKind.REVERSE:
        back = -view.row(act.participant, SPEED)
        fast = (back > back.max(axis=1, keepdims=True) - STANDS_MPS) & (back > STANDS_MPS)
        last: Ints = np.where(fast, np.arange(view.steps), begins[:, None]).max(axis=1)
        return last
    if act.kind is ActKind.WAIT:
        return rest(told, act, view)[1]
    if act.kind not in LEAVING:
        return begins
    aside = _ends_aside(told, act, begins, view)
    if act.kind is not ActKind.OVERTAKE:
        return aside
    # Who passes in its own lane, or comes back by another act, has done so when it is past.
    acts = told.functional.acts
    later = [a.kind for a in acts[acts.index(act) + 1 :] if a.participant == act.participant]
    there = (aside < view.steps) & (ActKind.CHANGE_LANE not in later)
    return np.where(there, aside, _is_past(told, act, begins, view))


def _is_past(told: Told, act: Act, begins: Ints, view: View) -> Ints:
    """When who has been beside those that it passes is past them all."""
    ends = begins
    for other in passed(told, act, view):
        level, steps = is_level(view, act.participant, other), np.arange(view.steps)
        ends = np.maximum(ends, first(~level & (steps > first(level)[:, None])))
    return ends


def _ends_aside(told: Told, act: Act, begins: Ints, view: View) -> Ints:
    """When a move to the side, once under way, first comes to rest sideways or turns round.

    A swerve is over when it has come to rest sideways for a moment, an overtake when who has gone
    out has come back; if it does, either.
    """
    steps, (moved, speed, sense, over) = np.arange(view.steps), aside_over(told, act, begins, view)
    if act.kind is ActKind.CHANGE_LANE:
        return straightened(view, act.participant, over)
    # A body that straightens up swings back a little: who comes back does so farther.
    comes = sense * (at(moved, over)[:, None] - moved) > SWERVES_M
    back = first(comes & (steps >= over[:, None]))
    there = first((sense * speed >= -ASIDE_MPS) & (steps > back[:, None]))
    either = act.kind is ActKind.OVERTAKE or (back - over) * view.dt_s <= _TURNS_BACK_S
    return np.where((there < view.steps) & either, there, over)
