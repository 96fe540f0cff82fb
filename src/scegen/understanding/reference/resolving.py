"""Resolves the mentions of a text in their order, with what the clauses say about them."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing, Word
from scegen.understanding.clauses.located import is_it
from scegen.understanding.clauses.relatives import aside
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, is_word
from scegen.understanding.phrases.on_sides import sides_of
from scegen.understanding.reference.describing import describe
from scegen.understanding.reference.discourse import Discourse
from scegen.understanding.reference.generic import mark_generic
from scegen.understanding.reference.ranks import rank
from scegen.understanding.reference.reference import is_pronoun
from scegen.understanding.reference.tellers import is_apart, teller_goes_by
from scegen.understanding.words.tokens import Token

_DONE_TO = frozenset({"tailgate", "undertake", "cut_off", "cut_in", "overtake"})
_FOLLOWING = frozenset({"follow", "tailgate", "avoid"})
_WAYS = frozenset({"left", "right", "straight"})
_BACKWARDS = {"ahead": "behind", "behind": "ahead"}
_UNDERWAY = frozenset({"move", "wait"})
_BEHIND = ("locus", "behind", None, None)
_COMING_OUT = frozenset({"cross", "appear", "pull_out"})


class _Along(NamedTuple):
    """``a van drives 20 m ahead of the ego``; by None: of whoever looks on."""

    who: Mention
    locus: str
    by: Mention | None


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
        along: who drives or stands ahead of whom, or behind, under both of them.
    """

    unlike: dict[int, list[NounPhrase]] = field(default_factory=lambda: defaultdict(list))
    follows: dict[int, list[Event]] = field(default_factory=lambda: defaultdict(list))
    passed: set[int] = field(default_factory=set)
    hiding: set[int] = field(default_factory=set)
    nearing: set[int] = field(default_factory=set)
    subjects: set[int] = field(default_factory=set)
    settled: set[int] = field(default_factory=set)
    everywhere: dict[int, int] = field(default_factory=dict)
    along: dict[int, list[_Along]] = field(default_factory=lambda: defaultdict(list))


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
        for who in event.subject if event.name in _UNDERWAY and not event.negated else []:
            _stands_along(who, [p for p in event.pps if p.outer is None], found)
        if event.name == "precede" and isinstance(event.object, Mention) and not event.passive:
            for who in event.subject:
                _along(who, "ahead", event.object, found)
        if event.name == "approach" or any(p.value == "to" and p.who for p in event.pps):
            found.nearing |= {id(m) for m in event.subject}
        if _comes_out(event):
            found.hiding |= {id(p.target) for p in event.pps if p.outer == "from"}
        _going_elsewhere(event, events, found)
        for place in (p.place for p in event.pps):
            if place is not None and place.beside is not None:
                # "drives in the lane to the left of it": "it" is somebody else
                found.unlike[id(place.beside)] += event.subject
    for mention in mentions:
        for prep in mention.pps:
            if prep.who is not None and prep.word.cat == "locus":
                found.unlike[id(prep.who)].append(mention)  # "a bus behind it"
            elif prep.place and (whose := prep.place.beside or prep.place.owner) is not None:
                found.unlike[id(whose)].append(mention)  # "two vans on either side of it"
        _stands_along(mention, [p for p in mention.pps if p.predicate], found)
    return found


def _stands_along(who: Mention, pps: list[Prep], found: _Bonds) -> None:
    for prep in pps:
        nobody = prep.target is None and prep.outer is None
        by = prep.who
        if prep.word.cat == "locus" and prep.value in _BACKWARDS and (nobody or by is not None):
            _along(who, prep.value, by, found)


def _along(who: Mention, locus: str, by: Mention | None, found: _Bonds) -> None:
    for of in (who, by) if by is not None else (who,):
        found.along[id(of)].append(_Along(who, locus, by))


def _going_elsewhere(event: Event, events: list[Event], found: _Bonds) -> None:
    """``a car going straight on hits the ego as it turns left``: "it" is not that car."""
    ways = {d.value for d in event.dirs} & _WAYS
    it = [m for m in event.subject if is_it(m)]
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
        elif who.pronoun == "it" and known is not None and known.has("det", "def"):
            # "it strikes the motorcycle": "it" is not that motorcycle
            found.unlike[id(who)] += [m for m in mentions if m.i < who.i and m.noun == known.noun]
    _of_another(event, found)
    _not_by_itself(event, found)
    for prep in event.pps:
        by = prep.who
        if (prep.word.cat, prep.value, prep.outer, prep.on_mention) == _BEHIND:
            found.follows[id(by)].append(event)
        if by is None or prep.on_mention not in (None, *event.subject):
            continue
        known_already = bool(by.heads) and by.has("det", "def")  # "behind the broken-down car"
        if is_it(by) or known_already or prep.value == "between":
            for beside in (by, *(m for m in mentions if m.joined is by)):
                found.unlike[id(beside)] += event.subject  # "between the ego and the van ahead"


def _of_another(event: Event, found: _Bonds) -> None:
    """``a van hits its front``, ``runs into the back of it``: not the van's own."""
    for part in (event.object, *(p.target for p in event.pps)):
        if not isinstance(part, Place) or part.owner is None:
            continue
        end = part.opening == "into" and bool({"front", "rear"} & set(part.dirs))
        if end or event.name == "collide":
            found.unlike[id(part.owner)] += event.subject


def _comes_out(event: Event) -> bool:
    """Whether somebody comes into view: on foot, or by a verb that says so."""
    return event.name in _COMING_OUT or any(m.is_person for m in event.subject)


def _not_by_itself(event: Event, found: _Bonds) -> None:
    """``it is hit by the ego``, ``by the ego's front``: "it" is not the ego."""
    for prep in (p for p in event.pps if p.value == "by"):
        agent = prep.target.owner if isinstance(prep.target, Place) else prep.target
        if not isinstance(agent, Mention):
            continue
        for who in (m for m in event.subject if m.pronoun):
            found.unlike[id(who)].append(agent)


def resolve_mentions(chunks: list[Chunk], events: list[Event], discourse: Discourse) -> None:
    """Finds out whom every mention refers to, in the order of the text."""
    describe(chunks, events, discourse.tokens)
    discourse.told_by(teller_goes_by(chunks, events, discourse.tokens), apart=is_apart(chunks))
    mark_generic(chunks, events, discourse.tokens)
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
        if is_pronoun(chunk) and _named_later(chunk, chunks):
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
    """``the ego waits because a van comes, so it is late``: "it" is not who the reason is about.

    Nor is it in "because a van comes, it waits".
    """
    found: set[int] = set()
    here: list[int] = []
    opened = False
    for k, (before, chunk) in enumerate(pairwise(chunks)):
        reason = isinstance(before, Word) and (before.cat, before.value) == ("sub", "because")
        if isinstance(before, Word) and before.value in BOUNDARIES:
            here, opened = [], False
        elif reason and tokens[before.i].low != "so":
            here.append(id(chunk))
            opened = opened or k == 0 or chunks[k - 1].value in BOUNDARIES
        elif isinstance(chunk, Mention) and chunk.pronoun == "it" and (reason or opened):
            found |= {*here}
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
    for chunk in chunks if any(c.value == "be" for c in chunks) else []:
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
    if isinstance(chunk, Place | Thing) and chunk.has("possessive", "first_person"):
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
    known = discourse.entities
    egos = [e for e in known if e.ego]
    hides = id(mention) in bonds.hiding and is_it(mention) and len(egos) < len(known)
    if hides or any(m.is_ego for m in unlike):
        exclude += egos  # who looks on hides nobody from itself
    if id(mention) in bonds.passed and mention.pronoun == "it" and any(e.parked for e in known):
        exclude += [e for e in known if not e.parked]  # "drives around it"
    discourse.resolve(
        mention,
        subject=id(mention) in bonds.subjects,
        exclude=exclude,
        sides=bonds.everywhere.get(id(mention)),
        settled=id(mention) in bonds.settled,
    )
    loci = _seen_from_the_ego(mention, unlike, bonds.follows[id(mention)])
    for entity in mention.entities:
        entity.loci |= loci
        entity.nears = not entity.ego if id(mention) in bonds.nearing else entity.nears
    for who, locus, by in bonds.along[id(mention)]:
        if by is None or any(e.ego for e in by.entities):
            for entity in who.entities:
                entity.loci |= {locus}


def _seen_from_the_ego(mention: Mention, placed: list[Mention], events: list[Event]) -> set[str]:
    """``I am behind a lorry``, ``the ego follows a car``: that is "the car ahead"."""
    told = [e for e in events if not (e.passive or e.negated)]
    loci = {"ahead" for event in told for who in event.doers if who.ego}
    phrases = [p for m in placed if any(e.ego for e in m.entities) for p in m.pps]
    places = [p.value for p in phrases if p.target is mention]
    return loci | {_BACKWARDS[word] for word in places if word in _BACKWARDS}


def _on_no_road(owner: Mention) -> bool:
    """``the neighbour's van``: the van takes part, the neighbour does not."""
    return owner.is_person and not any("afoot" in h.data for h in owner.heads[-1:])


def _settled(events: list[Event]) -> set[int]:
    """Mentions of whom the text says which way they go."""
    going = [e for e in events if e.finite and any(d.value in _WAYS for d in e.dirs)]
    return {id(m) for e in going for m in e.subject}
