"""How far apart two are: at the start, when an act begins, at the contact."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims import tolerances
from scegen.claims.arms import arms_of
from scegen.claims.boxes import (
    Boxes,
    box_at,
    boxes,
    contact,
    counting_mps,
    free,
    free_width_m,
    gap_m,
    same_way,
    seen,
)
from scegen.claims.claim import Claim, ClaimKind, Judged, as_wanted, within
from scegen.claims.moments import act_begins, along_whose, comes_to_rest
from scegen.claims.series import at, first
from scegen.claims.statements.act_ends import act_ends
from scegen.claims.told import Told, amount, plain
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats, Ints
from scegen.scenario.acts import SLOWING, Act
from scegen.scenario.concrete import door_of
from scegen.scenario.in_line import is_said_ahead
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START, Measure, Spacing
from scegen.scenario.vocabulary import Side

_COVERED_M = 0.02
_LEAST_MPS, _ALONG = 0.1, 0.5
_FADES_S = 0.3
"""So long a move aside goes on, slower than anybody sees, when it has ended."""


def claims(told: Told) -> Iterator[Claim]:
    """One for every spacing."""
    acts = {act.id: act for act in told.functional.acts}
    for number, spacing in enumerate(told.functional.spacings):
        called, unit, tolerance, scale = tolerances.OF_MEASURE[spacing.measure]
        beside = spacing.measure is Measure.LATERAL_GAP_M
        first = "as they are first level" if beside else "at the start"
        when = {START: first, CONTACT: "at the contact"}.get(spacing.at)
        if when is None:
            act = acts[spacing.at]
            when = f"when {act.participant} begins to {plain(act.kind)}"
            if spacing.since == "end":
                stops = act.kind in SLOWING
                does = "come to rest" if stops else f"ended its {plain(act.kind)}"
                when = f"when {act.participant} has {does}"
        on = f" on the {spacing.side}" if spacing.side else ""
        ahead = _is_ahead(told, spacing)
        who = f"the {called} of {spacing.participant} {_to(spacing, ahead)}"
        statement = f"{who} is {amount(spacing.value)} {unit}{on} {when}"
        test, name = partial(judge_spacing, told, spacing, ahead=ahead), f"spacing.{number}"
        kind, field = ClaimKind.SPACING, f"spacings.{number}"
        yield Claim(name, kind, statement, field, unit, test, tolerance, scale)


def _is_ahead(told: Told, spacing: Spacing) -> bool | None:
    """Whether it is ahead of its reference then, where that is told."""
    if spacing.measure not in LENGTHWISE:
        return None
    who, reference = spacing.participant, spacing.reference
    return is_said_ahead(told.functional, told.hazards, who, reference, spacing.at, spacing.since)


def _to(spacing: Spacing, ahead: bool | None) -> str:
    alone = spacing.participant == spacing.reference
    to = {None: "to", True: "ahead of", False: "behind"}[ahead]
    return "to the middle of its lane" if alone else f"{to} {spacing.reference}"


def _off_its_lane(told: Told, name: str, view: View, step: Ints) -> Floats:
    """How far to its own left of the middle of the lane that it is in (c,).

    Of one who goes across, how far beyond the middle of the road.
    """
    drive, crossing = told.drive(name), told.crossing(name)
    if crossing is not None:
        across = arms_of(view)[crossing.arm]
        beyond = across.place(box_at(view, name, step))[1] - sum(across.edges_m) / 2.0
        return np.asarray(-beyond if crossing.start is Side.LEFT else beyond)
    if drive is None:
        return np.full(view.count, np.nan)
    arm, box = arms_of(view)[drive.entry], box_at(view, name, step)
    left = arm.place(box)[1]
    share = (np.abs(left) - arm.inner_m) / arm.lane_width_m
    off = (np.mod(share, 1.0) - 0.5) * arm.lane_width_m * np.sign(left)
    return np.asarray(off * np.where(arm.facing(box) >= 0.0, 1.0, -1.0))


def judge_spacing(told: Told, spacing: Spacing, view: View, *, ahead: bool | None = None) -> Judged:
    """How far apart two are at the moment that is meant; ``ahead``: which way round, if told."""
    who, reference = spacing.participant, spacing.reference
    tolerance = tolerances.OF_MEASURE[spacing.measure].tolerance
    if spacing.at == CONTACT or _where_it_stands(told, spacing):
        # Where no contact is said, what counts is when they are nearest.
        met = contact(view, reference, who)
        nearest = view.of_pair("closest_s", reference, who)
        step = view.step_of(nearest)
        frame, box = box_at(view, reference, step), box_at(view, who, step)
        touching = measured(spacing.measure, met.first, met.second, spacing.side)
        value = measured(spacing.measure, frame, box, spacing.side)
        value = np.where(met.happens, touching, value)
        there = met.happens | (not told.may_touch(reference, who))
        when = np.where(met.happens, met.time_s, nearest)
        return as_wanted(value, spacing.value, tolerance, when, there=there)
    act = next((act for act in told.functional.acts if act.id == spacing.at), None)
    if act is None:
        step = np.zeros(view.count, dtype=np.int64)
    else:
        step = act_begins(told, act, view)
        if spacing.since == "end" and act.kind not in SLOWING:
            step = act_ends(told, act, view)
        elif spacing.since == "end":
            other = reference if who == act.participant else who
            other = act.participant if told.crossing(act.participant) else other
            step = comes_to_rest(told, act, other, view)
    if who == reference:
        value, there = _off_its_lane(told, who, view, step), step < view.steps
        return as_wanted(value, spacing.value, tolerance, view.time_of(step), there=there)
    value = measure_at(view, spacing.measure, who, reference, step, spacing.side, ahead, act)
    margin = within(value, spacing.value, tolerance)
    if spacing.at != START and spacing.measure is not Measure.LATERAL_GAP_M:
        # Somewhere within the steps between which the act begins, or while it fades out.
        fades = round(_FADES_S / view.dt_s) if spacing.since == "end" else 1
        near = [np.clip(step + k, 0, view.steps - 1) for k in (-1, fades)]
        alike = partial(measure_at, view, spacing.measure, who, reference)
        around = [value, *(alike(k, spacing.side, ahead, act) for k in near)]
        low, high = np.min(around, axis=0), np.max(around, axis=0)
        passes = (low <= spacing.value.high) & (high >= spacing.value.low)
        margin = np.where(passes, np.maximum(margin, tolerance), margin)
    margin = np.where(step < view.steps, margin, np.nan)
    return Judged(margin, value, view.time_of(step))


def _where_it_stands(told: Told, spacing: Spacing) -> bool:
    """Whether it is how far aside of another's line one who goes across comes to rest.

    That is seen as the other comes by: before, its line may be another.
    """
    aside = spacing.measure in {Measure.LATERAL_OFFSET_M, Measure.LATERAL_GAP_M}
    two = spacing.participant != spacing.reference
    stops = (a for a in told.functional.acts if a.kind in SLOWING and a.id == spacing.at)
    across = any(told.crossing(act.participant) for act in stops)
    return aside and two and across and spacing.since == "end"


def measure_at(
    view: View, measure: Measure, who: str, reference: str, step: Ints,
    side: Side | None = None, ahead: bool | None = None, act: Act | None = None,
) -> Floats:  # fmt: skip
    """A measure of somebody to a reference at a step of each candidate (c,).

    One along the road is negative where who is said to be ahead, or not, is not there.
    """
    if measure is Measure.LATERAL_GAP_M:
        # When the two are first level from then on; if never, at that moment.
        frame, box = boxes(view, reference), boxes(view, who)
        since = np.arange(view.steps) >= step[:, None]
        level = first((gap_m(frame, box) < 0.0) & since)
        return at(free_width_m(frame, box), np.where(level < view.steps, level, step))
    if measure in {Measure.LATERAL_OFFSET_M, Measure.OVERLAP_PERCENT}:
        frame, box = box_at(view, reference, step), box_at(view, who, step)
        return measured(measure, frame, box, side)
    # A vehicle whose door opens is as near as its door, which heads across the road.
    doors = [name for name in (door_of(who), door_of(reference)) if name in view.index]
    if doors:
        who, reference, ahead = doors[0], reference if doors[0] == door_of(who) else who, None
    own, other = along_whose(view.concrete.ego.id, who, reference, act)
    frame, box = box_at(view, own, step), box_at(view, other, step)
    clear = free(frame, box)
    gap, along = gap_m(frame, box), same_way(frame, box)
    if ahead is not None:
        there = clear.front if ahead == (other == who) else clear.rear
        gap = np.where(along > -_ALONG, there, gap)
    if measure is Measure.GAP_M:
        return gap
    speed, others = (at(view.speed_mps(name), step) for name in (own, other))
    counts = counting_mps(measure, (frame, speed), (box, others))
    time = gap / np.maximum(counts, _LEAST_MPS)
    return np.where((counts > _LEAST_MPS) | (measure is Measure.HEADWAY_S), time, np.inf)


def measured(measure: Measure, frame: Boxes, box: Boxes, side: Side | None) -> Floats:
    """A measure of two boxes; of those that depend on speed, the gap."""
    if measure is Measure.OVERLAP_PERCENT:
        return overlap_percent(frame, box, side)
    if measure is Measure.LATERAL_OFFSET_M:
        return seen(frame, box).y
    if measure is Measure.LATERAL_GAP_M:
        return free_width_m(frame, box)
    return gap_m(frame, box)


def overlap_percent(frame: Boxes, box: Boxes, side: Side | None) -> Floats:
    """Share of the frame's width that the box covers; all as soon as the narrower is covered.

    On a side, what the box covers must reach that side of the frame.
    """
    place = seen(frame, box)
    half = frame.half_width
    right, left = np.maximum(place.right, -half), np.minimum(place.left, half)
    over = left - right
    narrower = 2.0 * np.minimum(frame.half_width, box.half_width)
    share = np.where(over > narrower - _COVERED_M, 100.0, 100.0 * over / (2.0 * half))
    if side is None:
        return share
    middle = (left + right) / 2.0
    there = middle > 0.0 if side is Side.LEFT else middle < 0.0
    return np.where(there, share, -share)
