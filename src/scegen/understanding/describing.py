"""What clauses say about their nouns: who drives, who comes from elsewhere, whose car it is."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing

_ONLY_VEHICLES = frozenset(
    {"brake", "hard_brake", "overtake", "merge", "lane_change", "accelerate", "tailgate", "cut_off",
     "cut_in", "pull_out", "park", "swerve", "u_turn"}
)  # fmt: skip
_DRIVEN = _ONLY_VEHICLES | {"reverse", "move", "turn", "stop", "speed"}


def describe(chunks: list[Chunk], events: list[Event]) -> None:
    """Marks mentions by what they do, before it is decided whom they mean.

    Args:
        chunks: the chunks of the text.
        events: its events.
    """
    for event in events:
        for mention in event.subject:
            _by_doing(mention, event)
    _people_in_traffic(chunks, events)
    _own_vehicles(events)


def _by_doing(mention: Mention, event: Event) -> None:
    mention.seated = mention.seated or event.name == "door"
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
    if any(p.value == "from" and isinstance(p.target, Place) for p in event.pps):
        mention.elsewhere = mention.pronoun is None


def _own_vehicles(events: list[Event]) -> None:
    """``a woman backs her van out``: she stands for her van."""
    for event in events:
        what = event.object
        if not isinstance(what, Mention) or not event.subject or event.name not in _DRIVEN:
            continue
        whose = what.mods[0] if what.mods else None
        if whose is not None and whose.cat == "possessive" and whose.value == "its" and what.heads:
            what.same_as = event.subject[-1]
            event.subject[-1].drives = True


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
