"""What sets things off, read off the scenario as it was laid: so that it also reacts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from scegen.motion.trigger_steps import just_before_step_s
from scegen.scenario.concrete import AtTime, Travelled, Trigger

_MOVES_MPS, _SURE_S = 2.0, 1.0
"""How far one has come tells no moment if it is slower: some centimetres are long then. Nor does it
if it is so a moment later: who comes to rest does so some centimetres short where steps are taken.
"""


class Comes(Protocol):
    """One whose way so far may set another off."""

    id: str

    def speed_at_mps(self, time_s: float) -> float:
        """Its speed at a time of the scenario; 0 at the end of its way."""

    def gone_m(self, time_s: float) -> float:
        """How far it has come by then."""


def as_they_come(whose: Iterable[Comes], moment_s: float) -> Trigger:
    """How far the first of them who drives on has come at a moment; that moment if nobody does."""
    moment_s = just_before_step_s(moment_s)
    for who in whose:
        if all(who.speed_at_mps(moment_s + s) > _MOVES_MPS for s in (0.0, _SURE_S)):
            return Travelled(participant=who.id, distance_m=round(who.gone_m(moment_s), 3))
    return AtTime(time_s=round(moment_s, 3))
