"""Looks ahead in the chunks: does a verb follow, and does it make a clause of its own?"""

from __future__ import annotations

from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word

BOUNDARIES = frozenset({".", ";", "!", "?", ":"})
ADVERBS = frozenset(
    {"manner", "dir", "compass", "noted", "quantity", "locus", "neg", "aux", "control", "cue"}
)
GOVERNING = frozenset({"prep", "locus"})
_VIEW_OF = 3
_CLAUSE = 14


def chunk_at(chunks: list[Chunk], k: int) -> Chunk | None:
    """The chunk with an index, if there is one."""
    return chunks[k] if 0 <= k < len(chunks) else None


def is_word(chunk: Chunk | None, value: str) -> bool:
    """Whether a chunk is a word, or a mark, of that value."""
    return isinstance(chunk, Word) and chunk.value == value


def governs(chunk: Chunk | None) -> bool:
    """Whether a noun after it stands in a phrase of place."""
    return isinstance(chunk, Word) and chunk.cat in GOVERNING


def sentence_end(chunks: list[Chunk], k: int) -> int:
    """The index of the first mark from chunk ``k`` on that ends a sentence or a title."""
    ends = (m for m in range(k, len(chunks)) if getattr(chunks[m], "value", "") in BOUNDARIES)
    return next(ends, len(chunks))


def event_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether a verb comes after chunk ``k``, with at most adverbs in between.

    Args:
        chunks: the chunks of the text.
        k: index of a chunk.
    """
    for chunk in chunks[k + 1 : k + 6]:
        if isinstance(chunk, Event):
            return not chunk.nominal
        if not isinstance(chunk, Word) or chunk.cat not in ADVERBS:
            return False
    return False


def finite_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether a verb of its own comes after chunk ``k``, adverbs and phrases skipped.

    Args:
        chunks: the chunks of the text.
        k: index of a chunk.
    """
    auxiliary = preposed = False
    last = k + 8
    while k < min(last, len(chunks) - 1):
        behind = _behind_insertion(chunks, k)
        last, k = last + behind - k, behind + 1
        chunk = chunk_at(chunks, k)
        if isinstance(chunk, Event):
            return auxiliary or chunk.form != "ing"
        if isinstance(chunk, Word):
            if chunk.cat in {"sub", "conj", "rel", "copy"} or chunk.value == ",":
                return False
            if chunk.cat == "punct" and chunk.value in BOUNDARIES:
                return False
            if chunk.value == "to" and chunk.cat == "prep" and not _place_after(chunks, chunk):
                return False
            auxiliary = auxiliary or chunk.cat == "aux"
            preposed = chunk.cat in GOVERNING
        elif isinstance(chunk, Mention) and not chunk.possessor and not preposed:
            return False
    return False


def _behind_insertion(chunks: list[Chunk], k: int) -> int:
    """``the ego, driving at 45 km/h, brakes``: the second comma if the verb comes behind it."""
    words = [c.value if isinstance(c, Word) else None for c in chunks[k + 1 : k + 10]]
    if words[:1] != [","] or "," not in words[1:]:
        return k
    end = k + 2 + words[1:].index(",")
    inside = chunks[k + 2 : end]
    ends = any(isinstance(c, Word) and c.cat in {"conj", "sub"} for c in inside)
    ends = ends or any(word in BOUNDARIES for word in words[: end - k])
    opens = inside[:1] and (
        (isinstance(inside[0], Word) and inside[0].cat in {"prep", "quantity", "rel"})
        or (isinstance(inside[0], Event) and inside[0].form in {"ing", "ed"})
    )
    verb = chunk_at(chunks, end + 1)
    finite = isinstance(verb, Event) and verb.form in {"s", "ed"} and not verb.nominal
    finite = finite or (isinstance(verb, Word) and verb.cat == "aux")
    return end if opens and finite and not ends else k


def _place_after(chunks: list[Chunk], word: Word) -> bool:
    """``the view to the left``: no infinitive."""
    k = next(k for k, chunk in enumerate(chunks) if chunk is word)
    return k + 1 < len(chunks) and isinstance(chunks[k + 1], Place)


def main_verb_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether another verb makes the clause after a participle with a phrase of place.

    Args:
        chunks: the chunks of the text.
        k: index of the participle ("hidden" in "a man hidden behind a van runs out").
    """
    preposed = governed = False
    for before, chunk in pairwise(chunks[k : k + _CLAUSE]):
        if isinstance(chunk, Event) and preposed and _describes(chunk, before):
            continue  # "emerges from behind two cars parked there"
        if isinstance(chunk, Event):
            return governed and not chunk.nominal and chunk.form in {"s", "ed"}
        if isinstance(chunk, Word):
            ends = chunk.cat in {"sub", "conj", "rel", "copy"}
            if ends or (chunk.cat == "punct" and chunk.value not in "()"):
                return False
            preposed = chunk.cat in GOVERNING
            governed = governed or preposed
        elif not preposed and isinstance(chunk, Mention):
            return False
    return False


def _describes(participle: Event, noun: Chunk) -> bool:
    told = participle.form == "ed" and participle.name in {"park", "locate"}
    return told and isinstance(noun, Mention)


def only_a_noun_follows(word: Word, k: int, chunks: list[Chunk]) -> bool:
    """``after a car on its right``: a preposition, no clause.

    Args:
        word: a word.
        k: its index.
        chunks: the chunks of the text.
    """
    following = chunk_at(chunks, k + 1)
    place = chunk_at(chunks, k - 1)
    if word.value == "when" and isinstance(place, Place) and "same" in place.dirs:
        return isinstance(following, Mention)  # "in the same direction as the ego"
    if (word.cat, word.value) != ("sub", "before") or not isinstance(following, Mention):
        return False
    for m, chunk in enumerate(chunks[k + 2 :], start=k + 3):
        if isinstance(chunk, Event) or (isinstance(chunk, Word) and chunk.cat in {"aux", "copy"}):
            return False
        if isinstance(chunk, Word) and (chunk.value in BOUNDARIES or chunk.value == ","):
            after = chunk_at(chunks, m)
            return not isinstance(after, Event)  # "before the ego, turning left, has cleared it"
    return True


def by_follows(chunks: list[Chunk], k: int) -> bool:
    """``struck from behind by a van``: who does it stands after "by".

    Args:
        chunks: the chunks of the text.
        k: index of a participle.
    """
    for chunk in chunks[k + 1 : k + 7]:
        if isinstance(chunk, Mention | Event):
            return False
        if is_word(chunk, "by"):
            return True
        if isinstance(chunk, Word) and chunk.cat not in {"prep", "locus", "manner", "dir"}:
            return False
    return False


def view_of(before: list[Chunk]) -> Thing | None:
    """``its view blocked``, ``his view of the road blocked``.

    Args:
        before: the last chunks before a participle.
    """
    last = before[-1] if before else None
    if isinstance(last, Thing) and last.kind == "view":
        return last
    if len(before) == _VIEW_OF and is_word(before[1], "of"):
        first = before[0]
        return first if isinstance(first, Thing) and first.kind == "view" else None
    return None
