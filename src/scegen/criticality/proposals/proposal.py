"""What a proposer sees and what it gives."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, Protocol

from pydantic import Field, WithJsonSchema

from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.proposals.reaching import Explored
from scegen.criticality.target import Target
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.model import FrozenModel
from scegen.scenario.proof import HazardProof

MOST_PROPOSALS = 60
LONGEST_REASON = 500


class Proposal(FrozenModel):
    """One change: a parameter by its name, its new value in the parameter's unit, and why.

    Whatever stands in ``value`` is let in, so that one bad value costs itself only; the validator
    judges it.
    """

    parameter: str = Field(max_length=100)
    value: Annotated[Any, WithJsonSchema({"type": "number"})]
    reason: str = Field(min_length=1, max_length=LONGEST_REASON)


@dataclass(frozen=True, slots=True)
class Passage:
    """When somebody is on the ground that it shares with another, and where its way enters it."""

    enters_s: float
    leaves_s: float
    enters_m: float


@dataclass(frozen=True, slots=True)
class Encounter:
    """Two whose paths meet: ``second`` enters ``gap_s`` after ``first`` has left, or before (< 0).

    ``passages`` are those of the first and of the second. ``least_s`` is the smallest gap from
    there on: less, where the second catches up with the first in a lane that they share.
    """

    first: str
    second: str
    gap_s: float
    least_s: float
    passages: tuple[Passage, Passage]


@dataclass(frozen=True, slots=True)
class Situation:
    """A scenario before the search, and what it is to become.

    ``hazards`` say which dangers happen already; ``measures`` are the pair's by name with value
    (None: undefined) and unit; ``contacts`` are those who touch. ``explore`` finds out, when asked,
    what every parameter can do.
    """

    concrete: ConcreteScenario
    target: Target
    pair: tuple[str, str]
    parameters: tuple[Parameter, ...]
    hazards: tuple[HazardProof, ...]
    measures: tuple[tuple[str, float | None, str], ...]
    encounters: tuple[Encounter, ...]
    contacts: tuple[tuple[str, str], ...]
    explore: Callable[[], Explored] = field(compare=False)

    def parameter(self, name: str) -> Parameter | None:
        """The parameter of this name."""
        return next((p for p in self.parameters if p.name == name), None)


@dataclass(frozen=True, slots=True)
class Proposed:
    """Proposals, who makes them, and what is to be said about it."""

    speaker: str
    proposals: tuple[Proposal, ...]
    notes: tuple[str, ...] = ()


Check = Callable[[Sequence[Proposal]], list[str | None]]
"""What is wrong with each of some proposals; None: it is valid."""


class Proposer(Protocol):
    """Whoever proposes changes."""

    def propose(self, situation: Situation, check: Check) -> Proposed:
        """Changes for a situation; ``check`` says beforehand what the validator would reject."""
