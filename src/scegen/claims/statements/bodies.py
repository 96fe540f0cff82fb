"""Bodies: nobody does what its body and its tyres cannot, nor appears, jumps or stops dead."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import Claim, ClaimKind, Judged, always
from scegen.claims.series import greatest
from scegen.claims.told import Told, plain
from scegen.claims.view import View
from scegen.motion.batch.arrays import HEADING, Floats, Ints, X, Y
from scegen.motion.friction import GRAVITY_MPS2
from scegen.scenario.functional import Participant
from scegen.scenario.vocabulary import ON_FOOT
from scegen.scenario.wording import with_article

HARDEST_MPS2 = 10.0
"""No body of this world brakes harder (1 g), whatever the kind's usual limit is."""
_ROOM = 0.05
_SPEED_ROOM = 0.02
_OVER_S = 0.1
_JUMP_M = 0.05
_ASIDE = 0.9
_WALKS_ASIDE_MPS2 = 20.0
"""Who walks turns on the spot."""


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody who moves."""
    for person in told.people:
        if person.parked and not person.pulls_out:
            continue
        does = f"{person.id} is {with_article(plain(person.kind))} and moves as one can"
        field, test = f"participants.{person.id}.kind", partial(_possible, person)
        name, kind = f"body.{person.id}", ClaimKind.BODY
        yield Claim(name, kind, does, field, "1", test, _ROOM, scale=0.5, fixed=True)


def _possible(person: Participant, view: View) -> Judged:
    """The greatest share of a limit: speed, braking, accelerating, sideways, a jump."""
    if view.concrete.participant(person.id).kind is not person.kind:
        return always(view, holds=False)
    body = view.body(person.id)
    speed = view.speed_mps(person.id)
    change = np.diff(speed, axis=1) / view.dt_s
    hardest = max(body.max_deceleration_mps2, HARDEST_MPS2)
    on_foot = person.kind in ON_FOOT
    aside = _WALKS_ASIDE_MPS2 if on_foot else _ASIDE * view.friction * GRAVITY_MPS2
    series = [
        speed[:, 1:] / (body.top_speed_mps * (1.0 + _SPEED_ROOM)),
        change / body.max_acceleration_mps2,
        -change / hardest,
        _aside(view, person.id, speed) / aside,
        _jumps(view, person.id, speed),
    ]
    inside = np.arange(view.steps - 1) < np.minimum(view.last_step, _crash(person, view))[:, None]
    worst: Floats = np.where(inside, np.max(series, axis=0), 0.0)
    most, step = greatest(worst)
    return Judged(1.0 + _ROOM - most, most, view.time_of(step + 1))


def _crash(person: Participant, view: View) -> Ints:
    """The step from which on a collision moves it, and no body has limits; the last if none."""
    struck = view.concrete.participant(person.id).on_contact
    if struck is None:
        return view.last_step
    time_s = view.of_pair("contact_s", person.id, struck.participant)
    return np.where(np.isfinite(time_s), view.step_of(time_s), view.last_step)


def _aside(view: View, name: str, speed: Floats) -> Floats:
    """Lateral acceleration: speed times rate of turn, over a tenth of a second."""
    heading = view.row(name, HEADING)
    n = max(1, round(_OVER_S / view.dt_s))
    rate = np.zeros_like(speed)
    rate[:, n:] = np.abs(heading[:, n:] - heading[:, :-n]) / (n * view.dt_s)
    return speed[:, 1:] * rate[:, 1:]


def _jumps(view: View, name: str, speed: Floats) -> Floats:
    """How much farther than its speed allows it goes in a step, in shares of what is let pass."""
    x, y = view.row(name, X), view.row(name, Y)
    moved = np.hypot(np.diff(x, axis=1), np.diff(y, axis=1))
    fastest = np.maximum(speed[:, 1:], speed[:, :-1])
    return (moved - fastest * view.dt_s) / _JUMP_M
