"""Ways that are ruled out: "none of them may turn left"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.semantics import ways
from scegen.understanding.semantics.context import Clause, Context

_WAYS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT})


def rule_out(clause: Clause, context: Context) -> bool:
    """``none of them may turn left``: whichever other way they go.

    Args:
        clause: a movement that does not take place.
        context: the scenario in the making.

    Returns:
        Whether some way is ruled out.
    """
    event = clause.event
    if event.name not in {"turn", "move", "u_turn", "leave"}:
        return False
    said = (
        {Maneuver.U_TURN} if event.name == "u_turn" else set(ways.directions(event, context.tokens))
    )
    said = said or ({Maneuver.LEFT, Maneuver.RIGHT} if event.name == "turn" else set())
    for entity in clause.drivers if said else []:
        entity.excluded |= said
        entity.excluded_basis = Basis(event.i, event.j)
    return bool(said)


def ways_left(entity: Entity) -> set[Maneuver]:
    """The ways over a junction that are not ruled out; empty where nothing is said.

    Args:
        entity: a participant.
    """
    if not entity.excluded & _WAYS or not entity.is_vehicle:
        return set()
    return set(_WAYS - entity.excluded)
