"""Getting past what stands in the way, by the other half of the road.

It is said in many ways: by verbs ("borrows the oncoming lane", "is pushed over the centre line"),
by nouns ("its way round the van", "the detour leads over the solid line"), or only by where the
ego is ("half in the opposite lane"). What they share is a way round something, or a place on the
other half of the road, and something that makes the ego go there.
"""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing, Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_THERE = frozenset({"in", "into", "to", "for"})
_MOVED = frozenset({"cause", "send", "prevent"})
_SETTLED = frozenset(
    {Maneuver.OVERTAKE, Maneuver.LANE_CHANGE, Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN}
)
_IN_THE_WAY = frozenset({HazardKind.OBSTACLE, HazardKind.STOPPING, HazardKind.SLOW_DRIVING})
_PASSING = frozenset({"bypass", "overtake", "block"})
_REASON = "the oncoming lane is used to get past something"


def get_past(chunks: list[Chunk], clauses: list[Clause], context: Context) -> None:
    """Lets the ego overtake what is in its way, where its way leads round it."""
    ego = next((e for e in context.draft.entities if e.ego), None)
    if ego is None or ego.maneuvers & _SETTLED or context.junction.crossing:
        return
    if not _barred(chunks, clauses, context):
        return
    across = [d for d in context.draft.dangers if d.kind is HazardKind.ONCOMING_LANE]
    words = next((d.basis for d in across if ego in d.by), None)
    words = words or _by_verb(ego, clauses, context) or _by_noun(ego, chunks, clauses, context)
    if words is not None:
        context.draft.maneuver(ego, {Maneuver.OVERTAKE}, Basis(words.i, words.j, _REASON))


def _barred(chunks: list[Chunk], clauses: list[Clause], context: Context) -> bool:
    """Whether anything is in the way at all."""
    others = [e for e in context.draft.entities if not e.ego]
    slow = any(
        d.kind in _IN_THE_WAY and not any(e.ego for e in d.by) for d in context.draft.dangers
    )
    things = any(isinstance(c, Thing) and c.kind in {"object", "obstacle"} for c in chunks)
    passing = any(s.event.name in _PASSING for s in clauses)
    stands = any(e.parked or context.placed(e, Approach.AHEAD) for e in others)
    return slow or things or passing or stands


def _by_verb(ego: Entity, clauses: list[Clause], context: Context) -> Basis | None:
    for clause in clauses:
        event = clause.event
        moves = ego in clause.actors or (ego in clause.targets and event.name in _MOVED)
        if not moves or event.negated or (event.passive and event.name not in _MOVED):
            continue
        for prep in event.pps:
            if _leads_past(prep, context):
                return Basis(event.i, _end(prep))
    return None


def _by_noun(
    ego: Entity, chunks: list[Chunk], clauses: list[Clause], context: Context
) -> Basis | None:
    """``the ego, already in the opposite lane``, ``its way round the van``, ``the detour``."""
    for chunk in chunks:
        if isinstance(chunk, Mention) and ego in chunk.entities:
            for prep in chunk.pps:
                if _leads_past(prep, context):
                    return Basis(chunk.i, _end(prep))
    taken = {id(p) for s in clauses if s.actors for p in s.places()}
    taken |= {
        id(p.target)
        for c in chunks
        if isinstance(c, Mention) and ego not in c.entities
        for p in c.pps
    }
    for k, chunk in enumerate(chunks[:-1]):
        after = chunks[k + 1]
        if not isinstance(chunk, Word) or chunk.cat != "prep":
            continue
        way = chunks[k - 1] if k else None
        way = chunks[k - 2] if isinstance(way, Word) and way.cat == "prep" and k > 1 else way
        its = isinstance(way, Place) and way.kind == "path" and _of(way, ego)
        led = isinstance(after, Place) and _other_half(after) and id(after) not in taken
        if (its and _around(chunk, after, context)) or (led and chunk.value in _THERE):
            return Basis(chunk.i, after.j)
    return None


def _of(way: Place, ego: Entity) -> bool:
    return way.owner is None or ego in way.owner.entities


def _leads_past(prep: Prep, context: Context) -> bool:
    if _around(prep.word, prep.target, context):
        return True
    place = prep.target
    return prep.value in _THERE and isinstance(place, Place) and _other_half(place)


def _around(word: Word, target: NounPhrase | Event | Chunk | None, context: Context) -> bool:
    """``round the parked van``, ``past the skip``."""
    if context.tokens[word.i].low not in word_list("past"):
        return False
    if isinstance(target, Mention):
        return any(e.is_vehicle and not e.ego for e in target.entities)
    return isinstance(target, Thing) and target.kind in {"object", "obstacle"}


def _other_half(place: Place) -> bool:
    """The oncoming lane, the wrong side, what divides them."""
    if place.kind == "centerline":
        return True
    owner = place.owner
    theirs = owner is not None and any(m.value == "opposite" for m in owner.mods)
    other = any(m.value == "other" for m in place.mods)
    lane = place.kind == "lane" and "opposite" in place.dirs
    return lane or theirs or (place.kind in {"side", "lane"} and other)


def _end(prep: Prep) -> int:
    return prep.target.j if prep.target is not None else prep.word.j
