"""What somebody does on its way: turns, changes lane, overtakes, crosses, stands."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes, passes, to_side
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged, as_wanted, best_of, way_claim
from scegen.claims.lateral import lateral_m
from scegen.claims.series import at, first, greatest
from scegen.claims.statements.ramps import by_ramp
from scegen.claims.statements.touching import touched
from scegen.claims.told import KPH, Told, amount, either
from scegen.claims.tolerances import GAP_M, SAME_LANE_M, STANDS_MPS, TIME_S
from scegen.claims.view import View
from scegen.motion.batch.arrays import HEADING, Floats
from scegen.road.cross_section import CROSSWALK_WIDTH_M
from scegen.scenario.acts import LEAVING, LETS_BY, RESTING, ActKind
from scegen.scenario.functional import Participant
from scegen.scenario.hazards import FROM_BESIDE, HAZARDS
from scegen.scenario.logical import Crossing, Drive
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import ON_FOOT, HazardKind, Maneuver, Side

LANE_M = 2.0
"""Who goes so far to the side has changed lane."""
_TURNS_DEG, _BEGUN_DEG, _BACK_DEG = 15.0, 5.0, 140.0
_MOVES_M = 0.5


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody of whom it is said."""
    for person in told.people:
        field = f"participants.{person.id}.maneuvers"
        drive, crossing = told.drive(person.id), told.crossing(person.id)
        if person.pulls_out:
            yield _stands(told, person, pulls_out=True)
            if person.maneuvers == {Maneuver.U_TURN}:
                turned, does = partial(_turns_back, person.id), f"{person.id} turns back"
                yield way_claim(f"turn.{person.id}", does, field, turned, unit="deg")
        elif person.parked or person.maneuvers == {Maneuver.STAY}:
            yield _stands(told, person, pulls_out=False)
        if drive is not None and person.maneuvers:
            yield from _driven(told, drive, field)
            yield from by_ramp(person, drive, field)
        if drive is not None and _keeps_lane(told, drive):
            does = f"{person.id} keeps its lane{'' if told.plain_road else ' up to the junction'}"
            yield way_claim(f"lane.{person.id}", does, field, partial(_stays_in_lane, drive))
        if crossing is None:
            continue
        goes_over = Maneuver.CROSS in person.maneuvers and not _stops(told, person.id)
        if goes_over:
            does = f"{person.id} crosses from one side of the road to the other"
            yield way_claim(f"cross.{person.id}", does, field, partial(_crosses, told, crossing))
        yield from _by_numbers(told, crossing, goes_over=goes_over)
        if crossing.arm in told.functional.junction.crosswalks:
            does, test = f"{person.id} crosses on the crosswalk", partial(_on_crosswalk, crossing)
            yield way_claim(f"crosswalk.{person.id}", does, "junction.crosswalks", test)


def _keeps_lane(told: Told, drive: Drive) -> bool:
    """Whether nothing that is said lets it go sideways, nor somebody who stands in its way."""
    name = drive.participant
    person = told.functional.participant(name)
    moves = drive.changes_to or drive.reverses or drive.maneuver is not drive.turn
    if moves or drive.circulating or person.pulls_out or drive.turn is Maneuver.U_TURN:
        return False
    beside = [h for h in told.hazards if told.plain_road and h.kind in FROM_BESIDE]
    beside += [h for h in told.hazards if LEAVING & {*HAZARDS[h.kind].acts}]
    beside += [h for h in told.hazards if h.kind is HazardKind.SUDDEN_TURN]
    led_around = any(
        h.kind in {HazardKind.OBSTACLE, HazardKind.STOPPING} and name in h.to for h in told.hazards
    ) or any(thing.in_way_of == name for thing in told.functional.objects)
    stands = any(p.parked or p.maneuvers == {Maneuver.STAY} for p in told.people)
    sideways = any(act.kind in LEAVING for act in told.acts_of(name))
    return not (sideways or led_around or stands or any(name in h.by for h in beside))


def _stays_in_lane(drive: Drive, view: View) -> Judged:
    """How far to a side it comes on the arm by which it comes."""
    name = drive.participant
    arm = arms_of(view)[drive.entry]
    # Beyond the junction it may come beside its own arm again.
    there = arm.comes_to(view, name, arm.straight_m)[:, None]
    aside = np.where(np.arange(view.steps) < there, np.abs(lateral_m(view, name, drive)), 0.0)
    most, step = greatest(aside)
    return Judged(SAME_LANE_M - most, most, view.time_of(step))


def _stops(told: Told, name: str) -> bool:
    """Whether it is said to stop on its way."""
    own = told.acts_of(name)
    acts = any(act.kind in RESTING for act in own)
    acts |= any(act.kind is ActKind.CROSS and act.distance_m is not None for act in own)
    return acts or any(h.kind is HazardKind.STOPPING and name in h.by for h in told.hazards)


def _driven(told: Told, drive: Drive, field: str) -> Iterator[Claim]:
    name = drive.participant
    passes = any(h.kind is HazardKind.OVERTAKING and name in h.by for h in told.hazards)
    aside = [act for act in told.acts_of(name) if act.kind in LEAVING]
    stays = told.plain_road and passes and not aside[1:]  # it does not come home
    sides = {act.side for act in aside if act.kind is ActKind.CHANGE_LANE}  # claimed there
    is_act = drive.changes_to in sides if drive.changes_to else bool(sides)
    if drive.maneuver is Maneuver.LANE_CHANGE and (stays or not is_act):
        to = f" to the {drive.changes_to}" if drive.changes_to else ""
        does = f"{name} changes lane{to}{' and stays there' if stays else ''}"
        test = partial(_changes_lane, drive, stays)
        yield way_claim(f"lane_change.{name}", does, field, test)
    elif drive.maneuver is Maneuver.OVERTAKE and not _ended_from_beside(told, name):
        passed = [*told.functional.overtaken(name)]
        things = [t.id for t in told.functional.objects if t.in_way_of == name]
        whom = either(passed or things) if passed or things else "another who goes the same way"
        others = [p.id for p in told.people if p.id != name]
        past = partial(_overtakes, name, passed or [*others, *things])
        yield way_claim(f"overtake.{name}", f"{name} passes {whom}", field, past, fixed=False)
    if drive.turn in {Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN} and drive.reverses is None:
        does = "turns back" if drive.turn is Maneuver.U_TURN else f"turns {drive.turn}"
        held_up = not any(act.kind in LETS_BY for act in told.acts_of(name))
        bends = partial(_turns, drive, held_up)
        yield way_claim(f"turn.{name}", f"{name} {does}", field, bends, unit="deg")


def _ended_from_beside(told: Told, name: str) -> bool:
    """Whether all whom it could pass pull out or open a door before it, which may end it."""
    others = {p.id for p in told.people} - {name}
    coming = {*told.doors.values(), *(p.id for p in told.people if p.pulls_out)}
    return bool(others) and others <= coming


def _turns(drive: Drive, held_up: bool, view: View) -> Judged:
    """The change of heading up to the end; who is held up before it or in it is still to turn."""
    name, last = drive.participant, view.last_step
    turned = _turned_deg(name, view)
    if drive.turn is Maneuver.U_TURN:
        margin = np.abs(turned) - _BACK_DEG
    else:
        margin = (turned if drive.turn is Maneuver.LEFT else -turned) - _TURNS_DEG
    arm = arms_of(view)[drive.entry]
    along, _ = arm.place(boxes(view, name))
    begun = margin > _BEGUN_DEG - _TURNS_DEG
    waits = held_up & (begun | (at(along, last) <= arm.length_m)) & (np.abs(turned) < _TURNS_DEG)
    waits &= at(view.speed_mps(name), last) < STANDS_MPS
    return Judged(np.where(waits, 0.0, margin), turned, view.time_of(last))


def _turned_deg(name: str, view: View) -> Floats:
    heading = view.row(name, HEADING)
    turned: Floats = np.degrees(at(heading, view.last_step) - heading[:, 0])
    return turned


def _turns_back(name: str, view: View) -> Judged:
    turned = _turned_deg(name, view)
    return Judged(np.abs(turned) - _BACK_DEG, turned, view.time_of(view.last_step))


def _changes_lane(drive: Drive, stays: bool, view: View) -> Judged:
    aside = to_side(drive.changes_to, lateral_m(view, drive.participant, drive))
    most, step = (at(aside, view.last_step), view.last_step) if stays else greatest(aside)
    return Judged(most - LANE_M, most, view.time_of(step))


def _overtakes(name: str, others: list[str], view: View) -> Judged:
    """From wholly behind somebody to wholly ahead, side by side on one road."""
    found = [passes(view, name, other) for other in others]
    return best_of(view, [Judged(margin, margin, time_s) for margin, time_s in found])


def _crosses(told: Told, crossing: Crossing, view: View) -> Judged:
    """Beyond the far kerb in the end, unless it has been hit as is said."""
    place, _, far_kerb = _across(crossing, view)
    end = at(place, view.last_step)
    hit = touched(told, view, crossing.participant)
    margin = np.where(hit, np.maximum(end - far_kerb, 0.0), end - far_kerb)
    offset = -end if crossing.start is Side.LEFT else end
    return Judged(margin, offset, view.time_of(view.last_step))


def _across(crossing: Crossing, view: View) -> tuple[Floats, float, float]:
    """How far its middle is across an arm (c, t), the way it goes, and where the kerbs are (m)."""
    arm = arms_of(view)[crossing.arm]
    _, offset = arm.place(boxes(view, crossing.participant))
    right, left = arm.edges_m
    return (-offset, -left, -right) if crossing.start is Side.LEFT else (offset, right, left)


def _by_numbers(told: Told, crossing: Crossing, *, goes_over: bool) -> Iterator[Claim]:
    """How long it takes from kerb to kerb, how far from the kerb it stops: where that is said."""
    name = crossing.participant
    for act in [a for a in told.acts_of(name) if a.kind is ActKind.CROSS]:
        if goes_over and act.duration_s is not None:
            does = f"{name} takes {amount(act.duration_s)} s from kerb to kerb"
            field, test = f"acts.{act.id}.duration_s", partial(_takes, crossing, act.duration_s)
            yield way_claim(f"cross.{name}.takes", does, field, test, unit="s", fixed=False)
        if act.distance_m is not None:
            does = f"{name} stops {amount(act.distance_m)} m from the kerb"
            field, test = f"acts.{act.id}.distance_m", partial(_stops_at, crossing, act.distance_m)
            yield way_claim(f"cross.{name}.stops", does, field, test, fixed=False)


def _stops_at(crossing: Crossing, wanted: Interval, view: View) -> Judged:
    """Where its middle is in the end, from the kerb that it has left; unless it has been hit."""
    place, near_kerb, _ = _across(crossing, view)
    far, last = at(place, view.last_step) - near_kerb, view.last_step
    stands = at(view.speed_mps(crossing.participant), last) <= STANDS_MPS
    return as_wanted(far, wanted, GAP_M, view.time_of(last), there=stands)


def _takes(crossing: Crossing, wanted: Interval, view: View) -> Judged:
    """From when its middle is over one kerb until it is over the other."""
    place, near_kerb, far_kerb = _across(crossing, view)
    begins, ends = first(place > near_kerb), first(place > far_kerb)
    took, there = view.time_of(ends - begins), ends < view.steps
    return as_wanted(took, wanted, 2 * TIME_S, view.time_of(ends), there=there)


def _on_crosswalk(crossing: Crossing, view: View) -> Judged:
    """How far from its middle one is, along the road, while one is between the kerbs."""
    arm = arms_of(view)[crossing.arm]
    box = boxes(view, crossing.participant)
    middle = NEVER if arm.crosswalk_m is None else arm.crosswalk_m
    off = np.where(arm.on_it(box), np.abs(arm.place(box)[0] - middle), 0.0)
    most, step = greatest(off)
    return Judged(CROSSWALK_WIDTH_M / 2 - most, most, view.time_of(step))


def _stands(told: Told, person: Participant, *, pulls_out: bool) -> Claim:
    name = person.id
    until = " until it pulls out" if pulls_out else " all the time"
    where = "is parked" if person.parked else "stands"
    field = "parked" if person.parked else "maneuvers"
    walks = person.kind in ON_FOOT and told.crossing(name) is not None
    test = partial(_pulls_out if pulls_out or walks else _still, name)
    statement, field = f"{name} {where}{until}", f"participants.{name}.{field}"
    return Claim(f"stands.{name}", ClaimKind.STANDS, statement, field, "km/h", test)


def _still(name: str, view: View) -> Judged:
    fastest, step = greatest(view.speed_mps(name))
    return Judged((STANDS_MPS - fastest) * KPH, fastest * KPH, view.time_of(step))


def _pulls_out(name: str, view: View) -> Judged:
    """Stands at first, and moves later."""
    first = view.speed_mps(name)[:, 0]
    gone = view.place_m(name)[:, -1] - view.place_m(name)[:, 0]
    margin = np.where(gone > _MOVES_M, (STANDS_MPS - first) * KPH, -NEVER)
    return Judged(margin, first * KPH, np.zeros(view.count))
