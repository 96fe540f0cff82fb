"""Spacings: how far apart two participants are, in the measure that the text uses."""

from collections.abc import Iterator
from typing import Literal

from pydantic import Field, model_validator

from scegen.scenario.definitions import Word
from scegen.scenario.model import CheckedModel, Identifier, Interval
from scegen.scenario.vocabulary import Side

START, CONTACT = "start", "contact"
"""The moments of a spacing that are no act."""


class Measure(Word):
    """How a spacing is measured.

    ``gap_m``: free length between the bumpers along the road. ``headway_s``: that gap by the speed
    of who follows. ``ttc_s``: that gap by the difference of speeds. ``lateral_gap_m``: free width
    between the sides. ``lateral_offset_m``: of the participant's centre from the reference's line,
    positive to the reference's left; of one to itself, from the middle of its lane.
    ``overlap_percent``: the share of the reference's width that the participant's covers.
    """

    GAP_M = (
        "gap_m",
        "free length between the bumpers along the road, m; to who crosses, up to its place",
        "`lateral_gap_m`, beside",
        "20 m behind; when it is 12 m away",
    )
    HEADWAY_S = (
        "headway_s",
        "that gap by the speed of who follows, s",
        "`ttc_s`",
        "a time gap of 1.2 s; two seconds behind",
    )
    TTC_S = (
        "ttc_s",
        "that gap by the difference of speeds, s",
        "`headway_s`",
        "a time to collision of 4 s; is 3 s away; 2 s before contact",
    )
    LATERAL_GAP_M = (
        "lateral_gap_m",
        "free width between the sides as one passes the other, m",
        "`lateral_offset_m`, between the centres",
        "passes with 1 m to spare",
    )
    LATERAL_OFFSET_M = (
        "lateral_offset_m",
        "offset of its centre from the reference's line, m, positive to its left; of one to "
        "itself, from the middle of its lane",
        "`lateral_gap_m`",
        "0.5 m left of the ego's line; 0.3 m off its lane centre (reference: itself)",
    )
    OVERLAP_PERCENT = (
        "overlap_percent",
        "share of the reference's width that the participant's covers",
        "the impact point (`outcome.impact_percent`)",
        "with 50 % overlap",
    )


LENGTHWISE = frozenset({Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S})
"""Measures along the road."""


class Spacing(CheckedModel):
    """The ``measure`` of ``participant`` to ``reference`` is ``value``.

    ``at`` says when: ``start``, ``contact``, or the id of an act: ``since`` its begin, or its end
    ("is 10 m ahead when it has changed lanes"). Who stops by it has come to rest then, the other
    too if that one stops ("stops 3 m behind the truck"). Where an overlap is said to be on a
    ``side``, it is that side of the reference's width. Only a lateral offset may be one to itself:
    from the middle of its lane.
    """

    participant: Identifier
    reference: Identifier
    measure: Measure
    value: Interval
    at: str = Field(default=START, pattern=r"^[a-z][a-z0-9_]*$")
    since: Literal["begin", "end"] = "begin"
    side: Side | None = None

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        alone = self.participant == self.reference
        if alone and self.measure is not Measure.LATERAL_OFFSET_M:
            yield f"{self.participant} has a {self.measure} to itself; name another as reference"
        if self.since == "end" and self.at in {START, CONTACT}:
            yield f"`since: end` is of an act; `at` names none but {self.at!r}"

    @model_validator(mode="before")
    @classmethod
    def _as_it_was_written(cls, data: object) -> object:
        """Files of before say ``at_rest``."""
        if isinstance(data, dict) and "at_rest" in data:
            rest = {k: v for k, v in data.items() if k != "at_rest"}
            return rest | ({"since": "end"} if data["at_rest"] else {})
        return data
