"""Who goes at an all-way stop although somebody else came first."""

from __future__ import annotations

from scegen.scenario.vocabulary import Control, HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Context

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
