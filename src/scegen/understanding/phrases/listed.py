"""One by one: those who were counted (``two people, a woman and a man``), one from each side."""

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import (
    BOUNDARIES,
    GOVERNING,
    cat_at,
    chunk_at,
    ends,
    sentence_end,
    value_at,
)
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_MARKS = {",": ",", ":": ",", "(": ")"}
"""What opens a list, and what closes it before the end of the sentence."""
_KNOWN = frozenset({"det", "possessive"})
_COUNTS = frozenset({"det", "num", "quant"})
_IN_LINE = "ahead", "behind"


def list_them(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Those named one by one, as many as were counted, take the place of who was counted.

    Behind the verb ("two people cross, a woman and a man"), and wherever a colon opens the list
    ("three vehicles meet: a bus turns, …"), they are marked as ``listed``.
    """
    for k, counted in enumerate(chunks):
        count = _size(counted)
        if not isinstance(counted, Mention) or count < 2 or counted.is_ego or counted.listed:
            continue
        stop = next((m for m in range(k, len(chunks)) if chunks[m].value == "."), len(chunks))
        for m in (m for m in range(k + 1, stop) if chunks[m].value in _MARKS):
            first = m + 1 + (value_at(chunks, m + 1) == "with")
            told, end = _one_by_one(chunks[:stop], first, count, _MARKS[chunks[m].value])
            told = told if all(_alike(t, counted, tokens) for t in told) else []
            if told and m == k + 1:  # "three vehicles, a van and two cars, meet"
                told[0].i = counted.i
                for one in told:
                    one.marks = {"drives"} if counted.noun == "driver" else set()
                    one.mods = [*one.mods, *(t for t in counted.mods if t.cat not in _COUNTS)]
                return list_them([*chunks[:k], *chunks[first:end], *chunks[end + 1 :]], tokens)
            if chunks[m].value == ":":
                told = [c for c in chunks[m:stop] if isinstance(c, Mention) and _in_list(c)]
            elif any(map(_acts, chunks[end : sentence_end(chunks, end)])):
                continue
            for one in told:
                one.listed = True
    return chunks


def _one_by_one(
    chunks: list[Chunk], first: int, count: int, closes: str
) -> tuple[list[Mention], int]:
    """Who is named from a chunk on, up to so many, and where the list is closed."""
    told: list[Mention] = []
    for k in range(first, len(chunks)):
        chunk = chunks[k]
        left = count - sum(map(_size, told))
        if _acts(chunk) or left < 0:
            break
        if not left and (chunk.value == closes or ends(chunk)):
            return told, k
        free = value_at(chunks, k - 1) != "(" and cat_at(chunks, k - 1) not in GOVERNING
        if isinstance(chunk, Mention) and chunk.heads and (free or k == first):
            if not _size(chunk):
                break
            told.append(chunk)
        elif not told:
            break
    else:
        return (told if sum(map(_size, told)) == count else []), len(chunks)
    return [], first


def _acts(chunk: Chunk) -> bool:
    """A verb of its own, or "is"."""
    verb = isinstance(chunk, Event) and chunk.form != "ing" and not chunk.nominal
    return verb or chunk.cat in {"aux", "copy"}


def _size(chunk: Chunk) -> int:
    """How many ``a woman``, ``two cars`` are; 0 for those known by name, number or article."""
    if not isinstance(chunk, Mention) or not chunk.heads:
        return 0
    number = chunk.mod("num")
    single = chunk.opened_by("indef") or chunk.is_ego
    return int(number.data["number"]) if number is not None else int(single)


def _in_list(one: Mention) -> bool:
    """Not those who are known by an article ("the van")."""
    return one.is_ego or all(m.value == "indef" for m in one.mods if m.cat in _KNOWN)


def _alike(one: Mention, counted: Mention, tokens: list[Token]) -> bool:
    """Whether somebody can be one of those who were counted."""
    vehicles = tokens[counted.j - 1].base in word_list("generic_words")
    vehicles = (vehicles or counted.noun == "adversary") and one.noun != "pedestrian"
    return vehicles or counted.noun in {one.noun, "driver"}


_WHOLE = frozenset({"all", "both", "neither", "nobody"})
_EVERYWHERE = frozenset({"direction", "side", "exit", "leg", "road"})
_A_PAIR = 2
"""Of two sides named, there may still be any number of vehicles."""


def from_everywhere(prep: Prep) -> bool:
    """``from all directions``, ``from every side``."""
    target = prep.target
    if prep.value not in {"from", "in"} or not isinstance(target, Place):
        return False
    return target.has("quant", "all") and target.kind in _EVERYWHERE


def each_side(prep: Prep) -> bool:
    """``from each side``: one from the left, one from the right."""
    target = prep.target
    if not isinstance(target, Place):
        return False
    if target.kind == "lane" and prep.value == "in":
        return target.has("quant", "all") and "adjacent" in target.dirs  # "in each adjacent lane"
    single = target.head is not None and target.head.form != "s"
    return from_everywhere(prep) and single and target.kind == "side"


def in_between(chunks: list[Chunk]) -> list[Chunk]:
    """``rides between the ego and a truck``: ahead of the one and behind the other, in line.

    Between two others, between either of them.
    """
    found, second = list(chunks), dict[int, Chunk]()
    for k in [k for k, c in enumerate(chunks) if (c.cat, c.value) == ("locus", "between")]:
        ego, other = chunk_at(chunks, k + 1), chunk_at(chunks, k + 3)
        if not (isinstance(ego, Mention) and isinstance(other, Mention) and other.heads):
            continue
        before = (c for c in chunks[k::-1] if isinstance(c, Event) or c.value in BOUNDARIES)
        verb = next(before, None)
        stays = not isinstance(verb, Event) or verb.name in word_list("steady")
        stays = stays and cat_at(chunks, k - 1) != "inert"  # "the collision between us and a van"
        stays = stays and value_at(chunks, k + 2) == "and"
        mine = ego.is_ego or ego.is_me
        told = isinstance(chunks[k - 1], Event) or cat_at(chunks, k - 1) == "aux"
        if stays and mine and not other.has("state", "parked"):
            one, two = ("behind", "ahead") if value_at(chunks, k + 4) == "behind" else _IN_LINE
            found[k] = Term("locus", one, chunks[k].i, chunks[k].j)
            second[k + 3] = Term("locus", two, other.i, other.i)
        elif stays and told and not (mine or other.is_ego or other.is_me):
            second[k + 3] = Term("locus", "between", other.i, other.i)
    return [c for k, chunk in enumerate(found) for c in (second.get(k), chunk) if c is not None]


def _of_them(chunk: Chunk, found: list[Chunk]) -> None:
    """``each of the vans turns``, ``neither of the vans stops``: the vans do, or do not."""
    part = chunk_at(found, len(found) - 2)
    whole = isinstance(chunk, Mention) and bool(chunk.heads) and not chunk.is_ego
    of = whole and value_at(found, len(found) - 1) == "of"
    if of and isinstance(part, Mention) and part.pronoun in _WHOLE:
        none = part.pronoun not in {"all", "both"}
        found[-2:] = [Term("neg", "not", part.i, part.j)] if none else []


def each_of(chunks: list[Chunk]) -> list[Chunk]:
    """``in one of the lanes``, ``in each of them``, ``one from each side``: in it, from each."""
    found: list[Chunk] = []
    first: Place | None = None
    for k, chunk in enumerate(chunks):
        on = value_at(found, len(found) - 1) == "in"
        both = isinstance(chunk, Mention) and chunk.pronoun == "both" and len(found) > 2
        joined = both and isinstance(found[-1], Mention) and isinstance(found[-3], Mention)
        if joined and found[-2].value == "and" and isinstance(chunk_at(chunks, k + 1), Event):
            continue  # "the ego and the van both drive 60 km/h"
        if on and isinstance(chunk, Place) and {m.value for m in chunk.mods} == {"one"}:
            first = chunk  # "a bus on one side, a truck on the other": beside who is between them
        if on and first is not None and isinstance(chunk, Mention) and chunk.pronoun == "other":
            chunk = Place(chunk.i, chunk.j, list(chunk.mods), None, kind="side")  # noqa: PLW2901
            for place in (first, chunk):
                place.mods = [*place.mods, Term("dir", "adjacent", place.i, place.j)]
        roads = [c for c in found if isinstance(c, Place) and c.plural and c.kind in _EVERYWHERE]
        mention = chunk if isinstance(chunk, Mention) else None
        back = {"they": 3, "all": 1}.get(mention.pronoun or "") if mention is not None else None
        if mention and roads and back and value_at(found, len(found) - back) in {"in", "from"}:
            kind, head = roads[-1].kind, roads[-1].head  # "five arms, cars wait on each (of them)"
            chunk = Place(chunk.i, chunk.j, mention.mods, head, kind=kind)  # noqa: PLW2901
        part, word = chunk_at(found, len(found) - 2), value_at(found, len(found) - 1)
        there = value_at(found, len(found) - 3) == "in"  # "wait at the signs on all arms"
        if on and not there and isinstance(chunk, Place) and _stands_everywhere(part, chunk):
            del found[-1]
            continue
        if isinstance(chunk, Place) and isinstance(part, Mention):
            every = chunk.has("quant", "all") and chunk.kind == "side"
            if part.pronoun in {"one", "all", "both"} and word == "of":
                del found[-2:]
                mods = [m for m in chunk.mods if m.cat not in {"det", "num"}]
                opens = ("det", "indef") if part.pronoun == "one" else ("quant", "all")
                chunk.mods = [Term(*opens, chunk.i, chunk.i), *mods]
                if part.pronoun == "one" and chunk.head is not None:
                    chunk.head = replace(chunk.head, form="base")  # "one of the lanes"
            elif part.pronoun == "one" and word == "from" and every:
                del found[-2]
        _of_them(chunk, found)
        found.append(chunk)
    return found


def _stands_everywhere(noun: Chunk, where: Place) -> bool:
    """``with stop signs on all arms``, ``two lanes in each direction``: nobody is there."""
    if not isinstance(noun, Place) or noun.head is None or not where.has("quant", "all"):
        return False
    built = noun.kind in {"crosswalk", "lane"} or "control" in noun.head.data
    return built and where.kind in _EVERYWHERE


def sides_of(events: list[Event], chunks: list[Chunk]) -> dict[int, int]:
    """Mentions of those who come one from each of some sides -> how many sides; 0: all."""
    found: dict[int, int] = {}
    for event in events:
        compass = {m.value for p in event.pps if p.value == "from" for m in _compass(p)}
        count = _sides(event.pps)
        if count is None and len(compass) > _A_PAIR:
            count = len(compass)
        found |= {} if count is None else {id(m): count for m in event.subject}
    for chunk in chunks:
        count = _sides(chunk.pps) if isinstance(chunk, Mention) else None
        found |= {} if count is None else {id(chunk): count}
    return found


def _sides(pps: list[Prep]) -> int | None:
    """How many sides phrases of place tell of, 0 for all; None if they tell of none."""
    if any(each_side(p) for p in pps):
        return _A_PAIR
    return 0 if any(from_everywhere(p) for p in pps) else None


def _compass(prep: Prep) -> list[Term]:
    target = prep.target
    return [m for m in target.mods if m.cat == "compass"] if isinstance(target, Place) else []
