"""Everything about one scenario at a junction while its numbers are being chosen."""

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from scegen.concretization.amounts import AS_LONG_AS_NEEDED_S, implied, spelled_out
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.others import StandDraft, WalkDraft
from scegen.concretization.tale import Tale
from scegen.errors import MotionInfeasibleError
from scegen.road.model import RoadNetwork, Route
from scegen.scenario.acts import GAINING, SLOWING, Act, ActKind, AfterAct
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.signals import AtLight, SignalPlan
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver


class NeedsLongerArms(Exception):  # noqa: N818 - a signal between two parts, not an error
    """The arms are ``metres`` too short for the plan; caught by ``concretize``."""

    def __init__(self, metres: float, who: str) -> None:
        self.metres = metres
        self.who = who
        super().__init__(f"{who} needs {metres:.0f} m more")


def require_room(who: str, at_m: float, least_m: float, spare_m: float = 1.0) -> None:
    """Ask for longer arms, and a little more, where somebody would begin something too early.

    Raises:
        NeedsLongerArms: it would.
    """
    if at_m < least_m:
        raise NeedsLongerArms(least_m - at_m + spare_m, who)


def acts_of(functional: FunctionalScenario, logical: LogicalScenario) -> tuple[Act, ...]:
    """What happens, in order.

    Who pulls out sets off, and who endangers another by a change of speed makes it, also where the
    text has no act for that.
    """
    told = spelled_out(functional.acts, {drive.participant for drive in logical.drives})
    first = {a.participant: a.kind for a in reversed(told) if a.kind in SLOWING | GAINING}
    pulling = (p.id for p in functional.participants if p.pulls_out)
    setting_off = (
        implied("pull", name, name, ActKind.SET_OFF)
        for name in pulling
        if first.get(name) is not ActKind.SET_OFF
    )
    tale = Tale(functional, logical, (*setting_off, *told))
    for hazard in functional.hazards:
        tale.acts = (*tale.acts, *_implied(tale, hazard))
    return tuple(tale.acts)


def _implied(tale: Tale, hazard: Hazard) -> Iterator[Act]:
    """The change of speed that a danger consists of; who stops for it goes on again."""
    kind = next((kind for kind in HAZARDS[hazard.kind].acts if kind in SLOWING | GAINING), None)
    if kind is None:
        return
    alike = SLOWING if kind in SLOWING else GAINING
    own = {act.participant for act in tale.acts if act.kind in alike}
    late = hazard.kind is HazardKind.DELAYED_BRAKING
    for drive in tale.logical.drives:
        name = drive.participant
        reverses = drive.reverses is not None or HazardKind.REVERSING in tale.kinds_by(name)
        stays = reverses or drive.maneuver is Maneuver.STAY
        whom = hazard.to or [person.id for person in tale.functional.participants]
        never = tale.functional.participant(name).unresponsive
        runs_in = late and (never or any(tale.contact_wanted(name, to) for to in whom))
        if name not in hazard.by or name in own or stays or runs_in:
            continue
        act = implied(hazard.kind, name, name, kind)
        yield act
        if kind in SLOWING:
            free = AfterAct(act=act.id, since="end", delay_s=AS_LONG_AS_NEEDED_S)
            yield implied("on", act.id, name, ActKind.SET_OFF, when=free)


@dataclass
class Setup(Tale):
    """Everything about one scenario in the making.

    ``objects`` are the things that have a place, ``signals`` what its lights show: on the clock of
    the ego's course until everybody has a start, then on the scenario's.
    """

    road: RoadParameters
    network: RoadNetwork
    rng: np.random.Generator
    drives: dict[str, DriveDraft] = field(default_factory=dict)
    walks: dict[str, WalkDraft] = field(default_factory=dict)
    stands: dict[str, StandDraft] = field(default_factory=dict)
    objects: list[StaticObject] = field(default_factory=list)
    signals: SignalPlan | None = None
    paces: dict[tuple[int, float], float] = field(default_factory=dict)

    @property
    def ego(self) -> DriveDraft:
        """The ego's drive.

        Raises:
            MotionInfeasibleError: the ego does not drive.
        """
        name = self.functional.ego.id
        if name not in self.drives:
            raise MotionInfeasibleError("the ego must drive through the junction", where=name)
        return self.drives[name]

    @property
    def ring(self) -> bool:
        """Whether this is a roundabout."""
        return self.road.kind is JunctionKind.ROUNDABOUT

    def concerned(self, name: str) -> list[DriveDraft]:
        """Whose way somebody may come into: named sufferers first, then the ego, then others."""
        ranked = dict.fromkeys([*self.endangered_by(name), self.ego.id, *self.drives])
        return [self.drives[other] for other in ranked if other in self.drives]

    def runs_into_standing(self, name: str) -> bool:
        """Whether one is to touch another that stands on its arm: it comes no farther."""
        return any(self.contact_wanted(name, other) for other in self.logical.stand_before(name))

    def routes_of(self, draft: DriveDraft) -> tuple[Route, ...]:
        """The routes between a drive's arms.

        Raises:
            MotionInfeasibleError: there is none.
        """
        key = (draft.drive.entry, draft.drive.exit)
        routes = self.network.routes.get(key, ())
        if not routes:
            raise MotionInfeasibleError(
                f"no route leads from arm {key[0]} to arm {key[1]}", where=draft.id
            )
        return routes

    def entry_lanes(self, draft: DriveDraft) -> tuple[int, ...]:
        """The lanes from which a drive's exit can be reached, outermost first."""
        return tuple(sorted({r.entry_lane for r in self.routes_of(draft)}, reverse=True))

    def lanes_in(self, draft: DriveDraft) -> int:
        """Number of lanes towards the junction on a drive's entry arm."""
        return self.road.arms[draft.drive.entry].lanes_in

    def sets_off(self, name: str) -> bool:
        """Whether the first that one does is to set off: it stands until then."""
        return any(act.kind is ActKind.SET_OFF for act in self.speed_acts(name)[:1])

    def stands_at_line(self, name: str) -> bool:
        """Whether one who drives on is said to stand there from the start.

        Who waits for its light before one that stands does so, too.
        """
        one, drive = self.functional.participant(name), self.logical.assignment(name)
        stands = one.strip is None and one.speed_mps is not None and one.speed_mps.high == 0.0
        if one.light is AtLight.WAITS and isinstance(drive, Drive):
            line = (
                d for d in self.logical.drives if (d.entry, d.lane) == (drive.entry, drive.lane)
            )
            stands |= any(d.rank > drive.rank and self._stands(d) for d in line)
        return stands and not self.sets_off(name)

    def waits_for_green(self, name: str) -> bool:
        """Whether one is said to stand at its light and to go on, or does so from the start."""
        waits = self.functional.participant(name).light is AtLight.WAITS
        return waits or self.stands_at_line(name)

    def _stands(self, drive: Drive) -> bool:
        speed = self.functional.participant(drive.participant).speed_mps
        stays = drive.maneuver is Maneuver.STAY
        return stays or (speed is not None and speed.high == 0.0)
