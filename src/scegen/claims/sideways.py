"""When somebody begins to move sideways, one move after another, and when it no longer does."""

import numpy as np

from scegen.claims.lateral import lateral_m
from scegen.claims.series import at, first
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats, Ints
from scegen.scenario.acts import LEAVING, Act, ActKind
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import Approach, HazardKind, Side

LEAVES_M, HELD_M = 0.01, 0.001
"""Who is so far from its line has left it; the moment is when it was last so near."""
ASIDE_MPS = 0.05
"""Who goes sideways faster than this is on its way to there."""
_GOES_ON_S = 0.8


def sideways_begin(told: Told, act: Act, view: View) -> Ints:
    """When a move to the side begins; one after another of the same, as it turns to its side."""
    drive, acts = told.drive(act.participant), told.functional.acts
    beside = _starts_beside(told, drive)
    leaving = LEAVING - {ActKind.OVERTAKE} if beside else LEAVING
    before_it = acts[: acts.index(act)]
    earlier = [a for a in before_it if a.participant == act.participant and a.kind in leaving]
    if earlier:
        before = sideways_begin(told, earlier[-1], view)
    else:
        before = _last_held(np.abs(lateral_m(view, act.participant, drive)))
        if beside or not _comes_back_by(told, act):
            return before
    moved = lateral_m(view, act.participant, drive)
    speed = np.diff(moved, axis=1, append=moved[:, -1:]) / view.dt_s
    sense = _sense(act) or (-_sense(earlier[-1]) if earlier else 0.0)
    # A body that straightens up swings back for a step: what is a move goes on for a moment.
    soon = max(1, round(_GOES_ON_S / view.dt_s))
    ahead = np.minimum(np.arange(view.steps) + soon, view.steps - 1)
    goes_on = (moved[:, ahead] - moved) / _GOES_ON_S
    there = np.abs(speed) if sense == 0.0 else sense * speed
    under_way = (np.abs(goes_on) if sense == 0.0 else sense * goes_on) > ASIDE_MPS
    steps = np.arange(view.steps)
    since = first((np.abs(speed) > ASIDE_MPS) & (steps >= before[:, None]))
    if earlier and earlier[-1].kind is not ActKind.SWERVE:
        over = aside_over(told, earlier[-1], before, view)[-1]
        late = straightened(view, act.participant, over)
        # Who passes quickly comes back before it has straightened up.
        passing = earlier[-1].kind is ActKind.OVERTAKE
        since = np.where((np.abs(at(speed, late)) > ASIDE_MPS) & passing, since, late)
    # Between two moves to one side it rests for a moment.
    rests = (there <= ASIDE_MPS) & (steps > since[:, None])
    return first(np.maximum.accumulate(rests, axis=1) & (there > ASIDE_MPS) & under_way)


def aside_over(
    told: Told, act: Act, begins: Ints, view: View
) -> tuple[Floats, Floats, Floats, Ints]:
    """Way and speed to the left (c, t), to which side it goes, and when it no longer does so."""
    moved = lateral_m(view, act.participant, told.drive(act.participant))
    steps = np.arange(view.steps)
    speed = np.diff(moved, axis=1, append=moved[:, -1:]) / view.dt_s
    goes = first((np.abs(speed) > ASIDE_MPS) & (steps >= begins[:, None]))
    sense = np.sign(at(speed, goes))[:, None]
    return moved, speed, sense, first((steps > goes[:, None]) & (sense * speed <= ASIDE_MPS))


def straightened(view: View, name: str, over: Ints) -> Ints:
    """When the rear has come as far aside as the middle had when it went no farther (c,)."""
    speed = np.maximum(at(view.speed_mps(name), over), 1.0)
    later = np.ceil(view.body(name).centre_ahead_m / speed / view.dt_s)
    return over + later.astype(np.int64)


def _starts_beside(told: Told, drive: Drive | None) -> bool:
    """Whether it leaves no lane to pass: it drives beside at first, or all whom the ego passes."""
    if drive is None:
        return True
    name, of = drive.participant, told.functional
    whom = of.overtaken(name) if name == told.ego else (name,)
    return bool(whom) and all(Approach.ADJACENT in of.participant(p).approaches for p in whom)


def _comes_back_by(told: Told, act: Act) -> bool:
    """Whether one who overtakes comes back by it, before the one it has passed."""
    return any(
        hazard.kind is HazardKind.OVERTAKING
        and act.participant in hazard.by
        and act.into in hazard.to
        for hazard in told.functional.hazards
    )


def _sense(act: Act) -> float:
    """1 to its own left, -1 to its right, 0 where that is not said."""
    return 0.0 if act.side is None else 1.0 if act.side is Side.LEFT else -1.0


def _last_held(aside_m: Floats) -> Ints:
    """When one who comes so far aside (c, t) was last on its line before; all steps: never (c,)."""
    steps, leaves = aside_m.shape[1], first(aside_m > LEAVES_M)
    held = np.maximum.accumulate(np.where(aside_m < HELD_M, np.arange(steps), 0), axis=1)
    return np.where(leaves < steps, at(held, leaves), steps)
