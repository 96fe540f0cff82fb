"""Things that no lexicon lists, but that somebody is said to be behind: "behind a poster rack"."""

from __future__ import annotations

from scegen.understanding.chunks import NOTHING, Chunk, Event, Thing
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at
from scegen.understanding.words.terms import Term

_HIDING = frozenset({"behind", "between"})
_OPENERS = frozenset({"det", "possessive"})
_DESCRIBING = frozenset({"unknown", "label", "inert", "state", "noted", "env"})
_ENDS = frozenset({"prep", "conj", "sub", "rel", "aux", "locus", "punct", "manner", "copy"})
_LONGEST = 5


def name_hiders(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks, with unknown nouns after "behind" and "hidden by" as things."""
    found: list[Chunk] = []
    end = 0
    for k, chunk in enumerate(chunks):
        if k < end:
            continue
        found.append(chunk)
        end = _end(chunks, k + 1) if _hides(chunks, k) else 0
        if end:
            *before, last = chunks[k + 1 : end]
            mods = [w for w in before if isinstance(w, Term)]
            head = Term("thing", "object", last.i, last.j)
            found.append(Thing(chunks[k + 1].i, last.j, mods, head, kind="object"))
    return found


def _hides(chunks: list[Chunk], k: int) -> bool:
    """Whether what stands after this word is something one cannot see through."""
    word = chunks[k]
    if not isinstance(word, Term):
        return False
    if word.cat == "locus":
        return word.value in _HIDING
    before = chunks[max(0, k - 2) : k]
    hidden = any(isinstance(c, Event) and c.name == "hide" and c.form == "ed" for c in before)
    return word.value == "by" and hidden


def _end(chunks: list[Chunk], k: int) -> int:
    """Where a noun with an article ends whose last word is in no lexicon; 0 if none begins."""
    opener = chunk_at(chunks, k)
    if opener.cat not in _OPENERS:
        return 0
    m = k + 1
    while m < len(chunks) and m - k < _LONGEST:
        chunk = chunks[m]
        noun_like = isinstance(chunk, Event) and chunk.form == "base" and m > k + 1
        if not (noun_like or (chunk.cat in _DESCRIBING)):
            break
        m += 1
    last, after = chunks[m - 1], chunk_at(chunks, m)
    named = m > k + 1 and (isinstance(last, Event) or last.cat == "unknown")
    ends = after is NOTHING or after.cat in _ENDS or after.value in BOUNDARIES
    verb = isinstance(after, Event) and after.form in {"s", "ed", "ing"}
    return m if named and (ends or verb) else 0
