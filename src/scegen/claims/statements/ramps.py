"""Who merges does so out of the lane that ends and before its end; who exits leaves by the ramp."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes
from scegen.claims.claim import NEVER, Claim, Judged, always, way_claim
from scegen.claims.series import at
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats
from scegen.road.ramps import gore_m
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Drive
from scegen.scenario.road_parameters import Auxiliary
from scegen.scenario.roadway import AuxiliaryLane
from scegen.scenario.vocabulary import Maneuver


def by_ramp(person: Participant, drive: Drive, field: str) -> Iterator[Claim]:
    """Of one who is said to merge, or to take the exit."""
    name = person.id
    if person.maneuvers == {Maneuver.MERGE}:
        does = f"{name} leaves the lane that ends before its end, and is in it at first"
        test = partial(_merges, drive, in_lane=bool(person.lanes))
        yield way_claim(f"merge.{name}", does, field, test)
    if person.maneuvers == {Maneuver.EXIT}:
        does = f"{name} changes into the exit lane and leaves by the ramp"
        yield way_claim(f"exit.{name}", does, field, partial(_exits, drive))


def _beyond(view: View, drive: Drive) -> tuple[Auxiliary, Floats, Floats] | None:
    """The lane, how far past the joint it is, and how far outside the lanes beside (m)."""
    auxiliary = view.concrete.road.auxiliary
    if auxiliary is None or drive.entry != 0:
        return None
    arm = arms_of(view)[0]
    along, offset = arm.place(boxes(view, drive.participant))
    border = arm.inward * arm.lane_in_m(view.concrete.road.arms[0].lanes_in)
    outside = arm.inward * offset - border - arm.lane_width_m / 2
    return auxiliary, along - arm.length_m, outside


def _merges(drive: Drive, view: View, *, in_lane: bool) -> Judged:
    """How far before the end of its lane it comes over, from the ramp if that is not left yet."""
    found = _beyond(view, drive)
    if found is None or found[0].kind is AuxiliaryLane.OFF_RAMP:
        return always(view, holds=False)
    auxiliary, along, outside = found
    step = (outside < 0.0).argmax(axis=1)
    where = at(along, step)
    margin = np.minimum(where, auxiliary.length_m - where)
    over = (outside[:, 0] > 0.0) & (outside < 0.0).any(axis=1)
    if gore_m(view.concrete.road):
        # It has come down the ramp, or begins in the lane beside the others at the earliest.
        over &= (along[:, 0] < auxiliary.length_m) & ((along[:, 0] > 0.0) | (not in_lane))
    return Judged(np.where(over, margin, -NEVER), where, view.time_of(step))


def _exits(drive: Drive, view: View) -> Judged:
    """How long before the ramp it is in the exit lane; it is on the ramp in the end."""
    found = _beyond(view, drive)
    if found is None or found[0].kind is not AuxiliaryLane.OFF_RAMP:
        return always(view, holds=False)
    auxiliary, along, outside = found
    step = (outside > 0.0).argmax(axis=1)
    where = at(along, step)
    margin = np.minimum(-where, auxiliary.length_m + where)
    last = view.last_step
    left = (outside[:, 0] < 0.0) & (at(outside, last) > 0.0)
    gone = at(along, last)
    return Judged(np.where(left, np.minimum(margin, gone), -NEVER), where, view.time_of(step))
