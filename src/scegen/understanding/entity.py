"""Somebody who takes part, in the making, and the words on which a statement rests."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from scegen.scenario.model import Interval
from scegen.scenario.roadway import Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import ON_FOOT, Approach, CrossedArm, Maneuver, ParticipantKind


@dataclass(slots=True, unsafe_hash=True)
class Basis:
    """What a fact rests on: tokens of the text, a reason, or both."""

    i: int | None = None
    j: int | None = None
    reason: str | None = None

    def because(self, reason: str | None) -> Basis:
        """The same words, with the reason why a fact rests on them."""
        return Basis(self.i, self.j, reason)


@dataclass(slots=True, eq=False)
class Entity:
    """A participant in the making; each value has its basis beside it."""

    index: int
    kind: ParticipantKind
    basis: Basis
    ego: bool = False
    parked: bool = False
    parked_basis: Basis | None = None
    stands: Basis | None = None
    """Words that say that it stands in the lane from the start."""
    beside: tuple[str, Basis] | None = None
    """On which side the lane lies in which it drives beside the ego."""
    in_next_lane: tuple[set[Approach], Basis] | None = None
    """Whether it is ahead or behind there."""
    on_call: Basis | None = None
    """Words that say that its siren and blue lights are on."""
    strip: tuple[Strip, Basis] | None = None
    """The strip beside the lanes on which it is at first."""
    told: dict[str, Basis] = field(default_factory=dict)
    """What rows note of it (`marks.NOTED`), with the first words that say so."""
    crosses: tuple[CrossedArm, Basis] | None = None
    course: tuple[bool, Basis] | None = None
    """Whether it walks as the ego drove before it turned (else against that)."""
    light: tuple[AtLight, Basis] | None = None
    green_delay: Any = None
    start_lane: tuple[str, Basis] | None = None
    """The lane in which it is said to drive: ``left``, ``middle``, ``2``, ``2 from right``."""
    brakes_from: int | None = None
    """Where the text first says that it brakes."""
    rests: list[Basis] = field(default_factory=list)
    """Words that say that it stands, after it has braked."""
    sets_off: int = -1
    """Where the text says last that it moves, as the index of a token."""
    labels: set[str] = field(default_factory=set)
    dirs: set[str] = field(default_factory=set)
    named_by: set[str] = field(default_factory=set)
    loci: set[str] = field(default_factory=set)
    nears: bool = False
    """It comes towards somebody, from wherever."""
    approaches: set[Approach] = field(default_factory=set)
    approach_basis: Basis | None = None
    maneuvers: set[Maneuver] = field(default_factory=set)
    maneuver_basis: Basis | None = None
    turn_alternative: int | None = None
    excluded: set[Maneuver] = field(default_factory=set)
    excluded_basis: Basis | None = None
    entries: set[int] = field(default_factory=set)
    entry_basis: Basis | None = None
    speed: Interval | None = None
    speed_basis: Basis | None = None
    sizes: dict[str, Any] = field(default_factory=dict)
    """Its length and width as amounts, by the field."""
    heading: str | None = None
    heading_basis: Basis | None = None
    bound: bool = False
    on_minor: tuple[bool, Basis] | None = None
    """Whether it comes on the road that has the sign (else on the one that has priority)."""
    by_heading: Basis | None = None
    counted: Basis | None = None
    claimed: bool = False
    some: bool = False
    """It is one of so many of several alike, no matter which."""
    by_ramp: Basis | None = None
    """Words that say that it comes by a ramp, or in a lane that ends."""
    in_egos_lane: Basis | None = None
    far_side: Basis | None = None
    """Words that say that it comes from the other side of the road."""
    pulls_out: bool = False
    was_parked: Basis | None = None
    sides: set[str] = field(default_factory=set)
    opposed: set[int] = field(default_factory=set)
    name: str = ""

    @property
    def is_vehicle(self) -> bool:
        """Whether it drives on the road, parked or not."""
        return self.kind not in ON_FOOT

    @property
    def still(self) -> bool:
        """Whether it stands, beside the lane or in it."""
        return self.parked or self.stands is not None

    @property
    def stays(self) -> bool:
        """It stands in the lane from the start, and nothing says that it drives off."""
        goes = self.maneuvers - {Maneuver.STAY, Maneuver.STRAIGHT}
        return self.stands is not None and self.sets_off < 0 and not goes

    @property
    def lane(self) -> int | None:
        """The number of the lane in which it is said to drive."""
        number = self.start_lane[0].partition(" ")[0] if self.start_lane is not None else ""
        return int(number) if number.isdigit() else None

    @property
    def numbered(self) -> bool:
        """Whether it is called by a number ("V1")."""
        return any(label.startswith("#") for label in self.labels)

    @property
    def moving_vehicle(self) -> bool:
        """Whether it may be the ego."""
        return self.is_vehicle and not self.parked

    def comes_from(self, approaches: set[Approach], basis: Basis | None) -> None:
        """Settles where it is seen, or comes from."""
        self.approaches, self.approach_basis = approaches, basis
