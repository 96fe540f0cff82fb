"""A door is closed until somebody comes, and open when that one is there."""

from collections.abc import Iterator

from scegen.claims import tolerances
from scegen.claims.boxes import box_at, seen
from scegen.claims.claim import Claim, Judged, always, as_wanted
from scegen.claims.moments import act_begins
from scegen.claims.series import first
from scegen.claims.statements.of_an_act import claim_of, when_s
from scegen.claims.statements.spacings import measure_at
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.doors import WAY_M
from scegen.scenario.acts import Act
from scegen.scenario.concrete import door_of
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure

_AJAR_M = 0.05
_OPENS_BEFORE_S = Interval(low=0.0, high=4.0)
"""Whoever is farther away when a door opens has time to look for another way."""


def claims(told: Told, act: Act) -> Iterator[Claim]:
    """Of a door that is opened: when, and that it is open, for everybody who comes to it."""
    coming = {to for h in told.hazards if act.participant in h.by for to in h.to} or {told.ego}
    for name in sorted(coming):
        statement = f"the door of {act.participant} is open when {name} comes to it"
        yield claim_of(told, act, f"open.{name}", statement, "s", _is_open, name)
        if act.when is None:
            statement = f"the door of {act.participant} opens before {name}, shortly before"
            yield claim_of(told, act, f"before.{name}", statement, "s", _shortly_before, name)


def _is_open(_told: Told, act: Act, name: str, view: View) -> Judged:
    """How long it has been open when that one is nearest."""
    door = door_of(act.participant)
    if door not in view.index:
        return always(view, holds=False)
    opened_s = when_s(view, first(view.place_m(door) >= WAY_M - _AJAR_M))
    since = view.of_pair("closest_s", name, door) - opened_s
    return Judged(since + tolerances.TIME_S, since, opened_s)


def _shortly_before(told: Told, act: Act, name: str, view: View) -> Judged:
    """How far away that one still is, in time."""
    door, step = door_of(act.participant), act_begins(told, act, view)
    if door not in view.index:
        return always(view, holds=False)
    away = measure_at(view, Measure.HEADWAY_S, act.participant, name, step)
    follows = seen(box_at(view, name, step), box_at(view, door, step)).x > 0.0
    there = (step < view.steps) & follows
    return as_wanted(away, _OPENS_BEFORE_S, 0.0, when_s(view, step), there=there)
