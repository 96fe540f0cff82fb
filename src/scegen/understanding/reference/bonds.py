"""What the clauses say about whom a mention can mean."""

from collections import defaultdict
from dataclasses import dataclass, field
from itertools import pairwise, product
from typing import NamedTuple

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.clauses.further import aside
from scegen.understanding.clauses.located import is_it
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.listed import sides_of
from scegen.understanding.phrases.lookahead import (
    BOUNDARIES,
    chunk_at,
    free_mentions,
    sentences,
)
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.reference.its import others_than_it, same_again
from scegen.understanding.words.terms import NOTHING
from scegen.understanding.words.tokens import Token

_FOLLOWING = frozenset({"follow", "tailgate", "avoid"})
_ALONG = frozenset({"ahead", "behind"})
_DESCRIBES = frozenset({"ed", "ing"})
_UNDERWAY = frozenset({"move", "wait", "approach"})
_BEHIND = ("locus", "behind", None, None)
_PAIR = 2
_COMING_OUT = frozenset({"cross", "appear", "pull_out"})


class _Along(NamedTuple):
    """``a van drives 20 m ahead of the ego``; by None: of whoever looks on."""

    who: Mention
    locus: str
    by: Mention | None


@dataclass(slots=True)
class Bonds:
    """What the clauses say about whom a mention can mean, by the mention.

    Attributes:
        unlike: whom it cannot mean: who acts on it, and whom it places.
        follows: events that drive behind it, or up to it.
        hiding: what somebody comes out from behind.
        nearing: who comes towards somebody.
        subjects: those that a clause tells of.
        settled: those of whom the text says which way they go.
        everywhere: those that come one from each of so many sides.
        again: an "it" that is the same as one before.
        landmarks: of whom a phrase of place tells where somebody is, with its word.
        along: who drives or stands ahead of whom, or behind, under both of them.
    """

    unlike: dict[int, list[NounPhrase]] = field(default_factory=lambda: defaultdict(list))
    follows: dict[int, list[Event]] = field(default_factory=lambda: defaultdict(list))
    hiding: set[int] = field(default_factory=set)
    nearing: set[int] = field(default_factory=set)
    subjects: set[int] = field(default_factory=set)
    settled: set[int] = field(default_factory=set)
    everywhere: dict[int, int] = field(default_factory=dict)
    again: dict[int, Mention] = field(default_factory=dict)
    landmarks: dict[int, str] = field(default_factory=dict)
    along: dict[int, list[_Along]] = field(default_factory=lambda: defaultdict(list))


def bonds_of(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> Bonds:
    """Whom every mention can mean, as far as the clauses tell."""
    mentions = [c for c in chunks if isinstance(c, Mention)]
    objects = {id(e.object) for e in events}
    there = _said_to_be_there(chunks) | _noted(chunks)
    # "the lead car reveals a standing one. The ego hits it.": told of what came into view
    revealed = {id(e.object) for e in events if e.name == "reveal"}
    subjects = revealed | {
        id(m)
        for e in events
        for m in e.subject
        if not (aside(e, events) or _of_who_is_there(e, chunks, there))
        and (e.finite or not (id(m) in objects or m.prep is not None))
    }  # "meets a van blocking the lane", "waits for a van to pass": not about the van
    found = Bonds(
        subjects=(subjects | there) - _in_reasons(chunks, tokens),
        settled=_settled(events),
        everywhere=sides_of(events, chunks),
        again=same_again(mentions, events, tokens),
    )
    found.landmarks |= {id(m): m.prep.value for m in mentions if m.prep and m.prep.cat == "locus"}
    found.landmarks |= _whose_sides(chunks)
    for it, other in others_than_it(mentions, events, tokens):
        found.unlike[id(it)].append(other)
    for event in events:
        _done_to(event, mentions, found)
        _drives_along(event, found)
        _keeps_away(event, tokens, found)
        comes = event.name == "approach" or any(d.value == "opposite" for d in event.dirs)
        if comes or any(p.value == "to" and p.who for p in event.pps):
            found.nearing |= {id(m) for m in event.subject}
        if event.name in _COMING_OUT or any(m.noun == "pedestrian" for m in event.subject):
            found.hiding |= {id(p.target) for p in event.pps if p.outer == "from"}
        for place in (p.place for p in event.pps if p.place is not None):
            for whose in (place.beside, place.owner):
                if whose is not None and (whose is place.beside or whose.aside):
                    # "drives in the lane to the left of it", "on the left of it": somebody else
                    found.unlike[id(whose)] += event.subject
    for mention in mentions:
        for prep in mention.pps:
            if prep.who is not None and prep.word.cat == "locus":
                found.unlike[id(prep.who)].append(mention)  # "a bus behind it"
                found.unlike[id(mention)].append(prep.who)
            elif prep.place and (whose := prep.place.beside or prep.place.owner) is not None:
                found.unlike[id(whose)].append(mention)  # "two vans on either side of it"
        _stands_along(mention, [p for p in mention.pps if p.predicate], found)
    return found


def _whose_sides(chunks: list[Chunk]) -> dict[int, str]:
    """``to the left of the ego``, ``in the lane right of it``: of whom, and which side."""
    places = [c for c in chunks if isinstance(c, Place) and c.kind in {"side", "lane"} and c.dirs]
    whose = [(place.beside or place.owner, " ".join(place.dirs)) for place in places]
    return {id(who): side for who, side in whose if who is not None}


def _keeps_away(event: Event, tokens: list[Token], found: Bonds) -> None:
    """``keeps a headway of 2 s to a van``, ``keeps 20 m to a van``: drives behind it."""
    what = event.object
    kept = isinstance(what, Thing) and tokens[what.j - 1].low in word_list("gauged")
    if kept or (event.lemma == "keep" and any(m.cat == "quantity" for m in event.mods)):
        for prep in (p for p in event.pps if p.value in {"to", "from"}):
            found.follows[id(prep.who)].append(event)


def _drives_along(event: Event, found: Bonds) -> None:
    """``drives ahead of the ego``, ``leads the ego``, ``follows it``, ``closes in from behind``."""
    whom = event.object if isinstance(event.object, Mention) else None
    if event.negated:
        return
    if event.passive:  # "is followed by a van"
        agents = [p.who for p in event.pps if p.value == "by" and event.name in _FOLLOWING]
        for who, by in product(agents, event.subject):
            if who is not None:
                _along(who, "behind", by, found)
        return
    astern = any((p.value, p.outer) == ("behind", "from") for p in event.pps)
    behind = event.name in _FOLLOWING or (event.name == "approach" and astern)
    for who in event.subject:
        if event.name in _UNDERWAY and not (whom is not None and behind):
            _stands_along(who, [p for p in event.pps if p.outer is None], found)
        elif whom is not None and event.name == "precede":
            _along(who, "ahead", whom, found)
        elif whom is not None and behind:
            _along(who, "behind", whom, found)


def _stands_along(who: Mention, pps: list[Prep], found: Bonds) -> None:
    for prep in pps:
        nobody = prep.target is None and prep.outer is None
        by = prep.who
        if prep.word.cat == "locus" and prep.value in _ALONG and (nobody or by is not None):
            _along(who, prep.value, by, found)


def _along(who: Mention, locus: str, by: Mention | None, found: Bonds) -> None:
    for of in (who, by) if by is not None else (who,):
        found.along[id(of)].append(_Along(who, locus, by))


def _done_to(event: Event, mentions: list[Mention], found: Bonds) -> None:
    """Who acts is none of those on whom it is done."""
    known = event.object
    if known is not None:
        found.unlike[id(known)] += event.subject
        if event.name in _FOLLOWING or event.name == "approach":
            found.follows[id(known)].append(event)
    for who in event.subject if isinstance(known, Mention) else []:
        if who.pronoun and known is not None and known.i < who.i:
            found.unlike[id(who)].append(known)  # "the van it is following": "it" is not the van
        elif who.pronoun == "it" and known is not None and known.has("det", "def"):
            # "it strikes the motorcycle": "it" is not that motorcycle
            found.unlike[id(who)] += [m for m in mentions if m.i < who.i and m.noun == known.noun]
    _of_another(event, found)
    to = [m for m in (known, *(p.who for p in event.pps)) if isinstance(m, Mention) and m.is_ego]
    for who in (m for m in event.subject if m.pronoun == "it"):
        found.unlike[id(who)] += to  # "it does not yield to the ego"
    for prep in event.pps:
        by = prep.who
        if (prep.word.cat, prep.value, prep.outer, prep.on_mention) == _BEHIND:
            found.follows[id(by)].append(event)
        if by is None or prep.on_mention not in (None, *event.subject):
            continue
        told = by.has("det", "def") or by.has("state")  # "behind (the) broken-down car"
        if is_it(by) or (by.heads and told) or prep.value == "between":
            for beside in (by, *(m for m in mentions if m.joined is by)):
                found.unlike[id(beside)] += event.subject  # "between the ego and the van ahead"


def _of_another(event: Event, found: Bonds) -> None:
    """``a van hits its front``, ``runs into the back of it``: not the van's own."""
    for part in (event.object, *(p.target for p in event.pps)):
        if not isinstance(part, Place) or part.owner is None:
            continue
        end = part.opening == "into" and bool({"front", "rear"} & set(part.dirs))
        if end or (event.name == "collide" and part.opening != "of"):
            found.unlike[id(part.owner)] += event.subject


def _in_reasons(chunks: list[Chunk], tokens: list[Token]) -> set[int]:
    """``the ego waits because a van comes, so it is late``: "it" is not who the reason is about.

    Nor is it in "because a van comes, it waits".
    """
    found: set[int] = set()
    here: list[int] = []
    opened = False
    for k, (before, chunk) in enumerate(pairwise(chunks)):
        reason = (before.cat, before.value) == ("sub", "because")
        if before.value in BOUNDARIES:
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
        if before.value == "thereis" and isinstance(chunk, Mention)
        if not any(m.cat == "state" for m in chunk.mods)
    }
    opens: Mention | None = None
    fresh, subordinate = True, False
    said = any(c.value == "be" for c in chunks)
    for before, chunk in pairwise([NOTHING, *chunks]) if said else ():
        if isinstance(before, Mention) and isinstance(chunk, Event) and chunk.form in _DESCRIBES:
            continue  # "the car is 40 m short of a lorry standing there"
        if chunk.value in BOUNDARIES or chunk.cat == "sub":
            opens, fresh, subordinate = None, True, chunk.cat == "sub"
        elif chunk.value == "," or chunk.cat == "conj":
            opens, fresh = None, subordinate  # "while the ego drives, a van is ahead of it"
        elif isinstance(chunk, Mention) and fresh:
            opens, fresh = chunk, False
        elif (chunk.cat, chunk.value) == ("aux", "be"):
            found |= {id(opens)} if opens is not None else set()
        elif chunk.cat == "rel" and id(opens) in found:
            opens = None
        else:
            if isinstance(chunk, Event):
                found -= {id(opens)} if opens is not None else set()
                opens = None
            fresh = False
    return found


def _noted(chunks: list[Chunk]) -> set[int]:
    """``Target ahead of the VUT, both 50 km/h; it brakes.``: whom a sentence without a verb names.

    In "Ego 50 km/h, a van ahead of it" it is the van.
    """
    found: set[int] = set()
    for begin, k in sentences(chunks):
        here = chunks[begin:k]
        spoken = any(isinstance(c, Event) or c.cat in {"aux", "sub"} for c in here)
        who = free_mentions(here) if isinstance(chunk_at(here, 0), Mention) and not spoken else []
        others = [m for m in who if m.heads and not m.is_ego]
        found |= {id(m) for m in (others or who[:1]) if len(others) < _PAIR}
    return found


def _of_who_is_there(event: Event, chunks: list[Chunk], there: set[int]) -> bool:
    """``the car is 40 m short of a lorry that stands there``: told of the car."""
    if not event.embedded:
        return False
    told = (c for c in reversed(chunks) if isinstance(c, Event) or id(c) in there)
    return id(next((c for c in told if c.i < event.i), None)) in there


def _settled(events: list[Event]) -> set[int]:
    """Mentions of whom the text says which way they go."""
    going = [e for e in events if e.finite and any(d.value in WAYS for d in e.dirs)]
    return {id(m) for e in going for m in e.subject}
