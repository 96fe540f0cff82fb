"""Participants that come up together, and people who stand for their vehicle."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Word
from scegen.understanding.draft import Entity
from scegen.understanding.reference.mention_words import KINDS, Reading
from scegen.understanding.words.ordinals import POSITIONS
from scegen.understanding.words.tokens import Token

_MOTOR = frozenset(ParticipantKind) - ON_FOOT


@dataclass(slots=True)
class Group:
    """Participants introduced together ("two cars", "traffic")."""

    members: list[Entity]
    vague: bool
    dirs: set[str] = field(default_factory=set)
    specific: bool = False
    settled: bool = False
    """What they do is said of all of them, so that "one car" is somebody else."""
    both: bool = False
    """The text says "both": there is nobody else."""
    unnamed: bool = False
    """It is not said what they drive ("three of us")."""

    @property
    def free(self) -> list[Entity]:
        """Members that no later mention has picked out."""
        return [e for e in self.members if not e.claimed]


def opened(reading: Reading, mention: Mention, entities: list[Entity]) -> list[Entity]:
    """``parked cars … a driver opens his door``: the driver stands for one of them.

    Args:
        reading: what the words say.
        mention: who opens a door.
        entities: everybody so far.
    """
    aboard = mention.head is not None and bool(mention.head.data.get("aboard"))
    if not mention.seated or not (reading.driver or aboard):
        return []
    return [e for e in entities if e.parked][-1:]


def vehicle_around(reading: Reading, mention: Mention) -> Mention | None:
    """``someone in a van``: people in or on a vehicle stand for it."""
    afoot = reading.kind in ON_FOOT or mention.goes_by is not None
    if not afoot and not reading.driver:
        return None
    for prep in mention.pps:
        target = prep.target
        if prep.value == "in" and isinstance(target, Mention) and target.heads:
            kinds = [KINDS.get(h.value) for h in target.heads]
            if any(kind in _MOTOR for kind in kinds if kind is not None):
                return target
    return None


def in_list(groups: list[Group], tokens: list[Token], mention: Mention) -> bool:
    """Whether a colon after a group opens the list in which somebody is named.

    Args:
        groups: the groups so far.
        tokens: the tokens of the text.
        mention: somebody.
    """
    if not groups or groups[-1].vague:
        return False
    said = groups[-1].members[-1].basis.j or 0
    colons = [k for k, t in enumerate(tokens[: mention.i]) if t.low == ":" and k >= said]
    stops = [k for k, t in enumerate(tokens[: mention.i]) if t.low == "."]
    return bool(colons) and not any(k > colons[0] for k in stops)


def rank(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``the ego is fifth in a row of eight cars``: one of the eight, with four in front of it.

    Args:
        chunks: the chunks of the text.
        events: its events.
        tokens: its tokens.
    """
    for place, prep, row in zip(chunks, chunks[1:], chunks[2:], strict=False):
        label = tokens[place.i].low if isinstance(place, Word) else ""
        within = isinstance(prep, Word) and prep.value == "in"
        if label not in POSITIONS or not within or not isinstance(row, Mention):
            continue
        named = [c for c in chunks if isinstance(c, Mention)]
        who = [m for m in named for p in m.pps if p.target is row]
        who += [m for e in events for p in e.pps if p.target is row for m in e.subject]
        if len(who) == 1 and row.mod("num") is not None:
            row.ranked = (who[0], POSITIONS[label])


def with_the_ranked(row: Mention, others: list[Entity]) -> list[Entity]:
    """The row, with whom it was said to be in it at their place.

    Args:
        row: the words for it.
        others: all but that one, in order.
    """
    if row.ranked is None:
        return others
    who, place = row.ranked
    at = place if place >= 0 else len(others) + 1 + place
    return [*others[:at], *who.entities, *others[at:]]


def of_both(
    reading: Reading, loci: set[str], groups: list[Group], entities: list[Entity]
) -> list[Entity]:
    """``both vehicles go straight, the adversary from the left``: one of them, one the ego.

    Args:
        reading: what the words of a role ("the ego", "the adversary") say.
        loci: where words after the noun put it.
        groups: those named together so far.
        entities: everybody so far.
    """
    ego = next((e for e in entities if e.ego), None)
    places = reading.dirs | loci
    placed = bool(places) and places <= {"ahead", "behind"} and reading.det == "def"
    if reading.plural:
        return []
    if not (reading.ego or placed or "adversary" in reading.labels):
        return []
    for group in groups:
        taken = [e for e in group.members if e.claimed and e is not ego]
        left = [e for e in group.members if e not in taken]
        if not group.both or (ego is not None and ego not in group.members):
            continue
        if len(taken) == 1 and ego is None and not any("adversary" in e.labels for e in taken):
            left[0].ego, left[0].claimed = reading.ego, True
            left[0].named_by |= {"ego"} if reading.ego else set()
            return left  # "the follower hits the leader": of both, the one who is left
        if taken:
            continue
        own = ego or group.members[0]
        if placed and ego is None and not reading.ego:
            group.members[-1].claimed = True  # "both cars are fast; the leader brakes"
            return [group.members[-1]]
        own.ego = True
        own.named_by.add("ego")
        chosen = own if reading.ego else next(e for e in group.members if e is not own)
        chosen.claimed = True
        return [chosen]
    return []
