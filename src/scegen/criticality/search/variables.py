"""What a search may vary, and how its numbers become candidates of the batch simulator.

Variables are meant as a driver would mean them: "starts there", "cruises at", "comes to rest
there". Triggers follow from them: whoever is to have slowed down at a place begins earlier if it
is faster.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from typing import Any

import numpy as np

from scegen.motion.batch.arrays import Candidates, Floats
from scegen.motion.batch.compilation import repeat

LEAD_IN_S = 1.0
"""Everybody drives at least this long before its first phase."""


Column = Any
"""One value for each candidate (c,), one for all of them, or a symbol that stands for a value and
answers to numpy's functions."""


@dataclass(frozen=True, slots=True)
class Variable:
    """A number that may change within ``[low, high]``; ``scale`` is a small but real change."""

    name: str
    base: float
    low: float
    high: float
    scale: float


@dataclass(frozen=True, slots=True)
class Quantity:
    """A value that is a variable (``column`` >= 0) or fixed."""

    base: float
    column: int = -1

    def of(self, x: Sequence[Column]) -> Column:
        """Its value where ``x`` are those of the variables."""
        return x[self.column] if self.column >= 0 else self.base


class Place(Enum):
    """What the trigger of a phase follows from."""

    HERE = auto()
    """A fixed place on the owner's way."""
    SLOWED = auto()
    """The place on the owner's way at which it has slowed down to the target."""
    OTHER = auto()
    """A fixed place on another's way."""
    FAR_SIDE = auto()
    """The place from which one who walks can still stop before the end of its way."""
    AS_IS = auto()
    """A time or a distance of its own."""


@dataclass(frozen=True, slots=True)
class PhaseRecipe:
    """How one phase of a candidate is made; ``phase`` is its number in the program."""

    phase: int
    owner: int
    subject: int
    place: Place
    trigger: float
    before: Quantity
    target: Quantity
    rate: Quantity
    shift: Quantity
    original_rate_mps2: float
    path_length_m: float = 0.0


@dataclass(frozen=True, slots=True)
class PhaseValues:
    """What the variables make of one phase."""

    trigger: Column
    target_speed_mps: Column
    rate_mps2: Column


@dataclass(frozen=True, slots=True)
class Values:
    """What the variables make of everybody: by number of the participant, and of the phase."""

    start_m: Sequence[Column]
    speed_mps: Sequence[Column]
    phases: Mapping[int, PhaseValues]


@dataclass(frozen=True)
class Space:
    """The variables of a scenario and how they make candidates."""

    base: Candidates
    variables: Sequence[Variable]
    starts: Sequence[Quantity]
    speeds: Sequence[Quantity]
    recipes: Sequence[PhaseRecipe]

    @property
    def low(self) -> Floats:
        """Lower bounds (n,)."""
        return np.array([v.low for v in self.variables])

    @property
    def high(self) -> Floats:
        """Upper bounds (n,)."""
        return np.array([v.high for v in self.variables])

    @property
    def span(self) -> Floats:
        """How wide they are (n,)."""
        return self.high - self.low

    def at(self, u: Floats) -> Floats:
        """The values at points of the unit cube (…, n)."""
        return self.low + u * self.span

    def unit(self, x: Floats) -> Floats:
        """Where values lie in the unit cube (…, n)."""
        return (x - self.low) / self.span

    @property
    def origin(self) -> Floats:
        """The scenario as it was concretized, inside the bounds (n,)."""
        return np.array([min(max(v.base, v.low), v.high) for v in self.variables])

    def strangeness(self, x: Floats, home: Floats | None = None) -> Floats:
        """Mean squared distance from ``home`` (the concretized scenario), in small changes (c,)."""
        if not self.variables:
            return np.zeros(x.shape[0])
        base = np.array([v.base for v in self.variables]) if home is None else home
        scale = np.array([v.scale for v in self.variables])
        away: Floats = np.mean(((x - base) / scale) ** 2, axis=1)
        return away

    def values(self, x: Sequence[Column]) -> Values:
        """The numbers that follow from those of the variables."""
        starts = [start.of(x) for start in self.starts]
        speeds = [speed.of(x) for speed in self.speeds]
        moved = [start - self.base.start_m[0, i] for i, start in enumerate(starts)]
        phases = {
            recipe.phase: PhaseValues(
                _trigger(recipe, x, moved, speeds), recipe.target.of(x), recipe.rate.of(x)
            )
            for recipe in self.recipes
        }
        return Values(starts, speeds, phases)

    def candidates(self, x: Floats) -> Candidates:
        """The candidates of these values (c, variables)."""
        made = repeat(self.base, x.shape[0])
        values = self.values(tuple(x.T))
        for i, (start, speed) in enumerate(zip(values.start_m, values.speed_mps, strict=True)):
            made.start_m[:, i] = start
            made.speed_mps[:, i] = speed
        for k, phase in values.phases.items():
            made.target_speed_mps[:, k] = phase.target_speed_mps
            made.rate_mps2[:, k] = phase.rate_mps2
            made.trigger[:, k] = phase.trigger
        return made


def _trigger(
    recipe: PhaseRecipe, x: Sequence[Column], moved: Sequence[Column], speeds: Sequence[Column]
) -> Column:
    """The trigger value of a phase."""
    value = recipe.trigger + recipe.shift.of(x)
    if recipe.place in {Place.HERE, Place.SLOWED}:
        value = value - moved[recipe.owner]
        if recipe.place is Place.SLOWED:
            first, last = recipe.before, recipe.target
            was = (first.base**2 - last.base**2) / (2 * recipe.original_rate_mps2)
            now = (first.of(x) ** 2 - last.of(x) ** 2) / (2 * recipe.rate.of(x))
            value = value + was - now
        lead = np.minimum(speeds[recipe.owner] * LEAD_IN_S, recipe.trigger)
        return np.maximum(value, lead)
    if recipe.place is Place.OTHER:
        return np.maximum(value - moved[recipe.subject], 0.0)
    if recipe.place is Place.FAR_SIDE:
        share = (recipe.before.of(x) / max(recipe.before.base, 0.1)) ** 2
        left = (recipe.path_length_m - recipe.trigger) * share
        return np.maximum(recipe.path_length_m - left, 0.0)
    return np.maximum(value, 0.05)
