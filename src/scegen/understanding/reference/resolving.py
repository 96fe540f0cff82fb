"""Resolves the mentions of a text in their order, with what the clauses say about them."""

from __future__ import annotations

from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.clauses.relatives import aside
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES
from scegen.understanding.phrases.on_sides import sides_of
from scegen.understanding.reference.describing import describe
from scegen.understanding.reference.discourse import Discourse
from scegen.understanding.reference.generic import mark_generic
from scegen.understanding.reference.groups import rank
from scegen.understanding.words.tokens import Token

_CLOSING_IN = frozenset({"avoid"})
_DONE_TO = frozenset({"tailgate", "undertake", "cut_off", "cut_in", "overtake"})
_BEHIND = frozenset({"follow", "tailgate"})
_BACK = frozenset({"it", "him", "they"})


def resolve_mentions(chunks: list[Chunk], events: list[Event], discourse: Discourse) -> None:
    """Finds out whom every mention refers to, in the order of the text.

    Args:
        chunks: the chunks of the text.
        events: its events.
        discourse: the participants so far.
    """
    describe(chunks, events, discourse.tokens)
    mark_generic(chunks, events)
    rank(chunks, events, discourse.tokens)
    objects = {id(e.object) for e in events}
    subjects = {
        id(m)
        for e in events
        for m in e.subject
        if not aside(e, events) and (e.finite or not (id(m) in objects or m.prep is not None))
    }  # "meets a van blocking the lane", "waits for a van to pass": not about the van
    subjects = (subjects | _said_to_be_there(chunks)) - _in_reasons(chunks, discourse.tokens)
    acted_on = {id(e.object): e for e in events if e.object is not None}
    everywhere = sides_of(events, chunks)
    beside = _beside(chunks)
    settled = _settled(events)
    around = {
        id(m): e
        for e in events
        for p in e.pps
        if isinstance(p.target, Mention)
        and (p.on_mention is None or p.on_mention in e.subject)
        and (_is_it(p.target) or _definite(p.target) or p.value == "between")
        for m in (p.target, *(c for c in chunks if isinstance(c, Mention) and c.joined is p.target))
    }  # "drives between the ego and the van ahead": not the van itself
    behind = {
        id(p.target): e
        for e in events
        for p in e.pps
        if (p.word.cat, p.value, p.outer) == ("locus", "behind", None) and p.on_mention is None
    }
    relative = {
        id(m): e.object
        for e in events
        for m in e.subject
        if m.pronoun and isinstance(e.object, Mention) and e.object.i < m.i
    }  # "the van it is following": "it" is not the van
    acted_on = {**around, **acted_on}
    heads = {
        id(p.target): c
        for c in chunks
        if isinstance(c, Mention)
        for p in c.pps
        if p.word.cat == "locus" and isinstance(p.target, Mention)
    } | relative
    heads |= {
        id(p.target.owner): c
        for c in chunks
        if isinstance(c, Mention)
        for p in c.pps
        if isinstance(p.target, Place) and p.target.owner is not None
    }  # "two vans on either side of it"
    held = _held_by(chunks)
    owners = {id(c.owner) for c in chunks if isinstance(c, Mention)}
    stand = {id(m): e for e in events if e.name == "park" and not e.negated for m in e.subject}
    waiting: list[Mention] = []
    early: list[Mention] = []
    for chunk in chunks:
        _told_by_somebody(chunk, discourse)
        if not isinstance(chunk, Mention) or (id(chunk) in owners and _on_no_road(chunk)):
            continue
        if id(chunk) in held:
            continue
        if chunk.partitive and chunk.pronoun in word_list("parts"):
            waiting.append(chunk)
            continue
        if chunk.pronoun in _BACK and _named_later(chunk, chunks):
            early.append(chunk)
            continue
        _resolve(chunk, discourse, subjects, acted_on, everywhere, beside, settled, heads, behind)
        if id(chunk) in stand:
            _parked(chunk, stand[id(chunk)])
        if early and id(chunk) in subjects:
            waiting, early = [*waiting, *early], []
        for earlier in waiting:
            _resolve(
                earlier, discourse, subjects, acted_on, everywhere, beside, settled, heads, behind
            )
        waiting = []
    for earlier in (*waiting, *early):
        _resolve(earlier, discourse, subjects, acted_on, everywhere, beside, settled, heads, behind)


def _in_reasons(chunks: list[Chunk], tokens: list[Token]) -> set[int]:
    """``the ego waits because a van comes, so it is late``: "it" is not who the reason is about."""
    found: set[int] = set()
    here: list[int] = []
    for before, chunk in pairwise(chunks):
        reason = isinstance(before, Word) and (before.cat, before.value) == ("sub", "because")
        if isinstance(before, Word) and before.value in BOUNDARIES:
            here = []
        elif reason and tokens[before.i].low == "so":
            found |= {*here} if isinstance(chunk, Mention) and chunk.pronoun == "it" else set()
        elif reason:
            here.append(id(chunk))
    return found


def _said_to_be_there(chunks: list[Chunk]) -> set[int]:
    """``A truck is in front of the ego.``: of whom a sentence without a verb but "is" tells."""
    found: set[int] = set()
    opens: Mention | None = None
    fresh = True
    for chunk in chunks:
        if isinstance(chunk, Word) and (chunk.value in BOUNDARIES or chunk.cat == "sub"):
            opens, fresh = None, True
            continue
        if isinstance(chunk, Mention) and fresh:
            opens, fresh = chunk, False
        elif isinstance(chunk, Word) and (chunk.cat, chunk.value) == ("aux", "be"):
            found |= {id(opens)} if opens is not None else set()
        elif isinstance(chunk, Event):
            found -= {id(opens)} if opens is not None else set()
            opens = None
        fresh = False
    return found


def _told_by_somebody(chunk: Chunk, discourse: Discourse) -> None:
    """``in our lane``, ``sits on my bumper``: whoever tells it takes part."""
    if isinstance(chunk, Place | Thing) and any(m.value == "first_person" for m in chunk.mods):
        discourse.observer(chunk.i, chunk.j)
    if not isinstance(chunk, Word | Event) or not discourse.tells(chunk.i, chunk.j):
        return
    ego = discourse.observer(chunk.i, chunk.j)
    if isinstance(chunk, Event) and chunk.object is None and chunk.name in _DONE_TO:
        whom = Mention(chunk.i, chunk.j, [], None)
        chunk.object, whom.entities = whom, [ego]


def _parked(mention: Mention, event: Event) -> None:
    """``vehicle 1 was parked``: from then on, "the parked vehicle" is that one."""
    for entity in mention.entities if event.form == "ed" else []:
        entity.parked = entity.parked or (entity.is_vehicle and not entity.ego)


def _named_later(pronoun: Mention, chunks: list[Chunk]) -> bool:
    """``before it turns right, the ego …``: the main clause names whom "it" means."""
    opened = False
    if any(isinstance(c, Mention) and c.entities for c in chunks):
        return False
    for chunk in chunks:
        if isinstance(chunk, Word) and chunk.i < pronoun.i:
            opened = opened or chunk.cat == "sub"
        if isinstance(chunk, Word) and chunk.i > pronoun.i and chunk.value in {".", ";"}:
            return False
        if isinstance(chunk, Mention) and chunk.i > pronoun.i and chunk.heads:
            return opened
    return False


def _resolve(
    mention: Mention,
    discourse: Discourse,
    subjects: set[int],
    acted_on: dict[int, Event],
    everywhere: dict[int, int],
    beside: dict[int, Mention],
    settled: set[int],
    heads: dict[int, Mention],
    behind: dict[int, Event],
) -> None:
    event = acted_on.get(id(mention))
    exclude = [e for m in event.subject for e in m.entities] if event else []
    if mention.joined is not None and mention.pronoun is None:
        exclude = [*exclude, *mention.joined.entities]  # "a van and the van behind": two
    stands = [e for e in discourse.entities if e.parked]
    if event is not None and event.name == "bypass" and mention.pronoun == "it" and stands:
        exclude += [e for e in discourse.entities if not e.parked]  # "drives around it"
    described = heads.get(id(mention))
    if described is not None:
        exclude = [*exclude, *described.entities]  # "a bus behind it": "it" is not the bus
    placed = beside.get(id(mention))
    if placed is not None:
        exclude = [*exclude, *placed.entities]
    discourse.resolve(
        mention,
        subject=id(mention) in subjects,
        exclude=exclude,
        sides=everywhere.get(id(mention)),
        settled=id(mention) in settled,
    )
    _seen_from_the_ego(mention, described)
    if event is not None and event.name in _BEHIND | _CLOSING_IN and mention is event.object:
        _in_front_of_the_ego(mention, event)
    driving = behind.get(id(mention))
    if driving is not None:
        _in_front_of_the_ego(mention, driving)


def _in_front_of_the_ego(mention: Mention, event: Event) -> None:
    """``the ego follows a car``, ``drives behind a car``: that is "the car ahead"."""
    egos = [e for m in event.subject for e in m.entities if e.ego]
    if egos and not event.passive and not event.negated:
        for entity in mention.entities:
            entity.loci.add("ahead")


def _seen_from_the_ego(mention: Mention, described: Mention | None) -> None:
    """``I am behind a lorry``: the lorry is not "the car behind me"."""
    if described is None or not any(e.ego for e in described.entities):
        return
    for prep in described.pps:
        if prep.target is mention and prep.value in {"ahead", "behind"}:
            side = "behind" if prep.value == "ahead" else "ahead"
            for entity in mention.entities:
                entity.loci.add(side)


def _held_by(chunks: list[Chunk]) -> set[int]:
    """``slips out of its mother's hand``: she only has the hand."""
    return {
        id(who)
        for who, joint, part in zip(chunks, chunks[1:], chunks[2:], strict=False)
        if isinstance(who, Mention)
        and any(m.cat == "possessive" for m in who.mods)
        and isinstance(joint, Word)
        and joint.value == "genitive"
        and (isinstance(part, Word | Thing) or getattr(part, "kind", "") == "leg")  # "arms"
        and _on_no_road(who)
    }


def _on_no_road(owner: Mention) -> bool:
    """``the neighbour's van``: the van takes part, the neighbour does not."""
    head = owner.head
    return head is not None and head.value == "pedestrian" and "afoot" not in head.data


def _settled(events: list[Event]) -> set[int]:
    """Mentions of whom the text says which way they go."""
    ways = {"left", "right", "straight"}
    going = [e for e in events if e.finite and any(d.value in ways for d in e.dirs)]
    return {id(m) for e in going for m in e.subject}


def _definite(mention: Mention) -> bool:
    """``behind the broken-down car``: one that is known, so not who stops behind it."""
    return bool(mention.heads) and any((m.cat, m.value) == ("det", "def") for m in mention.mods)


def _is_it(target: object) -> bool:
    return isinstance(target, Mention) and target.pronoun in {"it", "him"}


def _beside(chunks: list[Chunk]) -> dict[int, Mention]:
    """Whom a noun in "the car behind it" places; it cannot mean the same."""
    return {
        id(prep.target): chunk
        for chunk in chunks
        if isinstance(chunk, Mention)
        for prep in chunk.pps
        if prep.word.cat == "locus" and isinstance(prep.target, Mention)
    }
