"""Demands that nothing can fulfil, found without a search."""

from scegen.claims.hazards.scenes import Pair
from scegen.criticality.search.bounds import speed_range
from scegen.criticality.search.pairs import MEETS, follows, has_areas
from scegen.criticality.target import Target
from scegen.measures.tables import Tables
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.wording import with_article

WALKING_PACE_MPS = 1.5
"""At this speed a car stops within its own shadow (0.2 m): nothing becomes dangerous."""


def too_slow(concrete: ConcreteScenario, pair: Pair) -> str | None:
    """Both go at walking pace at most, whatever is varied."""
    fastest = 0.0
    for participant in (p for p in concrete.participants if p.id in pair):
        arm = participant.motion.entry if isinstance(participant.motion, DriveMotion) else 0
        limit = concrete.road.arms[arm].speed_limit_mps
        later = (phase.target_speed_mps for phase in participant.speed_program)
        planned = max((participant.speed_mps, *later))
        fastest = max(fastest, speed_range(concrete, participant, limit, planned)[1])
    if fastest > WALKING_PACE_MPS:
        return None
    return (
        f"neither {pair[0]} nor {pair[1]} may go faster than {fastest:.2g} m/s here: at walking "
        "pace everybody stops within 0.2 m, so nothing becomes dangerous"
    )


def measurable(target: Target, scene: Tables, p: int, *, still: bool = False) -> bool:
    """Whether the target can be about this pair at all.

    How near somebody passes by what is ``still`` there can be asked even where it leads around.
    """
    if not target.choices:
        return True
    if target.contact:
        return has_areas(scene, p) or follows(scene, p)
    names = {choice[0].measure for choice in target.choices}
    if still and "distance" in names:
        return True
    if names == {"pet"}:
        return has_areas(scene, p)
    if names <= {"headway", "drac"}:
        return follows(scene, p)
    return has_areas(scene, p) or follows(scene, p)


def never_meet(target: Target, pairs: list[Pair], concrete: ConcreteScenario) -> str:
    """The reason where no pair can be measured."""
    if not pairs and len(concrete.participants) > 1:
        return f"nobody else moves, and what is parked is no danger asked for: no {target.text}"
    if not pairs:
        return f"nobody else is on the road, so nothing can be {with_article(target.text)}"
    shown = ", ".join(f"{a} and {b}" for a, b in pairs[:3])
    more = f" and {len(pairs) - 3} more pairs" if len(pairs) > 3 else ""
    names = {choice[0].measure for choice in target.choices}
    if names == {"pet"}:
        return f"the paths of {shown}{more} neither cross nor merge, so they have no PET"
    if names <= {"headway", "drac"}:
        return f"of {shown}{more} none drives behind the other, so there is no {min(names)}"
    meet = [(c.first, c.second) for c in concrete.logical.conflicts if c.kind in MEETS]
    lanes = ": where their ways meet, each has a lane of its own" if meet else ""
    return f"the paths of {shown}{more} never meet{lanes}"
