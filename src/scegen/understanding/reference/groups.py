"""Participants that come up together, and people who stand for their vehicle."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.scenario.vocabulary import ON_FOOT
from scegen.understanding.chunks import Mention
from scegen.understanding.entity import Entity
from scegen.understanding.reference.mention_words import KINDS, Reading


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

    @property
    def free(self) -> list[Entity]:
        """Members that no later mention has picked out."""
        return [e for e in self.members if not e.claimed]


def opened(reading: Reading, mention: Mention, entities: list[Entity]) -> list[Entity]:
    """``parked cars … a driver opens his door``: the driver stands for one of them."""
    aboard = mention.head is not None and bool(mention.head.data.get("aboard"))
    if not mention.seated or not (reading.driver or aboard):
        return []
    return [e for e in entities if e.parked][-1:]


def vehicle_around(reading: Reading, mention: Mention) -> Mention | None:
    """``someone in a van``, ``a cyclist on a racing bike``: they stand for the vehicle."""
    person = reading.driver or reading.kind in ON_FOOT or mention.goes_by is not None
    for prep in mention.pps:
        target = prep.target
        if prep.value == "in" and isinstance(target, Mention):
            kinds = [KINDS[h.value] for h in target.heads if h.value in KINDS]
            if set(kinds) - ON_FOOT and (person or set(kinds) == {reading.kind}):
                return target
    return None
