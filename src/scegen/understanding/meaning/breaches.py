"""Rules that are broken: speed limits, the right of way, who came first."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Control, DrivingSide, HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Context

_FROM_THE_SIDE = frozenset({Approach.LEFT, Approach.RIGHT})
_MARGIN = 1.1
_ANYWHERE_MPS = 44.0
"""About 100 mph: too fast wherever there is a limit."""


def onto_the_road(draft: Draft, side: DrivingSide) -> None:
    """Who comes from the side and turns left in front of somebody fails to give way.

    An unprotected left turn is one across oncoming traffic.
    """
    for danger in draft.dangers:
        across = danger.kind is HazardKind.UNPROTECTED_LEFT_TURN and side is DrivingSide.RIGHT
        aside = all(e.approaches and e.approaches <= _FROM_THE_SIDE for e in danger.by)
        if across and danger.by and aside:
            danger.kind = HazardKind.FAILURE_TO_YIELD


def too_fast(draft: Draft, limit_mps: float | None) -> None:
    """``at 60 mph in a 35 mph zone``: speeding, though nobody says the word."""
    allowed = limit_mps * _MARGIN if limit_mps is not None else _ANYWHERE_MPS
    for entity in draft.entities:
        speed, basis = entity.speed, entity.speed_basis
        if not entity.moving_vehicle or speed is None or basis is None:
            continue
        if speed.low >= allowed:
            draft.hazard(HazardKind.SPEEDING, basis, [entity])


_GOING = frozenset({"move", "turn", "enter", "cross", "pull_out", "cut_in", "accelerate", "leave",
                    "sharp_turn", "speed", "breach", "dash"})  # fmt: skip


def out_of_turn(chunks: list[Chunk], events: list[Event], context: Context) -> None:
    """``the ego was at the four-way stop first, but the van goes``: the van had to wait."""
    if context.junction.control is not Control.ALL_WAY_STOP:
        return
    tokens = context.tokens
    at = next((k for k, t in enumerate(tokens) if t.low in word_list("first")), None)
    if at is None or not word_list("still") & {t.low for t in tokens}:
        return
    who = _who(at, chunks)
    for event in events:
        drivers = [e for e in event.doers if e.moving_vehicle]
        goes = event.finite and event.name in _GOING and not (event.negated or event.modal)
        if who and goes and drivers and not any(e in who for e in drivers):
            basis = Basis(event.i, event.j)
            context.draft.hazard(HazardKind.FAILURE_TO_YIELD, basis, drivers, who)
            return


def _who(at: int, chunks: list[Chunk]) -> list[Entity]:
    """Whom "first" is said of: the participant named last before it, outside phrases."""
    named = [c for c in chunks if isinstance(c, Mention) and c.i < at and c.prep is None]
    return list(named[-1].entities) if named else []
