"""Motion = path x speed program: paths on the road, a reference simulator, concretization."""

from scegen.motion.concretization import concretize
from scegen.motion.paths import build_paths
from scegen.motion.simulation import simulate

__all__ = ["build_paths", "concretize", "simulate"]
