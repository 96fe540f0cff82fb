"""``one from each arm``: as many arms as vehicles."""

from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.phrases.listed import from_everywhere
from scegen.understanding.road.junctions import JunctionReading, shape_of

_FEWEST, _MOST = ARM_COUNTS[JunctionKind.MULTI_WAY]


def share_arms(chunks: list[Chunk], events: list[Event]) -> list[tuple[Mention, list[Mention]]]:
    """Marks "one" in "three cars meet, one from each arm" as nobody new.

    Returns:
        Each such "one" with those of whom it is said.
    """
    found = []
    for chunk in chunks:
        if not isinstance(chunk, Mention) or chunk.pronoun != "one":
            continue
        if not any(from_everywhere(p) and isinstance(p.target, Place) for p in chunk.pps):
            continue
        before = [e for e in events if e.j <= chunk.i and e.subject and chunk not in e.subject]
        listed = [c for c in chunks if isinstance(c, Mention) and c.j <= chunk.i]
        chunk.negated = True
        found.append((chunk, before[-1].subject if before else listed))
    return found


def count_arms(shared: list[tuple[Mention, list[Mention]]], junction: JunctionReading) -> None:
    """Gives the junction an arm for each of those who come from one each."""
    for one, together in shared:
        members: list[Entity] = [e for m in together for e in m.entities if e.is_vehicle]
        known = junction.arms is not None
        shaped = junction.kind not in {None, JunctionKind.ROUNDABOUT}
        if not _FEWEST <= len(members) <= _MOST or known or shaped:
            continue
        basis = Basis(one.i, one.pps[-1].target.j if one.pps[-1].target else one.j)
        junction.arms, junction.arms_basis = len(members), basis
        if junction.kind is None:
            junction.kind, junction.kind_basis = shape_of(len(members)), basis
        for arm, entity in enumerate(members):
            entity.entries, entity.entry_basis = {arm}, basis
