"""Which participant is the ego: the one called so, or one of those named together, by its place."""

from itertools import pairwise

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, value_at
from scegen.understanding.reference.mention_words import Reading
from scegen.understanding.reference.roster import Group, Roster, claimed
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at

_ANY = frozenset({"car", "driver"})
_REST = 12
"""Within so many words "the other" tells that somebody is one of two."""


def _take(entity: Entity) -> Entity:
    entity.ego = entity.claimed = True
    entity.named_by.add("ego")
    return entity


def the_ego(roster: Roster, kind: ParticipantKind, basis: Basis) -> Entity:
    """The ego, a new participant if nobody is it yet.

    Its kind is given where it does not say itself what it goes by.
    """
    told = kind is ParticipantKind.CAR and not roster.apart
    return roster.draft.ego or _take(roster.new(roster.teller if told else kind, basis))


def the_teller(roster: Roster, kind: ParticipantKind, basis: Basis) -> Entity:
    """Who tells it: the ego, unless it walks or cycles beside one that is named."""
    if roster.apart:
        known = next((e for e in roster.entities if "speaks" in e.named_by), None)
        teller = known or roster.new(roster.teller, basis)
        teller.claimed = True
    else:
        teller = the_ego(roster, kind, basis)
    teller.named_by.add("speaks")
    return teller


def last_is_ego(roster: Roster, mention: Mention) -> None:
    """``three cars: the first …, the second …, and the ego``: the one that is left."""
    if roster.draft.ego is not None:
        return
    for group in reversed(roster.groups):
        counted = not group.vague and len(group.members) > 2 and len(group.free) == 1
        counted = counted or _of_two(roster, group, mention)
        listed = group is roster.groups[-1] and not group.vague and mention.listed
        for last in group.free[:1] if counted or listed else []:
            if last.kind is ParticipantKind.CAR and not last.parked:
                _take(last)


def ego_by_order(roster: Roster, mention: Mention) -> None:
    """``three cars in a row …, we are the last``, ``the ego second``, ``with it as third``."""
    begin = mention.j + (low_at(roster.tokens, mention.j) == ",")  # "and the ego, last, …"
    after = roster.tokens[begin : begin + 5]
    words = [t.low for t in after]
    said = not word_list("counting_as").isdisjoint(words[:1])
    told = words[1 + (words[1:2] == ["the"]) :] if said else words
    alone = said or len(words) < 2 or after[1].kind == "punct" or mention.stands_after("with")
    inmost = "_".join(told[:3]) if told[3:4] != ["of"] else ""
    position = POSITIONS.get(inmost, POSITIONS.get(told[0]) if told and alone else None)
    if position is None or roster.draft.ego is not None or not roster.groups:
        return
    members = roster.groups[-1].members
    if not -len(members) <= position < len(members) or roster.groups[-1].vague:
        return
    chosen = members[position]
    if chosen.moving_vehicle:
        _take(chosen).named_by.add("ranked")


def _of_two(roster: Roster, group: Group, mention: Mention) -> bool:
    """``two cars drive in one lane, the ego behind the other``: one of the two."""
    pair = len(group.members) == 2 == len(group.free) and not group.vague
    pair = pair and all(e.kind is ParticipantKind.CAR for e in group.members)
    after = [t.low for t in roster.tokens[mention.j : mention.j + _REST]]
    return pair and any(a == "the" and b == "other" for a, b in pairwise(after))


def of_both(reading: Reading, loci: set[str], roster: Roster) -> list[Entity]:
    """``both vehicles go straight, the adversary from the left``: one of them, one the ego."""
    ego = roster.draft.ego
    places = reading.dirs | loci
    placed = bool(places) and places <= {"ahead", "behind"} and reading.det in {"def", "bare"}
    if reading.plural or not (reading.ego or placed or "adversary" in reading.labels):
        return []
    for group in roster.groups:
        taken = [e for e in group.members if e.claimed and e is not ego]
        left = [e for e in group.members if e not in taken]
        if not group.both or (ego is not None and ego not in group.members):
            continue
        if len(taken) == 1 and ego is None and not any("adversary" in e.labels for e in taken):
            # "the follower hits the leader": of both, the one who is left
            return [_take(left[0])] if reading.ego else claimed(left)
        if taken:
            continue
        own = ego or group.members[0]
        if placed and ego is None and not reading.ego:
            return claimed(group.members[-1:])  # "both cars are fast; the leader brakes"
        own.ego = True
        own.named_by.add("ego")
        return claimed([e for e in group.members if (e is own) is reading.ego][:1])
    return []


def cast_both(chunks: list[Chunk], events: list[Event]) -> None:
    """``two cars drive abreast; the adversary drifts towards the ego``: they are both of them."""
    named = [c for c in chunks if isinstance(c, Mention) and c.heads]
    first, later = (named[0], named[1:]) if named else (None, named)
    if first is None or first.noun not in _ANY or first.opening or first.joined:
        return
    if first.pps or first.dirs:
        return
    number = first.mod("num")
    doing = [e for e in events if first in e.subject]
    met = [n for e in doing for n in (e.object, *(p.target for p in e.pps))]
    egos = [m for m in later if m.is_ego]
    alone = not any(m.joined or any(m is n for n in met) for m in egos)
    alone = alone and not any(e.name in {"park", "stop", "wait"} for e in doing)
    others = [m for m in later if any(h.data.get("label") == "adversary" for h in m.heads)]
    if number and number.data["number"] == 2 and egos and alone and others:
        first.marks.add("both")


def rank(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``the ego is fifth in a row of eight cars``: one of the eight, with four in front of it.

    The same is said by "the last of three cars", "the last in a platoon of three cars".
    """
    named = [c for c in chunks if isinstance(c, Mention)]
    for k, (place, prep, row) in enumerate(zip(chunks, chunks[1:], chunks[2:], strict=False)):
        if not isinstance(row, Mention) or row.mod("num") is None:
            continue
        bare = isinstance(place, Mention) and not place.heads
        label = tokens[place.j - 1].low if bare or isinstance(place, Term) else ""
        within = prep.value in ({"of", "in"} if bare else {"in"})
        if label not in POSITIONS or not within:
            continue
        if bare:  # "the ego is the last of three cars"
            before, told = chunk_at(chunks, k - 2), value_at(chunks, k - 1) == "be"
            who = [before] if told and isinstance(before, Mention) else []
        else:
            who = [m for m in named for p in m.pps if p.target is row]
            who += [m for e in events for p in e.pps if p.target is row for m in e.subject]
        if len(who) == 1:
            row.ranked = (who[0], POSITIONS[label])


def with_the_ranked(row: Mention, others: list[Entity]) -> list[Entity]:
    """The row, with whom it was said to be in it at their place.

    The others are in order.
    """
    if row.ranked is None:
        return others
    who, place = row.ranked
    at = place if place >= 0 else len(others) + 1 + place
    return [*others[:at], *who.entities, *others[at:]]
