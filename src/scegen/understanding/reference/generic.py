"""Nobody, everybody, and nobody in particular: ``no driver``, ``red for cross traffic``."""

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at, value_at
from scegen.understanding.reference.mention_words import KINDS
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_LETTING_BY = frozenset({"wait", "yield", "stop", "brake", "slow", "hard_brake", "react"})
_NEAR = 2


def mark_generic(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``red for cross traffic``, ``too narrow for two cars``: nobody in particular.

    Traffic that somebody waits for, or gives way to, is there.
    Who is nobody in particular is marked as ``negated``.
    """
    met = {id(p.target) for e in events if e.name in _LETTING_BY for p in e.pps}
    each = {
        id(p.target)
        for e in events
        for p in e.pps
        if any(m.pronoun == "all" and m.head is None for m in e.subject)
    }
    acting = {id(m) for e in events for m in e.subject}
    _what_lies_there(chunks, events)
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Mention) and chunk.pronoun == "one":
            chunk.negated = chunk.negated or _is_no_participant(k, chunks)
        if not isinstance(chunk, Mention) or chunk.head is None:
            continue
        if id(chunk) in each and any(p.value == "ahead" for p in chunk.pps):
            chunk.negated = True  # "each 20 m from the car in front": the next of them
        first = chunk.joined  # "no vehicles or people", "without any vans or buses"
        if first is not None and (first.negated or first.stands_after("without")):
            own = chunk.mod("det", "num", "quant", "possessive") or chunk.pronoun or chunk.is_ego
            chunk.negated = chunk.negated or not own
        if chunk.prep is None:
            unmet = _only_the_scene(chunk, k, chunks) or _called_to(chunk, k, chunks, tokens)
            chunk.negated = chunk.negated or unmet
            continue
        chunk.negated = chunk.negated or _fits(chunk, chunk.prep, tokens)
        alike = tokens[chunk.prep.j - 1].low in word_list("comparing")  # "as fast as a train"
        alike = alike and chunk.opened_by("indef") and not (chunk.pps or id(chunk) in acting)
        chunk.negated = chunk.negated or alike
        several = chunk.plural and chunk.mod("det", "num", "quant") is None
        lit = any(isinstance(c, Place) and c.kind == "signal" for c in chunks[max(0, k - 4) : k])
        later = (m for m in chunks[k + 1 :] if isinstance(m, Mention) and not m.is_mass)
        # "turns left across oncoming traffic; an oncoming van …"
        told = "opposite" in chunk.dirs and any("opposite" in m.dirs for m in later)
        anybody = chunk.is_mass or (several and lit)
        seen = chunk_at(chunks, k - 2)  # "the view of oncoming traffic"
        met_head_on = "opposite" in chunk.dirs and chunk.prep.value == "against"
        purpose = (chunk.prep.value in {"for", "against"} and not met_head_on) or (
            chunk.prep.value == "of" and isinstance(seen, Thing) and seen.kind == "view"
        )
        general = anybody and (purpose or told) and id(chunk) not in met
        chunk.negated = chunk.negated or general


def _what_lies_there(chunks: list[Chunk], events: list[Event]) -> None:
    """``loses a pallet; it lies ahead``, ``the ego goes round it``: the thing, and nobody."""
    things = [c for c in chunks if isinstance(c, Thing) and c.lies_there]
    for event in (e for e in events if things):
        for it in (m for m in event.subject if m.pronoun == "it"):
            lies = event.lemma in word_list("lying") and any(c.i < it.i for c in things)
            it.negated = it.negated or lies
        meant = event.object
        if isinstance(meant, Mention) and meant.pronoun == "it":
            since = [c for c in chunks if isinstance(c, Thing | Mention) and c.i < meant.i]
            named = next((c for c in reversed(since) if c not in event.subject), None)
            if isinstance(named, Thing) and named.lies_there:
                meant.negated, event.object = True, named


def _is_no_participant(k: int, chunks: list[Chunk]) -> bool:
    """``the manoeuvre is a slow one``: what is told of something else."""
    what, copula = chunk_at(chunks, k - 2), chunk_at(chunks, k - 1)
    return (copula.cat, copula.value) == ("aux", "be") and isinstance(what, Event | Thing | Place)


def _fits(mention: Mention, prep: Term, tokens: list[Token]) -> bool:
    """``wide enough for one car``, ``no room for two``: a measure of the road."""
    known = mention.is_ego or any(m.value == "def" for m in mention.mods)
    before = {token.low for token in tokens[max(0, prep.i - _NEAR) : prep.i]}
    no_room = "no" in before and before & word_list("emptiness")
    return prep.value == "for" and not known and bool(no_room or before & word_list("wide"))


def _called_to(mention: Mention, k: int, chunks: list[Chunk], tokens: list[Token]) -> bool:
    """``Mum, that lorry is braking!``: somebody who is spoken to."""
    around = value_at(chunks, k - 1), value_at(chunks, k + 1)
    listed = chunk_at(chunks, k + 2)  # "mum, dad and a dog cross"
    opens = around[0] in {*BOUNDARIES, ",", ""} and around[1] in {",", "!"}
    bare = isinstance(listed, Mention) and not (listed.mods or listed.is_ego)
    alone = opens and not (mention.mods or bare)
    return alone and tokens[mention.j - 1].low in word_list("relatives")


def _only_the_scene(mention: Mention, k: int, chunks: list[Chunk]) -> bool:
    """``Stop-and-go traffic on a ring road; the car ahead …``: where it all takes place."""
    opens = k == 0 or chunks[k - 1].value in BOUNDARIES
    if not opens or not mention.is_mass or mention.dirs:
        return False
    for chunk in chunks[k + 1 :]:
        if isinstance(chunk, Event | Mention):
            return False
        if chunk.value in BOUNDARIES:
            after = [c for c in chunks if c.i > chunk.i and isinstance(c, Mention) and c.heads]
            return any(not c.is_ego for c in after)
    return False


_UNDONE = frozenset({"hide", "block", "encounter", "react", "avoid"})
"""What is not done if nothing does it; it is told of nobody in particular."""
_ASKED = frozenset({"inert", "try", "encounter", "light"})
_NONE = frozenset({"nobody", "everybody"})


def deny_of_everybody(events: list[Event]) -> None:
    """``no driver gives way``, ``nobody may turn left``: everybody does not."""
    for event in events:
        whom = [n for n in event.nouns("to", "for") if isinstance(n, Mention)]
        nobody = event.name in _LETTING_BY and any(m.pronoun == "nobody" for m in whom)
        event.negated = event.negated or nobody  # "gives way to nobody"
        named = [m for m in event.subject if m.negated or m.pronoun in _NONE]
        verbal = not event.nominal and event.name in word_list("owed") | _UNDONE
        if not named or not verbal or event.form == "ing":
            continue
        if event.name in _UNDONE:
            none = any(m.has("det", "negative") or m.pronoun == "nobody" for m in named)
            event.negated = event.negated or none
            event.unable = event.unable or (none and event.name == "encounter")
            continue
        event.negated = True
        for mention in named:
            mention.negated, mention.pronoun = False, "everybody"


def answer(events: list[Event], tokens: list[Token]) -> None:
    """``Did it brake? No``: it did not; ``you know the bend?``: who is asked takes no part."""
    marks = [k for k, token in enumerate(tokens) if token.low in {".", "!", "?"}]
    for event in events:
        mark = next((k for k in marks if k >= event.j), None)
        if mark is None or tokens[mark].low != "?":
            continue
        reply = next((t.low for t in tokens[mark + 1 :] if t.kind == "word"), "")
        event.negated = event.negated or reply in word_list("refusing")
        for who in event.subject if event.name in _ASKED else []:
            who.negated = who.negated or tokens[who.i].low == "you"


def everybody(mention: Mention, draft: Draft) -> list[Entity]:
    """Of whom "no driver", "no car" or "nobody" is said."""
    kinds = [KINDS[h.value] for h in mention.heads if h.value in KINDS]
    movers = [e for e in draft.entities if e.moving_vehicle]
    if not kinds or kinds == [ParticipantKind.CAR]:
        return movers
    return [e for e in draft.entities if e.kind in kinds and not e.parked]
