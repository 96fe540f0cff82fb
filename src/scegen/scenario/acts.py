"""Acts: what participants do, in the order of the text, by how much, and what sets it off."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Literal

from pydantic import Field

from scegen.scenario.model import FrozenModel, Identifier, Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Side


class ActKind(StrEnum):
    """What somebody does at some moment, beside driving its way."""

    BRAKE = "brake"
    ACCELERATE = "accelerate"
    STOP = "stop"
    SET_OFF = "set_off"
    CHANGE_LANE = "change_lane"
    SWERVE = "swerve"
    TURN = "turn"
    CROSS = "cross"
    REVERSE = "reverse"
    OVERTAKE = "overtake"


class AfterStart(FrozenModel):
    """So long after the start of the scenario."""

    type: Literal["start"] = "start"
    delay_s: Interval = Interval(low=0.0, high=0.0)


class AfterAct(FrozenModel):
    """So long after another act has begun, or has ended."""

    type: Literal["after"] = "after"
    act: Identifier
    since: Literal["begin", "end"] = "end"
    delay_s: Interval = Interval(low=0.0, high=0.0)


class WhenMeasure(FrozenModel):
    """As soon as a measure of ``participant`` to ``reference`` has come down to a value."""

    type: Literal["measure"] = "measure"
    measure: Measure
    participant: Identifier
    reference: Identifier
    value: Interval


class BeforeJunction(FrozenModel):
    """So far before the junction: the front of who acts from the end of its arm."""

    type: Literal["before_junction"] = "before_junction"
    distance_m: Interval


When = Annotated[AfterStart | AfterAct | WhenMeasure | BeforeJunction, Field(discriminator="type")]


class Act(FrozenModel):
    """Something that ``participant`` does; amounts are None where the text gives none.

    ``target_speed_mps`` is the speed that it ends at, ``rate_mps2`` how fast its speed changes
    on the way (a magnitude: the kind says which way), ``duration_s`` how long the act takes,
    ``distance_m`` how far it goes on doing it. ``side`` is its own left or right, ``into`` names
    whose lane it comes into; ``lateral_m`` how far it goes sideways, ``lateral_mps`` its greatest
    speed sideways. ``when`` is None where the text does not say what sets it off.
    """

    id: Identifier
    participant: Identifier
    kind: ActKind
    target_speed_mps: Interval | None = None
    rate_mps2: Interval | None = None
    duration_s: Interval | None = None
    distance_m: Interval | None = None
    side: Side | None = None
    into: Identifier | None = None
    lateral_m: Interval | None = None
    lateral_mps: Interval | None = None
    when: When | None = None
