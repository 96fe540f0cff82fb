"""Acts: what participants do, in the order of the text, by how much, and what sets it off."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from scegen.scenario.definitions import Word
from scegen.scenario.model import CheckedModel, FrozenModel, Identifier, Interval, Magnitude
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Side


class ActKind(Word):
    """What somebody does at some moment, beside driving its way."""

    BRAKE = (
        "brake",
        "slows down, to a speed that may be given; so does who reacts, if no more is said",
        "`stop`, which ends at rest",
        "brakes with 6 m/s2 to 20 km/h",
    )
    ACCELERATE = "accelerate", "gains speed", "`set_off`, from rest", "accelerates to 80 km/h"
    STOP = (
        "stop",
        "comes to rest and stays there",
        "`brake`, which ends in motion; standing all the time (maneuver `stay`)",
        "brakes with 4 m/s2 to a standstill",
    )
    WAIT = (
        "wait",
        "comes to rest, stands for a time, and goes on",
        "`stop`, after which it stays at rest; a delay, which lies between two acts",
        "waits 6 s at the stop line; stands there for 20 s",
    )
    GIVE_WAY = (
        "give_way",
        "lets another go first, slowing down or standing for as long as that takes",
        "`wait`, which lasts a time that is said; failing to (hazard `failure_to_yield`)",
        "gives way to the pedestrian; lets the oncoming car pass; waits for the bus",
    )
    SET_OFF = (
        "set_off",
        "begins to move from rest, up to a speed that may be given",
        "`accelerate`, for one who moves already",
        "pulls away with 2 m/s2 to 30 km/h",
    )
    CHANGE_LANE = (
        "change_lane",
        "goes over into the lane beside",
        "`swerve`, which leaves no lane for good; `turn`",
        "changes to the left lane; cuts in; merges",
    )
    SWERVE = (
        "swerve",
        "moves sideways, fast or slowly, and does not end in another lane",
        "`change_lane`, which does",
        "drifts 0.6 m to the left",
    )
    TURN = (
        "turn",
        "begins to turn at the junction, or back",
        "`change_lane`",
        "turns left as soon as the ego is near",
    )
    ENTER = (
        "enter",
        "comes into the junction or the roundabout, whatever way it takes there",
        "`turn`, which begins a change of direction; `cross`, over a road from its edge",
        "a van enters from the right 2 s after the ego",
    )
    CROSS = (
        "cross",
        "begins to go over the road, from its edge",
        "a vehicle through a junction (maneuver `straight`)",
        "steps off the kerb when the ego is 30 m away",
    )
    REVERSE = "reverse", "begins to drive backwards", "a U-turn (`turn`)", "backs up"
    OPEN_DOOR = (
        "open_door",
        "a parked vehicle opens a door on the side of the traffic",
        "a door that is open from the start: an object in the way",
        "opens its door when the cyclist is 10 m away",
    )
    OVERTAKE = (
        "overtake",
        "begins to pass somebody in front of it",
        "`change_lane` without getting past",
        "pulls out to overtake the truck",
    )


ENTERING = frozenset({ActKind.TURN, ActKind.ENTER})
"""How one comes to drive where another road's traffic does."""
LETS_BY = frozenset({ActKind.GIVE_WAY, ActKind.WAIT})
"""What one does for another that goes first, where one is named."""
LASTING = frozenset(ActKind) - {
    ActKind.GIVE_WAY,
    ActKind.OVERTAKE,
    ActKind.TURN,
    ActKind.ENTER,
    ActKind.REVERSE,
}
"""What may take as long as is said; the others follow from ways and speeds."""
SLOWING = frozenset({ActKind.BRAKE, ActKind.STOP})
GAINING = frozenset({ActKind.ACCELERATE, ActKind.SET_OFF})
"""Acts by which somebody becomes slower, or faster."""
RESTING = frozenset({ActKind.STOP, ActKind.WAIT})
"""Acts by which somebody comes to stand, for good or for a while."""
LEAVING = frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE, ActKind.OVERTAKE})
"""Acts by which somebody leaves its lane."""
FAR = SLOWING | GAINING | {ActKind.REVERSE, ActKind.CROSS}
"""What may go on for as far as is said; who crosses then stops there, before the far kerb."""


class _Moment(FrozenModel):
    """What sets an act off; its type is always written, though it never is another."""

    @model_serializer(mode="wrap")
    def _with_its_type(self, written: SerializerFunctionWrapHandler) -> dict[str, Any]:
        return {"type": type(self).model_fields["type"].default, **written(self)}


class AfterStart(_Moment):
    """So long after the start of the scenario."""

    type: Literal["start"] = "start"
    delay_s: Magnitude = Interval(low=0.0, high=0.0)


class AfterAct(_Moment):
    """So long after another act has begun, or has ended; at once is 0, None is some time later."""

    type: Literal["after"] = "after"
    act: Identifier
    since: Literal["begin", "end"] = "end"
    delay_s: Magnitude | None = None

    @property
    def later_s(self) -> Interval:
        """The delay that is said, else none: it may follow as soon as is natural."""
        return self.delay_s or Interval(low=0.0, high=0.0)


class WhenMeasure(_Moment):
    """As soon as a measure of ``participant`` to ``reference`` has come down to a value.

    The reference may be an object: "40 m before the crate".
    """

    type: Literal["measure"] = "measure"
    measure: Measure
    participant: Identifier
    reference: Identifier
    value: Interval


class AfterDistance(_Moment):
    """As soon as ``participant``, who acts if None, has gone so far since the start."""

    type: Literal["driven"] = "driven"
    participant: Identifier | None = None
    distance_m: Magnitude


class BeforeJunction(_Moment):
    """So far before the junction: the front of ``participant``, who acts if None, from there."""

    type: Literal["before_junction"] = "before_junction"
    participant: Identifier | None = None
    distance_m: Magnitude


When = Annotated[
    AfterStart | AfterAct | WhenMeasure | AfterDistance | BeforeJunction,
    Field(discriminator="type"),
]


class Act(CheckedModel):
    """Something that ``participant`` does; amounts are None where the text gives none.

    ``target_speed_mps`` is the speed that it ends at, ``rate_mps2`` how fast its speed changes
    on the way (a magnitude: the kind says which way), ``duration_s`` how long the act takes, of one
    who waits how long it stands, of one who crosses from kerb to kerb, of one who swerves until it
    is as far aside as it goes. ``distance_m`` is how far it goes on doing it, of one who crosses
    how far from the kerb it stops. ``side`` is its own left or right, ``into`` names whose lane it
    comes into, of one who overtakes whom, of one who waits or gives way for whom; ``lateral_m`` how
    far it goes sideways, ``lateral_mps`` its greatest speed sideways. ``when`` is None where the
    text does not say what sets it off.
    """

    id: Identifier
    participant: Identifier
    kind: ActKind
    target_speed_mps: Magnitude | None = None
    rate_mps2: Magnitude | None = None
    duration_s: Magnitude | None = None
    distance_m: Magnitude | None = None
    side: Side | None = None
    into: Identifier | None = None
    lateral_m: Magnitude | None = None
    lateral_mps: Magnitude | None = None
    when: When | None = None

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        does = self.kind.replace("_", " ")
        if self.duration_s is not None and self.kind not in LASTING:
            msg = f"acts.{self.id}: how long it takes to {does} follows from ways and speeds; "
            yield f"{msg}leave duration_s out"
        if self.distance_m is not None and self.kind not in FAR:
            msg = f"acts.{self.id}: how far one goes to {does} is not made; "
            yield f"{msg}leave distance_m out"
