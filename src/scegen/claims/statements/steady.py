"""Nobody gains speed that nothing asks for: who drives on is never faster than at first.

Who meets the ego may: it waits for the ego at a lower speed, so that the danger stays one for an
ego that comes earlier or later.
"""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import Claim, Judged
from scegen.claims.moments import STANDS_MPS
from scegen.claims.series import greatest
from scegen.claims.statements.speeds import SPEED_CHANGES, speed_claim
from scegen.claims.told import KPH, Told
from scegen.claims.tolerances import SPEED_MPS
from scegen.claims.view import View
from scegen.scenario.acts import GAINING, ActKind
from scegen.scenario.functional import Participant
from scegen.scenario.logical import Drive
from scegen.scenario.vocabulary import JunctionKind, Maneuver

_REASONS = GAINING | {ActKind.OVERTAKE, ActKind.REVERSE, ActKind.TURN}
"""Acts of one who may be faster than at first afterwards."""
_GAINING = {kind for kind, sense in SPEED_CHANGES.items() if sense > 0}
_GOING_ON = (Maneuver.STRAIGHT, Maneuver.LANE_CHANGE)


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody who drives straight on, or changes lanes, and has no reason to gain speed."""
    meets = told.concerned_by(told.ego)
    for person in [p for p in told.people if p.id not in meets]:
        drive = told.drive(person.id)
        if drive is None or person.parked or _has_reason(told, person, drive):
            continue
        name, test = f"steady.{person.id}", partial(_never_faster, person.id)
        does = f"{person.id} is never faster than at first"
        yield speed_claim(name, does, f"participants.{person.id}", test)


def _has_reason(told: Told, person: Participant, drive: Drive) -> bool:
    """Whether it turns, passes somebody, merges from a ramp, sets off, or is to speed up."""
    goes_on = drive.turn is Maneuver.STRAIGHT and drive.maneuver in _GOING_ON
    ring = told.functional.junction.kind is JunctionKind.ROUNDABOUT
    merges = Maneuver.MERGE in person.maneuvers
    if ring or merges or not goes_on or drive.reverses is not None:
        return True
    acts = {act.kind for act in told.acts_of(person.id)}
    gains = any(person.id in hazard.by and hazard.kind in _GAINING for hazard in told.hazards)
    return bool(acts & _REASONS) or gains


def _never_faster(name: str, view: View) -> Judged:
    """Who stands at first is not judged."""
    speed = view.speed_mps(name)
    fastest, step = greatest(speed)
    gained = np.where(speed[:, 0] > STANDS_MPS, fastest - speed[:, 0], 0.0)
    return Judged((SPEED_MPS - gained) * KPH, gained * KPH, view.time_of(step))
