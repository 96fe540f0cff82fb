"""Road networks: junction templates to geometry and topology, no file format."""

from scegen.road.build import build_network
from scegen.road.defaults import plan_road

__all__ = ["build_network", "plan_road"]
