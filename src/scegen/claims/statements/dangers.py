"""Dangers: their predicates, for those who are meant to cause and to suffer them."""

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged
from scegen.claims.hazards.judging import decisive, in_order
from scegen.claims.hazards.sideways import off_lane_s
from scegen.claims.moments import act_begins, speed_runs
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import Told, plain
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools
from scegen.scenario.acts import GAINING, SLOWING, Act, ActKind
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.vocabulary import HazardKind, Maneuver

_CLEARLY = 1.0
"""The margin of what either happens or not: more than a search asks for."""
_OFF_LANE = frozenset({HazardKind.ONCOMING_LANE, HazardKind.SWERVING,
                       HazardKind.LOSS_OF_CONTROL})  # fmt: skip
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE})
_MADE_BY: dict[HazardKind, frozenset[ActKind]] = {
    HazardKind.HARD_BRAKING: SLOWING,
    HazardKind.DELAYED_BRAKING: SLOWING,
    HazardKind.STOPPING: SLOWING,
    HazardKind.SUDDEN_ACCELERATION: GAINING,
    HazardKind.CUT_IN: _ASIDE,
    HazardKind.SWERVING: _ASIDE,
}
"""Acts that make a danger; where the text gives their amounts, these decide, not a threshold."""


def claims(told: Told) -> Iterator[Claim]:
    """One for every danger."""
    for number, hazard in enumerate(told.hazards):
        by = f" by {' and '.join(hazard.by)}" if hazard.by else ""
        to = f" to {' and '.join(hazard.to)}" if hazard.to else ""
        statement, field = f"{plain(hazard.kind)}{by}{to} happens", f"hazards.{hazard.kind}"
        test = partial(_test_of(told, hazard), told, hazard)
        name = claim_id(number, hazard.kind)
        yield Claim(name, ClaimKind.HAZARD, statement, field, "1", test)


def claim_id(number: int, kind: HazardKind) -> str:
    """What the statement of a danger is called, by its place among all dangers."""
    return f"hazard.{number}.{kind}"


def _test_of(told: Told, hazard: Hazard) -> Callable[[Told, Hazard, View], Judged]:
    """What decides: the amounts that the text gives, or else the predicate's thresholds."""
    if hazard.kind in _OFF_LANE:
        return _by_that
    if _measured_out(told, hazard):
        return _as_said
    paced = {p.id for p in told.functional.participants if p.speed_mps is not None}
    if hazard.kind is HazardKind.SLOW_DRIVING and hazard.by and paced >= {*hazard.by}:
        return _slower
    if hazard.kind is HazardKind.STOPPING:
        return _in_time
    hits = all(_struck(told, hazard, by) or told.unresponsive(by) for by in hazard.by)
    return _too_late if hazard.kind is HazardKind.DELAYED_BRAKING and hits else _happens


def _judged_as(told: Told, hazard: Hazard) -> HazardKind:
    """What one who crosses does to those who should let it go first, or stand there.

    After those who do not let it, it comes second, so close behind as two whose ways meet;
    before those who stand it passes as close as by what stands there.
    """
    if ActKind.CROSS not in HAZARDS[hazard.kind].acts or not hazard.to:
        return hazard.kind
    if all(told.functional.participant(to).maneuvers == {Maneuver.STAY} for to in hazard.to):
        return HazardKind.OBSTACLE
    breaches = [h for h in told.hazards if h.kind is HazardKind.FAILURE_TO_YIELD]
    unyielding = {b for h in breaches if {*hazard.by} <= {*h.to} for b in h.by}
    return HazardKind.MERGING_CONFLICT if unyielding >= {*hazard.to} else hazard.kind


def _measured_out(told: Told, hazard: Hazard) -> list[Act]:
    """Acts that make a danger and of which the text says how strong or how near they are."""
    spaced = {s.at for s in told.functional.spacings if s.since == "begin"}
    return [
        act
        for act in (each for name in hazard.by for each in told.acts_of(name))
        if act.kind in _MADE_BY.get(hazard.kind, ())
        and (
            act.rate_mps2 or act.lateral_m or act.lateral_mps or act.duration_s or act.id in spaced
        )
    ]


def _as_said(told: Told, hazard: Hazard, view: View) -> Judged:
    """What is said of it happens, where it endangers somebody: its amounts are other claims."""
    begins = [act_begins(told, act, view) for act in _measured_out(told, hazard)]
    step = np.max(begins, axis=0)
    time_s = view.time_of(np.minimum(step, view.steps - 1))
    margin = np.where(step < view.steps, _CLEARLY, -_CLEARLY)
    return Judged(np.minimum(margin, in_order(view, hazard, time_s)), time_s, time_s)


def _slower(told: Told, hazard: Hazard, view: View) -> Judged:
    """One called slow whose speed is told drives at that speed, more slowly than whom it slows."""
    others = [to for to in hazard.to or (told.ego,) if to not in hazard.by]
    gains = [
        view.speed_mps(to).max(axis=1) - view.speed_mps(by).min(axis=1)
        for by in hazard.by
        for to in others
    ]
    start_s = np.zeros(view.count)
    gain = np.min([*gains, np.full(view.count, np.inf)], axis=0)
    margin = np.where(gain > 0.0, _CLEARLY, -_CLEARLY)
    return Judged(np.minimum(margin, in_order(view, hazard, start_s)), start_s, start_s)


def _happens(told: Told, hazard: Hazard, view: View) -> Judged:
    """Margins are relative to the scale of the weakest condition."""
    doors = {of: door for door, of in told.doors.items() if door in view.index}
    by = tuple(doors.get(name, name) for name in hazard.by)
    kind = _judged_as(told, hazard)
    if (by, kind) != (hazard.by, hazard.kind):
        hazard = hazard.but(by=by, kind=kind)
    margin, time_s = decisive(view, hazard)
    return Judged(margin, margin, time_s)


def _in_time(told: Told, hazard: Hazard, view: View) -> Judged:
    """Who stops and is said to be hit stands by then."""
    stands = _happens(told, hazard, view)
    hits_s = [hit_s(told, view, name) for name in hazard.by]
    early_s = np.min([*hits_s, np.full(view.count, np.inf)], axis=0) + view.dt_s - stands.time_s
    margin = np.where(early_s < 0.0, np.minimum(stands.margin, early_s), stands.margin)
    return Judged(margin, margin, stands.time_s)


def _by_that(told: Told, hazard: Hazard, view: View) -> Judged:
    """Who leaves its lane and hits somebody by that alone does so before it is back."""
    leaves = (_as_said if _measured_out(told, hazard) else _happens)(told, hazard, view)
    margin = leaves.margin
    for by in _culprits_alone(told, hazard):
        hit = hit_s(told, view, by)
        hits_s, during_s = np.minimum(hit, NEVER), np.full(view.count, -NEVER)
        for out_s, back_s in off_lane_s(view, by, hazard.kind):
            within_s = np.minimum(hits_s - out_s, np.minimum(back_s, NEVER) - hits_s)
            during_s = np.maximum(during_s, within_s)
        margin = np.where(np.isfinite(hit), np.minimum(margin, during_s), margin)
    return Judged(margin, margin, leaves.time_s)


def _culprits_alone(told: Told, hazard: Hazard) -> list[str]:
    """Who causes it, and neither that one nor whom it hits does anything else that is dangerous."""
    others = {n for h in told.hazards if h.kind not in _OFF_LANE for n in (*h.by, *h.to)}
    return [by for by in hazard.by if others.isdisjoint({by, *_struck(told, hazard, by)})]


def _struck(told: Told, hazard: Hazard, by: str) -> list[str]:
    """Into whom one who causes it is said to run."""
    return [to for to in hazard.to or (told.ego,) if told.may_touch(by, to)]


def _too_late(told: Told, hazard: Hazard, view: View) -> Judged:
    """Who is said to run into somebody, or not to react, brakes late or has not braked by then."""
    late = _happens(told, hazard, view)
    margin = np.where(_never_brakes(told, hazard, view), np.maximum(late.margin, 0.0), late.margin)
    return Judged(margin, margin, late.time_s)


def _never_brakes(told: Told, hazard: Hazard, view: View) -> Bools:
    """Whether all who cause it do not brake before they run into whom they are said to, if so."""
    never = np.ones(view.count, dtype=np.bool_)
    for by in hazard.by:
        hits = [view.of_pair("contact_s", by, to) for to in _struck(told, hazard, by)]
        hit = np.min([*hits, np.full(view.count, np.inf)], axis=0)
        run = speed_runs(view, by, -1)[0]
        brakes = run.happens & (view.time_of(run.begin) < hit)
        never &= (np.isfinite(hit) | told.unresponsive(by)) & ~brakes
    return never
