"""Pictures of scenarios for the page, from the drawing layer of the reports.

Their colours are the theme's custom properties, so that the page's variant is theirs too.
"""

from dataclasses import fields
from typing import Any

from scegen.report.theme import LIGHT, Theme
from scegen.report.tile import TILE_WIDTH, describe, roads, tile_body, tile_svg
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario

_COLOURS: dict[str, Any] = {f.name: f"var(--{f.name.replace('_', '-')})" for f in fields(Theme)}
_PEOPLE = tuple(f"var(--participant-{number + 1})" for number in range(len(LIGHT.participants)))
PAGE = Theme(**{**_COLOURS, "name": "page", "participants": _PEOPLE})
"""A theme whose every colour is the custom property of its name."""


def tile_picture(scenario: LogicalScenario, functional: FunctionalScenario) -> str:
    """A logical scenario as a picture."""
    return tile_svg(scenario, functional, tile_body(scenario, functional, theme=PAGE))


def tile(scenario: LogicalScenario, functional: FunctionalScenario) -> dict[str, Any]:
    """A logical scenario as a picture, with its number and what it shows in words."""
    return {
        "index": scenario.index,
        "name": describe(scenario),
        "svg": tile_picture(scenario, functional),
    }


def junction(functional: FunctionalScenario) -> str:
    """The roads alone, where there is no scenario to show on them."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {TILE_WIDTH} {TILE_WIDTH}" '
        f'role="img" aria-label="Plan of the roads">{roads(functional, PAGE)}</svg>'
    )
