"""Acts, spacings, things and the outcome in the making; each value has its words beside it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from scegen.scenario.acts import RESTING, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.outcome import BodySide, OutcomeKind
from scegen.scenario.spacings import START, Measure
from scegen.scenario.things import ThingKind
from scegen.scenario.vocabulary import Side
from scegen.understanding.entity import Basis, Entity

STILL = Interval(low=0.0, high=0.0)
Since: TypeAlias = Literal["begin", "end"]
"""Whether something counts from when an act begins, or from when it is over."""


@dataclass(frozen=True, slots=True)
class Amount:
    """A quantity with its words."""

    value: Interval
    basis: Basis


@dataclass(slots=True, eq=False)
class Trigger:
    """What sets an act off.

    ``amount`` is a delay after the start or after ``act``, the value that ``measure`` comes down
    to, or how far before the junction.
    """

    kind: str
    basis: Basis
    amount: Amount | None = None
    act: Doing | None = None
    since: Since = "end"
    measure: Measure | None = None
    entity: Entity | None = None
    reference: Entity | Item | None = None


@dataclass(slots=True, eq=False)
class Doing:
    """An act in the making; ``i`` is where the text tells of it."""

    kind: ActKind
    entity: Entity
    basis: Basis
    i: int
    always: bool = True
    amounts: dict[str, Amount] = field(default_factory=dict)
    side: Side | None = None
    side_basis: Basis | None = None
    into: Entity | None = None
    into_basis: Basis | None = None
    when: Trigger | None = None
    nominal: bool = False
    """A noun tells of it ("a deceleration")."""
    forced: bool = False
    """The ego has to, because of what another does."""
    told: list[int] = field(default_factory=list)
    """Where the text tells of it again."""
    name: str = ""

    @property
    def places(self) -> set[int]:
        """All tokens at which the text tells of it."""
        return {self.i, *self.told}

    @property
    def ends_at_rest(self) -> bool:
        """Whether who does it stands in the end, for a while or for good."""
        target = self.amounts.get("target_speed_mps")
        rests = self.kind in RESTING
        return rests or (target is not None and target.value == STILL)


@dataclass(slots=True, eq=False)
class Apart:
    """A spacing in the making."""

    measure: Measure
    entity: Entity | Item
    reference: Entity
    amount: Amount
    at: Doing | str = START
    side: Side | None = None
    since: Since = "begin"


@dataclass(slots=True, eq=False)
class Ending:
    """The outcome in the making; ``half`` of the ego's front is the part that is touched.

    ``share`` is how many percent of its width that part has, where it is said.
    """

    kind: OutcomeKind
    basis: Basis
    between: list[Entity] = field(default_factory=list)
    impact: Amount | None = None
    struck: BodySide | None = None
    struck_basis: Basis | None = None
    half: Side | None = None
    half_basis: Basis | None = None
    share: float | None = None

    @property
    def other(self) -> Entity | None:
        """Who touches the ego."""
        return next((e for e in self.between if not e.ego), None)


@dataclass(slots=True, eq=False)
class Item:
    """A thing in the making; ``blocked`` is in whose way it lies, None where that is the ego."""

    kind: ThingKind
    called: str
    basis: Basis
    blocks: bool = False
    blocked: Entity | None = None
    blocked_basis: Basis | None = None
    hides: list[Entity] = field(default_factory=list)
    side: Side | None = None
    side_basis: Basis | None = None
    sizes: dict[str, Amount] = field(default_factory=dict)
    name: str = ""


def name_them(found: Iterable[Doing | Item]) -> None:
    """Gives each its name, by kind and number."""
    counts = Counter[str]()
    for one in found:
        counts[one.kind] += 1
        one.name = f"{one.kind.value}_{counts[one.kind]}"


@dataclass(slots=True)
class Happenings:
    """All that the text tells of beside who takes part and where they go."""

    acts: list[Doing] = field(default_factory=list)
    spacings: list[Apart] = field(default_factory=list)
    items: list[Item] = field(default_factory=list)
    ending: Ending | None = None
    speeds_again: list[tuple[Entity, Basis]] = field(default_factory=list)
    """Words that say again how fast somebody is."""
