"""Words that stand for a verb, or make it another: ``Ego straight``, ``cuts the van off``."""

from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import entitle
from scegen.understanding.phrases.lookahead import BOUNDARIES, cat_at, chunk_at, ends, value_at
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token, low_at

_OPENERS = frozenset({",", "and", "but", "while", "when", "(", ":"})
_ENDS = frozenset({",", "and", "but", "while", "when", "(", ")", "before", "or",
                   "in", "from", "into"})  # fmt: skip
_HOLDING = frozenset({"match", "follow", "use", "move", "light", "unknown", "try"})
_BETWEEN = frozenset({"manner", "noted", "inert", "unknown"})


def complete(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """The events, with one for each direction that is all that is said of what somebody does.

    Nouns of doings get their subject.
    """
    entitle(chunks, events, tokens)
    found = [*events, *_courses_said(chunks, events, tokens)]
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event) and chunk.nominal and not chunk.subject:
            chunk.subject = _whose(chunks, k, found)
        elif isinstance(chunk, Term) and _predicative(chunks, k):
            leads = [e for e in found if e.name in word_list("with_a_direction")]
            subject = _whose(chunks, k, found)
            if subject and not any(chunk in e.mods for e in leads):
                going = Event("move", chunk.i, chunk.j, "s", finite=True, mods=[chunk])
                going.subject, going.sentence = subject, _sentence_at(chunk.i, found)
                found.append(going)
    return sorted(found, key=lambda e: (e.sentence, e.i)) if len(found) > len(events) else found


def _predicative(chunks: list[Chunk], k: int) -> bool:
    """A bare direction at the end of its clause, or right before a phrase of place."""
    if chunks[k].cat != "dir" or chunks[k].value not in WAYS:
        return False
    return k + 1 == len(chunks) or value_at(chunks, k + 1) in _ENDS | BOUNDARIES


def _whose(chunks: list[Chunk], k: int, events: list[Event]) -> list[Mention]:
    """Who does it: the noun right before, or after a comma the one that the clause is about."""
    m = k - 1
    while cat_at(chunks, m) == "manner":
        m -= 1
    before = chunk_at(chunks, m)
    acting = {id(who) for e in events for who in e.subject if e.i < chunks[k].i}
    if isinstance(before, Mention):
        free = id(before) not in acting and _opens(chunks, m) and before.prep is None
        return [before] if free and not before.negated else []
    if value_at(chunks, m) != ",":
        return []
    for n in range(m - 1, -1, -1):
        chunk = chunks[n]
        if ends(chunk):
            break
        if isinstance(chunk, Mention) and chunk.prep is None and _opens(chunks, n):
            return [] if chunk.negated else [chunk]
    return []


def _opens(chunks: list[Chunk], m: int) -> bool:
    """Whether a noun begins its clause."""
    return m == 0 or chunks[m - 1].value in _OPENERS | BOUNDARIES


def _courses_said(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """A verb of motion for each noun that says which way somebody goes."""
    found = []
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, NounPhrase) or isinstance(chunk, Mention):
            continue
        if tokens[chunk.j - 1].base not in word_list("courses"):
            continue
        way = _way(chunk, k, chunks)
        who = _on_whose_way(chunk, k, chunks, events, tokens) if way is not None else []
        if way is None or not who:
            continue
        for event in events:
            event.mods = [m for m in event.mods if m is not way]
        going = Event("move", chunk.i, max(chunk.j, way.j), "ing", mods=[way], subject=who)
        going.sentence = _sentence_at(chunk.i, events)
        found.append(going)
    return found


def _sentence_at(i: int, events: list[Event]) -> int:
    """The number of the sentence that holds a token, by the events before it."""
    return max((e.sentence for e in events if e.i < i), default=0)


def _way(noun: NounPhrase, k: int, chunks: list[Chunk]) -> Term | None:
    m = k + 1
    while cat_at(chunks, m) in _BETWEEN:
        m += 1
    word = chunk_at(chunks, m)
    after = [word] if isinstance(word, Term) and word.cat == "dir" else []
    return next((w for w in [*noun.ways, *after] if w.value in WAYS), None)


def _on_whose_way(
    noun: NounPhrase, k: int, chunks: list[Chunk], events: list[Event], tokens: list[Token]
) -> list[Mention]:
    verb = next((e for e in events if e.object is noun), None)
    if verb is not None and noun.owner is not None and verb.name not in _HOLDING:
        return [noun.owner]  # "blocks the ego's way straight on"
    if verb is not None:
        return verb.subject if verb.name in _HOLDING and not verb.passive else []
    prep = chunk_at(chunks, k - 1)
    prep = chunk_at(chunks, k - 2) if isinstance(prep, Mention) else prep
    if not isinstance(prep, Term) or low_at(tokens, prep.i) not in word_list("along"):
        return []
    for chunk in reversed(chunks[:k]):
        if ends(chunk):
            break
        if isinstance(chunk, Mention) and (chunk.heads or chunk.pronoun) and not chunk.possessor:
            return [chunk]
    return [c for c in chunks[k + 1 :] if isinstance(c, Mention)][:1]


_CHANGE_REACH = 7
_BOTH = 2


def between_lanes(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``changes from the inner to the outer lane`` is a change of lane."""
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Event) or tokens[chunk.i].base not in word_list("changing"):
            continue
        for before, place in pairwise(chunks[k : k + 1 + _CHANGE_REACH]):
            direct = before is chunk  # "has to change two lanes to the right"
            if not direct and (isinstance(before, Mention | Event) or before.cat == "punct"):
                break
            goal = direct or before.value in {"to", "into"}
            if goal and isinstance(place, Place) and place.kind == "lane":
                chunk.name = "lane_change"
    return chunks


def with_particles(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``cuts the van off``, ``runs him over``: "cut off" and "run over" with the object inside."""
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Event):
            continue
        whom, particle, after = (*chunks[k + 1 : k + 4], None, None, None)[:3]
        last = after is None or after.cat in {"punct", "conj"}
        split = isinstance(whom, Mention) and isinstance(particle, Term) and last
        if split and particle is not None and particle.cat != "manner":
            both = longest_match([tokens[chunk.i], tokens[particle.i]], 0)
            if both is not None and both.j == _BOTH and both.has("verb"):
                chunk.name = both.get("verb").value
        if chunk.name == "cut":
            chunk.name = "cut_in"
    return chunks
