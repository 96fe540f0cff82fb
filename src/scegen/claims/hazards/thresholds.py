"""Thresholds of the hazard predicates, as data with their sources.

[UN152] UN R152: emergency braking demands at least 5 m/s2 (*). [AASHTO] A Policy on Geometric
Design: 3.4 m/s2 is the deceleration for stopping sight distances; about nine in ten drivers brake
harder than that when something surprises them, most harder than 4.5 (Fambro et al. 1997).
[ISO15622] ISO 15622:2018: adaptive cruise control keeps at least 0.8 s (*). [ASC] Allen, Shin,
Cooper (1978) define PET; that below 1.5 s is a conflict is later practice, not agreed on:
Songchitruksa and Tarko (2006) found crashes best explained by PET below 6.5 s. [TTC] 1.5 s
bounds the conflicts that the FHWA's Surrogate Safety Assessment Model counts (FHWA-HRT-08-051);
the measure is Hayward's (1972). [UN157] UN R157, 5.2.5.2: cut-ins are to be managed above a TTC of
v_rel / (2 * 6 m/s2) + 0.35 s, which is 1 s at 28 km/h of difference; its careful driver takes
0.4 s to evaluate a risk. [telematics] makers' thresholds of harsh acceleration for cars lie
between 0.2 and 0.44 g. "own" marks this program's own choice, made so that the danger is plain to
see in the player. (*) quoted from memory: the text itself could not be consulted.
"""

from dataclasses import dataclass

from scegen.scenario.hazards import CUT_IN_S, HARD_BRAKING_MPS2


@dataclass(frozen=True, slots=True)
class Threshold:
    """A limit, the scale on which margins are compared with each other, the source."""

    value: float
    unit: str
    scale: float
    source: str


SPEEDING = Threshold(1.1, "m/s", 1.4, "own: a tenth above the limit")
"""As a share of the speed limit; its margin is in m/s."""
SLOW = Threshold(0.6, "m/s", 1.4, "own: below 0.6 of the limit")
SLOW_FOR_S = 3.0
ACCELERATION = Threshold(2.94, "m/s2", 1.0, "own: 0.3 g, within [telematics]")
HARD_BRAKING = Threshold(HARD_BRAKING_MPS2, "m/s2", 1.0, "[UN152]")
LATE_BRAKING = Threshold(3.4, "m/s2", 1.0, "[AASHTO]")
MEASURED_OVER_S = 0.5
"""Accelerations are means over this time, so that one step does not count."""
OF_WHAT_IS_POSSIBLE = 0.8
"""Bodies and roads that cannot reach a threshold of acceleration need this share of their best."""
STANDS = Threshold(1.0, "s", 0.5, "own: stands for a second")
STANDS_MPS = 0.1
LATERAL_SPEED = Threshold(1.0, "m/s", 0.3, "own: a lane of 3.5 m in at most 3.5 s")
CUT_IN_GAP = Threshold(CUT_IN_S, "s", 0.4, "own: near [UN157]")
TAILGATING = Threshold(0.8, "s", 0.2, "[ISO15622]")
TAILGATING_FOR_S = 1.0
CONFLICT = Threshold(1.5, "s", 0.5, "[ASC], [TTC]")
CONFLICT_WITHIN_M = 5.0
"""A TTC counts only for those who come this close."""
DRIVES_ON = Threshold(1.4, "m/s", 0.5, "own: at least walking pace where it should stop")
IN_TIME = Threshold(0.0, "s", 0.5, "own: who comes when the other has left endangers nobody")
AHEAD = Threshold(0.0, "m", 2.0, "own: on its side of the other, however far")
PASSES = Threshold(0.0, "m", 2.0, "own: from wholly behind to wholly ahead")
ONCOMING = Threshold(1.0, "s", 0.5, "own: a second over the centre line")
OCCLUDED = Threshold(0.4, "s", 0.2, "[UN157]: as long as a careful driver takes to see a risk")
IN_SIGHT = Threshold(4.0, "s", 1.0, "own: a careful driver [UN157] stops from 70 km/h in as long")
"""Who is seen for longer before the two come nearest was not hidden when it mattered."""
REVERSED = Threshold(1.5, "m", 1.0, "own: clearly seen, a third of a car's length")
NEAR = Threshold(5.0, "m", 2.0, "own: as close as a conflict")
REVERSED_FOR_S = 2.0
"""So long after it has gone back, coming near still counts."""
OBSTACLE = Threshold(2.0, "m", 0.5, "own: passed within 2 m")
LATERAL_ACCELERATION = Threshold(4.0, "m/s2", 0.8, "own: 0.4 g, more than everyday bends ask for")
