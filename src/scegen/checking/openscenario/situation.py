"""A scenario on its road, and what the concrete scenario beside it asks for."""

from cmath import exp
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scegen.checking.opendrive.arms import Arm, ramp_of
from scegen.checking.opendrive.lanes import lane_pose, reference, section_at
from scegen.checking.opendrive.locate import OnLane, lanes_at
from scegen.checking.opendrive.network import Network
from scegen.checking.openscenario.storyboard import LanePoint, Storyboard, WorldPoint
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario


@dataclass(frozen=True)
class Situation:
    """What the rules look at; ``concrete`` and ``arms`` are empty for files from elsewhere."""

    storyboard: Storyboard
    network: Network | None
    concrete: ConcreteScenario | None
    arms: dict[int, Arm]

    def participant(self, entity: str) -> ConcreteParticipant | None:
        """The participant of the concrete scenario with an entity's name."""
        if self.concrete is None:
            return None
        return next((p for p in self.concrete.participants if p.id == entity), None)

    @property
    def ramp(self) -> Arm | None:
        """The outer end of a ramp, where the road has one."""
        return ramp_of(self.network, self.arms) if self.network and self.arms else None

    def lanes_at(self, points: Sequence[complex]) -> list[list[OnLane]]:
        """The lanes under each point; nothing without a road."""
        if self.network is None:
            return [[] for _ in points]
        return lanes_at(self.network, np.array(points, dtype=np.complex128))

    def in_world(self, position: WorldPoint | LanePoint | None) -> complex | None:
        """A position as x + iy; None if it cannot be placed."""
        if position is None or isinstance(position, WorldPoint):
            return position.point if position else None
        road = self.network.roads.get(position.road) if self.network else None
        if road is None or not road.measurable:
            return None
        section = section_at(road, position.s)
        if position.lane not in section.lanes or position.lane == 0:
            return None
        centre = lane_pose(road, section, position.lane, position.s).centre
        return centre + 1j * position.offset * exp(1j * reference(road, position.s)[1])
