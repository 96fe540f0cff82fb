"""Cubics, and shapes of reference lines (OpenDRIVE 1.7, 8.2), from the origin along the x axis.

``ds`` counts from its start. Lengths in metres, headings in radians, curvatures in 1/m, left turns
positive. Written apart from the generator's own geometry on purpose: a checker that shares the
formula would share its bug.
"""

from cmath import exp
from dataclasses import dataclass
from math import atan2, ceil, sin
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

S = TypeVar("S", float, NDArray[np.float64])
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(6)
_PIECE_M = 5.0
"""Six nodes on so short a piece place a clothoid of a road to less than a nanometre."""


@dataclass(frozen=True, slots=True)
class Poly3:
    """a + b·u + c·u² + d·u³ with u measured from ``s``."""

    s: float
    a: float
    b: float
    c: float
    d: float

    def value(self, s: S) -> S:
        """The value at ``s``, or at places."""
        u = s - self.s
        return self.a + u * (self.b + u * (self.c + u * self.d))

    def slope(self, s: float) -> float:
        """The derivative at ``s``."""
        u = s - self.s
        return self.b + u * (2 * self.c + u * 3 * self.d)


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

    u: Poly3
    v: Poly3
    scale: float

    def point(self, ds: float) -> complex:
        """The point, as x + iy."""
        return complex(self.u.value(ds * self.scale), self.v.value(ds * self.scale))

    def heading(self, ds: float) -> float:
        """The heading."""
        return atan2(self.v.slope(ds * self.scale), self.u.slope(ds * self.scale))

    def curvature(self, ds: float) -> float:
        """The curvature."""
        p = ds * self.scale
        u, v = self.u.slope(p), self.v.slope(p)
        uu, vv = (2 * cubic.c + 6 * cubic.d * p for cubic in (self.u, self.v))
        return float((u * vv - v * uu) / (u * u + v * v) ** 1.5)


Curve = Arc | Spiral | Cubic
