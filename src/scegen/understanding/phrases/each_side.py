"""``two cars, one from each side``: spelled out as one from the left and one from the right."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Mention, Place, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token


def both_sides(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with "one from each side" spelled out."""
    pronouns = {c.pronoun for c in chunks if isinstance(c, Mention)}
    if pronouns & {"all", "both"}:
        chunks = _each_of(chunks)
    if "other" in pronouns:
        chunks = _one_and_the_other(chunks)
    if "one" not in pronouns:
        return chunks
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        one, word, place = (chunks[m] if m < len(chunks) else None for m in (k, k + 1, k + 2))
        single = isinstance(one, Mention) and one.pronoun == "one"
        either = isinstance(place, Word) and place.value == "either" and k + 3 < len(chunks)
        length = 4 if either else 3
        place = chunks[k + 3] if either else place
        if (
            single
            and isinstance(one, Mention)
            and isinstance(word, Word)
            and word.cat == "prep"
            and isinstance(place, Place)
            and _each(place, tokens, either=either)
            and any(isinstance(c, Mention) and _several(c) for c in chunks[:k])
        ):
            for value in ("left", "right"):
                side = Term("dir", value, place.i, place.j)
                joint = Word(Term("conj", "and", place.i, place.i))
                found += [joint] if value == "right" else []
                found += [
                    Mention(one.i, one.j, list(one.mods), None, pronoun="one"),
                    Word(replace(word.term, value="from")),
                    Place(place.i, place.j, [side], place.head),
                ]
            k += length
            continue
        found.append(chunks[k])
        k += 1
    return found


def _each_of(chunks: list[Chunk]) -> list[Chunk]:
    """``in each of the two adjacent lanes``: in each adjacent lane."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        one, word = (chunks[m] if m >= 0 else None for m in (k - 2, k - 1))
        parted = isinstance(one, Mention) and one.pronoun in {"all", "both"}
        of = isinstance(word, Word) and (word.cat, word.value) == ("prep", "of")
        if isinstance(chunk, Place) and parted and of and found[-2:] == [one, word]:
            del found[-2:]
            quant = Term("quant", "all", chunk.i, chunk.i)
            chunk.mods = [quant, *(m for m in chunk.mods if m.cat not in {"det", "num"})]
        found.append(chunk)
    return found


def _one_and_the_other(chunks: list[Chunk]) -> list[Chunk]:
    """``a bus on one side, a truck on the other``: beside whoever is between them."""
    found = list(chunks)
    first: Place | None = None
    for k, chunk in enumerate(chunks[1:], 1):
        before, after = chunks[k - 1], chunks[k + 1] if k + 1 < len(chunks) else None
        on = isinstance(before, Word) and (before.cat, before.value) == ("prep", "in")
        road = isinstance(after, Word) and after.value == "of"
        if isinstance(chunk, Word) and chunk.value in {".", ";"}:
            first = None
        if not on or road:
            continue
        if isinstance(chunk, Place) and chunk.kind == "side" and not chunk.dirs:
            values = {m.value for m in chunk.mods}
            first = chunk if values == {"one"} else first
        elif isinstance(chunk, Mention) and chunk.pronoun == "other" and first is not None:
            found[k] = _beside(Place(chunk.i, chunk.j, list(chunk.mods), None, kind="side"), first)
    return found


def _beside(second: Place, first: Place) -> Place:
    for place in (first, second):
        place.mods = [*place.mods, Term("dir", "adjacent", place.i, place.j)]
    return second


def _each(place: Place, tokens: list[Token], *, either: bool) -> bool:
    words = {t.low for t in tokens[place.i : place.j]}
    return (
        place.kind == "side"
        and bool(words & word_list("sides"))
        and (either or bool(words & word_list("each")))
    )


def _several(mention: Mention) -> bool:
    return bool(mention.heads) and mention.heads[-1].form == "s"
