"""Roads and courses told by how somebody drives: "the road that the ego turns into"."""

from scegen.scenario.vocabulary import CrossedArm
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.lexicon import word_list, word_lists
from scegen.understanding.phrases.lookahead import cat_at, chunk_at, ends, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at

ALONG, AGAINST = "along_course", "against_course"
"""Words of manner that stand for a course told by the one that somebody had before it turned."""
_ROADS = frozenset({"road", "access", "leg", "exit", "highway"})
_COURSES = frozenset({"direction", "path"})
_TURNING = frozenset({"turn", "sharp_turn", "u_turn"})
_STOPS = frozenset({"punct", "conj", "sub", "rel"})
_ON_THE_WAY = frozenset({"aux", "manner", "quantity"})
_WALKING = frozenset({"cross", "walk", "dash", "move", "appear", "approach", "enter", "inert"})


def name_roads(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Takes clauses that only tell a road or a course out of the sentence around them.

    Returns:
        The chunks without these clauses; the place tells which arm it is, a word of manner which
        course. A clause that tells more (who turns, and which way) is a sentence of its own.
    """
    found: list[Chunk] = []
    begin, k = 0, 0
    courses = any(isinstance(c, Place) and c.kind in _COURSES for c in chunks)
    while k < len(chunks):
        chunk = chunks[k]
        clause = _arm_clause(chunks, k, tokens)
        course = _course(chunks, k, tokens, found) if courses and clause is None else None
        if clause is not None and isinstance(chunk, Place):
            end, chunk.arm = clause
            chunk.user = next(c for c in chunks[k + 1 : end] if isinstance(c, Mention))
            after = range(end, len(chunks))
            stop = next((m for m in after if chunks[m].cat in _STOPS), end)
            speed = next((m + 1 for m in (end, end + 1) if value_at(chunks, m) == "speed"), None)
            told = _told_anew(chunks, k, end, measured=speed is not None)
            # "on which a van approaches from the left", "that the ego drives along at 50 km/h"
            stop = stop if chunk.user.opened_by("indef") else speed or end
            if told:
                told[-1:] = [*chunks[end:stop], told[-1]]
                end = stop
            found[begin:begin] = told
            found.append(chunk)
            k = end
        elif course is not None:
            k, term = course
            found.append(term)
        else:
            found.append(chunk)
            k += 1
        if ends(chunk):
            begin = len(found)
    return _without_asides(found, tokens)


def _text(chunk: Chunk, tokens: list[Token]) -> str:
    return " ".join(t.low for t in tokens[chunk.i : chunk.j])


def _arm_clause(chunks: list[Chunk], k: int, tokens: list[Token]) -> tuple[int, CrossedArm] | None:
    """``(the road) into which the ego turns``, ``it is turning into``: its end, and which arm."""
    place = chunks[k]
    if not isinstance(place, Place) or place.kind not in _ROADS or place.plural:
        return None  # "at a roundabout with four arms the ego enters": the sentence itself
    m, opener = k + 1, ""
    word = chunk_at(chunks, m)
    if _preposed(chunks, m):
        who, opener, m = chunk_at(chunks, m + 2), _text(word, tokens), m + 2
        if opener == "from" and isinstance(who, Mention) and who.opened_by("indef"):
            return None  # "a side road from which a van turns": told of the van, not of the road
    elif value_at(chunks, m) == "where":
        opener, m = _text(word, tokens).split()[0], m + 1
    else:
        m += cat_at(chunks, m) == "rel"
    clause = _does(chunks, m)
    if clause is None:
        return None
    event, m = clause
    while cat_at(chunks, m) in {"dir", "manner"}:
        m += 1
    after = chunk_at(chunks, m)
    if not opener and isinstance(after, Place):
        return None  # "with 5 exits the ego takes the second exit": the verb has its own object
    lemma, stranded = tokens[event.i].base, _text(after, tokens)
    preposed = cat_at(chunks, m) == "prep" and not opener and cat_at(chunks, m + 1) != "locus"
    preposed = preposed and not isinstance(chunk_at(chunks, m + 1), Mention | Place | Event)
    for said, end in ((f"{lemma} {stranded}", m + 1), (f"{lemma} {opener}".strip(), m)):
        for arm in CrossedArm:
            if said in word_lists("ways")[arm.value] and (preposed or end == m):
                return end, arm
    return None


def _preposed(chunks: list[Chunk], m: int) -> bool:
    """``in which``, ``from which``."""
    return cat_at(chunks, m) == "prep" and cat_at(chunks, m + 1) == "rel"


def _does(chunks: list[Chunk], m: int) -> tuple[Event, int] | None:
    """Somebody and its verb, or a verb and by whom: the verb, and what comes after it."""
    if not isinstance(chunk_at(chunks, m), Mention):
        while cat_at(chunks, m) == "aux":
            m += 1
        done, by = chunk_at(chunks, m), isinstance(chunk_at(chunks, m + 2), Mention)
        by = by and value_at(chunks, m + 1) == "by"  # "(the road) being entered by the ego"
        return (done, m + 3) if by and isinstance(done, Event) and done.form == "ed" else None
    m += 1
    while cat_at(chunks, m) in _ON_THE_WAY:
        m += 1
    verb, further = chunk_at(chunks, m), chunk_at(chunks, m + 1)
    if isinstance(verb, Event) and verb.name == "try" and isinstance(further, Event):
        verb, m = further, m + 1  # "is about to enter"
    return (verb, m + 1) if isinstance(verb, Event) and not verb.nominal else None


def turns(chunk: Chunk | None) -> bool:
    """Whether it is a turn, also one back."""
    return isinstance(chunk, Event) and chunk.name in _TURNING


def _told_anew(chunks: list[Chunk], k: int, end: int, *, measured: bool) -> list[Chunk]:
    """The clause as a sentence, if it is measured, or else nothing tells that somebody turns."""
    clause = [c for c in chunks[k + 1 : end] if c.cat not in {"rel", "prep", "sub"}]
    who = next(c for c in clause if isinstance(c, Mention))
    sided = any(c.cat == "dir" for c in clause)
    anew = any(map(turns, clause)) and not any(map(turns, [*chunks[:k], *chunks[end:]]))
    if who.pronoun is not None or not (sided or measured or not who.is_ego or anew):
        return []
    return [*clause, Term("punct", ".", who.i, who.i)]


def _course(
    chunks: list[Chunk], k: int, tokens: list[Token], before: list[Chunk]
) -> tuple[int, Term] | None:
    """``against the direction from which the ego came``: its end, and a word of manner for it."""
    ways = word_lists("ways")
    verb = next((c for c in reversed(before) if isinstance(c, Event)), None)
    whence = value_at(before, len(before) - 1) == "from"  # "from the other direction a van comes"
    if verb is None or verb.name not in _WALKING or whence:
        return None
    m, against = k, False
    word = chunks[k]
    if word.cat in {"prep", "locus", "dir"}:
        against = _text(word, tokens) in ways["against"]
        if not against and _text(word, tokens) not in ways["along"]:
            return None
        m += 1
    m += isinstance(chunk_at(chunks, m), Mention)
    noun = chunk_at(chunks, m)
    if not isinstance(noun, Place) or noun.kind not in _COURSES:
        return None
    against = against or "opposite" in noun.dirs
    early = any(t.low in ways["original"] for t in tokens[noun.i : noun.j])
    m += 1
    if value_at(chunks, m) == "of":
        m += 2  # "of travel", "of the ego"
    told = _heading(chunks, m, tokens)
    if told is None and not early:
        return None
    end = _end_of_turn(chunks, m if told is None else told)
    value = AGAINST if against else ALONG
    return end, Term("manner", value, word.i, chunks[end - 1].j)


def _heading(chunks: list[Chunk], m: int, tokens: list[Token]) -> int | None:
    """``in which the ego was driving``, ``it came from``: where the clause ends."""
    if _preposed(chunks, m):
        m += 2
    else:
        m += value_at(chunks, m) in {"where", "which"} or _text(chunk_at(chunks, m), tokens) == "as"
    clause = _does(chunks, m)
    if clause is None or tokens[clause[0].i].base not in word_lists("ways")["heads"]:
        return None
    m = clause[1]
    stranded = cat_at(chunks, m) in {"prep", "manner"}
    return m + 1 if stranded and not isinstance(chunk_at(chunks, m + 1), Mention | Place) else m


def _end_of_turn(chunks: list[Chunk], m: int) -> int:
    """After ``before the turn``, ``before it turned``, if that follows."""
    if (cat_at(chunks, m), value_at(chunks, m)) != ("sub", "before"):
        return m
    if turns(chunk_at(chunks, m + 1)):
        return m + 2
    clause = _does(chunks, m + 1)
    return clause[1] if clause is not None and turns(clause[0]) else m


def _without_asides(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks without "as the ego sees it after the turn"."""
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        chunk = chunks[k]
        end = _seen(chunks, k, tokens) if low_at(tokens, chunk.i) == "as" else None
        if end is None and isinstance(chunk, Term) and _from_a_side(found):
            end = _end_of_turn(chunks, k)
            end = k if cat_at(chunks, end) in {"dir", "prep"} else end
        if end is not None and end > k:
            k = end
            continue
        found.append(chunk)
        k += 1
    return found


def _from_a_side(before: list[Chunk]) -> bool:
    """``from the left``, ``from its left``."""
    place = before[-1] if before else None
    if not isinstance(place, Place) or place.kind != "side":
        return False
    m = len(before) - (3 if isinstance(chunk_at(before, len(before) - 2), Mention) else 2)
    return value_at(before, m) == "from"


def _seen(chunks: list[Chunk], k: int, tokens: list[Token]) -> int | None:
    clause = _does(chunks, k + 1)
    if clause is None or tokens[clause[0].i].base not in word_lists("ways")["sees"]:
        return None
    m = clause[1]
    return _end_of_turn(chunks, m + isinstance(chunk_at(chunks, m), Mention))


def name_turned_into(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks; a road that is told by the turn into it is an arm, wherever it is told of."""
    turn = next((k for k, c in enumerate(chunks) if turns(c)), None)
    begin = 0
    for k, chunk in enumerate(chunks if turn is not None else []):
        if isinstance(chunk, Place) and chunk.kind in _ROADS and chunk.arm is None:
            before = chunk_at(chunks, k - 1)
            verb = next((c for c in reversed(chunks[begin:k]) if isinstance(c, Event)), None)
            onto = isinstance(before, Term) and low_at(tokens, before.i) in {"into", "onto"}
            done = chunk_at(chunks, k + 1 + (cat_at(chunks, k + 1) == "aux"))
            entered = isinstance(done, Event) and (done.name, done.form) == ("enter", "ed")
            if entered:  # "the road being entered"
                del chunks[k + 1 : chunks.index(done) + 1]
            if entered or (onto and turns(verb)) or _pointed_at(chunk, chunks[:k], tokens):
                whole = chunk_at(chunks, k - 2) if before.value == "of" else None
                for place in (chunk, whole):  # "the zebra crossing of the destination road"
                    if isinstance(place, Place):
                        place.arm, place.user = CrossedArm.EXIT, _turning(chunks, turn or 0)
        begin = k + 1 if ends(chunk) else begin
    return chunks


def _turning(chunks: list[Chunk], k: int) -> Mention | None:
    named = [c for c in chunks[:k] if isinstance(c, Mention)][-1:]
    named += [c for c in chunks[k:] if isinstance(c, Mention)]
    return named[0] if named else None


def _pointed_at(road: Place, before: list[Chunk], tokens: list[Token]) -> bool:
    """``the destination road``; "that road", "the side street", if the turn alone tells which."""
    words = {t.low for t in tokens[road.i : road.j]}
    named = [c for c in before if isinstance(c, Place) and c.kind in _ROADS]
    turned = any(map(turns, before))
    that = not words.isdisjoint(word_list("pointing")) and turned and len(named) <= 1
    that |= road.kind == "access" and road.opened_by("def") and turned and not named
    return that or not words.isdisjoint(word_lists("ways")["reached"])
