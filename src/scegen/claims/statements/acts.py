"""Acts: that they happen, in order, to which side; the rest of them stands beside."""

from collections.abc import Iterator

import numpy as np

from scegen.claims import tolerances
from scegen.claims.boxes import boxes, gap_m, offset, to_side
from scegen.claims.claim import NEVER, Claim, Judged, best_of
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import act_begins, passed
from scegen.claims.series import at, greatest, least
from scegen.claims.sideways import sideways_begin
from scegen.claims.statements import act_amounts, act_triggers, doors
from scegen.claims.statements.act_ends import SWERVES_M
from scegen.claims.statements.maneuvers import LANE_M
from scegen.claims.statements.of_an_act import claim_of, hits, when_s
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import KPH, Told
from scegen.claims.view import View
from scegen.scenario.acts import LEAVING, Act, ActKind, AfterAct
from scegen.scenario.verbs import does
from scegen.scenario.vocabulary import Side

_BESIDE_M = 0.5


def claims(told: Told) -> Iterator[Claim]:
    """Of every act: that it happens, each of its amounts, what sets it off."""
    for act in told.functional.acts:
        if act.kind is ActKind.GIVE_WAY:
            continue  # whom it lets go first is a claim of its own
        yield from _in_order(told, act)
        yield claim_of(told, act, "", f"{act.participant} {does(act.kind)}", "s", _happens)
        if act.kind in LEAVING:
            yield from _to_a_side(told, act)
        if act.kind is ActKind.WAIT:
            yield claim_of(told, act, "rest", f"{act.participant} comes to rest", "km/h", _rests)
        yield from act_amounts.claims(told, act)
        if act.kind in LEAVING and act.into is not None:
            where, test = "into the lane of", _into
            if act.kind is ActKind.OVERTAKE:
                where, test = "up beside", _beside
            statement = f"{act.participant} comes {where} {act.into}"
            yield claim_of(told, act, "into", statement, "m", test)
        if act.kind is ActKind.OPEN_DOOR:
            yield from doors.claims(told, act)
        yield from act_triggers.claims(told, act)


def _in_order(told: Told, act: Act) -> Iterator[Claim]:
    """What one does comes in the order of the text, where no moments are given."""
    own = [a for a in told.acts_of(act.participant) if a.kind is not ActKind.GIVE_WAY]
    before = own[own.index(act) - 1] if own.index(act) else None
    if before is None or isinstance(act.when, AfterAct) or before.when is not None:
        return
    statement = f"{act.participant} {does(before.kind)} first, and then {does(act.kind)}"
    tolerance = tolerances.TIME_S
    yield claim_of(told, act, "order", statement, "s", _follows, before, tolerance=tolerance)


def _follows(told: Told, act: Act, before: Act, view: View) -> Judged:
    """How much later the second begins."""
    first_s, then_s = (when_s(view, act_begins(told, each, view)) for each in (before, act))
    return Judged(then_s - first_s + tolerances.TIME_S, then_s - first_s, then_s)


def _happens(told: Told, act: Act, view: View) -> Judged:
    """Within the time that is played; whom a contact brings to rest does not brake."""
    time_s, last_s = when_s(view, act_begins(told, act, view)), view.time_of(view.last_step)
    if act.kind is ActKind.BRAKE:
        last_s = np.minimum(last_s, hit_s(told, view, act.participant) - view.dt_s)
    return Judged(last_s - time_s, time_s, time_s)


def _rests(told: Told, act: Act, view: View) -> Judged:
    """How slow it becomes once it has begun to slow down."""
    slowest, step = least(view.speed_mps(act.participant), since=act_begins(told, act, view))
    return Judged((tolerances.STANDS_MPS - slowest) * KPH, slowest * KPH, view.time_of(step))


def _to_a_side(told: Told, act: Act) -> Iterator[Claim]:
    """To which side it goes, or passes."""
    name = act.participant
    if act.kind is not ActKind.OVERTAKE:
        far = LANE_M if act.kind is ActKind.CHANGE_LANE else SWERVES_M
        to = f" to the {act.side}" if act.side else ""
        yield claim_of(told, act, "side", f"{name} {does(act.kind)}{to}", "m", _aside, far)
    elif (side := _passing_side(told, act)) is not None:
        passes = f"{name} passes on the {side}"
        yield claim_of(told, act, "side", passes, "m", _passes_there, side)


def _passing_side(told: Told, act: Act) -> Side | None:
    """On which side one passes, where that is said or the one passed goes aside, too."""
    aside = {a.participant for a in told.functional.acts if a.kind in LEAVING}
    usual = told.functional.junction.kerb.opposite
    whom = {act.into, *told.functional.overtaken(act.participant)}
    return act.side or (usual if whom & (aside - {act.participant}) else None)


def _aside(told: Told, act: Act, far: float, view: View) -> Judged:
    """How far it comes to that side from where the act begins."""
    aside = lateral_m(view, act.participant, told.drive(act.participant))
    begins = sideways_begin(told, act, view)
    most, step = greatest(to_side(act.side, aside - at(aside, begins)[:, None]), since=begins)
    # Who hits the one beside it comes no farther.
    far_m = np.where(hits(told, act, view), min(far, SWERVES_M), far)
    return Judged(most - far_m, most, view.time_of(step))


def _passes_there(told: Told, act: Act, side: Side, view: View) -> Judged:
    """On which side of the one passed it is while they are level, its centre beside theirs."""
    passes = []
    for other in passed(told, act, view):
        own, frame = boxes(view, act.participant), boxes(view, other)
        ahead, left = offset(frame, own)
        level = np.abs(ahead) < frame.half_length + own.half_length
        beside, step = least(np.where(level, to_side(side, left), NEVER))
        beside = np.where(level.any(axis=1), beside, -NEVER)
        passes.append(Judged(beside - _BESIDE_M, beside, view.time_of(step)))
    return best_of(view, passes)


def _into(told: Told, act: Act, view: View) -> Judged:
    """After it has begun to move sideways, its centre comes into the other's lane."""
    away = np.abs(offset(boxes(view, act.into or told.ego), boxes(view, act.participant))[1])
    nearest, step = least(away, since=act_begins(told, act, view))
    margin = tolerances.SAME_LANE_M - nearest
    margin = np.where(hits(told, act, view), np.maximum(margin, 0.0), margin)
    return Judged(margin, nearest, view.time_of(step))


def _beside(told: Told, act: Act, view: View) -> Judged:
    """How far it is from being level, along the road, at the least; a contact may come before."""
    away = gap_m(boxes(view, act.into or told.ego), boxes(view, act.participant))
    nearest, step = least(away)
    margin = np.where(hits(told, act, view), np.maximum(-nearest, 0.0), -nearest)
    return Judged(margin, nearest, view.time_of(step))
