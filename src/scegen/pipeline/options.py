"""What ``generate`` may be told."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from scegen.scenario.vocabulary import ArmsMode, Reduction


class OscVersion(StrEnum):
    """Versions of OpenSCENARIO that can be written."""

    V1_0 = "1.0"
    V1_2 = "1.2"


class CheckDepth(StrEnum):
    """How deep to check: not at all, all but the ASAM checkers (the slowest), everything."""

    NONE = "none"
    QUICK = "quick"
    FULL = "full"


@dataclass(frozen=True, slots=True)
class Options:
    """Options of one run.

    ``pick`` names logical scenarios (see :mod:`scegen.pipeline.picking`), and all that it names
    are made; without it, the ``count`` richest are.
    """

    pick: str | None = None
    count: int = 1
    seed: int = 0
    reduction: Reduction = Reduction.EXACT
    arms: ArmsMode = ArmsMode.DISTINCT
    osc: OscVersion = OscVersion.V1_0
    depth: CheckDepth = CheckDepth.QUICK
    force: bool = False
