"""Noun phrases that continue others: appositions, parts of sets, and sides joined by "and"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Word
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import chunk_at, is_word

_RELATIVE = 3
"""A noun, "which", and "is"."""


def apposed_to(chunks: list[Chunk], k: int, state: State) -> Mention | None:
    """``vehicle 1, a sedan, was …``: the second only describes the first.

    Args:
        chunks: the chunks of the text.
        k: index of the second noun.
        state: what the clause reader remembers.

    Returns:
        Whom it describes; None if it is somebody else.
    """
    if _names_before(chunks, k, state) and isinstance(state.anchor, Mention):
        return state.anchor
    who = state.candidate
    waiting = who is not None and (state.anchor is who or _places(state.anchor, who))
    if not waiting or state.between != {","} or state.candidate_done:
        return None
    following = chunks[k + 1 : k + 3]
    comma = bool(following) and is_word(following[0], ",")
    if not comma and _described_role(chunks, k, state):
        return who
    if not comma or len(following) < 2:
        return None
    after = following[1]
    verb = isinstance(after, Event) and after.form != "ing"
    return who if verb or (isinstance(after, Word) and after.cat == "aux") else None


def _places(anchor: object, who: Mention) -> bool:
    """``the car behind it, a taxi, …``: "it" only says which car."""
    return any(p.target is anchor for p in who.pps)


def also_from(noun: NounPhrase, state: State) -> bool:
    """``from the north and the east``: the preposition counts for both.

    Args:
        noun: the noun just read.
        state: what the clause reader remembers.
    """
    last = state.last_prep
    if last is None or not (isinstance(noun, Place) and noun.kind == "side"):
        return False
    joined = state.between & {"and", "or", ","} and isinstance(last.target, Place)
    if not joined or last.target is None or last.target.j != noun.i - 1:
        return False
    further = Prep(last.word, noun, last.outer, last.on_mention)
    listed = [e.pps for e in state.events[-1:]] + [m.pps for m in state.mentions]
    for phrases in listed:
        if last in phrases:
            phrases.append(further)
    state.last_prep = further
    return True


def bracketed(chunks: list[Chunk], k: int) -> bool:
    """``vehicle 1 (a taxi)``: a noun alone in brackets describes the noun before.

    Args:
        chunks: the chunks of the text.
        k: index of the noun in brackets.
    """
    around = [*chunks[max(0, k - 1) : k], *chunks[k + 1 : k + 2]]
    return [c.value for c in around if isinstance(c, Word)] == ["(", ")"]


def _names_before(chunks: list[Chunk], k: int, state: State) -> bool:
    """``struck V2, an oncoming pickup.``: a noun without a name after one with a name."""
    here, before = chunks[k], state.anchor
    if state.between != {","} or not isinstance(before, Mention) or not isinstance(here, Mention):
        return False
    named = (before.label or "").startswith("#") and not (here.label or "").startswith("#")
    following = chunk_at(chunks, k + 1)
    listed = isinstance(following, Word) and following.cat == "conj"
    indefinite = any(m.value == "indef" for m in here.mods)
    acts = isinstance(following, Event) and following.form != "ing"
    return named and indefinite and not listed and not acts


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


def _described_role(chunks: list[Chunk], k: int, state: State) -> bool:
    """``the driver, a man from Leeds, lost …``: a noun and its phrases between two commas."""
    role, noun = state.candidate, chunks[k]
    if role is None or not role.heads or not isinstance(noun, Mention) or not noun.mods:
        return False
    bare = noun.mods[0].value == "indef" or noun.is_ego
    after = chunks[k + 1 : k + 9]
    ends = next((m for m, c in enumerate(after) if is_word(c, ",")), None)
    if not bare or ends is None or ends + 1 >= len(after):
        return False
    joined = any(isinstance(c, Word) and c.cat in {"conj", "sub", "copy"} for c in after[:ends])
    verb = after[ends + 1]
    finite = isinstance(verb, Event) and verb.form != "ing" and not verb.nominal
    return not joined and (finite or (isinstance(verb, Word) and verb.cat == "aux"))


def relative_noun(chunks: list[Chunk], k: int) -> Mention | None:
    """``struck vehicle 2, which was a taxi``: the noun says what vehicle 2 is.

    Args:
        chunks: the chunks of the text.
        k: index of the noun.

    Returns:
        Whom it describes, if it does.
    """
    noun = chunks[k]
    before = [c for c in chunks[max(0, k - 4) : k] if getattr(c, "value", "") != ","]
    if len(before) < _RELATIVE or not isinstance(noun, Mention) or not noun.mods:
        return None
    who, joint, copula = before[-_RELATIVE:]
    relative = isinstance(joint, Word) and joint.cat == "rel"
    said = isinstance(copula, Word) and (copula.cat, copula.value) == ("aux", "be")
    single = noun.mods[0].value == "indef" or noun.is_ego
    return who if relative and said and single and isinstance(who, Mention) else None


def further_ones(mention: Mention, k: int, chunks: list[Chunk], state: State) -> bool:
    """``two cars coming from the left and one from the right``: three cars, not two.

    Args:
        mention: the noun.
        k: index of the noun.
        chunks: the chunks of the text.
        state: what the clause reader remembers.
    """
    if mention.pronoun not in {"one", "count"} or not {"and"} <= state.between <= {"and", "conj"}:
        return False
    before, following = state.anchor, chunk_at(chunks, k + 1)
    participle = isinstance(before, Event) and before.form == "ing" and len(before.subject) == 1
    who = before.subject[0] if isinstance(before, Event) and participle else before
    number = who.mod("num") if isinstance(who, Mention) and who.heads else None
    if number is None or number.data["number"] < 2:
        return False
    again = isinstance(following, Event) and following.form == "ing" and participle
    off = is_word(following, "from")
    return again or (off and state.last_prep is not None and state.last_prep.value == "from")
