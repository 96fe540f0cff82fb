"""Those who cross or stand, in the making."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from scegen.claims.boxes import Boxes, around
from scegen.concretization.limits import WALKING_START_MPS2
from scegen.concretization.profile import Mover, Profile
from scegen.concretization.written import as_they_come
from scegen.motion.model import Array, Path
from scegen.motion.standing import crossing_path
from scegen.road.model import RoadNetwork
from scegen.scenario.acts import Act, ActKind, AfterStart
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import (
    CrossingMotion,
    SpeedPhase,
    StandingMotion,
    StoodStill,
    Travelled,
    Trigger,
)
from scegen.scenario.logical import Crossing
from scegen.scenario.vocabulary import ANIMALS, HazardKind, ParticipantKind

STOPS_SHORT_M = 0.15
"""Who comes to rest on its way does so this far before its way ends."""
_ABREAST_M = 0.9
_CROSSES = {
    ParticipantKind.PEDESTRIAN: HazardKind.CROSSING_PEDESTRIAN,
    ParticipantKind.BICYCLE: HazardKind.CROSSING_CYCLIST,
    ParticipantKind.ANIMAL: HazardKind.CROSSING_ANIMAL,
    ParticipantKind.LARGE_ANIMAL: HazardKind.CROSSING_ANIMAL,
}


def abreast_m(number: int) -> float:
    """How far aside the next of several walks: 0, one to the left, one to the right, and so on."""
    return (number + 1) // 2 * _ABREAST_M * (1 if number % 2 else -1)


@dataclass
class Walker:
    """One who goes across a road, on foot or by bicycle, at a steady pace from where it starts.

    ``act`` is the one of the text that this is, ``stop`` the one by which it stops on its way,
    ``setback_m`` how far outside the carriageway it starts, ``stops_after_m`` where it stops: its
    way ends there, unless it is said for how long it stops.
    """

    id: str
    kind: ParticipantKind
    body: Body
    crossing: Crossing
    speed_mps: float
    act: Act | None
    setback_m: float = field(default=0.0, kw_only=True)
    stops_after_m: float | None = field(default=None, kw_only=True)
    stop: Act | None = field(default=None, kw_only=True)

    @property
    def timed(self) -> bool:
        """Whether it is said how long after the start it sets off, whatever others do."""
        return self.act is not None and isinstance(self.act.when, AfterStart)

    @property
    def rate_mps2(self) -> float:
        """How fast it gains speed, and loses it."""
        most = self.body.max_acceleration_mps2
        return most if self.kind in ANIMALS else min(WALKING_START_MPS2, most)

    @property
    def gains_m(self) -> float:
        """How far it goes until it has its pace."""
        return self.speed_mps**2 / (2 * self.rate_mps2)

    def runs_s(self, way_m: float) -> float:
        """How long it takes from setting off until so much way is behind it."""
        return way_m / self.speed_mps + self.speed_mps / (2 * self.rate_mps2)

    def slows_s(self) -> float:
        """How long after setting off one begins to come to rest who does not go across."""
        return self.runs_s((self.stops_after_m or 0.0) - STOPS_SHORT_M - self.gains_m)

    def rests_s(self) -> float:
        """How long after setting off that one has come to rest."""
        return self.slows_s() + self.speed_mps / self.rate_mps2

    def gone(self, since_s: Array) -> tuple[Array, Array]:
        """(way, speed) by the time since setting off, up to where it comes to rest on its way."""
        return self.profile.at_times(np.maximum(since_s, 0.0))

    @property
    def stands_s(self) -> float | None:
        """How long one stops who goes on then; None if it does not."""
        if self.stop is None or self.stop.kind is not ActKind.WAIT:
            return None
        return None if self.stop.duration_s is None else self.stop.duration_s.middle

    @property
    def profile(self) -> Profile:
        """Its way over time from when it sets off."""
        profile = Profile(0.0)
        profile.change(0.0, self.speed_mps, self.rate_mps2)
        if self.stops_after_m is not None:
            profile.change(max(0.0, self.slows_s()), 0.0, self.rate_mps2)
            if self.stands_s is not None:
                profile.change(self.rests_s() + self.stands_s, self.speed_mps, self.rate_mps2)
        return profile

    def motion_at(self, from_junction_m: float) -> CrossingMotion:
        """Its way across, so far from the inner end of its arm."""
        stops = self.stops_after_m if self.stands_s is None else None
        return CrossingMotion(
            arm=self.crossing.arm,
            start_side=self.crossing.start,
            from_junction_m=round(from_junction_m, 3),
            setback_m=round(self.setback_m, 3),
            stops_after_m=None if stops is None else round(stops, 3),
        )

    def program_by(
        self, met: Iterable[Mover], sets_off_s: float, length_m: float
    ) -> tuple[SpeedPhase, ...]:
        """Set off as one has come so far who is met, and come to rest just before its way ends.

        Who stops for a while on its way goes on after it.
        """
        sets_off = as_they_come(() if self.timed else met, sets_off_s)
        told: list[tuple[Trigger, float, HazardKind | None, Act | None]] = [
            (sets_off, self.speed_mps, _CROSSES.get(self.kind), self.act)
        ]
        if self.stops_after_m is not None:
            there = self._short_of(round(self.stops_after_m, 3))
            told.append((there, 0.0, HazardKind.STOPPING, self.stop))
        if self.stands_s is not None:
            stood = StoodStill(participant=self.id, duration_s=self.stands_s)
            told.append((stood, self.speed_mps, None, None))
        if self.stops_after_m is None or self.stands_s is not None:
            told.append((self._short_of(length_m), 0.0, None, None))
        return tuple(
            SpeedPhase(
                trigger=trigger,
                target_speed_mps=round(target, 4),
                rate_mps2=self.rate_mps2,
                hazard=hazard,
                act=None if act is None else act.id,
            )
            for trigger, target, hazard, act in told
        )

    def _short_of(self, way_m: float) -> Trigger:
        """When it must begin to stop."""
        begins_m = max(0.0, way_m - self.gains_m - STOPS_SHORT_M)
        return Travelled(participant=self.id, distance_m=round(begins_m, 3))


@dataclass
class Walk(Walker):
    """One who goes across an open road: at ``x_m`` of it, ``sets_off_s`` after the start.

    ``from_y_m`` is where it starts, to the ego's left of the centre line.
    """

    from_left: bool
    meets: str
    x_m: float = 0.0
    sets_off_s: float = 0.0
    from_y_m: float = 0.0

    def track(self, times_s: Array) -> tuple[Boxes, Array]:
        """Its boxes over time, and its speeds."""
        way, speed = self.gone(times_s - self.sets_off_s)
        into = -1.0 if self.from_left else 1.0
        x, cos, sin = (np.full_like(way, value) for value in (self.x_m, 0.0, into))
        return around(self.body, x, self.from_y_m + into * way, cos, sin), speed


@dataclass
class WalkDraft(Walker):
    """One who crosses an arm, in the making; ``sets_off_s`` is known if that is said."""

    from_junction_m: float
    path: Path = field(init=False)
    sets_off_s: float | None = None

    def lay(self, network: RoadNetwork) -> None:
        """Lay its way out, anew if it is to end elsewhere."""
        self.path = crossing_path(network, self.motion_at(self.from_junction_m), self.id)


@dataclass
class StandDraft:
    """One who stands, in the making."""

    id: str
    body: Body
    motion: StandingMotion
    path: Path
