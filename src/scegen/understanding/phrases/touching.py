"""Parts of bodies that touch, and where: "our front into its tail", "10 % from its right"."""

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import teller_at
from scegen.understanding.phrases.lookahead import chunk_at, ends, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

ARTICLES = ("det", "num", "possessive", "quant")
_BODY = frozenset({"side", "front", "flank", "portion", "middle"})
_NEAR = 5
_PACE = frozenset({"quantity", "dir", "manner"})


def touching(chunks: list[Chunk], k: int) -> list[Chunk]:
    """``our front into its tail``, ``…, middle of our front``: parts touch, without a verb.

    So it is in ``…, front into the taxi``; "40 km/h straight into the van" drives into it.
    """
    at, last = chunks[k].i, chunk_at(chunks, k - 1)
    opens = ends(last) or last.value == ","
    if not (opens or chunks[k].value == "into"):
        return []
    marks = [m for m, c in enumerate(chunks) if ends(c) or c.value == ","]
    before = chunks[max((m + 1 for m in marks if m < k), default=0) : k]
    after = chunks[k : min((m for m in marks if m >= k), default=len(chunks))]
    if chunks[k].value == "into" and _owned(before) and _of_bodies(before + after[1:]):
        return [Event("collide", at, at, "s", lemma="hit")]
    # not "…, parked cars both sides"
    if opens and _of_bodies(after) and getattr(after[0], "possessor", True):
        aside = all(c.kind == "side" and c.owner is None for c in after if isinstance(c, Place))
        doing = [] if aside else [Event("collide", at, at, "base", nominal=True)]
        return [*doing, Term("prep", "in", at, at)]  # "…, right side": there it is
    into = next((m for m, c in enumerate(after) if c.value == "into"), 0)
    whom, paced = after[into + 1 :], all(c.cat in _PACE for c in after[:into])
    touched = isinstance(chunk_at(whom, 0), Mention) or _of_bodies(whom)
    own = _of_bodies(after[:into]) and not _owned(after)
    if not (opens and into and touched and (paced or own)):
        return []
    who = [teller_at(at)] if ends(last) else []
    if paced:
        return [*who, Event("move", at, at, "s")]
    return [*who, Event("collide", at, at, "s"), Term("prep", "with", at, at)]


def _owned(parts: list[Chunk]) -> bool:
    """``our front``, ``front of the ego``, unlike a bare ``front`` of whoever acts."""
    first, whose = chunk_at(parts, 0), value_at(parts, 1) == "of"
    return isinstance(first, NounPhrase) and (whose or first.mod(*ARTICLES) is not None)


def _of_bodies(chunks: list[Chunk]) -> bool:
    """``the left end of the ego's front``: a part of somebody, and nothing else."""
    parts = [c for c in chunks if not (isinstance(c, Mention) or c.value == "of")]
    return bool(parts) and all(isinstance(c, Place) and c.kind in _BODY for c in parts)


def counted_from(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``10 % of its width, counted from the right``: from there the share is, and nobody comes."""
    gone: set[int] = set()
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Thing) or tokens[chunk.j - 1].base not in word_list("extents"):
            continue
        share = any(c.value == "percentage" for c in chunks[max(0, k - _NEAR) : k])
        near = range(k + 1, min(k + _NEAR, len(chunks)) if share else 0)
        begins = next((n for n in near if value_at(chunks, n) == "from"), None)
        if begins is None or any(isinstance(c, Event | NounPhrase) for c in chunks[k + 1 : begins]):
            continue
        after = range(begins + 1, begins + 3)  # "the ego's right side"
        place = next((n for n in after if isinstance(chunk_at(chunks, n), Place)), begins)
        gone.update(range(begins, place + 1))
    return [c for k, c in enumerate(chunks) if k not in gone]
