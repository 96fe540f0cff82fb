"""Whom a search is about: the pair of the target, and whose measures it needs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np

from scegen.criticality.hazards.judging import hazard_pairs
from scegen.criticality.hazards.roles import victims
from scegen.criticality.hazards.table import PREDICATES
from scegen.criticality.scene import Scene, build_scene
from scegen.motion.model import Path
from scegen.motion.standing import object_paths
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.logical import ConflictKind
from scegen.scenario.vocabulary import HazardKind

Pair = tuple[str, str]
MEETS = (ConflictKind.CROSSING, ConflictKind.MERGING)


def candidate_pairs(concrete: ConcreteScenario) -> list[Pair]:
    """Pairs that the danger may be about, the best first, each once.

    First those of the dangers, plain conflicts and the ego's before others, what only stands there
    last; then the ego's conflicts, then all others; those between whom somebody drives come last.
    """
    ego = concrete.ego.id
    things = {thing.id for thing in concrete.objects}
    found: list[Pair] = []
    kinds = list(PREDICATES)
    for hazard in sorted(
        (h for h in concrete.hazards if h.kind in PREDICATES), key=lambda h: kinds.index(h.kind)
    ):
        if not PREDICATES[hazard.kind].conflict:
            continue
        pairs = [
            (b, v) for b, _ in hazard_pairs(concrete, hazard) for v in victims(concrete, hazard, b)
        ]
        found += sorted(dict.fromkeys(pairs), key=lambda pair: ego not in pair)
    moving = [pair for pair in found if not things & {*pair}]
    found = [*moving, *(pair for pair in found if pair not in moving and ego in pair)]
    conflicts = [c for c in concrete.logical.conflicts if c.kind is not ConflictKind.NONE]
    conflicts.sort(key=lambda c: (ego not in {c.first, c.second}, c.kind not in MEETS))
    found += [(c.first, c.second) for c in conflicts]
    movers = [p.id for p in concrete.participants if not p.parked]
    found += sorted(combinations(movers, 2), key=lambda pair: ego not in pair)
    seen: set[frozenset[str]] = set()
    result = []
    for pair in found:
        if frozenset(pair) not in seen and pair[0] != pair[1]:
            seen.add(frozenset(pair))
            result.append(pair)
    return sorted(result, key=lambda pair: _parted(concrete, pair))


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


def judged_pairs(concrete: ConcreteScenario) -> list[Pair]:
    """Pairs whose measures a predicate asks for."""
    pairs = []
    for hazard in concrete.hazards:
        pairs += [(b, v) for b, v in hazard_pairs(concrete, hazard) if b != v]
    return list(dict.fromkeys(pairs))


def occlusions(concrete: ConcreteScenario) -> list[tuple[str, str, str]]:
    """(observer, target, occluder) of the dangers of occlusion."""
    movers = [p.id for p in concrete.participants if not p.parked]
    return [
        (observer, target, occluder)
        for hazard in concrete.hazards
        if hazard.kind is HazardKind.OCCLUSION
        for occluder, observer in hazard_pairs(concrete, hazard)
        for target in movers
        if target not in {observer, occluder}
    ]


def scene_of(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    focus: Sequence[Pair],
    friction: float,
) -> Scene:
    """A scene with all measures for some pairs, and contacts and distances for all others.

    Where lanes are shared and paths cross costs time per pair, so only the focus gets it.
    """
    index = {entity.id: i for i, entity in enumerate(concrete.entities)}
    ways = {**paths, **object_paths(concrete)}
    chosen: dict[tuple[int, int], None] = {}
    for a, b in focus:
        if (index[b], index[a]) not in chosen:
            chosen[index[a], index[b]] = None
    scene = build_scene(
        [ways[name] for name in index],
        [*(p.kind for p in concrete.participants), *concrete.objects],
        pairs=list(chosen),
        occlusions=[(index[a], index[b], index[c]) for a, b, c in occlusions(concrete)],
        friction=friction,
    )
    parked = [*(p.parked for p in concrete.participants), *(True for _ in concrete.objects)]
    rest = [
        (i, j)
        for i, j in combinations(range(len(parked)), 2)
        if (i, j) not in chosen and (j, i) not in chosen and not (parked[i] and parked[j])
    ]
    if not rest:
        return scene
    first = np.vstack([scene.following.first, np.full((len(rest), 2), -1, dtype=np.int64)])
    areas = np.concatenate(
        [scene.areas.first, np.full(len(rest), scene.areas.first[-1], dtype=np.int64)]
    )
    return scene._replace(
        pairs=np.vstack([scene.pairs, np.array(rest, dtype=np.int64)]),
        following=scene.following._replace(first=first),
        areas=scene.areas._replace(first=areas),
    )


def has_areas(scene: Scene, p: int) -> bool:
    """Whether the paths of a pair cross or merge."""
    return bool(scene.areas.first[p + 1] > scene.areas.first[p])


def follows(scene: Scene, p: int) -> bool:
    """Whether one of a pair drives behind the other somewhere."""
    return bool((scene.following.first[p] >= 0).any())
