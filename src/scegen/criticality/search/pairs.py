"""Whom a search is about: the pair of the target, and whose measures it needs."""

from itertools import combinations

from scegen.claims.hazards.judging import both_sides
from scegen.claims.hazards.scenes import Pair
from scegen.claims.hazards.table import PREDICATES
from scegen.measures.tables import Tables
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.logical import ConflictKind, Rule

MEETS = (ConflictKind.CROSSING, ConflictKind.MERGING)


def candidate_pairs(concrete: ConcreteScenario) -> list[Pair]:
    """Pairs that the danger may be about, the best first, each once.

    First those of the dangers, the ego's before others, plain conflicts before those with what
    only stands there; then the ego's conflicts, then all others; those between whom somebody
    drives, and whom lights keep apart, come last. Others of whom one only follows another keep
    their distance.
    """
    ego = concrete.ego.id
    things = {thing.id for thing in concrete.objects}
    found: list[Pair] = []
    kinds = list(PREDICATES)
    asked = [h for h in concrete.hazards if h.kind in PREDICATES and PREDICATES[h.kind].conflict]
    for hazard in sorted(asked, key=lambda h: kinds.index(h.kind)):
        found += both_sides(hazard)
    found.sort(key=lambda pair: ego not in pair)
    moving = [pair for pair in found if not things & {*pair}]
    found = [*moving, *(pair for pair in found if pair not in moving and ego in pair)]
    conflicts = [c for c in concrete.logical.conflicts if c.kind is not ConflictKind.NONE]
    conflicts.sort(key=lambda c: (ego not in {c.first, c.second}, c.kind not in MEETS))
    movers = [p.id for p in concrete.participants if not p.parked]
    more = [(c.first, c.second) for c in conflicts]
    more += sorted(combinations(movers, 2), key=lambda pair: ego not in pair)
    in_file = (c for c in conflicts if c.kind is ConflictKind.FOLLOWING)
    follow = {frozenset((c.first, c.second)) for c in in_file}
    found += [pair for pair in more if ego in pair or frozenset(pair) not in follow]
    once: dict[frozenset[str], Pair] = {}
    for pair in found:
        if pair[0] != pair[1]:
            once.setdefault(frozenset(pair), pair)
    apart = {
        frozenset((c.first, c.second))
        for c in concrete.logical.conflicts
        if c.rule is Rule.SIGNAL
        and not any({c.first, c.second} & {*h.by} for h in concrete.hazards)
    }
    return sorted(once.values(), key=lambda p: (frozenset(p) in apart, _parted(concrete, p)))


def _parted(concrete: ConcreteScenario, pair: Pair) -> bool:
    """Whether somebody drives between two in the queue of one lane: neighbours come close."""
    ranks = {drive.participant: drive.rank for drive in concrete.logical.drives}
    queues = {
        p.id: (p.motion.entry, p.motion.entry_lane)
        for p in concrete.participants
        if isinstance(p.motion, DriveMotion) and not p.motion.lane_changes and p.id in ranks
    }
    if not queues.keys() >= {*pair} or queues[pair[0]] != queues[pair[1]]:
        return False
    low, high = sorted(ranks[name] for name in pair)
    return any(
        low < ranks[name] < high for name, queue in queues.items() if queue == queues[pair[0]]
    )


def has_areas(scene: Tables, p: int) -> bool:
    """Whether the paths of a pair cross or merge."""
    return bool(scene.areas.first[p + 1] > scene.areas.first[p])


def follows(scene: Tables, p: int) -> bool:
    """Whether one of a pair drives behind the other somewhere."""
    return bool((scene.following.first[p] >= 0).any())
