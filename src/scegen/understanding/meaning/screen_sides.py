"""Who is hidden by something, or comes out from behind it, stands on its side of the road."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.semantics.context import Clause, Context

_SIDES = {"left": Approach.LEFT, "right": Approach.RIGHT}
_BESIDE = frozenset({"side", "sidewalk", "shoulder", "leg"})
_HIDING = frozenset({"behind", "between"})


def share(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """Places people and cyclists at the side of what hides them."""
    for clause in clauses:
        event = clause.event
        hides = event.name == "hide" and not event.negated
        for prep in event.pps:
            locus = prep.word.cat == "locus" and (prep.value in _HIDING or prep.outer == "from")
            by = hides and event.passive and prep.value == "by"
            out = context.tokens[prep.word.i].low in {"out", "from", "of"}
            out = out and isinstance(prep.target, Thing)  # "out of a gap in a hedge"
            if locus or by or out:
                _place(prep.target, clause.actors, chunks, context, prep.word.i)
        if hides and not event.passive:
            for hider in event.subject[:1]:
                _place(hider, clause.targets, chunks, context)


def _place(
    hider: NounPhrase | Event | None,
    entities: list[Entity],
    chunks: list[Chunk],
    context: Context,
    begin: int | None = None,
) -> None:
    if not isinstance(hider, NounPhrase):
        return
    sides, end = _sides_of(hider, chunks, context)
    words = Basis(hider.i if begin is None else begin, end)
    for entity in entities:
        on_foot = not entity.is_vehicle or (context.is_cyclist(entity) and not entity.ego)
        known = _standing(entity, context.draft) & set(_SIDES.values())
        if sides and on_foot and not known:
            context.draft.place(entity, None, sides, words)


def _sides_of(
    hider: NounPhrase, chunks: list[Chunk], context: Context
) -> tuple[set[Approach], int]:
    """The side of what hides somebody, and where the words for it end."""
    if isinstance(hider, Mention):
        found = {a for e in hider.entities for a in _standing(e, context.draft)}
        if found == {Approach.OPPOSITE} and not context.junction.crossing:
            found = {Approach(context.across)}
        found &= set(_SIDES.values())
        return (found if len(found) == 1 else set()), hider.j
    own = {_SIDES[d] for d in hider.dirs if d in _SIDES}
    k = next((k for k, c in enumerate(chunks) if c is hider), len(chunks))
    ends = [c.j for c in chunks[k + 1 : k + 3] if isinstance(c, Place) and c.kind in _BESIDE]
    return own, max([hider.j, *ends]) if own else hider.j


def _standing(entity: Entity, draft: Draft) -> set[Approach]:
    """The sides at which a participant stands, as far as said."""
    seen = [p for p in draft.placements if p.entity is entity and p.reference is None]
    return {a for p in seen for a in p.approaches}
