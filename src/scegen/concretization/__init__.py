"""From a logical scenario to numbers: the first, deterministic concretization."""

from scegen.concretization.concretize import concretize

__all__ = ["concretize"]
