"""Nobody: subjects that deny their verb of everybody, and ways that are ruled out."""

from __future__ import annotations

from scegen.scenario.vocabulary import Maneuver, ParticipantKind
from scegen.understanding import ways
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.context import Scene
from scegen.understanding.draft import Basis, Draft, Entity

_OWED = frozenset({"yield", "stop", "brake", "slow", "wait", "turn", "move", "u_turn", "obey",
                   "inert", "leave"})  # fmt: skip
"""What is told of everybody when nobody does it."""
_KINDS = {kind.value: kind for kind in ParticipantKind}
_WAYS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.STRAIGHT})


def deny_of_everybody(events: list[Event]) -> None:
    """``no driver gives way``, ``nobody may turn left``: everybody does not.

    Args:
        events: the events of the text; mentions not yet resolved.
    """
    for event in events:
        named = [m for m in event.subject if m.negated or m.pronoun in {"nobody", "everybody"}]
        verbal = not event.nominal and event.name in _OWED
        if not named or not verbal or event.form == "ing":
            continue
        event.negated = True
        for mention in named:
            mention.negated, mention.pronoun = False, "everybody"


def everybody(mention: Mention, draft: Draft) -> list[Entity]:
    """Of whom "no driver", "no car" or "nobody" is said.

    Args:
        mention: the subject.
        draft: the scenario in the making.
    """
    kinds = [_KINDS[h.value] for h in mention.heads if h.value in _KINDS]
    movers = [e for e in draft.entities if e.moving_vehicle]
    if not kinds or kinds == [ParticipantKind.CAR]:
        return movers
    return [e for e in draft.entities if e.kind in kinds and not e.parked]


def rule_out(scene: Scene) -> bool:
    """``none of them may turn left``: whichever other way they go.

    Args:
        scene: a movement that does not take place.

    Returns:
        Whether some way is ruled out.
    """
    event = scene.event
    if event.name not in {"turn", "move", "u_turn", "leave"}:
        return False
    said = {Maneuver.U_TURN} if event.name == "u_turn" else set(ways.directions(event))
    said = said or ({Maneuver.LEFT, Maneuver.RIGHT} if event.name == "turn" else set())
    for entity in scene.drivers if said else []:
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
