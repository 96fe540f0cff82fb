"""Spacings: how far apart two participants are, in the measure that the text uses."""

from __future__ import annotations

from enum import StrEnum

from pydantic import Field

from scegen.scenario.model import FrozenModel, Identifier, Interval
from scegen.scenario.vocabulary import Side

START, CONTACT = "start", "contact"
"""The moments of a spacing that are no act."""


class Measure(StrEnum):
    """How a spacing is measured.

    ``gap_m``: free length between the bumpers along the road. ``headway_s``: that gap by the speed
    of who follows. ``ttc_s``: that gap by the difference of speeds. ``lateral_gap_m``: free width
    between the sides. ``lateral_offset_m``: of the participant's centre from the reference's line,
    positive to the reference's left. ``overlap_percent``: the share of the reference's width that
    the participant's covers.
    """

    GAP_M = "gap_m"
    HEADWAY_S = "headway_s"
    TTC_S = "ttc_s"
    LATERAL_GAP_M = "lateral_gap_m"
    LATERAL_OFFSET_M = "lateral_offset_m"
    OVERLAP_PERCENT = "overlap_percent"


class Spacing(FrozenModel):
    """The ``measure`` of ``participant`` to ``reference`` is ``value``.

    ``at`` says when: ``start``, ``contact``, or the id of an act (when it begins). Where an
    overlap is said to be on a ``side``, it is that side of the reference's width.
    """

    participant: Identifier
    reference: Identifier
    measure: Measure
    value: Interval
    at: str = Field(default=START, pattern=r"^[a-z][a-z0-9_]*$")
    side: Side | None = None
