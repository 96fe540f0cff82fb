"""People whom a text tells of and who take no part: listeners, and those who come to harm."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Thing, Word
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token

_REFERRING = frozenset({"it", "him", "they"})
_PEOPLE = frozenset({"driver", "pedestrian", "rider"})
_PUT_REACH = 3


def mark_bystanders(chunks: list[Chunk], events: list[Event]) -> None:
    """Marks people as nobody who only hear of it, or are only said to be hurt."""
    _listeners(events)
    doing = [e for e in events if e.name != "harm" and not e.says]
    named = {id(m) for e in doing for m in (*e.subject, e.object)}
    for event in events:
        hurt = event.subject if event.passive or event.object is None else [event.object]
        for mention in hurt if event.name == "harm" else []:
            if isinstance(mention, Mention) and _anybody(mention) and id(mention) not in named:
                _victim(mention, event, chunks)


def _listeners(events: list[Event]) -> None:
    """``officers said …``, ``told a policeman …``: they take no part."""
    for event in events:
        told = [p.target for p in event.pps if p.value == "to"]
        for mention in [*event.subject, event.object, *told] if event.says else []:
            if isinstance(mention, Mention) and any("onlooker" in h.data for h in mention.heads):
                mention.negated = True


def _anybody(mention: Mention) -> bool:
    """``two people``, ``a man``: not said to be on foot."""
    people = bool(mention.heads) and all(h.value == "pedestrian" for h in mention.heads)
    return people and not any("afoot" in h.data for h in mention.heads) and not mention.pps


def _victim(mention: Mention, event: Event, chunks: list[Chunk]) -> None:
    """``a man was hurt when his van left the road``: his van; else nobody, unless told more of."""
    after = [c for c in chunks if isinstance(c, Mention) and c.i >= event.j]
    own = next((m for m in after if _his(m)), None)
    several = mention.head is not None and mention.head.form == "s"
    if own is not None and not several:
        own.same_as = mention
        mention.drives = True
    elif own is not None or not any(m.pronoun in _REFERRING for m in after):
        mention.negated = True


def _his(mention: Mention) -> bool:
    """Whether it is somebody's vehicle ("his van", "their car")."""
    whose = mention.mods[0] if mention.mods else None
    owned = whose is not None and (whose.cat, whose.value) == ("possessive", "its")
    people = {"pedestrian", "driver"}
    return owned and bool(mention.heads) and not any(h.value in people for h in mention.heads)


def put_there(chunks: list[Chunk], tokens: list[Token]) -> None:
    """``a cone left behind by workers``: they are not about any more."""
    for k, chunk in enumerate(chunks):
        by, who = [*chunks[k + 1 : k + 3], None, None][:2]
        if not (isinstance(by, Word) and by.value == "by" and isinstance(who, Mention)):
            continue
        put = any(t.low in word_list("put") for t in tokens[max(0, chunk.i - _PUT_REACH) : chunk.j])
        before = any(isinstance(c, Thing) for c in chunks[max(0, k - _PUT_REACH) : k])
        if put and before and any(h.value in _PEOPLE for h in who.heads):
            who.negated = True
