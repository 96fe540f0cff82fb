"""What the search for danger shows: which dangers happen, how critical it was and has become."""

from __future__ import annotations

from typing import Literal

from scegen.scenario.model import FrozenModel, Identifier
from scegen.scenario.vocabulary import HazardKind


class PartProof(FrozenModel):
    """One condition of a danger: a value against its threshold; None where it is undefined."""

    name: str
    value: float | None
    threshold: float
    unit: str
    happened: bool


class HazardProof(FrozenModel):
    """Whether one danger that was asked for happens.

    ``margin`` belongs to the weakest of ``parts``, in its unit; positive: it happens. ``note``
    says why there is nothing to judge.
    """

    kind: HazardKind
    by: tuple[Identifier, ...]
    to: tuple[Identifier, ...]
    happened: bool
    margin: float | None = None
    unit: str = "1"
    threshold: float | None = None
    time_s: float | None = None
    parts: tuple[PartProof, ...] = ()
    note: str | None = None


class MeasureProof(FrozenModel):
    """A measure of the pair that the target is about, before and after; None: undefined."""

    name: str
    unit: str
    before: float | None
    after: float | None


class Proof(FrozenModel):
    """The result of one search.

    ``pair`` is whom the target is about, ``measure`` what decided (or comes nearest), ``band`` its
    range. ``unwanted_contacts`` are pairs that touch although the target does not ask for it.
    ``dt_s`` is the time step of the proof. ``blocked_by`` says what kept the search from its aim.
    """

    level: Literal["proof"] = "proof"
    target: str
    in_band: bool
    in_band_before: bool
    measure: str | None = None
    band: tuple[float, float] | None = None
    pair: tuple[Identifier, ...] = ()
    measures: tuple[MeasureProof, ...] = ()
    hazards: tuple[HazardProof, ...] = ()
    hazards_before: tuple[HazardProof, ...] = ()
    unwanted_contacts: tuple[tuple[Identifier, Identifier], ...] = ()
    evaluations: int = 0
    dt_s: float = 0.01
    changed: bool = False
    blocked_by: str | None = None

    @property
    def hazards_happened(self) -> int:
        """How many of the dangers asked for happen."""
        return sum(hazard.happened for hazard in self.hazards)

    @property
    def reached(self) -> bool:
        """Whether every danger happens and the measure lies in its band."""
        return self.in_band and all(hazard.happened for hazard in self.hazards)

    def of(self, measure: str | None) -> MeasureProof | None:
        """The values of a measure, by name."""
        return next((m for m in self.measures if m.name == measure), None)
