"""Arms: the open road ends of a network, and which arm of a concrete scenario each one is."""

from cmath import phase
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import degrees, remainder
from typing import NamedTuple

from scegen.checking.opendrive.lanes import driving, reference
from scegen.checking.opendrive.locate import OnLane
from scegen.checking.opendrive.network import END, START, Network, Road, other_end, road_place
from scegen.checking.results import Finding, error
from scegen.road.ramps import gore_m
from scegen.scenario.concrete import ConcreteScenario

ANGLE_DEG = 5.0
"""How far an arm's outer end may lie beside the direction that the scenario gives it."""
STRIPS = frozenset({"biking", "parking", "shoulder", "sidewalk"})
"""Types of lanes beside the driving ones on which one may stand, ride or walk."""


@dataclass(frozen=True)
class Arm:
    """An open end of a road outside junctions; lanes ``inward`` lead away from that end."""

    road: Road
    contact: str

    @property
    def inward(self) -> list[int]:
        """Driving lanes that lead to the junction, the innermost first."""
        return [n for n in self._lanes() if not self.road.leads_to(n, self.contact)]

    @property
    def outward(self) -> list[int]:
        """Driving lanes that lead out of the network, the innermost first."""
        return [n for n in self._lanes() if self.road.leads_to(n, self.contact)]

    @property
    def strips(self) -> list[int]:
        """Strips beside the lanes that lead to the junction, outwards."""
        return self._beside(self.inward)

    def numbered_in(self, number: int) -> set[int]:
        """The lane that leads in by its number; beyond the driving ones come the strips."""
        return {*[*self.inward, *self.strips][number - 1 : number]}

    def numbered_out(self, number: int) -> set[int]:
        """The lane that leads out by its number, likewise."""
        return {*[*self.outward, *self._beside(self.outward)][number - 1 : number]}

    def under(self, lanes: Iterable[OnLane]) -> set[int]:
        """Which of its lanes are among those that a point lies on."""
        return {lane.lane for lane in lanes if lane.road == self.road.id}

    def _beside(self, lanes: list[int]) -> list[int]:
        section = self.road.section(self.contact)
        side = {n > 0 for n in lanes}
        found = [n for n, x in section.lanes.items() if x.type in STRIPS and (n > 0) in side]
        return sorted(found, key=abs)

    @property
    def inner(self) -> str:
        """The end of the road at the junction."""
        return other_end(self.contact)

    @property
    def place(self) -> str:
        """How findings name it."""
        return road_place(self.road.id, self.contact)

    def _lanes(self) -> list[int]:
        return sorted(driving(self.road.section(self.contact)), key=abs)


class MatchedArms(NamedTuple):
    """The arm roads by arm number; empty where ``findings`` says that they do not fit."""

    arms: dict[int, Arm]
    findings: tuple[Finding, ...]


def open_ends(network: Network) -> Iterator[Arm]:
    """The road ends that lead out of the network."""
    for road in network.roads.values():
        for contact in (START, END):
            if road.junction is None and road.link(contact) is None:
                yield Arm(road, contact)


def ramp_of(network: Network, arms: dict[int, Arm]) -> Arm | None:
    """The open end beside those of the arms: that of a ramp."""
    known = {arm.road.id for arm in arms.values()}
    return next((end for end in open_ends(network) if end.road.id not in known), None)


def match_arms(network: Network, concrete: ConcreteScenario) -> MatchedArms:
    """Find each arm by the direction in which its outer end lies, not by ids or names.

    ``xodr.arms``: as many open ends as arms (and a ramp, if the road has one), each within 5° of
    its direction.
    """
    free = [arm for arm in open_ends(network) if arm.road.measurable]
    ramps = 1 if gore_m(concrete.road) else 0
    if len(free) != len(concrete.road.arms) + ramps:
        and_ramps = " and a ramp" if ramps else ""
        message = f"has {len(free)} open road ends for {len(concrete.road.arms)} arms{and_ramps}"
        return MatchedArms({}, (error("xodr.arms", network.name, message),))
    arms: dict[int, Arm] = {}
    for wanted in concrete.road.arms:
        off, number = min((_off(arm, wanted.angle_deg), i) for i, arm in enumerate(free))
        if off > ANGLE_DEG:
            message = f"no road leads out at {wanted.angle_deg:g}°; the nearest is {off:.1f}° off"
            return MatchedArms({}, (error("xodr.arms", f"arm {wanted.id}", message),))
        arms[wanted.id] = free.pop(number)
    return MatchedArms(arms, ())


def _off(arm: Arm, angle_deg: float) -> float:
    point = reference(arm.road, arm.road.s_at(arm.contact))[0]
    return abs(remainder(degrees(phase(point)) - angle_deg, 360.0))
