"""What the one who tells it goes by, where that is not a car: a lorry, a bicycle, or on foot."""

from __future__ import annotations

from itertools import pairwise

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.mention_words import KINDS, mine, tells
from scegen.understanding.reference.own_vehicles import ONLY_VEHICLES
from scegen.understanding.words.tokens import Token

_STEPS = frozenset({"walk", "cross", "appear"})
_RIDDEN = frozenset({"bicycle", "motorcycle"})
_WAITS = frozenset({"wait", "stop"})
_MY = frozenset({"my", "our"})
_REACH = 3
"""Within so many words after "my" stands what is mine."""


def teller_goes_by(
    chunks: list[Chunk], events: list[Event], tokens: list[Token]
) -> ParticipantKind | None:
    """``I was walking over the zebra``, ``on my handlebar``: no driver tells it.

    Returns:
        How the teller moves; None if it drives, or nothing says so.
    """
    mentions = [c for c in chunks if isinstance(c, Mention)]
    us = [(e, w) for e in events if not e.negated for m in e.subject for w in (m, m.whole)]
    own = [e for e, who in us if who is not None and tells(who)]
    my_car = any(m.is_ego and tokens[m.i].low in _MY for m in mentions)
    kinds = [(m, KINDS[h.value]) for m in mentions for h in m.heads if h.value in KINDS]
    mines = [kind for m, kind in kinds if mine(m, kind)]
    if my_car or any(e.drives for e in own):
        return next(iter(mines), None)
    ridden = {m.value for c in mentions for m in c.heads} & _RIDDEN
    cycles = any(_cycles(e) for e in own) or _rides(tokens, others=bool(ridden))
    if ParticipantKind.BICYCLE in mines or cycles:
        return ParticipantKind.BICYCLE
    if any(e.name in ONLY_VEHICLES for e in own):
        return next(iter(mines), None)
    afoot = any(_afoot(e, tokens) for e in own) or any(_on_foot(m, tokens) for m in mentions)
    return ParticipantKind.PEDESTRIAN if afoot else next(iter(mines), None)


def _cycles(event: Event) -> bool:
    """``I was cycling``; ``I rode out of an alley``, where nothing else is ridden."""
    rides = event.lemma == "ride" and not isinstance(event.object, Mention)
    return rides or event.lemma in word_list("pedalling")


def _rides(tokens: list[Token], *, others: bool) -> bool:
    """``my handlebar``; ``my elbow on the handlebar``, where nobody else rides."""
    whose = _MY if others else _MY | {"the"}
    near = [tokens[k + 1 :][:_REACH] for k, t in enumerate(tokens) if t.low in whose]
    return any(token.forms[-1][0] in word_list("of_cyclists") for after in near for token in after)


def _afoot(event: Event, tokens: list[Token]) -> bool:
    """``I stepped out``, ``I was waiting on the pavement``, ``pushing the pram, I …``."""
    if event.name in _STEPS and event.lemma in word_list("stepping"):
        return True
    what = event.object
    if event.lemma == "push":
        last = tokens[what.j - 1].forms[-1][0] if what is not None else ""
        return event.name == "walk" or last in word_list("of_walkers")
    places = [what, *(p.target for p in event.pps)]
    waits = event.name in _WAITS
    return waits and any(isinstance(p, Place) and p.kind == "sidewalk" for p in places)


def _on_foot(mention: Mention, tokens: list[Token]) -> bool:
    """``I was on foot``."""
    after = [t.low for t in tokens[mention.j :][: _REACH + 1]]
    return tells(mention) and ("on", "foot") in pairwise(after)


def is_apart(chunks: list[Chunk]) -> bool:
    """``the ego turned left as I crossed on foot``: who tells it beside a vehicle under test."""
    return any(isinstance(c, Mention) and c.is_ego and not tells(c) for c in chunks)
