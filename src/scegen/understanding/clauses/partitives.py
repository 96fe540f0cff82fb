"""Parts of sets: "four of them trucks", "two cars from the left and one from the right"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.clauses.state import State


def partitive_before(k: int, chunks: list[Chunk]) -> Mention | None:
    """``four of them trucks``, ``one of which a bus``: the noun says what kind they are.

    Args:
        k: index of the noun.
        chunks: the chunks of the text.
    """
    if k < 3:
        return None
    part, of, whole = chunks[k - 3 : k]
    if not isinstance(part, Mention) or not isinstance(of, Word) or of.value != "of":
        return None
    named = isinstance(whole, Mention) and whole.pronoun == "they"
    return part if named or (isinstance(whole, Word) and whole.cat == "rel") else None


def further_ones(mention: Mention, k: int, chunks: list[Chunk], state: State) -> bool:
    """``two cars coming from the left and one from the right``: three cars, not two.

    Args:
        mention: the noun.
        k: index of the noun.
        chunks: the chunks of the text.
        state: what the clause reader remembers.
    """
    if mention.pronoun not in {"one", "count"} or state.between - {"and", "conj"}:
        return False
    last = state.events[-1] if state.events else None
    following = chunks[k + 1] if k + 1 < len(chunks) else None
    if "and" in state.between and _in_the_same_words(state.anchor, following, state):
        return True
    if last is None or last.form != "ing" or last.finite or len(last.subject) != 1:
        return False
    described = isinstance(following, Event) and following.form == "ing"
    described = described or (isinstance(following, Word) and following.cat == "prep")
    number = last.subject[0].mod("num")
    several = number is not None and number.data["number"] > 1 and bool(last.subject[0].heads)
    return described and several and "and" in state.between


def _in_the_same_words(before: object, following: Chunk | None, state: State) -> bool:
    """``two cars from the left and one from the right``: each with a place of its own."""
    verb = before if isinstance(before, Event) and len(before.subject) == 1 else None
    who = verb.subject[0] if verb is not None else before
    prep = state.last_prep
    if not isinstance(who, Mention) or not who.heads or prep is None:
        return False
    if prep not in (verb.pps if verb is not None else who.pps):
        return False
    number = who.mod("num")
    several = number is not None and number.data["number"] > 1
    side = isinstance(prep.target, Place) and prep.target.kind == "side"
    alike = isinstance(following, Word) and following.value == prep.value
    return several and alike and (prep.value == "from" or (side and prep.value == "in"))
