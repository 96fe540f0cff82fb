"""What rows note of a participant beside where it comes from and what it does."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.model import Interval
from scegen.understanding.draft import Basis, Entity

_RUNNING = Interval(low=2.2, high=3.8)
"""From Euro NCAP's running adult (8 km/h, AEB VRU protocol) up; the upper end is our own."""


def _pulls_out(entity: Entity, _: Basis) -> None:
    entity.pulls_out = True


def _was_parked(entity: Entity, basis: Basis) -> None:
    entity.was_parked = entity.was_parked or basis


def _parked(entity: Entity, basis: Basis) -> None:
    entity.parked, entity.parked_basis = True, basis


def _moves(entity: Entity, basis: Basis) -> None:
    entity.moves = entity.moves or basis


def _stands(entity: Entity, basis: Basis) -> None:
    entity.stands = entity.stands or basis


def _waits(entity: Entity, basis: Basis) -> None:
    entity.waits = entity.waits or basis


def _gives_way(entity: Entity, _: Basis) -> None:
    entity.gives_way = True


def _begins_over(entity: Entity, _: Basis) -> None:
    entity.begins_over = True


def _goes_back(entity: Entity, _: Basis) -> None:
    entity.goes_back = True


def _by_ramp(entity: Entity, basis: Basis) -> None:
    entity.by_ramp = entity.by_ramp or basis


def _along(entity: Entity, basis: Basis) -> None:
    entity.course = entity.course or (True, basis)


def _against(entity: Entity, basis: Basis) -> None:
    entity.course = entity.course or (False, basis)


def _roadside(entity: Entity, basis: Basis) -> None:
    entity.roadside = entity.roadside or basis


def _walks_up(entity: Entity, _: Basis) -> None:
    entity.walks_up = True


def _halts(entity: Entity, _: Basis) -> None:
    entity.halts = True


def _exits(entity: Entity, basis: Basis) -> None:
    entity.exits = entity.exits or basis


def _circulates(entity: Entity, basis: Basis) -> None:
    entity.circulates = entity.circulates or basis


def _on_minor(entity: Entity, basis: Basis) -> None:
    entity.on_minor = entity.on_minor or (True, basis)


def _on_major(entity: Entity, basis: Basis) -> None:
    entity.on_minor = entity.on_minor or (False, basis)


def _sets_off(entity: Entity, basis: Basis) -> None:
    """Whoever is parked and then drives is not parked for the whole scenario."""
    entity.sets_off = max(entity.sets_off, basis.i or 0)
    if entity.parked and not entity.ego:
        entity.was_parked = entity.parked_basis or entity.basis
        entity.parked, entity.parked_basis, entity.pulls_out = False, None, True


def _runs(entity: Entity, basis: Basis) -> None:
    if entity.speed is None:
        entity.speed, entity.speed_basis = _RUNNING, basis


def _forgets(entity: Entity, _: Basis) -> None:
    entity.maneuvers = set()


def _through(entity: Entity, basis: Basis) -> None:
    entity.through = entity.through or basis


def _parks(entity: Entity, basis: Basis) -> None:
    """Unless the text says before or after that it drives."""
    at = basis.i or 0
    if entity.ego:
        _was_parked(entity, basis)
    if entity.is_vehicle and not entity.ego and entity.sets_off < at:
        _parked(entity, basis)
    entity.pulls_out = entity.pulls_out or entity.sets_off > at


MARKS: dict[str, Callable[[Entity, Basis], None]] = {
    "pulls_out": _pulls_out,
    "was_parked": _was_parked,
    "parked": _parked,
    "parks": _parks,
    "moves": _moves,
    "stands": _stands,
    "waits": _waits,
    "gives_way": _gives_way,
    "through": _through,
    "begins_over": _begins_over,
    "goes_back": _goes_back,
    "by_ramp": _by_ramp,
    "halts": _halts,
    "exits": _exits,
    "along": _along,
    "against": _against,
    "roadside": _roadside,
    "walks_up": _walks_up,
    "circulates": _circulates,
    "on_minor": _on_minor,
    "on_major": _on_major,
    "sets_off": _sets_off,
    "runs": _runs,
    "forgets": _forgets,
}
"""Mark -> what it sets; ``forgets``: what was said of its way before no longer holds."""
