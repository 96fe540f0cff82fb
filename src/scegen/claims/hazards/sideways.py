"""Dangers that lie in moving sideways: cutting in, swerving, straying, overtaking, fast bends."""

import numpy as np

from scegen.claims.boxes import passes
from scegen.claims.hazards import thresholds as limits
from scegen.claims.hazards.conflict import conflict
from scegen.claims.hazards.driving import braking_part, possible
from scegen.claims.hazards.in_line import comes_in_ahead, faces
from scegen.claims.hazards.predicate import Part, Predicate, at_least, at_most
from scegen.claims.series import chosen, greatest, least
from scegen.claims.view import View
from scegen.claims.ways import Sideways
from scegen.motion.batch.arrays import Floats
from scegen.scenario.vocabulary import HazardKind

_AFTER_S = 1.5


def _lateral_part(view: View, by: str, changes: list[Sideways]) -> Part:
    """Mean lateral speed of its quickest change of lane."""
    found = [(np.zeros(view.count), np.zeros(view.count))]
    for change in changes:
        begin, end = view.reaches_s(by, change.start_m), view.reaches_s(by, change.end_m)
        took = np.where(np.isfinite(end), end, np.inf) - np.where(np.isfinite(end), begin, 0.0)
        found.append((change.width_m / np.maximum(took, view.dt_s), end))
    best, when = chosen(found, np.argmax)
    return at_least("lateral speed", best, limits.LATERAL_SPEED, when)


def _changes(view: View, by: str, kind: HazardKind) -> list[Sideways]:
    """Its lane changes of a danger, or all if none is marked so."""
    changes = list(view.ways[by].changes)
    return [c for c in changes if c.change.hazard is kind] or changes


def off_lane_s(view: View, by: str, kind: HazardKind) -> list[tuple[Floats, Floats]]:
    """From when until when it is out of where it drove, each time that it leaves that (c,)."""
    motion, those = view.ways[by].participant.motion, _changes(view, by, kind)
    here = home = (getattr(motion, "entry_lane", 0), getattr(motion, "offset_m", 0.0))
    spells: list[tuple[Floats, Floats]] = []
    out_s: Floats | None = None
    for change in view.ways[by].changes:
        there = change.change.lane_after, change.change.offset_m
        if change in those and out_s is None:
            home, out_s = here, view.reaches_s(by, change.start_m)
        elif there == home and out_s is not None:
            spells.append((out_s, view.reaches_s(by, change.end_m)))
            out_s = None
        here = there
    return spells if out_s is None else [*spells, (out_s, np.full(view.count, np.inf))]


def cut_in(view: View, by: str, to: str) -> list[Part]:
    """Changes lanes abruptly, and the other is right behind when it arrives.

    One without a change of lane cuts in by turning into the other's way: a conflict.
    """
    changes = _changes(view, by, HazardKind.CUT_IN)
    if not changes:
        return conflict(view, by, to)
    lateral = _lateral_part(view, by, changes)
    headway, time_s = view.headway_s(to, by), view.traces.time_s
    gaps = np.full(view.count, np.inf)
    for change in changes:
        begins = np.searchsorted(time_s, view.reaches_s(by, change.start_m))
        ends_s = view.reaches_s(by, change.end_m) + _AFTER_S
        ends = np.searchsorted(time_s, ends_s, side="right") - 1
        gaps = np.minimum(gaps, least(headway, begins, ends)[0])
    pet = view.of_pair("pet_s", by, to)
    # Where the other's way joins only here, the gap at the merge point is what PET says.
    gaps = np.fmin(gaps, np.abs(pet))
    return [lateral, at_most("gap at the cut-in", gaps, limits.CUT_IN_GAP, lateral.time_s)]


def swerving(view: View, by: str, _: str) -> list[Part]:
    """Leaves its lane quickly."""
    return [_lateral_part(view, by, _changes(view, by, HazardKind.SWERVING))]


def loss_of_control(view: View, by: str, _: str) -> list[Part]:
    """Skids sideways and brakes."""
    changes = _changes(view, by, HazardKind.LOSS_OF_CONTROL)
    return [_lateral_part(view, by, changes), braking_part(view, by, limits.LATE_BRAKING)]


def oncoming_lane(view: View, by: str, _: str) -> list[Part]:
    """Drives beyond the centre line for some time."""
    changes = view.ways[by].changes
    total, when = np.zeros(view.count), np.zeros(view.count)
    end_s = view.place_m(by).shape[1] * view.dt_s
    for n, change in enumerate(changes):
        if change.change.lane_after != 0:
            continue
        out = view.reaches_s(by, (change.start_m + change.end_m) / 2)
        back = np.full(view.count, end_s)
        if n + 1 < len(changes):
            following = changes[n + 1]
            there = view.reaches_s(by, (following.start_m + following.end_m) / 2)
            back = np.minimum(there, end_s)
        total, when = total + np.maximum(back - out, 0.0), out
    return [at_least("time over the centre line", total, limits.ONCOMING, when)]


def overtaking(view: View, by: str, to: str) -> list[Part]:
    """From wholly behind another to wholly ahead of it, on roads side by side."""
    passed, time_s = passes(view, by, to)
    return [at_least("clear of the other", np.maximum(passed, -50.0), limits.PASSES, time_s)]


def sudden_turn(view: View, by: str, _: str) -> list[Part]:
    """Takes its bend faster than is comfortable, or leaves its lane quickly where there is none."""
    aside = [c for c in view.ways[by].changes if c.change.hazard is HazardKind.SUDDEN_TURN]
    if aside:
        return [_lateral_part(view, by, aside)]
    way, place = view.ways[by], view.place_m(by)
    inside = (place >= way.turn_start_m - 1.0) & (place <= way.turn_end_m + 1.0)
    most, step = greatest(np.where(inside, view.lateral_mps2(by), 0.0))
    limit = limits.LATERAL_ACCELERATION
    bound = possible(view, limit)
    return [at_least("lateral acceleration", most, limit, view.time_of(step), bound)]


CUT_IN = Predicate(cut_in, order=comes_in_ahead)
SWERVING = Predicate(swerving, pairwise=False)
LOSS_OF_CONTROL = Predicate(loss_of_control, pairwise=False)
ONCOMING_LANE = Predicate(oncoming_lane, pairwise=False, order=faces)
OVERTAKING = Predicate(overtaking)
SUDDEN_TURN = Predicate(sudden_turn, pairwise=False)
