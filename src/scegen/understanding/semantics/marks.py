"""What rows note of a participant beside where it comes from and what it does."""

from __future__ import annotations

from collections.abc import Callable

from scegen.understanding.draft import Basis, Entity


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


def _by_ramp(entity: Entity, basis: Basis) -> None:
    entity.by_ramp = entity.by_ramp or basis


def _walks_up(entity: Entity, _: Basis) -> None:
    entity.walks_up = True


def _exits(entity: Entity, basis: Basis) -> None:
    entity.exits = entity.exits or basis


def _forgets(entity: Entity, _: Basis) -> None:
    entity.maneuvers = set()


def _on_straight(entity: Entity, _: Basis) -> None:
    entity.on_straight = True


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
    "on_straight": _on_straight,
    "through": _through,
    "by_ramp": _by_ramp,
    "exits": _exits,
    "walks_up": _walks_up,
    "forgets": _forgets,
}
"""Mark -> what it sets; ``forgets``: what was said of its way before no longer holds."""
