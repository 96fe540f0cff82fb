"""Motion = path x speed program: paths on the road, the simulators."""

from scegen.motion.paths import build_paths
from scegen.motion.simulation import simulate

__all__ = ["build_paths", "simulate"]
