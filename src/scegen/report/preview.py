"""A picture of one concrete scenario: real roads, real boxes, the moment that matters."""

from __future__ import annotations

from collections.abc import Mapping

from scegen.motion.model import Path, Trace
from scegen.motion.simulation import simulate
from scegen.report.encounter import closest_encounter
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario


def preview_png(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    paths: Mapping[str, Path],
    traces: Mapping[str, Trace] | None = None,
) -> bytes:
    """The scenario as a PNG; the same input gives the same bytes.

    Args:
        concrete: the scenario.
        network: its roads.
        paths: the paths of its participants.
        traces: their movement, simulated here if not given.
    """
    # Here and not above: matplotlib takes longer to load than to draw, and few commands draw.
    from scegen.report.drawing import draw_scenario  # noqa: PLC0415

    traces = traces or simulate(concrete, paths)
    return draw_scenario(concrete, network, paths, traces, closest_encounter(concrete, traces))
