"""The outcome that a description tells of: a contact, a near miss, or neither."""

from pydantic import Field

from scegen.scenario.definitions import Word
from scegen.scenario.model import FrozenModel, Identifier, Interval


class BodySide(Word):
    """A side of a vehicle's body."""

    FRONT = "front", "the front of the body", "", "hit head-on"
    REAR = "rear", "the rear of the body", "", "hit from behind"
    LEFT = (
        "left",
        "the left side of the body",
        "the left half of its front",
        "struck in the driver's side",
    )
    RIGHT = (
        "right",
        "the right side of the body",
        "the right half of its front",
        "struck from the right",
    )


class OutcomeKind(Word):
    """How it ends."""

    NEAR_MISS = (
        "near_miss",
        "they nearly touch and do not, or by a margin that is said",
        "`avoided`, where nothing is said about how close",
        "narrowly misses; a near-collision",
    )
    COLLISION = (
        "collision",
        "they touch",
        "`near_miss`; a danger or risk of collision",
        "hits; is struck; an impact point that a test sets",
    )
    AVOIDED = (
        "avoided",
        "nobody touches anybody",
        "`near_miss`, if it is said to be close; an attempt to avoid, whose end is open",
        "there is no contact",
    )


class Outcome(FrozenModel):
    """What becomes of it, between whom (two ids; empty if not said).

    ``impact_percent`` is where the other's centre meets the ego's width: 0 at the ego's left side,
    100 at its right. ``struck`` is the side of the ego's body that is touched first.
    """

    kind: OutcomeKind
    between: tuple[Identifier, ...] = Field(default=(), max_length=2)
    impact_percent: Interval | None = None
    struck: BodySide | None = None
