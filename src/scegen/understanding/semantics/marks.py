"""What rows note of a participant beside where it comes from and what it does."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.model import Interval
from scegen.understanding.entity import Basis, Entity

Mark: TypeAlias = Callable[[Entity, Basis], None]

_RUNNING = Interval(low=2.2, high=3.8)
"""From Euro NCAP's running adult (8 km/h, AEB VRU protocol) up; the upper end is our own."""
_TOLD = ("was_parked", "moves", "stands", "waits", "bides", "on_ramp", "by_ramp", "roadside",
         "exits", "circulates", "through", "held")  # fmt: skip
"""Fields that hold the first words that say so."""
_TRUE = ("pulls_out", "gives_way", "walks_up", "halts", "begins_over", "goes_back", "gone_by")
_EITHER = {"along": ("course", True), "against": ("course", False),
           "on_minor": ("on_minor", True), "on_major": ("on_minor", False)}  # fmt: skip
"""Fields that hold whether it is so, and the first words that say it."""


def _told(field: str) -> Mark:
    def mark(entity: Entity, basis: Basis) -> None:
        setattr(entity, field, getattr(entity, field) or basis)

    return mark


def first(field: str, value: object) -> Mark:
    """Sets a field to a value with the first words that say so."""

    def mark(entity: Entity, basis: Basis) -> None:
        setattr(entity, field, getattr(entity, field) or (value, basis))

    return mark


def _true(field: str) -> Mark:
    return lambda entity, _: setattr(entity, field, True)


def _parked(entity: Entity, basis: Basis) -> None:
    entity.parked, entity.parked_basis = True, basis


def _sets_off(entity: Entity, basis: Basis) -> None:
    """Whoever is parked and then drives is not parked for the whole scenario."""
    entity.sets_off = max(entity.sets_off, basis.i or 0)
    if entity.parked and not entity.ego:
        entity.was_parked = entity.parked_basis or entity.basis
        entity.parked, entity.parked_basis, entity.pulls_out = False, None, True


def in_the_lane(entity: Entity, basis: Basis) -> None:
    """It stands there from the start, unless it has braked or is parked."""
    if entity.parked or basis in entity.rests:
        return
    entity.stands = entity.stands or basis
    if entity.ego and entity.speed is None:
        entity.speed, entity.speed_basis = Interval(low=0.0, high=0.0), basis


def comes_to_rest(entity: Entity, basis: Basis) -> None:
    """Notes who stands since it has braked."""
    if entity.brakes_from is not None and entity.brakes_from < (basis.i or 0):
        entity.rests.append(basis)


def _stands_aside(entity: Entity, basis: Basis) -> None:
    """``stands on the shoulder``, ``… and pulls out``: parked, all the time or at first."""
    if entity.sets_off < (basis.i or 0):
        if not entity.ego:
            _parked(entity, basis)
    else:
        entity.was_parked, entity.pulls_out = entity.was_parked or basis, True


def _runs(entity: Entity, basis: Basis) -> None:
    if entity.speed is None:
        entity.speed, entity.speed_basis = _RUNNING, basis


def _forgets(entity: Entity, _: Basis) -> None:
    entity.maneuvers = set()


def _parks(entity: Entity, basis: Basis) -> None:
    """Unless the text says before or after that it drives."""
    at = basis.i or 0
    if entity.ego:
        entity.was_parked = entity.was_parked or basis
    if entity.is_vehicle and not entity.ego and entity.sets_off < at:
        _parked(entity, basis)
    entity.pulls_out = entity.pulls_out or entity.sets_off > at


MARKS: dict[str, Mark] = {
    **{field: _told(field) for field in _TOLD},
    **{field: _true(field) for field in _TRUE},
    **{name: first(field, so) for name, (field, so) in _EITHER.items()},
    "parked": _parked,
    "parks": _parks,
    "in_the_lane": in_the_lane,
    "comes_to_rest": comes_to_rest,
    "stands_aside": _stands_aside,
    "sets_off": _sets_off,
    "runs": _runs,
    "forgets": _forgets,
}
"""Mark -> what it sets; ``forgets``: what was said of its way before no longer holds."""
