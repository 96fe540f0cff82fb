"""How exactly what is said must hold: beyond this, a test engineer calls it something else."""

from typing import NamedTuple

from scegen.scenario.spacings import Measure

SPEED_MPS = 0.5 / 3.6
GAP_M = 0.5
LATERAL_M = 0.1
TIME_S = 0.1
RATE_MPS2 = 0.3
PERCENT = 5.0
STANDS_MPS = SPEED_MPS
SAME_LANE_M = 1.75
"""Half a lane: whose centre lies farther to the side is in another."""
DISTANCE_M = 1.0
"""Of a way that somebody goes, or a place along the road."""


class Exactly(NamedTuple):
    """What a measure is called, its unit, how far it may be off, and what is worth as much."""

    name: str
    unit: str
    tolerance: float
    scale: float


OF_MEASURE: dict[Measure, Exactly] = {
    Measure.GAP_M: Exactly("gap", "m", GAP_M, 2.0),
    Measure.HEADWAY_S: Exactly("headway", "s", TIME_S, 0.5),
    Measure.TTC_S: Exactly("time to collision", "s", TIME_S, 0.5),
    Measure.LATERAL_GAP_M: Exactly("free width", "m", LATERAL_M, 2.0),
    Measure.LATERAL_OFFSET_M: Exactly("lateral offset", "m", LATERAL_M, 2.0),
    Measure.OVERLAP_PERCENT: Exactly("overlap", "%", PERCENT, 20.0),
}
