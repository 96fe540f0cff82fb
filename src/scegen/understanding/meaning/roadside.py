"""Things on and beside the road: what blocks, what hides, what somebody only carries."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list

_OPENED_REACH = 11
_TYRES = frozenset({"tire", "tyre"})
_IN_THE_WAY = 9
_CARRIAGEWAY = frozenset({"road", "lane", "highway", "path", "crosswalk"})
_REACH = 4


def read_thing(thing: Thing, chunks: list[Chunk], draft: Draft) -> None:
    """What a thing on or beside the road means.

    Args:
        thing: the thing.
        chunks: the chunks of the text, mentions resolved.
        draft: the scenario in the making.
    """
    basis = Basis(thing.i, thing.j)
    possessed = thing.owner is not None or any(m.cat == "possessive" for m in thing.mods)
    possessed = possessed or _part(thing, draft)
    if _bursts(thing, draft):
        return
    lost = possessed and _comes_off(thing, draft)
    if thing.kind == "obstacle" and not lost and (possessed or _carried(thing, chunks)):
        return  # "its tyre bursts", "a man with a dog": a part of somebody
    if thing.kind == "obstacle":
        draft.hazard(HazardKind.OBSTACLE, basis, [])
        draft.lying.append(thing)
    elif thing.kind == "door" and _open(thing, draft):
        whose = [e for p in thing.pps if isinstance(p.target, Mention) for e in p.target.entities]
        whose += thing.owner.entities if thing.owner is not None else []
        draft.hazard(HazardKind.OBSTACLE, basis, whose)
        draft.note(thing.i, thing.j, "doors are not modelled; an obstacle is")
    elif thing.kind == "object" and _in_the_way(thing, chunks):
        draft.hazard(HazardKind.OBSTACLE, basis, [])
        draft.lying.append(thing)
    elif thing.kind == "object":
        draft.note(
            thing.i, thing.j, "things beside the road are built only where they hide somebody"
        )
    elif thing.kind == "view" and any(m.cat == "verb" for m in thing.mods):
        draft.hazard(HazardKind.OCCLUSION, basis, _owing_to(thing, chunks))


def _in_the_way(thing: Thing, chunks: list[Chunk]) -> bool:
    """``a barrier blocks the lane``, ``a tree lying across the road``."""
    k = next(k for k, c in enumerate(chunks) if c is thing)
    after = chunks[k + 1 : k + _IN_THE_WAY]
    verb = next((m for m, c in enumerate(after) if isinstance(c, Event)), None)
    if verb is None or any(isinstance(c, Mention) for c in after[:verb]):
        return False
    event, rest = after[verb], after[verb + 1 :]
    what = next((c for c in rest if isinstance(c, Place | Thing)), None)
    blocks = isinstance(event, Event) and event.name == "block"
    return blocks and isinstance(what, Place) and what.kind in _CARRIAGEWAY


def _bursts(thing: Thing, draft: Draft) -> bool:
    """``a tyre bursts``, ``a tire goes flat``: on the vehicle, not on the road."""
    tyre = draft.tokens[thing.j - 1].forms[-1][0] in {"tyre", "tire"}
    after = {t.low for t in draft.tokens[thing.j : thing.j + _REACH]}
    return tyre and bool(after & word_list("bursting"))


def _open(thing: Thing, draft: Draft) -> bool:
    """``an opening door``, ``a door opens``; "hit the driver's door" is a place on a car."""
    around = draft.tokens[max(0, thing.i - 2) : thing.j + _OPENED_REACH]
    ends = next((k for k, t in enumerate(around) if k > 2 and t.kind == "punct"), len(around))
    around = around[:ends]
    return any(t.low.startswith("open") or t.low in word_list("flung") for t in around)


def _comes_off(thing: Thing, draft: Draft) -> bool:
    """``the truck's cargo falls onto the road``: no longer a part of it."""
    words = [t.forms[-1][0] for t in draft.tokens[thing.j : thing.j + _REACH]]
    return bool(word_list("falling") & set(words))


def _part(thing: Thing, draft: Draft) -> bool:
    """``suffered a blown tyre``, ``its left front tire``: of a vehicle, not on the road."""
    words = [t.low for t in draft.tokens[max(0, thing.i - 1) : thing.j]]
    return words[-1].rstrip("s") in _TYRES and bool(word_list("states") & set(words))


def _carried(thing: Thing, chunks: list[Chunk]) -> bool:
    """Whether it is with somebody on foot."""
    k = next(k for k, c in enumerate(chunks) if c is thing)
    who = chunks[k - 2] if k > 1 else None
    along = thing.prep is not None and thing.prep.value == "with"
    if along and thing.head is not None and "part" in thing.head.data:
        return True  # "parked with a flat tyre"
    return along and isinstance(who, Mention) and any(not e.is_vehicle for e in who.entities)


def _owing_to(thing: Thing, chunks: list[Chunk]) -> list[Entity]:
    """``obstructed views due to parked cars``: the mention right after, with "due to" or "by"."""
    position = next(k for k, c in enumerate(chunks) if c is thing)
    for chunk in chunks[position + 1 : position + 4]:
        if isinstance(chunk, Mention):
            prep = chunk.prep
            causal = prep is not None and prep.value in {"due", "by"}
            return [e for e in chunk.entities if causal]
    return []
