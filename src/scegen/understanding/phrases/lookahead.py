"""Looks ahead in the chunks: does a verb follow, and does it make a clause of its own?"""

from collections.abc import Iterator
from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.words.terms import NOTHING, Term

BOUNDARIES = frozenset({".", ";", "!", "?", ":"})
ADVERBS = frozenset(
    {"manner", "dir", "compass", "noted", "quantity", "locus", "neg", "aux", "control", "cue"}
)
GOVERNING = frozenset({"prep", "locus"})
_LINKS = frozenset({"sub", "conj", "rel", "copy"})
_VIEW_OF = 3
_CLAUSE = 14
_INSERTED = 9
_PUT_IN = frozenset({"prep", "locus", "quantity", "rel"})
"""Classes of words with which it begins what is put in."""


def chunk_at(chunks: list[Chunk], k: int) -> Chunk:
    """The chunk with an index; `NOTHING` before the text and behind it."""
    return chunks[k] if 0 <= k < len(chunks) else NOTHING


def cat_at(chunks: list[Chunk], k: int) -> str:
    """The class of the word with an index, empty where no mere word stands."""
    return chunk_at(chunks, k).cat


def value_at(chunks: list[Chunk], k: int) -> str:
    """The value of the word with an index, empty where no mere word stands."""
    return chunk_at(chunks, k).value


def ends(chunk: Chunk) -> bool:
    """Whether a sentence or a title ends here, as before and behind the text."""
    return chunk is NOTHING or chunk.value in BOUNDARIES


def sentences(chunks: list[Chunk]) -> Iterator[tuple[int, int]]:
    """Where each sentence or title that a mark ends begins, and the index of the mark."""
    begin = 0
    for k, chunk in enumerate(chunks):
        if chunk.value in BOUNDARIES:
            yield begin, k
            begin = k + 1


def free_mentions(chunks: list[Chunk]) -> list[Mention]:
    """Those named whom no word of place governs."""
    pairs = pairwise([NOTHING, *chunks])
    return [c for before, c in pairs if isinstance(c, Mention) and before.cat not in GOVERNING]


def sentence_end(chunks: list[Chunk], k: int) -> int:
    """The index of the first mark from chunk ``k`` on that ends a sentence or a title."""
    return next((m for m in range(k, len(chunks)) if ends(chunks[m])), len(chunks))


def event_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether a verb comes after chunk ``k``, with at most adverbs in between."""
    for chunk in chunks[k + 1 : k + 6]:
        if isinstance(chunk, Event):
            return not chunk.nominal
        if chunk.cat not in ADVERBS:
            return False
    return False


def finite_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether a verb of its own comes after chunk ``k``, adverbs and phrases skipped."""
    k = _behind_relative(chunks, k)
    auxiliary = preposed = False
    last = k + 10
    while k < min(last, len(chunks) - 1):
        k += 1
        behind = behind_insertion(chunks, k + 1) if chunks[k].value == "," else k
        if behind > k + 1 and predicate_opens(chunk_at(chunks, behind)):
            last, k = last + behind - k, behind
        chunk = chunks[k]
        if isinstance(chunk, Event):
            return auxiliary or chunk.form != "ing" or main_verb_follows(chunks, k)
        if isinstance(chunk, Term):
            if chunk.cat in _LINKS or chunk.value == "," or ends(chunk):
                return False
            if chunk.value == "to" and not isinstance(chunk_at(chunks, k + 1), Place):
                return False  # an infinitive, unlike "the view to the left"
            auxiliary = auxiliary or chunk.cat == "aux"
            preposed = chunk.cat in GOVERNING
        elif isinstance(chunk, Mention) and not chunk.possessor and not preposed:
            return False
    return False


def _behind_relative(chunks: list[Chunk], k: int) -> int:
    """``a van that has been sitting at the kerb pulls out``: the verb of the relative clause."""
    if cat_at(chunks, k + 1) != "rel":
        return k
    inside = range(k + 2, min(k + 10, len(chunks)))
    return next((m for m in inside if isinstance(chunks[m], Event) or ends(chunks[m])), k)


def behind_insertion(chunks: list[Chunk], m: int) -> int:
    """Behind what is put in between two commas, ``m`` itself if nothing is.

    "The ego, driving at 45 km/h, brakes", "from the right, partly hidden by a wall, a van comes",
    "ahead of the ego, which does 50 km/h, …", "in the left lane, 10 m ahead of it, …".
    """
    end = next((n for n in range(m, m + _INSERTED) if value_at(chunks, n) == ","), m)
    inside = chunks[m:end]
    opens = [c for c in inside if c.cat != "manner"][:1]
    if not inside or any(c.cat in {"conj", "sub"} or ends(c) for c in inside):
        return m
    if not opens:
        return end + 1  # "from the left, without looking, comes a van"
    participle = isinstance(opens[0], Event) and opens[0].form in {"ing", "ed"}
    told = opens[0].cat != "rel" or any(isinstance(c, Event) for c in inside)
    return end + 1 if participle or (told and opens[0].cat in _PUT_IN) else m


def predicate_opens(chunk: Chunk) -> bool:
    """Whether the verb of a clause, or its auxiliary, stands there."""
    verb = isinstance(chunk, Event) and chunk.form != "ing" and not chunk.nominal
    return verb or chunk.cat == "aux"


def main_verb_follows(chunks: list[Chunk], k: int) -> bool:
    """Whether another verb makes the clause after a participle with a phrase or an object."""
    governed = preposed = isinstance(chunk_at(chunks, k + 1), Mention)
    for chunk in chunks[k + 1 : k + _CLAUSE]:
        if isinstance(chunk, Event):
            close = chunk is chunks[k + 1] and chunk.form == "s"  # "the car overtaken speeds up"
            return (governed or close) and not chunk.nominal and chunk.form in {"s", "ed"}
        if isinstance(chunk, Term):
            if chunk.cat in _LINKS or (chunk.cat == "punct" and chunk.value not in "()"):
                return False
            preposed = chunk.cat in GOVERNING
            governed = governed or preposed
        elif not preposed and isinstance(chunk, Mention):
            return False
    return False


def only_a_noun_follows(word: Term, k: int, chunks: list[Chunk]) -> bool:
    """``after a car on its right``: a preposition, no clause."""
    following, place = chunk_at(chunks, k + 1), chunk_at(chunks, k - 1)
    if word.value == "when" and isinstance(place, Place) and "same" in place.dirs:
        return isinstance(following, Mention)  # "in the same direction as the ego"
    if (word.cat, word.value) != ("sub", "before") or not isinstance(following, Mention):
        return False
    if (place.cat, place.value) == ("quantity", "length"):
        return True  # "50 m before it"
    for m, chunk in enumerate(chunks[k + 2 :], start=k + 3):
        if isinstance(chunk, Event) or chunk.cat in {"aux", "copy"}:
            return False
        if ends(chunk) or chunk.value == ",":  # "before the ego, turning left, has cleared it"
            return not isinstance(chunk_at(chunks, m), Event)
    return True


def by_follows(chunks: list[Chunk], k: int) -> bool:
    """``struck from behind by a van``: who does it stands after "by"."""
    for m, chunk in enumerate(chunks[k + 1 : k + 7], start=k + 2):
        if isinstance(chunk, Mention | Event):
            return False
        if chunk.value == "by":
            return not isinstance(chunk_at(chunks, m), Event)  # "by turning right"
        if chunk.cat not in {"", "prep", "locus", "manner", "dir"}:
            return False
    return False


def view_of(before: list[Chunk]) -> Thing | None:
    """``its view blocked``, ``his view of the road blocked``."""
    last = chunk_at(before, len(before) - 1)
    if isinstance(last, Thing) and last.kind == "view":
        return last
    of_it = len(before) == _VIEW_OF and before[1].value == "of"
    return view_of(before[:1]) if of_it else None
