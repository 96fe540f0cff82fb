"""Shapes of reference lines (OpenDRIVE 1.7, 8.2), each from the origin along the x axis.

``ds`` counts from its start. Lengths in metres, headings in radians, curvatures in 1/m, left turns
positive. Written apart from the generator's own geometry on purpose: a checker that shares the
formula would share its bug.
"""

from __future__ import annotations

from cmath import exp
from dataclasses import dataclass
from math import atan2, ceil, sin

import numpy as np

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(6)
_PIECE_M = 5.0
"""Six nodes on so short a piece place a clothoid of a road to less than a nanometre."""


@dataclass(frozen=True, slots=True)
class Arc:
    """A line (curvature 0) or an arc."""

    bend: float = 0.0

    def point(self, ds: float) -> complex:
        """The point, as x + iy."""
        half = self.bend * ds / 2
        return exp(1j * half) * (ds * sin(half) / half if half else ds)

    def heading(self, ds: float) -> float:
        """The heading."""
        return self.bend * ds

    def curvature(self, ds: float) -> float:  # noqa: ARG002 - the same everywhere
        """The curvature."""
        return self.bend


@dataclass(frozen=True, slots=True)
class Spiral:
    """A clothoid: its curvature goes evenly from ``first`` by ``rate`` (1/m²)."""

    first: float
    rate: float

    def point(self, ds: float) -> complex:
        """The point, as x + iy."""
        count = max(1, ceil(abs(ds) / _PIECE_M))
        half = ds / count / 2
        s = (2 * np.arange(count)[:, None] + 1 + _NODES) * half
        return complex((_WEIGHTS * np.exp(1j * (self.first + self.rate * s / 2) * s)).sum() * half)

    def heading(self, ds: float) -> float:
        """The heading."""
        return (self.first + self.rate * ds / 2) * ds

    def curvature(self, ds: float) -> float:
        """The curvature."""
        return self.first + self.rate * ds


@dataclass(frozen=True, slots=True)
class Cubic:
    """A parametric cubic: u and v by the powers of p = ds · ``scale``."""

    u: tuple[float, float, float, float]
    v: tuple[float, float, float, float]
    scale: float

    def point(self, ds: float) -> complex:
        """The point, as x + iy."""
        p = ds * self.scale
        return complex(*(a + p * (b + p * (c + p * d)) for a, b, c, d in (self.u, self.v)))

    def heading(self, ds: float) -> float:
        """The heading."""
        u, v = self._first(ds)
        return atan2(v, u)

    def curvature(self, ds: float) -> float:
        """The curvature."""
        p = ds * self.scale
        u, v = self._first(ds)
        uu, vv = (2 * c + 6 * d * p for _, _, c, d in (self.u, self.v))
        return float((u * vv - v * uu) / (u * u + v * v) ** 1.5)

    def _first(self, ds: float) -> tuple[float, float]:
        p = ds * self.scale
        u, v = (b + p * (2 * c + p * 3 * d) for _, b, c, d in (self.u, self.v))
        return u, v


Curve = Arc | Spiral | Cubic
