"""Pictures of scenarios for the page, from the drawing layer of the reports."""

from __future__ import annotations

from typing import Any

from scegen.report.tile import TILE_WIDTH, describe, tile_height, tile_svg
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario


def tile(scenario: LogicalScenario, functional: FunctionalScenario) -> dict[str, Any]:
    """A logical scenario as a picture, with its number and what it shows in words."""
    return {
        "index": scenario.index,
        "name": describe(scenario),
        "svg": tile_svg(scenario, functional),
    }


def tile_ratio(functional: FunctionalScenario) -> float:
    """Height of a tile by its width."""
    return tile_height(functional) / TILE_WIDTH
