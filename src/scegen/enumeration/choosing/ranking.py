"""Ranking by conflict richness."""

from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import ConflictKind, LogicalScenario, Reverses
from scegen.scenario.vocabulary import JunctionKind, Maneuver

_WEIGHT = {
    ConflictKind.CROSSING: 3,
    ConflictKind.MERGING: 2,
    ConflictKind.FOLLOWING: 1,
    ConflictKind.DIVERGING: 1,
    ConflictKind.NONE: 0,
}


def richness(scenario: LogicalScenario, functional: FunctionalScenario) -> int:
    """Conflicts count by kind, and twice where the ego or somebody in a hazard takes part."""
    centre = {functional.ego.id}
    for hazard in functional.hazards:
        centre.update(hazard.by, hazard.to)
    return sum(
        _WEIGHT[c.kind] * (1 + len(centre & {c.first, c.second})) for c in scenario.conflicts
    )


def richest_first(scenario: LogicalScenario, functional: FunctionalScenario) -> tuple[int, ...]:
    """A key to sort by: rich before poor, of equally rich ones the plainest first.

    But who reverses at a junction comes out of an arm, as out of a drive, where it can; everybody
    meets somebody and they come from all sides, if that can be had; of whom no turn is said keeps
    its course, the ego before all; and who turns meets those on foot on the road it turns into.
    """
    ego = functional.ego
    turning = {d.participant for d in scenario.drives if d.turn is not Maneuver.STRAIGHT}
    strays = {p.id for p in functional.participants if not p.maneuvers} & turning
    meeting = {n for c in scenario.conflicts if _WEIGHT[c.kind] > 1 for n in (c.first, c.second)}
    junction = functional.junction.kind is not JunctionKind.STRAIGHT
    odd = sum(junction and drive.reverses is Reverses.BACKS_UP for drive in scenario.drives)
    moving = (d for d in scenario.drives if junction and d.maneuver is not Maneuver.STAY)
    arms = {drive.entry for drive in moving}
    left = {d.entry for d in scenario.drives if d.participant in turning}
    early = sum(crossing.arm in left for crossing in scenario.crossings)
    varied = -len(meeting), -len(arms), len(strays), early, -richness(scenario, functional)
    return odd, ego.id in strays, *varied, len(turning), scenario.index
