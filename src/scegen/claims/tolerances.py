"""How exactly what is said must hold: beyond this, a test engineer calls it something else."""

from __future__ import annotations

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

OF_MEASURE: dict[Measure, float] = {
    Measure.GAP_M: GAP_M,
    Measure.HEADWAY_S: TIME_S,
    Measure.TTC_S: TIME_S,
    Measure.LATERAL_GAP_M: LATERAL_M,
    Measure.LATERAL_OFFSET_M: LATERAL_M,
    Measure.OVERLAP_PERCENT: PERCENT,
}
UNITS: dict[Measure, str] = {
    Measure.GAP_M: "m",
    Measure.HEADWAY_S: "s",
    Measure.TTC_S: "s",
    Measure.LATERAL_GAP_M: "m",
    Measure.LATERAL_OFFSET_M: "m",
    Measure.OVERLAP_PERCENT: "%",
}
