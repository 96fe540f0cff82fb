"""Who backs straight out stands square to the road, and keeps so."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes
from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.series import greatest
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.scenario.logical import Drive, Reverses

_MOST_DEG = 5.0
_ENDS = 2


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody who does."""
    for drive in told.logical.drives:
        if drive.reverses is Reverses.SQUARE:
            name, test = drive.participant, partial(_square, drive)
            does, field = "backs straight out, square to the road", f"participants.{name}.maneuvers"
            yield Claim(f"square.{name}", ClaimKind.ENTRY, f"{name} {does}", field, "deg", test)


def _square(drive: Drive, view: View) -> Judged:
    """How far it is turned, at most, from heading away from the junction, or from the road.

    Beside a road without a junction it starts off the lane by which it would come in.
    """
    arm, box = arms_of(view)[drive.entry], boxes(view, drive.participant)
    out = -arm.facing(box)
    if len(view.concrete.road.arms) == _ENDS:
        off = arm.inward * arm.place(box)[1][:, :1] > max(arm.edges_m)
        away = arm.inward * (box.sin * arm.cos - box.cos * arm.sin)
        out = np.where(off, away, -1.0)
    turned = np.degrees(np.arccos(np.clip(out, -1.0, 1.0)))
    most, step = greatest(turned)
    return Judged(_MOST_DEG - most, most, view.time_of(step))
