"""Whose measures the predicates of hazards ask for."""

from collections.abc import Mapping, Sequence
from itertools import combinations

from scegen.claims.hazards.judging import hazard_pairs
from scegen.measures.tables import Tables, build_tables
from scegen.motion.model import Path
from scegen.motion.standing import object_paths
from scegen.scenario.concrete import ConcreteScenario, SwingingMotion
from scegen.scenario.vocabulary import HazardKind

Pair = tuple[str, str]


def judged_pairs(concrete: ConcreteScenario) -> list[Pair]:
    """Pairs whose measures a predicate asks for."""
    pairs = (pair for hazard in concrete.hazards for pair in hazard_pairs(hazard))
    return list(dict.fromkeys((b, v) for b, v in pairs if b != v))


def occlusions(concrete: ConcreteScenario) -> list[tuple[str, str, str]]:
    """(observer, target, occluder) of the dangers of occlusion.

    Who is hidden is who endangers the observer, or is endangered by it, otherwise, and moves, if
    anybody does; if nobody is, everybody who moves.
    """
    people = [p.id for p in concrete.participants]
    movers = {p.id for p in concrete.participants if not p.parked}
    hiding = [h for h in concrete.hazards if h.kind is HazardKind.OCCLUSION]
    others = [h for h in concrete.hazards if h not in hiding]
    found = []
    for hazard in hiding:
        for occluder, observer in hazard_pairs(hazard):
            meets = {who for h in others if observer in h.to for who in h.by}
            meets |= {who for h in others if observer in h.by for who in h.to}
            meets &= {*people} - {occluder}
            hidden = (meets & movers or meets or movers) - {observer, occluder}
            found += [(observer, target, occluder) for target in people if target in hidden]
    return found


def scene_of(
    concrete: ConcreteScenario, paths: Mapping[str, Path], focus: Sequence[Pair], friction: float
) -> Tables:
    """A scene with all measures for some pairs, and contacts and distances for all others.

    Where lanes are shared and paths cross costs time per pair, so only the focus gets it.
    """
    index = {entity.id: i for i, entity in enumerate(concrete.entities)}
    ways = {**paths, **object_paths(concrete)}
    chosen: dict[tuple[int, int], None] = {}
    for a, b in focus:
        if (index[b], index[a]) not in chosen:
            chosen[index[a], index[b]] = None
    parked = [*(p.parked for p in concrete.participants), *(True for _ in concrete.objects)]
    hung = {
        (index[p.motion.vehicle], index[p.id])
        for p in concrete.participants
        if isinstance(p.motion, SwingingMotion)
    }
    known = {*chosen, *((j, i) for i, j in chosen), *hung}
    rest = (pair for pair in combinations(range(len(parked)), 2) if pair not in known)
    return build_tables(
        [ways[name] for name in index],
        [entity.body for entity in concrete.entities],
        pairs=list(chosen),
        others=[(i, j) for i, j in rest if not (parked[i] and parked[j])],
        occlusions=[(index[a], index[b], index[c]) for a, b, c in occlusions(concrete)],
        friction=friction,
    )
