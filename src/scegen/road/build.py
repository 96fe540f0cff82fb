"""From parameters to a road network."""

from functools import lru_cache

from scegen.road.crossing import build_crossing
from scegen.road.feasibility import check_parameters
from scegen.road.model import RoadNetwork
from scegen.road.roundabout import build_roundabout
from scegen.road.straight import build_straight
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.vocabulary import JunctionKind

KEPT = 16
"""Networks that are kept: every stage asks for the same one, and many scenarios share theirs."""


@lru_cache(maxsize=KEPT)
def build_network(parameters: RoadParameters, name: str = "road") -> RoadNetwork:
    """The road network with these parameters, its centre at the origin.

    The same parameters always give the same network, which nobody changes.

    Raises:
        RoadInfeasibleError: if there is none; the message gives the reason with numbers.
    """
    check_parameters(parameters)
    if parameters.kind is JunctionKind.STRAIGHT and not parameters.u_turns:
        return build_straight(parameters, name)
    if parameters.kind is JunctionKind.ROUNDABOUT:
        return build_roundabout(parameters, name)
    return build_crossing(parameters, name)
