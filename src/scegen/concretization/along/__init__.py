"""Scenarios on a road without a junction, laid backwards from the moments that the text fixes."""

from scegen.concretization.along.compose import compose_along

__all__ = ["compose_along"]
