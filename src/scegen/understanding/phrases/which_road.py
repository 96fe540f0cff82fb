"""Roads and courses told by how somebody drives: "the road that the ego turns into"."""

from __future__ import annotations

from scegen.scenario.vocabulary import CrossedArm
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.lexicon import word_lists
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

ALONG, AGAINST = "along_course", "against_course"
"""Words of manner that stand for a course told by the one that somebody had before it turned."""
_ROADS = frozenset({"road", "access", "leg", "exit", "highway"})
_COURSES = frozenset({"direction", "path"})
_TURNING = frozenset({"turn", "sharp_turn", "u_turn"})
_ON_THE_WAY = frozenset({"aux", "manner", "quantity"})
_WALKING = frozenset({"cross", "walk", "dash", "move", "appear", "approach", "enter", "inert"})


def name_roads(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Takes clauses that only tell a road or a course out of the sentence around them.

    Returns:
        The chunks without these clauses; the place tells which arm it is, a word of manner which
        course. A clause that tells more (who turns, and which way) is a sentence of its own.
    """
    kinds = {c.kind for c in chunks if isinstance(c, Place)}
    if kinds.isdisjoint(_ROADS | _COURSES):
        return _without_asides(chunks, tokens)
    found: list[Chunk] = []
    begin, k = 0, 0
    while k < len(chunks):
        chunk = chunks[k]
        clause = _arm_clause(chunks, k, tokens) if isinstance(chunk, Place) else None
        named = clause is None and not kinds.isdisjoint(_COURSES)
        course = _course(chunks, k, tokens, found) if named else None
        if clause is not None and isinstance(chunk, Place):
            end, chunk.arm = clause
            told = _told_anew(chunks, k, end)
            found[begin:begin] = told
            chunk.user = next(c for c in chunks[k + 1 : end] if isinstance(c, Mention))
            _hand_on(found, chunk)
            found.append(chunk)
            k = end
        elif course is not None:
            k, term = course
            found.append(Word(term))
        else:
            found.append(chunk)
            k += 1
        if isinstance(chunk, Word) and chunk.value in BOUNDARIES:
            begin = len(found)
    return _without_asides(found, tokens)


def _hand_on(before: list[Chunk], road: Place) -> None:
    """``the crosswalk of the road that it turns into``: on that arm."""
    place, word = chunk_at(before, len(before) - 2), chunk_at(before, len(before) - 1)
    of = isinstance(word, Word) and word.cat == "prep" and word.value in {"of", "in"}
    if of and isinstance(place, Place) and place.kind == "crosswalk":
        place.arm, place.user = road.arm, road.user


def _text(chunk: Chunk | None, tokens: list[Token]) -> str:
    return " ".join(t.low for t in tokens[chunk.i : chunk.j]) if chunk is not None else ""


def _lemma(event: Event, tokens: list[Token]) -> str:
    return tokens[event.i].forms[-1][0]


def _arm_clause(chunks: list[Chunk], k: int, tokens: list[Token]) -> tuple[int, CrossedArm] | None:
    """``(the road) into which the ego turns``, ``it is turning into``: its end, and which arm."""
    place = chunks[k]
    if not isinstance(place, Place) or place.kind not in _ROADS:
        return None
    if place.head is not None and place.head.form == "s":
        return None  # "at a roundabout with four arms the ego enters": the sentence itself
    m, opener = k + 1, ""
    word = chunk_at(chunks, m)
    if isinstance(word, Word) and word.cat == "prep" and _relative(chunk_at(chunks, m + 1), tokens):
        opener, m = _text(word, tokens), m + 2
    elif isinstance(word, Word) and (word.cat, word.value) == ("sub", "where"):
        opener, m = _text(word, tokens).split()[0], m + 1
    elif _relative(word, tokens):
        m += 1
    clause = _does(chunks, m)
    if clause is None:
        return None
    event, m = clause
    while isinstance(after := chunk_at(chunks, m), Word) and after.cat in {"dir", "manner"}:
        m += 1
    if not opener and isinstance(after, Place):
        return None  # "with 5 exits the ego takes the second exit": the verb has its own object
    lemma, stranded = _lemma(event, tokens), _text(after, tokens)
    preposed = isinstance(after, Word) and after.cat == "prep" and not opener
    beyond = chunk_at(chunks, m + 1)
    behind = isinstance(beyond, Word) and beyond.cat == "locus"  # "a car comes up from behind"
    preposed = preposed and not (behind or isinstance(beyond, Mention | Place | Event))
    for said, end in ((f"{lemma} {stranded}", m + 1), (f"{lemma} {opener}".strip(), m)):
        for arm in CrossedArm:
            if said in word_lists("ways")[arm.value] and (preposed or end == m):
                return end, arm
    return None


def _relative(chunk: Chunk | None, tokens: list[Token]) -> bool:
    return isinstance(chunk, Word) and chunk.cat == "rel" and _text(chunk, tokens) != "who"


def _does(chunks: list[Chunk], m: int) -> tuple[Event, int] | None:
    """Somebody and its verb: the verb, and what comes after it."""
    if not isinstance(chunk_at(chunks, m), Mention):
        return None
    m += 1
    while isinstance(word := chunk_at(chunks, m), Word) and word.cat in _ON_THE_WAY:
        m += 1
    verb = chunk_at(chunks, m)
    if (
        isinstance(verb, Event)
        and verb.name == "try"
        and isinstance(chunk_at(chunks, m + 1), Event)
    ):
        m += 1  # "is about to enter"
        verb = chunk_at(chunks, m)
    return (verb, m + 1) if isinstance(verb, Event) and not verb.nominal else None


def _told_anew(chunks: list[Chunk], k: int, end: int) -> list[Chunk]:
    """The clause as a sentence, if nothing else in the text tells that somebody turns."""
    clause = [c for c in chunks[k + 1 : end] if not (isinstance(c, Word) and c.cat == "rel")]
    clause = [c for c in clause if not (isinstance(c, Word) and c.cat in {"prep", "sub"})]
    who = next(c for c in clause if isinstance(c, Mention))
    sided = any(isinstance(c, Word) and c.cat == "dir" for c in clause)
    around = [*chunks[:k], *chunks[end:]]
    turned = any(isinstance(c, Event) and c.name in _TURNING for c in around)
    known = who.pronoun is not None or who.is_ego
    turns = any(isinstance(c, Event) and c.name in _TURNING for c in clause)
    if who.pronoun is not None or not (sided or not known or (turns and not turned)):
        return []
    return [*clause, Word(Term("punct", ".", who.i, who.i))]


def _course(
    chunks: list[Chunk], k: int, tokens: list[Token], before: list[Chunk]
) -> tuple[int, Term] | None:
    """``against the direction from which the ego came``: its end, and a word of manner for it."""
    ways = word_lists("ways")
    verb = next((c for c in reversed(before) if isinstance(c, Event)), None)
    if verb is None or verb.name not in _WALKING:
        return None
    m, against = k, False
    word = chunks[k]
    if isinstance(word, Word) and word.cat in {"prep", "locus", "dir"}:
        against = _text(word, tokens) in ways["against"]
        if not against and _text(word, tokens) not in ways["along"]:
            return None
        m += 1
        m += 1 if isinstance(to := chunk_at(chunks, m), Word) and to.value == "to" else 0
    owner = chunk_at(chunks, m)
    m += 1 if isinstance(owner, Mention) and isinstance(chunk_at(chunks, m + 1), Place) else 0
    noun = chunk_at(chunks, m)
    if not isinstance(noun, Place) or noun.kind not in _COURSES:
        return None
    against = against or "opposite" in noun.dirs
    words = {t.low for t in tokens[noun.i : noun.j]}
    early = bool(words & {*ways["original"]})
    m += 1
    opener = chunk_at(chunks, m)
    if isinstance(opener, Word) and opener.value == "of":
        m += 2  # "of travel", "of the ego"
    told = _heading(chunks, m, tokens)
    if told is None and not early:
        return None
    end = told if told is not None else m
    end = _end_of_turn(chunks, end)
    value = AGAINST if against else ALONG
    return end, Term("manner", value, word.i, chunks[end - 1].j)


def _heading(chunks: list[Chunk], m: int, tokens: list[Token]) -> int | None:
    """``in which the ego was driving``, ``it came from``: where the clause ends."""
    word = chunk_at(chunks, m)
    if isinstance(word, Word) and word.cat == "prep" and _relative(chunk_at(chunks, m + 1), tokens):
        m += 2
    elif isinstance(word, Word) and (word.cat in {"sub", "rel"}):
        m += 1
    clause = _does(chunks, m)
    if clause is None or _lemma(clause[0], tokens) not in word_lists("ways")["heads"]:
        return None
    m = clause[1]
    after = chunk_at(chunks, m)
    stranded = isinstance(after, Word) and after.cat in {"prep", "manner"}
    return m + 1 if stranded and not isinstance(chunk_at(chunks, m + 1), Mention | Place) else m


def _end_of_turn(chunks: list[Chunk], m: int) -> int:
    """After ``before the turn``, ``before it turned``, if that follows."""
    word, verb = chunk_at(chunks, m), chunk_at(chunks, m + 1)
    if not isinstance(word, Word) or (word.cat, word.value) != ("sub", "before"):
        return m
    if isinstance(verb, Event) and verb.name in _TURNING:
        return m + 2
    clause = _does(chunks, m + 1)
    return clause[1] if clause is not None and clause[0].name in _TURNING else m


def _without_asides(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks without "as the ego sees it after the turn", and without "so" before a side."""
    ways = word_lists("ways")
    words = {"as", *ways["therefore"]}
    turns = any(isinstance(c, Word) and c.value == "before" for c in chunks)
    if not turns and words.isdisjoint([t.low for t in tokens]):
        return chunks
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        chunk = chunks[k]
        text, after = _text(chunk, tokens), chunk_at(chunks, k + 1)
        from_there = isinstance(after, Word) and (after.cat, after.value) == ("prep", "from")
        if text in ways["therefore"] and from_there and not isinstance(chunk, Mention):
            k += 1
            continue
        end = _seen(chunks, k, tokens) if text == "as" else None
        if end is None and isinstance(chunk, Word) and _from_a_side(found):
            end = _end_of_turn(chunks, k)
            tells = isinstance(more := chunk_at(chunks, end), Word) and more.cat in {"dir", "prep"}
            end = k if tells else end
        if end is not None and end > k:
            k = end
            continue
        found.append(chunk)
        k += 1
    return found


def _from_a_side(before: list[Chunk]) -> bool:
    """``from the left``, ``from its left``."""
    place = chunk_at(before, len(before) - 1)
    m = len(before) - (3 if isinstance(chunk_at(before, len(before) - 2), Mention) else 2)
    word = chunk_at(before, m)
    side = isinstance(place, Place) and place.kind == "side"
    return side and isinstance(word, Word) and (word.cat, word.value) == ("prep", "from")


def _seen(chunks: list[Chunk], k: int, tokens: list[Token]) -> int | None:
    clause = _does(chunks, k + 1)
    if clause is None or _lemma(clause[0], tokens) not in word_lists("ways")["sees"]:
        return None
    m = clause[1]
    m += 1 if isinstance(chunk_at(chunks, m), Mention) else 0
    return _end_of_turn(chunks, m)
