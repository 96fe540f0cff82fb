"""What a drive made of the danger, by the measures and predicates that judge our own scenarios."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from scegen.checking.esmini.recording import Movement
from scegen.checking.said import recorded_view
from scegen.claims.hazards.judging import judge, number
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.proof import HazardProof

_MEASURES = ("distance_m", "ttc_s", "pet_s", "drac_mps2", "contact_s")


@dataclass(frozen=True, slots=True)
class Danger:
    """How near the ego came to one other, None where a measure does not exist.

    ``distance_m`` is the least between the bodies, 0 in contact; ``ttc_s`` the least time to
    collision; ``pet_s`` the post-encroachment time; ``drac_mps2`` the highest deceleration that
    would have been needed; ``contact_s`` when they touched.
    """

    other: str
    distance_m: float | None
    ttc_s: float | None
    pet_s: float | None
    drac_mps2: float | None
    contact_s: float | None


def judged(
    concrete: ConcreteScenario, movements: Sequence[Movement]
) -> tuple[list[Danger], tuple[HazardProof, ...]]:
    """The danger of the ego with everybody else, and whether each hazard still happens.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    view = recorded_view(concrete, list(movements))
    ego = concrete.ego.id
    dangers = []
    for entity in concrete.entities:
        if entity.id == ego or view.pair(ego, entity.id) is None:
            continue
        values = {name: number(view.of_pair(name, ego, entity.id)[0]) for name in _MEASURES}
        dangers.append(Danger(entity.id, **values))
    return dangers, tuple(judge(view, hazard) for hazard in concrete.hazards)
