"""Whom an "it" cannot mean, by what the clauses around it say, and which is the same as another."""

from collections.abc import Iterator, Sequence
from itertools import pairwise, product

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.clauses.located import is_it
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.words.tokens import Token

_FOLLOWS = frozenset({"follow", "tailgate"})
_STEPS_OUT = frozenset({"cross", "walk"})
_SLOWS = frozenset({"brake", "hard_brake", "slow", "stop"})


def others_than_it(
    mentions: Sequence[Mention], events: Sequence[Event], tokens: list[Token]
) -> Iterator[tuple[Mention, NounPhrase]]:
    """Each "it" with one whom it does not mean."""
    for again, prep, whose in _goes_on(mentions, events, tokens):
        if is_it(prep.who) or (prep.target is None and not is_it(whose)):
            yield again, whose
    for before, event in pairwise(events):
        if _is_waited_for(before, event, tokens) or _slows_ahead(before, event):
            yield from product((m for m in _its(event) if m.i > before.i), before.subject)
    yield from _placed_in_turn(mentions, events, tokens)
    backs = any(e.name == "reverse" and m.is_ego for e in events for m in e.subject)
    egos = [m for m in mentions if m.is_ego and not backs]
    for event in events:
        yield from _going_elsewhere(event, events)
        yield from _not_by_itself(event)
        yield from product(_hiders(event), egos)


def same_again(
    mentions: Sequence[Mention], events: Sequence[Event], tokens: list[Token]
) -> dict[int, Mention]:
    """``when the ego is 15 m behind it, it brakes``: the second "it" with the first."""
    found = _goes_on(mentions, events, tokens)
    return {id(again): prep.who for again, prep, _ in found if is_it(prep.who)}


def _placed_in_turn(
    mentions: Sequence[Mention], events: Sequence[Event], tokens: list[Token]
) -> Iterator[tuple[Mention, Mention]]:
    """``a van ahead of it and a bus on the left of it``: the second "it" is not the van."""
    named = [m for m in mentions if m.heads]
    for (one, other), after in zip(pairwise(named), [*named[2:], None], strict=False):
        own = [m for m in mentions if one.i < m.i < other.i and _places(m)]
        sided = any(p.place is not None and p.place.has("possessive") for p in one.pps)
        end = after.i if after is not None else len(tokens)
        again = [m for m in mentions if other.i < m.i < end and _places(m)]
        begin = own[-1].j if own else one.j
        apart = any(e.finite and begin < e.i < other.i for e in events)
        parted = {t.low for t in tokens[begin : other.i]}
        if (own or sided) and not apart and parted & {"and", ","} and "." not in parted:
            yield from ((it, one) for it in again[:1] if other.opened_by("indef"))


def _places(mention: Mention) -> bool:
    """``ahead of it``, ``to the left of it``."""
    located = mention.prep is not None and mention.prep.cat == "locus"
    return is_it(mention) and (located or mention.aside)


def _its(event: Event) -> list[Mention]:
    return [m for m in event.subject if is_it(m)]


def _goes_on(
    mentions: Sequence[Mention], events: Sequence[Event], tokens: list[Token]
) -> Iterator[tuple[Mention, Prep, Mention]]:
    """``… is 15 m behind it, it brakes``: an "it" right behind a clause that says where one is."""
    acting = [m for event in events for m in _its(event)]
    for whose in mentions:
        for prep in (p for p in whose.pps if p.predicate and p.word.cat == "locus"):
            last = prep.who or prep.word
            for again in acting:
                if [t.low for t in tokens[last.j : again.i]] == [","]:
                    yield again, prep, whose


def _slows_ahead(follows: Event, event: Event) -> bool:
    """``the ego follows a car; it brakes``: who is followed, as who follows would brake for it."""
    follows_it = follows.name in _FOLLOWS and isinstance(follows.object, Mention)
    return follows_it and event.name in _SLOWS and not (follows.passive or event.negated)


def _is_waited_for(waiting: Event, event: Event, tokens: list[Token]) -> bool:
    """``waits until it has passed``: "it" is not who waits."""
    waits = waiting.name in {"wait", "yield"} and not event.modal
    return waits and any(tokens[m.i - 1].low in word_list("until") for m in _its(event))


def _going_elsewhere(event: Event, events: Sequence[Event]) -> Iterator[tuple[Mention, NounPhrase]]:
    """``a car going straight on hits the ego as it turns left``: "it" is not that car."""
    ways = {d.value for d in event.dirs} & WAYS
    here = [e for e in events if e.sentence == event.sentence and e.i < event.i]
    hits = any(e.name == "collide" for e in here)
    for other in here if ways and hits else []:
        if {d.value for d in other.dirs} & WAYS - ways:
            yield from product(_its(event), other.subject)


def _hiders(event: Event) -> list[Mention]:
    """``a child hidden behind it``, ``a man behind it walks out``, ``it hides her``: no ego."""
    if event.name == "hide" and event.form != "ed":
        return _its(event)
    own = event.pps if event.name == "hide" else []
    own = own or [p for m in event.subject for p in m.pps if event.name in _STEPS_OUT]
    return [p.who for p in own if p.value in {"behind", "by"} and is_it(p.who) and not p.fronted]


def _not_by_itself(event: Event) -> Iterator[tuple[Mention, NounPhrase]]:
    """``it is hit by the ego``, ``it moves into the ego's lane``: "it" is not the ego."""
    places = [n for n in (event.object, *(p.target for p in event.pps)) if isinstance(n, Place)]
    by = [p.target for p in event.pps if p.value == "by"]
    agents = [n.owner if isinstance(n, Place) else n for n in by]
    owners = [n.owner for n in places]
    every = product((m for m in event.subject if m.pronoun), agents)
    for who, other in (*every, *product(_its(event), owners)):
        if isinstance(other, Mention) and not other.pronoun:
            yield who, other
