"""Fills in verbs that are left out: "one goes left, the other right"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at
from scegen.understanding.phrases.predicates import complete
from scegen.understanding.words.tokens import Token

_JOINTS = frozenset({"and", "but", ",", "while", "when", ";"})
_EMPTY = frozenset({"light", "try", "cause", "inert", "unknown", "likewise", "avoid"})
_MOST_AFTER = 3


def fill_in(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """The events with a copy of the verb before for each clause that leaves its verb out.

    Such a clause is a participant after "and" or a comma, followed by nothing but a direction,
    an exit or a phrase of place: what the verb before says of somebody else.

    Args:
        chunks: the chunks of the text; an ordinal that stands for an exit is replaced by it.
        events: its events.
        tokens: its tokens.
    """
    for event in events:
        event.lemma = tokens[event.i].forms[-1][0]
    _likewise(events, tokens)
    acting = {id(m) for e in events for m in (*e.subject, e.object)}
    found = [*events, *_denied(chunks, events)]
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Mention) or id(chunk) in acting or chunk.prep is not None:
            continue
        joint = chunk_at(chunks, k - 1)
        if not isinstance(joint, Word) or joint.value not in _JOINTS:
            continue
        verb = _verb_before(chunk, events)
        if verb is None or not _ends(chunks, k + 2):
            continue
        if _further(chunk, chunks, k, verb):
            continue
        copy = _copy(verb, chunk, chunks, k + 1)
        if copy is not None:
            found.append(copy)
    return complete(chunks, found, tokens)


def _further(mention: Mention, chunks: list[Chunk], k: int, verb: Event) -> bool:
    """``waits for a car from the left and a van from the right``: for both.

    Whom the verb governs has a phrase of place of its own there, and so has the second one.
    """
    last = next((c for c in reversed(chunks[: k - 1]) if isinstance(c, Mention)), None)
    governs = next((p for p in verb.pps if p.target is last and p.word.cat == "prep"), None)
    if last is None or governs is None or not last.pps or last.i < verb.i:
        return False
    mention.joined = last
    verb.pps.append(replace(governs, target=mention))
    return True


def _likewise(events: list[Event], tokens: list[Token]) -> None:
    """``and the van ahead does the same``: what somebody else was last said to do."""
    for k, event in enumerate(events):
        if (
            event.i
            and tokens[event.i].low in word_list("does")
            and tokens[event.i - 1].low in {"so", "as"}
        ):
            _turned_round(event)
        later = any((m.cat, m.value) == ("quantity", "time") for m in event.mods)
        if event.name == "follow" and later and not (event.object or event.pps):
            event.name = "likewise"  # "a van sets off and the ego follows 1 s later"
        if event.name != "likewise":
            continue
        who = set(map(id, event.subject))
        before = [
            e
            for e in events[:k]
            if e.name not in _EMPTY and e.subject and not who & set(map(id, e.subject))
        ]
        if before:
            model = before[-1]
            event.name, event.object = model.name, event.object or model.object
            event.mods = [*event.mods, *(m for m in model.mods if m.cat == "dir")]
            event.pps = [*event.pps, *(p for p in model.pps if isinstance(p.target, Place))]


def _denied(chunks: list[Chunk], events: list[Event]) -> list[Event]:
    """``has to yield but does not``: the verb before, denied."""
    found = []
    for k, chunk in enumerate(chunks[1:], start=1):
        if not isinstance(chunk, Word) or chunk.cat != "neg":
            continue
        helper, after = chunks[k - 1], chunk_at(chunks, k + 1)
        does = isinstance(helper, Word) and (helper.cat, helper.value) == ("aux", "do")
        ends = after is None or (isinstance(after, Word) and after.value in _JOINTS | BOUNDARIES)
        before = [e for e in events if e.j <= helper.i and e.subject and not e.nominal]
        if does and ends and before:
            again = replace(before[-1], i=helper.i, j=chunk.j, negated=True, modal=False, pps=[])
            who = chunk_at(chunks, k - 2)
            fresh = isinstance(who, Mention) and who.prep is None
            again.subject = [who] if isinstance(who, Mention) and fresh else again.subject
            found.append(replace(again, mods=[], parent=None, children=[], alternative=None))
    return found


def _turned_round(event: Event) -> None:
    """``and so does the van``: the subject stands after the verb."""
    if isinstance(event.object, Mention):
        event.name, event.subject, event.object = "likewise", [event.object], None


def _verb_before(mention: Mention, events: list[Event]) -> Event | None:
    before = [e for e in events if e.j <= mention.i and e.subject and not e.nominal]
    return before[-1] if before and before[-1].premod_of is None else None


def _ends(chunks: list[Chunk], k: int) -> bool:
    """Whether the clause ends before a verb comes: nothing but a phrase of place may follow."""
    for chunk in chunks[k : k + _MOST_AFTER]:
        if isinstance(chunk, Word) and (chunk.value in _JOINTS or chunk.value in BOUNDARIES):
            return True
        if isinstance(chunk, Event | Mention) or (isinstance(chunk, Word) and chunk.cat == "aux"):
            return False
    return True


def _copy(verb: Event, who: Mention, chunks: list[Chunk], k: int) -> Event | None:
    rest = chunk_at(chunks, k)
    fresh = replace(verb, subject=[who], parent=None, children=[], alternative=None)
    if isinstance(rest, Mention) and rest.pronoun == "ordinal" and isinstance(verb.object, Place):
        chunks[k] = place = Place(rest.i, rest.j, rest.mods, verb.object.head, None)
        place.kind = verb.object.kind
        return replace(fresh, i=rest.i, j=rest.j, object=place)
    if isinstance(rest, NounPhrase) and type(rest) is type(verb.object):
        return replace(fresh, i=rest.i, j=rest.j, object=rest)
    if isinstance(rest, Word) and rest.cat == "prep" and k + 1 < len(chunks):
        return _copy_phrase(fresh, rest, chunks[k + 1])
    return None


def _copy_phrase(fresh: Event, word: Word, target: Chunk) -> Event | None:
    """``a car comes from the left and a van from the right``."""
    if not isinstance(target, Place):
        return None
    alike = any(p.value == word.value for p in fresh.pps)
    alike = alike and (word.value != "in" or fresh.form != "ing")
    kept = [p for p in fresh.pps if p.value != word.value]
    if not alike:
        return None
    return replace(fresh, i=word.i, j=target.j, pps=[*kept, Prep(word, target)])
