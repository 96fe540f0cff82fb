"""Driving backwards, in numbers: what a drive has if its vehicle reverses somewhere on it.

The body always heads the way of the drive; on the part driven backwards it moves the other way.
Before and after that part it drives forwards as any other.
"""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from scegen.scenario.model import CheckedModel, FrozenModel
from scegen.scenario.vocabulary import Side

MOST_BACK_M = 100.0
"""Nobody backs up for longer."""


class BacksUp(FrozenModel):
    """Stops at ``from_m`` along the drive, goes ``length_m`` back on its own way, drives on."""

    type: Literal["backs_up"] = "backs_up"
    from_m: float = Field(gt=0)
    length_m: float = Field(gt=0, le=MOST_BACK_M)


class BacksOut(CheckedModel):
    """Starts beside the road or on a side arm and comes out backwards, rear first.

    It has come out where the drive starts (``start_m``), and drives on from there. It begins
    ``setback_m`` (rear axle) beyond the edge of the carriageway on ``side``, seen by entering
    traffic, at right angles to the road; or, with ``arm``, that far from the inner end of that
    arm, in the lane that leads away from the junction. Beside a road it comes out in a quarter
    turn of ``radius_m``. With ``straight_m`` it only goes straight back, so far, and stays there.
    """

    type: Literal["backs_out"] = "backs_out"
    side: Side | None = None
    arm: int | None = Field(default=None, ge=0)
    setback_m: float = Field(gt=0, le=50)
    radius_m: float = Field(default=5.0, ge=2.0, le=50)
    straight_m: float | None = Field(default=None, gt=0, le=MOST_BACK_M)

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if (self.side is None) == (self.arm is None):
            yield "one that backs out does so from a side of its road, or from an arm"


Reversal = Annotated[BacksUp | BacksOut, Field(discriminator="type")]
