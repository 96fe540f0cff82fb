"""What a collision leaves: nobody drives on through whom it has hit.

Who hits somebody with its front is halted by the crash; who is hit otherwise, and who hits what is
light, brakes; people on foot and riders fall. There is no rebound, and nobody is pushed: a
stand-in for what players do not compute.
"""

import numpy as np

from scegen.claims.boxes import boxes, contact, free, seen
from scegen.claims.view import View
from scegen.motion.batch.arrays import COS, SIN
from scegen.scenario.concrete import (
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    Motion,
    OnContact,
)

_CRUSHED_M = 0.5
"""So much of a front gives way."""
_MOST_MPS2 = 300.0
_HEAVY = 0.2
"""Of what it hits, the share of both masses that halts it: what is lighter is pushed away."""
_BRAKES_MPS2 = 6.0
_FALLS_S = 0.5
_MOVES_MPS = 0.3
_SCRAPED_M = 0.05
"""So deep one lies against the other's side."""
_SHARPLY = 0.65
"""Between the same acceleration sideways (0.5) and the same speed (1)."""


def halted(concrete: ConcreteScenario, view: View, *, scraping: bool) -> ConcreteScenario:
    """The scenario in which all who touch somebody come to rest from their first contact on.

    What they would do after it is left out. The same one if nobody touches anybody. ``view`` is its
    movement, one candidate. With ``scraping``, one who moves sideways into another goes no farther
    that way.
    """
    met = _first_contacts(view)
    people = []
    changes: list[Change] = []
    first = 0
    for person in concrete.participants:
        count, made = len(person.speed_program), person
        found = met.get(person.id)
        rate = None if found is None else _rate_mps2(concrete, view, person, *found)
        if found is not None and rate is not None:
            fired = view.traces.fired_step[0, first : first + count]
            until = view.step_of(np.array([found[1]]))[0]
            done = int(((fired >= 0) & (fired < until)).sum())
            made = person.but(
                speed_program=person.speed_program[:done],
                on_contact=OnContact(participant=found[0], rate_mps2=rate),
                motion=_stopped_aside(view, person, *found) if scraping else person.motion,
            )
            reason = f"comes to rest where it touches {found[0]}"
            name = f"{person.id}.on_contact.rate_mps2"
            changes.append(Change(parameter=name, by="aftermath", after=rate, reason=reason))
        people.append(made)
        first += count
    return concrete.changed(people, changes) if changes else concrete


def _first_contacts(view: View) -> dict[str, tuple[str, float]]:
    """Whom everybody touches first, and when (s)."""
    met: dict[str, tuple[str, float]] = {}
    for p in view.touching():
        names, time_s = view.names_of(p), float(view.summary.contact_s[0, p])
        for who, other in (names, names[::-1]):
            if time_s < met.get(who, ("", np.inf))[1]:
                met[who] = other, time_s
    return met


def _rate_mps2(
    concrete: ConcreteScenario, view: View, who: ConcreteParticipant, other: str, time_s: float
) -> float | None:
    """How one comes to rest; None if it stands already."""
    step = view.step_of(np.array([time_s]))[0]
    speed = float(view.speed_mps(who.id)[0, step])
    if speed < _MOVES_MPS:
        return None
    if who.body.unprotected:
        return round(max(speed / _FALLS_S, _MOVES_MPS), 3)
    struck = next(entity for entity in concrete.entities if entity.id == other)
    mass_kg = struck.body.mass_kg
    heavy = mass_kg / (mass_kg + who.body.mass_kg) > _HEAVY
    closing = speed - _along_mps(view, who.id, other, int(step))
    if not heavy or closing < _MOVES_MPS or not _with_its_front(view, who.id, other):
        return _BRAKES_MPS2
    crash = closing**2 / (2 * _CRUSHED_M)
    return round(min(max(crash, _BRAKES_MPS2), _MOST_MPS2), 3)


def _stopped_aside(view: View, who: ConcreteParticipant, other: str, time_s: float) -> Motion:
    """Its way, which leads no farther sideways from where its side lies against the other's."""
    motion, laid = who.motion, view.ways[who.id].laid
    if not isinstance(motion, DriveMotion) or laid is None:
        return motion
    own, far = boxes(view, who.id), boxes(view, other)
    aside_m = np.abs(seen(far, own).y[0])
    beside_m = own.half_width + far.half_width - _SCRAPED_M
    against = (aside_m < beside_m) & (view.traces.time_s >= time_s)
    if not against.any():
        return motion
    stations_m = np.array([laid.station_m(float(s)) for s in view.place_m(who.id)[0]])
    here_m = stations_m[against.argmax()]
    width_m = view.concrete.road.arms[motion.entry].lane_width_m
    lane, offset_m = motion.entry_lane, motion.offset_m
    for number, change in enumerate(motion.lane_changes):
        if 0.0 < here_m - change.position_m < change.length_m:
            over_m = change.offset_m - offset_m - (change.lane_after - lane) * width_m
            first_m = float(aside_m[(stations_m >= change.position_m).argmax()])
            if first_m <= beside_m or over_m == 0.0:
                return motion  # it is before the other, not beside it
            part_m = float(np.sign(over_m)) * (first_m - beside_m)
            # About as sharply as before.
            length_m = change.length_m * min(part_m / over_m, 1.0) ** _SHARPLY
            stays = change.but(length_m=length_m, lane_after=lane, offset_m=offset_m + part_m)
            kept = (*motion.lane_changes[:number], stays)
            last = motion.lane_changes[-1].lane_after
            ends = motion.exit_lane if motion.exit_lane != last else lane
            return motion.but(lane_changes=kept, exit_lane=ends)
        lane, offset_m = change.lane_after, change.offset_m
    return motion


def _along_mps(view: View, who: str, other: str, step: int) -> float:
    """The part of the other's velocity that goes its way."""
    cos = view.row(who, COS)[0, step] * view.row(other, COS)[0, step]
    sin = view.row(who, SIN)[0, step] * view.row(other, SIN)[0, step]
    return float((cos + sin) * view.speed_mps(other)[0, step])


def _with_its_front(view: View, who: str, other: str) -> bool:
    """Whether they meet at its front: there their boxes are about to separate, seen from it."""
    touch = contact(view, who, other)
    clear = free(touch.first, touch.second)
    nearest = [float(values[0]) for values in clear]
    return nearest[0] == max(nearest)
