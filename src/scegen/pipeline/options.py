"""What ``generate`` may be told."""

from dataclasses import dataclass
from enum import StrEnum

from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Reduction


class OscVersion(StrEnum):
    """Versions of OpenSCENARIO that can be written."""

    V1_0 = "1.0"
    V1_2 = "1.2"


class EgoMode(StrEnum):
    """Who drives the ego: the scenario file, or the user's own stack."""

    SCRIPTED = "scripted"
    EXTERNAL = "external"


class CheckDepth(StrEnum):
    """How deep to check: not at all, all but the ASAM checkers (the slowest), everything."""

    NONE = "none"
    QUICK = "quick"
    FULL = "full"


@dataclass(frozen=True, slots=True)
class Options:
    """Options of one run.

    ``pick`` names logical scenarios (see :mod:`scegen.pipeline.picking`), and all that it names
    are made; without it, the ``count`` richest are. ``target`` is what the search is to
    reach, ``none`` for no search; None stands for a near-miss, and for no search where concrete
    numbers are given; ``solutions`` how many different ways to reach it are looked for in each
    logical scenario. ``where`` and ``rules`` narrow the list of logical scenarios.
    """

    pick: str | None = None
    count: int = 1
    seed: int = 0
    reduction: Reduction = Reduction.EXACT
    arms: ArmsMode = ArmsMode.DISTINCT
    osc: OscVersion = OscVersion.V1_0
    depth: CheckDepth = CheckDepth.QUICK
    force: bool = False
    ego: EgoMode = EgoMode.SCRIPTED
    target: str | None = None
    solutions: int = 1
    where: str | None = None
    rules: RuleFile | None = None
