"""Nouns joined by "and", "or" or commas: when the second takes the role of the first."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import is_word, sentence_end


def joins(mention: Mention, state: State) -> bool:
    """``a car and a truck``: the second takes the role of the first."""
    anchor = state.anchor
    _doing_the_same(mention, state)
    listed = "and" in state.between or "or" in state.between or state.between == {","}
    if not (isinstance(anchor, Mention) and listed) or state.between & {"sub", "copy"}:
        return False
    joint = state.at(-1)
    if isinstance(joint, Word) and "next" in joint.term.data and state.verb_follows:
        return False  # "…, and then the van brakes": what happens next
    if mention.pronoun in {"count", "one", "another"} and "," in state.between:
        return False  # "four vans, two turning left": some of them, not further ones
    waiting = anchor is state.waiting
    waiting = waiting and not any(anchor in event.subject for event in state.events)
    said = bool({"aux:be", "aux:have"} & state.between) or _is_somewhere(anchor, state)
    said = said or state.being is not None
    told = state.verb_follows or is_word(state.at(1), "be")
    complete = said and told  # "I'm here and a van …", "and a van is behind it"
    if complete or (state.between == {","} and not (waiting and _list_goes_on(state))):
        return False
    let = _let(anchor, state)
    if not waiting and ((state.verb_follows and not let) or "," in state.between):
        return False
    if _in_parallel(anchor, state):
        return False
    mention.joined = anchor
    mention.pps += [p for p in anchor.pps if p.fronted]
    if waiting:
        state.candidate = mention
    for event in state.events:
        if event.object is anchor:
            event.object = mention
    state.stand_at(mention)
    return True


def _is_somewhere(who: Mention, state: State) -> bool:
    """``we're in the left lane of the motorway and a van …``: a clause of its own, without verb."""
    since = [c for c in state.chunks[: state.k] if c.i >= who.j]
    return any(isinstance(c, Word) and (c.cat, c.value) == ("aux", "be") for c in since)


def _list_goes_on(state: State) -> bool:
    """``a car, a van and a bus``: a comma alone does not make a list."""
    rest = state.chunks[state.k + 1 : sentence_end(state.chunks, state.k + 1)]
    joint = next((c for c in rest if isinstance(c, Event) or _joins(c)), None)
    return _joins(joint)


def _joins(chunk: Chunk | None) -> bool:
    return chunk is not None and chunk.value in {"and", "or"}


def _doing_the_same(mention: Mention, state: State) -> None:
    """``waits for a van coming from the left and a bus coming from the right``: for both."""
    last, following = state.last, state.at(1)
    if last is None or last.form != "ing" or last.finite or "and" not in state.between:
        return
    alike = isinstance(following, Event) and following.form == "ing"
    if alike and last.subject and mention.heads:
        mention.prep = last.subject[-1].prep


def _let(anchor: Mention, state: State) -> bool:
    """``lets two people and a cyclist cross``: both are let."""
    last = state.last
    if last is None or last.control != "object" or last.object is not anchor:
        return False
    verb = next((c for c in state.after(3) if isinstance(c, Event)), None)
    return verb is not None and verb.form == "base"


def _in_parallel(anchor: Mention, state: State) -> bool:
    """``a bus approaches the ego from the left and a taxi from the right``: the taxi does, too."""
    known = anchor.is_ego or anchor.pronoun is not None  # others are described by where they are
    if not known or state.last is None or state.last.object is not anchor:
        return False
    before, place, after = (state.at(n) for n in (-3, -2, 1))
    prep = isinstance(before, Word) and before.cat == "prep" and is_word(after, before.value)
    return prep and isinstance(place, Place)
