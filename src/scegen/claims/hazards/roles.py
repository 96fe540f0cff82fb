"""Who causes and who suffers a danger, also where the text does not say.

The same choices as when the danger was made concrete (``motion.concretization.hazards.rule``).
"""

from __future__ import annotations

from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

_BRAKING = frozenset({HazardKind.HARD_BRAKING, HazardKind.DELAYED_BRAKING, HazardKind.STOPPING})
_BY_STANDERS = frozenset({HazardKind.OCCLUSION, HazardKind.OBSTACLE})
_BY_WALKERS = frozenset({HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_CYCLIST})


def drivers(concrete: ConcreteScenario) -> list[str]:
    """Those who drive."""
    return [p.id for p in concrete.participants if isinstance(p.motion, DriveMotion)]


def culprits(concrete: ConcreteScenario, hazard: Hazard) -> list[str]:
    """Those who cause a danger.

    Where nobody is named: who stands (or a thing that causes nothing else) or walks for what they
    cause; for braking the one that
    another tailgates, else the ego; else the first vehicle that does not suffer.
    """
    if hazard.by:
        return list(hazard.by)
    driving, ego = drivers(concrete), concrete.ego.id
    if hazard.kind in _BY_STANDERS:
        standing = [p.id for p in concrete.participants if p.parked]
        named = {name for other in concrete.hazards for name in other.by}
        return standing or [thing.id for thing in concrete.objects if thing.id not in named]
    if hazard.kind in _BY_WALKERS:
        walkers = [p.id for p in concrete.participants if p.motion.type == "crossing"]
        return [name for name in walkers if name not in hazard.to]
    if hazard.kind in _BRAKING:
        followed = [
            name
            for other in concrete.hazards
            if other.kind is HazardKind.TAILGATING
            for name in other.to
            if name in driving
        ]
        return [name for name in (*followed, ego) if name not in hazard.to][:1]
    free = [name for name in driving if name != ego and name not in hazard.to]
    return free[:1] or ([ego] if ego not in hazard.to else [])


def victims(concrete: ConcreteScenario, hazard: Hazard, culprit: str) -> list[str]:
    """Those who suffer it; where nobody is named, the ego, or the others if it is the ego's."""
    if hazard.to:
        return [name for name in hazard.to if name != culprit]
    ego = concrete.ego.id
    if culprit != ego:
        return [ego]
    return [p.id for p in concrete.participants if p.id != culprit and not p.parked]
