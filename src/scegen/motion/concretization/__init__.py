"""From a logical scenario to numbers: the first, deterministic concretization."""

from scegen.motion.concretization.concretize import concretize

__all__ = ["concretize"]
