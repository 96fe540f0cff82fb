"""Which predicate recognises which danger; every kind of the vocabulary has an entry."""

from scegen.claims.hazards.conflict import BEFORE, DOES_NOT_YIELD, DRIVES_ON, MERGING
from scegen.claims.hazards.driving import (
    DELAYED_BRAKING,
    HARD_BRAKING,
    SLOW_DRIVING,
    SPEEDING,
    STOPPING,
    SUDDEN_ACCELERATION,
)
from scegen.claims.hazards.in_line import TAILGATING
from scegen.claims.hazards.predicate import Predicate
from scegen.claims.hazards.reversing import REVERSING
from scegen.claims.hazards.sideways import (
    CUT_IN,
    LOSS_OF_CONTROL,
    ONCOMING_LANE,
    OVERTAKING,
    SUDDEN_TURN,
    SWERVING,
)
from scegen.claims.hazards.surroundings import OBSTACLE, OCCLUSION
from scegen.scenario.vocabulary import HazardKind

PREDICATES: dict[HazardKind, Predicate] = {
    HazardKind.CROSSING_PEDESTRIAN: BEFORE,
    HazardKind.CROSSING_CYCLIST: BEFORE,
    HazardKind.CROSSING_ANIMAL: BEFORE,
    HazardKind.UNPROTECTED_LEFT_TURN: BEFORE,
    HazardKind.MERGING_CONFLICT: MERGING,
    HazardKind.CUT_IN: CUT_IN,
    HazardKind.RED_LIGHT_RUNNING: DRIVES_ON,
    HazardKind.FAILURE_TO_YIELD: DOES_NOT_YIELD,
    HazardKind.REVERSING: REVERSING,
    HazardKind.OVERTAKING: OVERTAKING,
    HazardKind.TAILGATING: TAILGATING,
    HazardKind.DELAYED_BRAKING: DELAYED_BRAKING,
    HazardKind.HARD_BRAKING: HARD_BRAKING,
    HazardKind.STOPPING: STOPPING,
    HazardKind.OBSTACLE: OBSTACLE,
    HazardKind.ONCOMING_LANE: ONCOMING_LANE,
    HazardKind.SWERVING: SWERVING,
    HazardKind.LOSS_OF_CONTROL: LOSS_OF_CONTROL,
    HazardKind.SUDDEN_TURN: SUDDEN_TURN,
    HazardKind.SUDDEN_ACCELERATION: SUDDEN_ACCELERATION,
    HazardKind.SLOW_DRIVING: SLOW_DRIVING,
    HazardKind.SPEEDING: SPEEDING,
    HazardKind.OCCLUSION: OCCLUSION,
}
"""In the order in which a target looks for its pair: the plainest conflicts first."""
