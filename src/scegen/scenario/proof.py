"""What the search for danger shows: which dangers happen, how critical it was and has become."""

from typing import Literal

from scegen.scenario.concrete import Change
from scegen.scenario.model import FrozenModel, Identifier
from scegen.scenario.vocabulary import HazardKind
from scegen.scenario.wording import change, counted, figure


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


QUANTITIES = ("_mps", "_mps2", "_m", "_s", "_percent", "_deg")
"""How fields end that hold a quantity, with its unit."""


class ClaimProof(FrozenModel):
    """Whether one statement holds: what was measured, when, and by how much it holds.

    ``field`` is the path of the functional field that it rests on, ``words`` the words behind it.
    ``margin``, ``measured`` and ``tolerance`` are in ``unit``; None where there is nothing to
    measure. ``fixed``: it lies in roads, ways, lanes and bodies, which no search changes.
    """

    id: str
    kind: str
    statement: str
    field: str
    words: str | None = None
    holds: bool
    measured: float | None = None
    unit: str = "1"
    margin: float | None = None
    tolerance: float = 0.0
    time_s: float | None = None
    fixed: bool = False

    @property
    def helps(self) -> str:
        """What would make it hold."""
        if self.fixed:
            return f"pick another scenario, or change {self._said}"
        if self.field == "outcome" and self.words is None:
            room = "start farther away, drive more slowly, brake harder"
            return f"give more room ({room}), or say that they collide"
        named = self.field.startswith("spacings.") or self.field.endswith(QUANTITIES)
        if self.measured is None or not named:
            return f"leave {self._said} out, or something that stands against it"
        instead = "instead of" if self.words else "in"
        value = f"{self.measured:.4g}{self._of_unit}"
        return f"{value} {instead} {self._said}, or leave something else open"

    @property
    def _said(self) -> str:
        return f'"{self.words}" ({self.field})' if self.words else self.field

    @property
    def _of_unit(self) -> str:
        return "" if self.unit == "1" else f" {self.unit}"

    @property
    def found(self) -> str:
        """What is there instead, where it does not hold."""
        if self.measured is None:
            return "it does not happen"
        when = "" if self.time_s is None else f" at {self.time_s:.1f} s"
        return f"{self.measured:.4g}{self._of_unit}{when}"


class MeasureProof(FrozenModel):
    """A measure of the pair that the target is about, before and after; None: undefined."""

    name: str
    unit: str
    before: float | None
    after: float | None

    @property
    def in_words(self) -> str:
        """Such as ``0.83 → 0.78 s``; only one figure where it stays."""
        return f"{change(figure(self.before), figure(self.after))} {self.unit}"


class Advice(FrozenModel):
    """Changes that were proposed before the search, and what the validator made of them.

    ``speaker`` proposed them; ``led`` says whether what was found began at them. ``notes`` say why
    others, who were asked before, did not speak.
    """

    speaker: str
    led: bool = False
    changes: tuple[Change, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def accepted(self) -> int:
        """How many proposals were taken as they were."""
        return sum(change.rejected is None for change in self.changes)

    @property
    def replaced(self) -> int:
        """How many were replaced by a random value."""
        return sum(c.rejected is not None and c.after is not None for c in self.changes)

    @property
    def dropped(self) -> int:
        """How many were rejected and not replaced."""
        return len(self.changes) - self.accepted - self.replaced


class Proof(FrozenModel):
    """The result of one search.

    ``pair`` is whom the target is about, ``measure`` what decided (or comes nearest), ``band`` its
    range. ``claims`` are all statements of the description. ``unwanted_contacts`` are pairs that
    touch although the target does not ask for it. ``dt_s`` is the time step of the proof.
    ``blocked_by`` says what kept the search from its aim. ``advice`` is None where nobody was
    asked, since nothing had to change or nothing would help.
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
    claims: tuple[ClaimProof, ...] = ()
    unwanted_contacts: tuple[tuple[Identifier, Identifier], ...] = ()
    evaluations: int = 0
    dt_s: float = 0.01
    changed: bool = False
    blocked_by: str | None = None
    advice: Advice | None = None

    @property
    def missed(self) -> tuple[ClaimProof, ...]:
        """The statements that do not hold."""
        return tuple(claim for claim in self.claims if not claim.holds)

    @property
    def held(self) -> str:
        """How many of the statements hold, in words."""
        hold = len(self.claims) - len(self.missed)
        return f"{hold} of {counted(len(self.claims), 'statement')} hold"

    @property
    def reached(self) -> bool:
        """Whether every danger happens and the measure lies in its band."""
        return self.in_band and all(hazard.happened for hazard in self.hazards)

    def of(self, measure: str | None) -> MeasureProof | None:
        """The values of a measure, by name."""
        return next((m for m in self.measures if m.name == measure), None)
