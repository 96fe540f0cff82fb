"""The words of the contract: every string that may stand in a scenario file."""

from __future__ import annotations

from enum import StrEnum

from scegen.scenario.definitions import Word


class JunctionKind(Word):
    """Shape of the road network; ``straight`` has two arms and no crossing."""

    STRAIGHT = (
        "straight",
        "one road without a crossing; its two directions are two arms",
        "a junction that is driven straight through",
        "on a country road; on the motorway",
    )
    T = (
        "t",
        "a road ends at another that goes straight through",
        "`y`, where no way goes straight on; a driveway that nobody uses",
        "a T-junction; a side road joins; a three-way intersection",
    )
    Y = (
        "y",
        "three roads meet at wide angles, so that none goes straight on",
        "`t`, unless the text says fork or Y",
        "a fork; a Y-intersection",
    )
    FOUR_WAY = (
        "four_way",
        "two roads cross at right angles",
        "`skewed`, if the angles are said to be others",
        "a crossroads; an intersection without further words",
    )
    SKEWED = (
        "skewed",
        "four roads meet at other than right angles",
        "`multi_way`, which has five arms or more",
        "a skewed intersection",
    )
    MULTI_WAY = (
        "multi_way",
        "five roads or more meet",
        "`roundabout`, where traffic goes round an island",
        "a five-way intersection",
    )
    ROUNDABOUT = (
        "roundabout",
        "traffic goes round an island in one direction",
        "`multi_way`, which is crossed",
        "a roundabout with four exits",
    )


class Control(Word):
    """Who regulates priority at the junction."""

    UNCONTROLLED = (
        "uncontrolled",
        "nothing is said about signs, lights or priority",
        "`priority_to_right`, unless the text says that rule",
        "an uncontrolled intersection",
    )
    PRIORITY_TO_RIGHT = (
        "priority_to_right",
        "who comes from the right goes first",
        "who merely comes from the right",
        "right before left applies",
    )
    YIELD = (
        "yield",
        "the road that ends, is minor or has no priority as is said gives way, with a sign",
        "`stop`; somebody who just lets another go",
        "a give-way junction",
    )
    STOP = (
        "stop",
        "the road that ends or is said to be minor has a stop sign",
        "`all_way_stop`, where every road has one",
        "at the stop line of a side road",
    )
    ALL_WAY_STOP = (
        "all_way_stop",
        "every road has a stop sign",
        "`stop`, where only the minor road has one",
        "a four-way stop",
    )
    SIGNALS = (
        "signals",
        "traffic lights regulate the junction",
        "lights of a vehicle; `signals_off`, where they do not work",
        "somebody runs a red light; at the lights",
    )
    SIGNALS_OFF = (
        "signals_off",
        "traffic lights stand there that are switched off, out of order or flash amber: priority "
        "is as without them",
        "`signals`, which work; `uncontrolled`, where there are none; `stop` or `yield`, if the "
        "text says that signs hold instead",
        "the traffic lights are out of order",
    )


class DrivingSide(Word):
    """The side of the road on which traffic keeps."""

    RIGHT = "right", "traffic keeps to the right", "", "Germany, USA; not said"
    LEFT = "left", "traffic keeps to the left", "", "in the UK; in Japan"


class ParticipantKind(Word):
    """What a traffic participant is."""

    CAR = (
        "car",
        "a passenger car, and any vehicle of which no more is said",
        "`van`, `truck`",
        "a vehicle; a taxi; a test target (GVT)",
    )
    VAN = "van", "a light goods vehicle, or one of its size", "`truck`", "a delivery van; a camper"
    TRUCK = (
        "truck",
        "a heavy goods vehicle, also an agricultural one",
        "`van`",
        "a lorry; a tow truck; a pickup; a tractor",
    )
    BUS = "bus", "a bus or coach of any size", "`van`", "a school bus; a minibus"
    MOTORCYCLE = (
        "motorcycle",
        "a motorcycle, scooter, quad or trike with its rider",
        "`bicycle`",
        "a motorcyclist",
    )
    BICYCLE = (
        "bicycle",
        "a bicycle with its rider, who drives in the lanes or crosses",
        "`pedestrian`, for one who pushes it",
        "a cyclist",
    )
    PEDESTRIAN = (
        "pedestrian",
        "somebody on foot, also on skates or a toy scooter",
        "people inside vehicles",
        "a child; a jogger",
    )
    ANIMAL = (
        "animal",
        "an animal up to the size of a big dog",
        "`large_animal`; an animal that somebody leads or carries",
        "a dog; a fox",
    )
    LARGE_ANIMAL = (
        "large_animal",
        "an animal of the size of a deer or bigger",
        "`animal`",
        "a deer; a wild boar; a cow",
    )
    EMERGENCY_VEHICLE = (
        "emergency_vehicle",
        "a vehicle of police, fire or rescue service",
        "`car`, `truck`",
        "an ambulance",
    )
    DOOR = (
        "door",
        "a door of a parked vehicle, which the act `open_door` makes: in concrete scenarios only",
        "a participant of a description",
    )


ANIMALS = frozenset({ParticipantKind.ANIMAL, ParticipantKind.LARGE_ANIMAL})
DESCRIBED = tuple(kind for kind in ParticipantKind if kind is not ParticipantKind.DOOR)
"""Kinds that a description may have."""
ON_FOOT = ANIMALS | {ParticipantKind.PEDESTRIAN}
"""Kinds that walk or run, and drive nothing."""


class Side(Word):
    """A side: of the road, seen by traffic that enters on that arm; or of who acts or is met."""

    RIGHT = (
        "right",
        "to the right, seen by who is spoken of",
        "`Approach.right`, where one comes from",
        "on its right",
    )
    LEFT = (
        "left",
        "to the left, seen by who is spoken of",
        "`Approach.left`, where one comes from",
        "on its left",
    )

    @property
    def opposite(self) -> Side:
        """The other one."""
        return Side.LEFT if self is Side.RIGHT else Side.RIGHT


class CrossedArm(Word):
    """Which arm one crosses, by the way of the one whom it meets (the ego, if nobody is named)."""

    ENTRY = (
        "entry",
        "the arm by which the one whom it meets comes to the junction",
        "`exit`; a number of an arm (`entries`)",
        "crosses the road that the ego comes from, before it turns",
    )
    EXIT = (
        "exit",
        "the arm by which the one whom it meets leaves the junction",
        "`entry`; a number of an arm (`entries`)",
        "crosses the road into which the ego turns",
    )


class Role(Word):
    """``ego`` is the vehicle under test; there is exactly one."""

    EGO = (
        "ego",
        "the vehicle under test; there is exactly one",
        "",
        "the ego vehicle; the subject vehicle",
    )
    OTHER = "other", "everybody else", "", "the adversary; the lead car"


class Approach(Word):
    """Where a participant comes from, seen from a reference participant (the ego by default)."""

    OPPOSITE = (
        "opposite",
        "comes towards the reference: on its road, or from the arm that lies opposite",
        "`ahead`, which goes the same way",
        "oncoming",
    )
    LEFT = (
        "left",
        "comes from the reference's left, by another arm or over the kerb",
        "turning left (a maneuver); with `adjacent`, the lane beside",
        "a car from the left",
    )
    RIGHT = (
        "right",
        "comes from the reference's right, by another arm or over the kerb",
        "turning right (a maneuver); with `adjacent`, the lane beside",
        "a child from the right",
    )
    AHEAD = (
        "ahead",
        "on the reference's arm and in its direction, before it",
        "`opposite`, which faces it",
        "the lead vehicle",
    )
    BEHIND = (
        "behind",
        "on the reference's arm and in its direction, after it",
        "`adjacent`, in another lane",
        "a following car",
    )
    ADJACENT = (
        "adjacent",
        "in a lane beside the reference's, same way, level or not; with `left` or `right`: there; "
        "with `ahead` or `behind`: not level but there",
        "`left`, `right` alone, which are other roads",
        "the car in the next lane",
    )


def _exit(number: int, which: str) -> tuple[str, str, str, str]:
    told = f"leaves the roundabout by the {which} exit that it reaches"
    return f"exit_{number}", told, "", f"takes the {which} exit"


class Maneuver(Word):
    """What a participant does; ``exit_k`` is the k-th exit of a roundabout in driving direction."""

    STRAIGHT = (
        "straight",
        "goes on through the junction or along the road, past others who are in another lane; "
        "on foot: walks along it",
        "what the text leaves open",
        "goes straight through",
    )
    LEFT = (
        "left",
        "turns left at the junction",
        "`lane_change` to the left; coming from the left (an approach)",
        "turns off to the left",
    )
    RIGHT = (
        "right",
        "turns right at the junction",
        "`lane_change` to the right; coming from the right (an approach)",
        "takes the right-hand branch",
    )
    U_TURN = "u_turn", "turns back the way that it came", "`left`", "makes a U-turn"
    LANE_CHANGE = (
        "lane_change",
        "goes over to another lane, to stay there or until it hits somebody; cuts out",
        "`overtake`, which ends before somebody; one broken off (`straight`); a forced reaction",
        "merges into the ego's lane",
    )
    OVERTAKE = (
        "overtake",
        "passes somebody that moves, at the edge too, or bypasses one that stands in its lane",
        "`lane_change` without getting past",
        "overtakes the truck",
    )
    MERGE = (
        "merge",
        "comes by the ramp, or in the lane that ends, and leaves that",
        "`lane_change` between lanes that go on",
        "merges from the on-ramp",
    )
    EXIT = (
        "exit",
        "leaves the road by a ramp",
        "`exit_1` of a roundabout; `right` at a junction",
        "takes the motorway exit",
    )
    CROSS = (
        "cross",
        "goes over a road from its edge or out of a side road, on foot or by bicycle",
        "`straight`, for vehicles through a junction",
        "crosses the street",
    )
    STAY = (
        "stay",
        "stands all the time",
        "one that stops or sets off (an act); who waits at its light to go on (`light`)",
        "a stationary car; somebody who waits and does not go on",
    )
    EXIT_1 = _exit(1, "first")
    EXIT_2 = _exit(2, "second")
    EXIT_3 = _exit(3, "third")
    EXIT_4 = _exit(4, "fourth")
    EXIT_5 = _exit(5, "fifth")
    EXIT_6 = _exit(6, "sixth")


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
    CROSSING_ANIMAL = "crossing_animal"
    OCCLUSION = "occlusion"
    OBSTACLE = "obstacle"
    RED_LIGHT_RUNNING = "red_light_running"
    FAILURE_TO_YIELD = "failure_to_yield"
    REVERSING = "reversing"
    SUDDEN_TURN = "sudden_turn"
    LOSS_OF_CONTROL = "loss_of_control"


class Reduction(Word):
    """Which assignments count as one scenario."""

    NONE = "none", "every assignment counts"
    PATTERN = "pattern", "one scenario for each multiset of symbolic moves, as in the source paper"
    EXACT = (
        "exact",
        "one scenario for all that rotating the junction and swapping equal vehicles make alike",
    )


class ArmsMode(Word):
    """Whether the arms of a junction count alike (the source paper's view) or as built."""

    EQUAL = "equal", "every arm counts alike"
    DISTINCT = "distinct", "arms count alike only where geometry, lanes and control are"
