"""What clauses say about their nouns: who drives, who comes from elsewhere, whose car it is."""

from __future__ import annotations

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.tokens import Token

_ONLY_VEHICLES = frozenset(
    {"brake", "hard_brake", "overtake", "merge", "lane_change", "accelerate", "tailgate", "cut_off",
     "cut_in", "pull_out", "park", "swerve", "u_turn"}
)  # fmt: skip
_CYCLING = frozenset({"cycle", "pedal"})
_WALKING = frozenset({"walk", "jog", "stroll"})
_OPERATING = frozenset({"drive", "ride", "operate", "pilot"})
_DRIVEN = _ONLY_VEHICLES | {"reverse", "move", "turn", "stop", "speed"}


def describe(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Marks mentions by what they do, before it is decided whom they mean.

    Args:
        chunks: the chunks of the text.
        events: its events.
        tokens: the tokens of the text.
    """
    for event in events:
        for mention in event.subject:
            _by_doing(mention, event, tokens)
    _people_in_traffic(chunks, events)
    _listeners(events)
    _own_vehicles(events, tokens)
    _vehicles_of_parties(chunks)


def _by_doing(mention: Mention, event: Event, tokens: list[Token]) -> None:
    failing = event.negated and event.name in {"stop", "yield"}
    alone = event.drives or event.name in _ONLY_VEHICLES or _takes_a_turn(event)
    vague = mention.head is not None and "vague" in mention.head.data
    turns = vague and any(d.value in {"left", "right"} for d in event.dirs)
    mention.drives = mention.drives or failing or alone or turns
    close = 0 <= event.i - mention.j <= 1 and not event.finite and not event.nominal
    mention.narrowed = mention.narrowed or (close and event.premod_of is None)
    acted_on = event.object
    pronoun = isinstance(acted_on, Mention) and acted_on.pronoun in {"it", "him", "they"}
    mention.besides = mention.besides or (close and pronoun)
    _by_word(mention, tokens[event.i])
    if any(p.value == "from" and isinstance(p.target, Place) for p in event.pps):
        mention.elsewhere = mention.pronoun is None


def _by_word(mention: Mention, word: Token) -> None:
    """``the claimant was cycling``, ``the insured walked``: people who are no drivers."""
    base = word.forms[-1][0]
    party = any("party" in h.data for h in mention.heads)
    if base in _CYCLING and mention.heads:
        mention.goes_by = ParticipantKind.BICYCLE
    elif base in _WALKING and party:
        mention.goes_by = ParticipantKind.PEDESTRIAN


def _own_vehicles(events: list[Event], tokens: list[Token]) -> None:
    """``a woman backs her van out``, ``a man riding a moped``: they stand for what they drive."""
    for event in events:
        what = event.object
        if not isinstance(what, Mention) or not event.subject or event.name not in _DRIVEN:
            continue
        who = event.subject[-1]
        whose = what.mods[0] if what.mods else None
        own = whose is not None and whose.cat == "possessive" and whose.value == "its"
        driven = _is_person(who) and tokens[event.i].forms[-1][0] in _OPERATING
        if what.heads and not what.label and (own or driven):
            what.same_as = who
            who.drives = True


def _is_person(mention: Mention) -> bool:
    return any(h.value in {"driver", "pedestrian", "rider"} for h in mention.heads)


def _vehicles_of_parties(chunks: list[Chunk]) -> None:
    """``the insured's van``, ``driver 2's car``: its owner stands for it."""
    for chunk in chunks:
        owner = chunk.owner if isinstance(chunk, Mention) else None
        if owner is None or not isinstance(chunk, Mention) or not chunk.heads:
            continue
        drives = any("driver" in h.data for h in owner.heads)
        if drives and not _is_person(chunk):
            chunk.same_as = owner


def _listeners(events: list[Event]) -> None:
    """``officers said …``, ``told a policeman …``: they take no part."""
    for event in events:
        told = [p.target for p in event.pps if p.value == "to"]
        for mention in [*event.subject, event.object, *told] if event.says else []:
            if isinstance(mention, Mention) and any("onlooker" in h.data for h in mention.heads):
                mention.negated = True


def _on_foot(event: Event) -> bool:
    against = any(p.value == "into" and isinstance(p.target, Mention) for p in event.pps)
    return event.name in {"cross", "walk", "appear"} and not against


def _people_in_traffic(chunks: list[Chunk], events: list[Event]) -> None:
    """``the guy behind me``: somebody who is behind or in front, and does not walk, drives."""
    walking = {id(m) for e in events if _on_foot(e) for m in e.subject}
    for chunk in chunks:
        if isinstance(chunk, Mention) and chunk.head is not None and chunk.head.data.get("aboard"):
            chunk.negated = id(chunk) not in walking
        if isinstance(chunk, Mention) and id(chunk) not in walking:
            along = any(
                p.word.cat == "locus"
                and p.value in {"behind", "ahead"}
                and not isinstance(p.target, Place | Thing)
                for p in chunk.pps
            )
            vague = chunk.head is not None and bool(chunk.head.data.get("vague"))
            chunk.drives = chunk.drives or (along and vague)


def _takes_a_turn(event: Event) -> bool:
    """``makes a left``: who says so means a driver."""
    target = event.object
    return event.name == "light" and isinstance(target, Place) and target.kind == "side"
