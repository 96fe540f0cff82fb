"""Resolves the mentions of a text in their order, with what the clauses say about them."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from itertools import pairwise

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing, Word
from scegen.understanding.clauses.relatives import aside
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, is_word
from scegen.understanding.phrases.on_sides import sides_of
from scegen.understanding.reference.describing import describe
from scegen.understanding.reference.discourse import Discourse
from scegen.understanding.reference.generic import mark_generic
from scegen.understanding.reference.ranks import rank
from scegen.understanding.reference.tellers import is_apart, teller_goes_by
from scegen.understanding.words.tokens import Token

_DONE_TO = frozenset({"tailgate", "undertake", "cut_off", "cut_in", "overtake"})
_FOLLOWING = frozenset({"follow", "tailgate", "avoid"})
_WAYS = frozenset({"left", "right", "straight"})
_BACK = frozenset({"it", "him", "they"})
_COMING_OUT = frozenset({"cross", "appear", "pull_out"})


@dataclass(slots=True)
class _Bonds:
    """What the clauses say about whom a mention can mean, by the mention.

    Attributes:
        unlike: whom it cannot mean: who acts on it, and whom it places.
        follows: events that drive behind it, or up to it.
        passed: what is driven around.
        hiding: what somebody comes out from behind.
        nearing: who comes towards somebody.
        subjects: those that a clause tells of.
        settled: those of whom the text says which way they go.
        everywhere: those that come one from each of so many sides.
    """

    unlike: dict[int, list[NounPhrase]] = field(default_factory=lambda: defaultdict(list))
    follows: dict[int, list[Event]] = field(default_factory=lambda: defaultdict(list))
    passed: set[int] = field(default_factory=set)
    hiding: set[int] = field(default_factory=set)
    nearing: set[int] = field(default_factory=set)
    subjects: set[int] = field(default_factory=set)
    settled: set[int] = field(default_factory=set)
    everywhere: dict[int, int] = field(default_factory=dict)


def _bonds(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> _Bonds:
    objects = {id(e.object) for e in events}
    subjects = {
        id(m)
        for e in events
        for m in e.subject
        if not aside(e, events) and (e.finite or not (id(m) in objects or m.prep is not None))
    }  # "meets a van blocking the lane", "waits for a van to pass": not about the van
    found = _Bonds(
        subjects=(subjects | _said_to_be_there(chunks)) - _in_reasons(chunks, tokens),
        settled=_settled(events),
        everywhere=sides_of(events, chunks),
    )
    mentions = [c for c in chunks if isinstance(c, Mention)]
    for event in events:
        _done_to(event, mentions, found)
        if event.name == "approach" or any(isinstance(p.target, Mention) for p in _to(event)):
            found.nearing |= {id(m) for m in event.subject}
        if _comes_out(event):
            found.hiding |= {id(p.target) for p in event.pps if p.outer == "from"}
        _going_elsewhere(event, events, found)
        _beside_another(event, found)
    for mention in mentions:
        for prep in mention.pps:
            by = prep.target
            if isinstance(by, Mention) and prep.word.cat == "locus":
                found.unlike[id(by)].append(mention)  # "a bus behind it"
            elif isinstance(by, Place) and (whose := by.beside or by.owner) is not None:
                found.unlike[id(whose)].append(mention)  # "two vans on either side of it"
    return found


def _to(event: Event) -> list[Prep]:
    return [p for p in event.pps if p.value == "to"]


def _beside_another(event: Event, found: _Bonds) -> None:
    """``drives in the lane to the left of it``: "it" is somebody else."""
    for place in (p.target for p in event.pps):
        if isinstance(place, Place) and place.beside is not None:
            found.unlike[id(place.beside)] += event.subject


def _going_elsewhere(event: Event, events: list[Event], found: _Bonds) -> None:
    """``a car going straight on hits the ego as it turns left``: "it" is not that car."""
    ways = {d.value for d in event.dirs} & _WAYS
    it = [m for m in event.subject if _is_it(m)]
    here = [e for e in events if e.sentence == event.sentence and e.i < event.i]
    hits = any(e.name == "collide" for e in here)
    for other in here if ways and it and hits else []:
        if {d.value for d in other.dirs} & _WAYS - ways:
            for who in it:
                found.unlike[id(who)] += other.subject


def _done_to(event: Event, mentions: list[Mention], found: _Bonds) -> None:
    """Who acts is none of those on whom it is done."""
    known = event.object
    if known is not None:
        found.unlike[id(known)] += event.subject
        found.passed |= {id(known)} if event.name == "bypass" else set()
        if event.name in _FOLLOWING:
            found.follows[id(known)].append(event)
    for who in event.subject if isinstance(known, Mention) else []:
        if who.pronoun and known is not None and known.i < who.i:
            found.unlike[id(who)].append(known)  # "the van it is following": "it" is not the van
    for part in [known, *(p.target for p in event.pps)] if event.name == "collide" else []:
        if isinstance(part, Place) and part.owner is not None:
            found.unlike[id(part.owner)] += event.subject  # "a van hits its rear": not the van's
    _not_by_itself(event, found)
    for prep in event.pps:
        by = prep.target
        if (prep.word.cat, prep.value, prep.outer) == ("locus", "behind", None):
            found.follows[id(by)] += [event] if prep.on_mention is None else []
        if not isinstance(by, Mention) or prep.on_mention not in (None, *event.subject):
            continue
        if _is_it(by) or _definite(by) or prep.value == "between":
            for beside in (by, *(m for m in mentions if m.joined is by)):
                found.unlike[id(beside)] += event.subject  # "between the ego and the van ahead"


def _comes_out(event: Event) -> bool:
    """Whether somebody comes into view: on foot, or by a verb that says so."""
    afoot = any(m.head is not None and m.head.value == "pedestrian" for m in event.subject)
    return afoot or event.name in _COMING_OUT


def _not_by_itself(event: Event, found: _Bonds) -> None:
    """``it is hit by the ego``, ``by the ego's front``: "it" is not the ego."""
    for prep in (p for p in event.pps if p.value == "by"):
        agent = prep.target.owner if isinstance(prep.target, Place) else prep.target
        if not isinstance(agent, Mention):
            continue
        for who in (m for m in event.subject if m.pronoun):
            found.unlike[id(who)].append(agent)


def resolve_mentions(chunks: list[Chunk], events: list[Event], discourse: Discourse) -> None:
    """Finds out whom every mention refers to, in the order of the text.

    Args:
        chunks: the chunks of the text.
        events: its events.
        discourse: the participants so far.
    """
    describe(chunks, events, discourse.tokens)
    discourse.told_by(teller_goes_by(chunks, events, discourse.tokens), apart=is_apart(chunks))
    mark_generic(chunks, events)
    rank(chunks, events, discourse.tokens)
    bonds = _bonds(chunks, events, discourse.tokens)
    owners = {id(c.owner) for c in chunks if isinstance(c, Mention)}
    stand = {id(m): e for e in events if e.name == "park" and not e.negated for m in e.subject}
    waiting: list[Mention] = []
    early: list[Mention] = []
    for chunk in chunks:
        _told_by_somebody(chunk, discourse)
        if not isinstance(chunk, Mention) or (id(chunk) in owners and _on_no_road(chunk)):
            continue
        if chunk.partitive and chunk.pronoun in word_list("parts"):
            waiting.append(chunk)
            continue
        if chunk.pronoun in _BACK and _named_later(chunk, chunks):
            early.append(chunk)
            continue
        _resolve(chunk, discourse, bonds)
        if id(chunk) in stand:
            _parked(chunk, stand[id(chunk)])
        if early and id(chunk) in bonds.subjects:
            waiting, early = [*waiting, *early], []
        for earlier in waiting:
            _resolve(earlier, discourse, bonds)
        waiting = []
    for earlier in (*waiting, *early):
        _resolve(earlier, discourse, bonds)


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
    """``A truck is in front of the ego.``: of whom a sentence without a verb but "is" tells.

    So does "there is a truck", but if it stands, what follows is rather told of who comes.
    """
    found = {
        id(chunk)
        for before, chunk in pairwise(chunks)
        if is_word(before, "thereis") and isinstance(chunk, Mention)
        if not any(m.cat == "state" for m in chunk.mods)
    }
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


def _resolve(mention: Mention, discourse: Discourse, bonds: _Bonds) -> None:
    unlike = [m for m in bonds.unlike[id(mention)] if isinstance(m, Mention)]
    if mention.joined is not None and mention.pronoun is None:
        unlike.append(mention.joined)  # "a van and the van behind": two
    exclude = [e for m in unlike for e in m.entities]
    if any(m.is_ego for m in unlike):
        exclude += [e for e in discourse.entities if e.ego]
    stands = any(e.parked for e in discourse.entities)
    if id(mention) in bonds.passed and mention.pronoun == "it" and stands:
        exclude += [e for e in discourse.entities if not e.parked]  # "drives around it"
    if (
        id(mention) in bonds.hiding
        and _is_it(mention)
        and not all(e.ego for e in discourse.entities)
    ):
        exclude += [e for e in discourse.entities if e.ego]  # who looks on hides nobody from itself
    discourse.resolve(
        mention,
        subject=id(mention) in bonds.subjects,
        exclude=exclude,
        sides=bonds.everywhere.get(id(mention)),
        settled=id(mention) in bonds.settled,
    )
    for placed in unlike:
        _seen_from_the_ego(mention, placed)
    for event in bonds.follows[id(mention)]:
        _in_front_of_the_ego(mention, event)
    for entity in mention.entities if id(mention) in bonds.nearing else []:
        entity.nears = not entity.ego


def _in_front_of_the_ego(mention: Mention, event: Event) -> None:
    """``the ego follows a car``, ``drives behind a car``: that is "the car ahead"."""
    egos = [e for m in event.subject for e in m.entities if e.ego]
    if egos and not event.passive and not event.negated:
        for entity in mention.entities:
            entity.loci.add("ahead")


def _seen_from_the_ego(mention: Mention, described: Mention) -> None:
    """``I am behind a lorry``: the lorry is not "the car behind me"."""
    if not any(e.ego for e in described.entities):
        return
    for prep in described.pps:
        if prep.target is mention and prep.value in {"ahead", "behind"}:
            side = "behind" if prep.value == "ahead" else "ahead"
            for entity in mention.entities:
                entity.loci.add(side)


def _on_no_road(owner: Mention) -> bool:
    """``the neighbour's van``: the van takes part, the neighbour does not."""
    head = owner.head
    return head is not None and head.value == "pedestrian" and "afoot" not in head.data


def _settled(events: list[Event]) -> set[int]:
    """Mentions of whom the text says which way they go."""
    going = [e for e in events if e.finite and any(d.value in _WAYS for d in e.dirs)]
    return {id(m) for e in going for m in e.subject}


def _definite(mention: Mention) -> bool:
    """``behind the broken-down car``: one that is known, so not who stops behind it."""
    return bool(mention.heads) and any((m.cat, m.value) == ("det", "def") for m in mention.mods)


def _is_it(target: object) -> bool:
    return isinstance(target, Mention) and target.pronoun in {"it", "him"}
