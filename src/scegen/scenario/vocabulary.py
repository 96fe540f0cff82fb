"""The words of the contract: every string that may stand in a scenario file."""

from __future__ import annotations

from enum import StrEnum


class JunctionKind(StrEnum):
    """Shape of the road network; ``straight`` has two arms and no crossing."""

    STRAIGHT = "straight"
    T = "t"
    Y = "y"
    FOUR_WAY = "four_way"
    SKEWED = "skewed"
    MULTI_WAY = "multi_way"
    ROUNDABOUT = "roundabout"


class Control(StrEnum):
    """Who regulates priority at the junction."""

    UNCONTROLLED = "uncontrolled"
    PRIORITY_TO_RIGHT = "priority_to_right"
    YIELD = "yield"
    STOP = "stop"
    ALL_WAY_STOP = "all_way_stop"
    SIGNALS = "signals"


class DrivingSide(StrEnum):
    """The side of the road on which traffic keeps."""

    RIGHT = "right"
    LEFT = "left"


class ParticipantKind(StrEnum):
    """What a traffic participant is."""

    CAR = "car"
    VAN = "van"
    TRUCK = "truck"
    BUS = "bus"
    MOTORCYCLE = "motorcycle"
    BICYCLE = "bicycle"
    PEDESTRIAN = "pedestrian"
    EMERGENCY_VEHICLE = "emergency_vehicle"


class Side(StrEnum):
    """A side: of the road, seen by traffic that enters on that arm; or of who acts or is met."""

    RIGHT = "right"
    LEFT = "left"


class BodySide(StrEnum):
    """A side of a vehicle's body."""

    FRONT = "front"
    REAR = "rear"
    LEFT = "left"
    RIGHT = "right"


class Role(StrEnum):
    """``ego`` is the vehicle under test; there is exactly one."""

    EGO = "ego"
    OTHER = "other"


class Approach(StrEnum):
    """Where a participant comes from, seen from a reference participant (the ego by default)."""

    OPPOSITE = "opposite"
    LEFT = "left"
    RIGHT = "right"
    AHEAD = "ahead"
    BEHIND = "behind"
    ADJACENT = "adjacent"


class Maneuver(StrEnum):
    """What a participant does; ``exit_k`` is the k-th exit of a roundabout in driving direction."""

    STRAIGHT = "straight"
    LEFT = "left"
    RIGHT = "right"
    U_TURN = "u_turn"
    LANE_CHANGE = "lane_change"
    OVERTAKE = "overtake"
    CROSS = "cross"
    STAY = "stay"
    EXIT_1 = "exit_1"
    EXIT_2 = "exit_2"
    EXIT_3 = "exit_3"
    EXIT_4 = "exit_4"
    EXIT_5 = "exit_5"
    EXIT_6 = "exit_6"


class HazardKind(StrEnum):
    """The dangers that can be asked for."""

    SPEEDING = "speeding"
    SUDDEN_ACCELERATION = "sudden_acceleration"
    HARD_BRAKING = "hard_braking"
    DELAYED_BRAKING = "delayed_braking"
    STOPPING = "stopping"
    SLOW_DRIVING = "slow_driving"
    CUT_IN = "cut_in"
    SWERVING = "swerving"
    TAILGATING = "tailgating"
    MERGING_CONFLICT = "merging_conflict"
    OVERTAKING = "overtaking"
    ONCOMING_LANE = "oncoming_lane"
    UNPROTECTED_LEFT_TURN = "unprotected_left_turn"
    CROSSING_PEDESTRIAN = "crossing_pedestrian"
    CROSSING_CYCLIST = "crossing_cyclist"
    OCCLUSION = "occlusion"
    OBSTACLE = "obstacle"
    RED_LIGHT_RUNNING = "red_light_running"
    FAILURE_TO_YIELD = "failure_to_yield"
    REVERSING = "reversing"
    SUDDEN_TURN = "sudden_turn"
    LOSS_OF_CONTROL = "loss_of_control"


FROM_BESIDE = frozenset({HazardKind.MERGING_CONFLICT, HazardKind.FAILURE_TO_YIELD})
"""On a road without a junction, these come from the lane beside, as a cut-in does."""


class Weather(StrEnum):
    """Sky and precipitation."""

    CLEAR = "clear"
    CLOUDY = "cloudy"
    RAIN = "rain"
    HEAVY_RAIN = "heavy_rain"
    SNOW = "snow"
    FOG = "fog"


class TimeOfDay(StrEnum):
    """Light conditions by the position of the sun."""

    DAY = "day"
    DAWN = "dawn"
    DUSK = "dusk"
    NIGHT = "night"


class RoadSurface(StrEnum):
    """Condition of the road surface."""

    DRY = "dry"
    WET = "wet"
    ICY = "icy"
    SNOWY = "snowy"


class Visibility(StrEnum):
    """How far one sees."""

    GOOD = "good"
    REDUCED = "reduced"
    POOR = "poor"


class EvidenceSource(StrEnum):
    """What a field rests on: the words, a conclusion from them, or a default."""

    STATED = "stated"
    INFERRED = "inferred"
    DEFAULT = "default"


class Reduction(StrEnum):
    """Which assignments count as one scenario."""

    NONE = "none"
    PATTERN = "pattern"
    EXACT = "exact"


class ArmsMode(StrEnum):
    """Whether the arms of a junction count alike (the source paper's view) or as built."""

    EQUAL = "equal"
    DISTINCT = "distinct"
