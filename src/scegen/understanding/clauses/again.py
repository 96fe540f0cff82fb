"""Who is meant by one that comes from somewhere, and by a doing that is told already."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.scenario.acts import ActKind
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.frames import acts

_SEVERAL = frozenset({"both", "all", "they"})
_SIDES = frozenset({"left", "right"})


def who_comes(chunks: list[Chunk], events: list[Event]) -> None:
    """``hits a cyclist at 15 km/h, coming from the left``: the ego comes from no own side."""
    for event in events:
        coming = (event.lemma, event.form) == ("come", "ing") and not event.finite
        ego = bool(event.subject) and all(m.is_ego for m in event.subject)
        if not (coming and ego and any(map(_from_a_side, event.pps))):
            continue
        named = [c for c in chunks if isinstance(c, Mention) and c.i < event.i and c.heads]
        others = [m for m in named if m.i > event.subject[0].i and not (m.is_ego or m.possessor)]
        event.subject = others[-1:] or event.subject


def named_again(events: list[Event]) -> None:
    """``… as the lane change begins``, ``2 s after the cut-in the ego brakes``: whose it was.

    Not of who acts there, unless it is called its own, or of its verb.
    """
    for event in events:
        known = any((m.cat, m.value) == ("det", "def") for m in event.mods)
        owners = [m for p in event.pps for m in [p.target] if isinstance(m, Mention)]
        own = event.parent is not None or any(m.possessor or m in owners for m in event.subject)
        later = [m for e in events if e.sentence > event.sentence for m in e.subject]
        others = any(m.pronoun in _SEVERAL or m in later for m in event.subject)
        if event.nominal and event.form != "s" and known and (others or not own):
            kind = acts().get(event.name)
            told = [e for e in events if e.i < event.i and e.finite and kind in _done(e)]
            subject = [] if others else event.subject
            event.subject = list(told[-1].subject) if told and kind else subject


def _done(event: Event) -> Iterator[ActKind | None]:
    """What a verb is as an act; who comes into a lane has changed lanes."""
    yield acts().get(event.name)
    if any(isinstance(n, Place) and n.kind == "lane" for n in event.nouns("into")):
        yield ActKind.CHANGE_LANE


def names_another(events: list[Event]) -> None:
    """``comes up to a lorry that does 60 km/h and slows to the lorry's speed``: not the lorry.

    Nobody calls himself by his noun again: then the verb goes with the one outside the clause.
    """
    for k, event in enumerate(events):
        if event.embedded or event.nominal or len(event.subject) != 1:
            continue
        (one,) = event.subject
        said = (m for m, e in enumerate(events[:k]) if e.embedded and e.subject == [one])
        first = next(said, 0)  # the clause within another that tells of it
        outer = [e for e in events[:first] if not e.embedded and one not in e.subject]
        if outer and outer[-1].subject and any(_same_noun(m, one) for m in _named_with(event)):
            event.subject = outer[-1].subject


def said_of_one(chunks: list[Chunk], events: list[Event]) -> None:
    """``the van ahead of the ego, both at 50 km/h, brakes``: the van, as "both" would brake."""
    for event in (e for e in events if e.form == "s" and not e.nominal):
        both = [m for m in event.subject if m.pronoun == "both" and m.head is None]
        opens = max((c.i for c in chunks if c.value == "." and c.i < event.i), default=-1)
        named = [c for c in chunks if isinstance(c, Mention) and opens < c.i < event.i and c.heads]
        if both and named and not named[0].plural:
            event.subject = named[:1]


def _named_with(event: Event) -> list[Mention]:
    """Whom a verb takes, and who owns what it takes."""
    taken = [event.object, *(p.target for p in event.pps)]
    owners = [t.owner for t in taken if isinstance(t, NounPhrase)]
    return [m for m in (*taken, *owners) if isinstance(m, Mention)]


def _same_noun(mention: Mention, one: Mention) -> bool:
    later = mention.i > one.i and mention.has("det", "def") and mention.head is not None
    return later and one.noun == mention.noun and one.label == mention.label


def _from_a_side(prep: Prep) -> bool:
    sided = prep.place is not None and bool(_SIDES & {*prep.place.dirs})
    return sided and prep.value == "from"
