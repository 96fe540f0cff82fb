"""A change of speed: an act's, a danger's or the road's, at a time or at a place of the way."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from scegen.scenario.concrete import Trigger
from scegen.scenario.vocabulary import HazardKind


class Sort(Enum):
    """What a change is: a danger's, an act, the road's (round a bend), what follows another."""

    DANGER = "danger"
    ACT = "act"
    SLOWS = "slows"
    FREES = "frees"
    GOES_ON = "goes on"


@dataclass(frozen=True, slots=True)
class SpeedChange:
    """The speed goes over to ``target_mps`` at ``rate_mps2``: from ``begins_s`` on, or ``s_m``.

    At a junction it is tied to the place ``s_m`` of the path (from the outer end) until a drive is
    worked out; ``there``: also however fast one comes. With ``then_s`` it comes so long after the
    one before it has ended instead, wherever that is, and ``then`` is one that does so at once.
    What the road slows down to must be reached ``by_m``: where acts have changed the speed, it
    begins just in time for that. ``act`` names the act of the text that it is, ``hazard`` the
    danger that it serves, ``reacts_to`` whom it answers. ``timed``: it comes so long after the
    start, whatever others do. ``trigger`` is what sets it off, once that is known.
    """

    target_mps: float
    rate_mps2: float
    begins_s: float = 0.0
    s_m: float = 0.0
    act: str | None = None
    hazard: HazardKind | None = None
    sort: Sort = Sort.DANGER
    then: SpeedChange | None = None
    then_s: float | None = None
    by_m: float = 0.0
    there: bool = False
    reacts_to: str | None = None
    timed: bool = False
    trigger: Trigger | None = None
