"""What the description fixes, so that a search leaves it alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from scegen.scenario.acts import Act, WhenMeasure
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import Interval
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START


@dataclass(frozen=True)
class Stated:
    """Who is placed by a spacing, whose speed is given, and the acts with what they fix.

    ``placed`` start where they do; ``speeds`` are ranges by participant; ``moments`` are acts of
    which the text says when they happen.
    """

    placed: frozenset[str] = frozenset()
    speeds: Mapping[str, Interval] = field(default_factory=dict)
    acts: Mapping[str, Act] = field(default_factory=dict)
    moments: frozenset[str] = frozenset()

    @classmethod
    def of(cls, functional: FunctionalScenario | None) -> Stated:
        """What a functional scenario fixes; nothing if it is unknown."""
        if functional is None:
            return cls()
        placed: set[str] = set()
        moments = {act.id for act in functional.acts if act.when is not None}
        for spacing in functional.spacings:
            if spacing.measure in LENGTHWISE and spacing.at != CONTACT:
                placed |= {spacing.participant, spacing.reference}
                moments |= {spacing.at} - {START}
        for act in functional.acts:
            if isinstance(act.when, WhenMeasure):
                placed |= {act.when.participant, act.when.reference}
        speeds = {p.id: p.speed_mps for p in functional.participants if p.speed_mps is not None}
        return cls(
            frozenset(placed), speeds, {act.id: act for act in functional.acts}, frozenset(moments)
        )

    def fixes_rate(self, act: str | None) -> bool:
        """Whether the text says how fast the speed changes."""
        said = self.acts.get(act or "")
        return said is not None and any((said.rate_mps2, said.duration_s, said.distance_m))

    def fixes_target(self, act: str | None) -> bool:
        """Whether the text says at which speed the act ends."""
        said = self.acts.get(act or "")
        return said is not None and any((said.target_speed_mps, said.duration_s))
