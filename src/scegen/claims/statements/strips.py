"""On which strip beside the lanes somebody stands, drives or walks."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import boxes
from scegen.claims.claim import Claim, ClaimKind, Judged, always
from scegen.claims.series import at, least
from scegen.claims.told import Told, plain
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats
from scegen.road.cross_section import LANE_TYPES
from scegen.scenario.acts import ActKind
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Drive, Reverses
from scegen.scenario.roadway import BAYS, Strip
from scegen.scenario.vocabulary import Maneuver, Side

_STAYS_ON_IT = frozenset({Maneuver.STRAIGHT, Maneuver.STAY})
_LEADS_ALONG = frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.STOP, ActKind.SET_OFF})


def claims(told: Told) -> Iterator[Claim]:
    """One for everybody of whom it is said: all the time, unless something leads it away."""
    for person in told.people:
        if person.strip is None:
            continue
        stays = _stays(told, person)
        when = "" if stays else " at first"
        statement = f"{person.id} is on the strip beside the lanes ({plain(person.strip)}){when}"
        test = partial(_on_it, told, person.id, person.strip, stays=stays)
        name, field = f"strip.{person.id}", f"participants.{person.id}.strip"
        fixed = person.parked
        yield Claim(name, ClaimKind.ENTRY, statement, field, "m", test, fixed=fixed)


def _stays(told: Told, person: Participant) -> bool:
    """Whether nothing that is said of it leads it off the strip."""
    causes = any(person.id in hazard.by for hazard in told.hazards)
    aside = any(act.kind not in _LEADS_ALONG for act in told.acts_of(person.id))
    parked = person.parked and not person.pulls_out
    if person.strip in BAYS and told.drive(person.id) is not None:
        return False  # nobody drives along in a bay
    return parked or not (causes or aside or person.pulls_out or person.maneuvers - _STAYS_ON_IT)


def _on_it(told: Told, name: str, strip: Strip, view: View, *, stays: bool) -> Judged:
    """How far inside the strip its middle is, at worst; beyond its edges it is negative."""
    assignment = told.logical.assignment(name)
    drives = isinstance(assignment, Drive)
    arm = arms_of(view)[assignment.entry if isinstance(assignment, Drive) else assignment.arm]
    band = arm.strips.get(LANE_TYPES[strip])
    if band is None:
        return always(view, holds=False)
    side = getattr(assignment, "side", None)
    sign = arm.inward if drives or side is None else (1 if side is Side.LEFT else -1)
    _, offset = arm.place(boxes(view, name))
    out: Floats = sign * offset
    inside = np.minimum(out - band[0], band[1] - out)
    if isinstance(assignment, Drive) and assignment.reverses is Reverses.SQUARE:
        inside = out - band[0]  # a bay square to the road is as deep as that takes
    worst, step = least(inside, until=view.last_step if stays else np.zeros_like(view.last_step))
    return Judged(worst, at(out, step), view.time_of(step))
