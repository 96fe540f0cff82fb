"""Motion = path x speed program: paths on the road, the simulator."""

from scegen.motion.batch import simulate
from scegen.motion.paths import build_paths

__all__ = ["build_paths", "simulate"]
