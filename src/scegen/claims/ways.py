"""What the predicates know of the participants' ways beside the movements."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from scegen.motion.batch.arrays import Floats
from scegen.motion.lanes import arm_lane_id
from scegen.motion.model import Path
from scegen.motion.paths import build_path, lay_drive
from scegen.motion.polyline import LaidDrive
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario, DriveMotion, LaneChange

_INTO_EXIT_M = 20.0
_BEHIND_CHANGE_M = 5.0
_BEHIND_REVERSING_M = 10.0
_WALKED_M = 0.5


@dataclass(frozen=True, slots=True)
class Sideways:
    """A lane change: from ``start_m`` to ``end_m`` of the path, ``width_m`` to the side."""

    start_m: float
    end_m: float
    width_m: float
    change: LaneChange


@dataclass(frozen=True)
class Way:
    """One participant's way; positions are along its path, m.

    ``turn_start_m`` and ``turn_end_m`` are where the junction begins and ends, ``goal_m`` how far
    it must come before the scenario may end, unless it ``halts``; ``lanes_in`` is the number of
    lanes of its entry arm, ``line_m`` where that has its stop line; ``whole`` is the same way from
    the outer end of its entry arm, on which it starts at ``starts_m``: None of one that is no such
    part, and where no ways cross.
    """

    participant: ConcreteParticipant
    path: Path
    limit_mps: float
    turn_start_m: float
    turn_end_m: float
    goal_m: float
    changes: tuple[Sideways, ...] = ()
    laid: LaidDrive | None = None
    lanes_in: int = 0
    line_m: float = 0.0
    whole: Path | None = None
    starts_m: float = 0.0

    @property
    def sets_off(self) -> bool:
        """Whether it stands at first and is to move."""
        return self.participant.speed_mps == 0.0 and bool(self.participant.speed_program)

    @property
    def halts(self) -> bool:
        """Whether a driver ends at rest: it stops on its way and stays, or stands all the time."""
        speeds = [p.target_speed_mps for p in self.participant.speed_program]
        drives = isinstance(self.participant.motion, DriveMotion)
        return drives and [self.participant.speed_mps, *speeds][-1] == 0.0

    def curvature_1pm(self, s_m: Floats) -> Floats:
        """The change of heading per metre at places: that in the middle of every piece, between."""
        path, step = self.path, np.diff(self.path.s_m)
        if not step.size:
            return np.zeros_like(s_m)
        bends = np.abs(np.diff(path.heading_rad)) / step
        return np.interp(s_m, path.s_m[:-1] + step / 2, bends)


def ways_of(concrete: ConcreteScenario, network: RoadNetwork) -> dict[str, Way]:
    """The ways of all participants, by id, from where they start.

    Raises:
        MotionInfeasibleError: somebody cannot move as its numbers say.
    """
    return {p.id: _way(p, concrete, network) for p in concrete.participants}


def paths_of(ways: Mapping[str, Way]) -> dict[str, Path]:
    """Their paths."""
    return {name: way.path for name, way in ways.items()}


def _way(participant: ConcreteParticipant, concrete: ConcreteScenario, network: RoadNetwork) -> Way:
    motion = participant.motion
    if not isinstance(motion, DriveMotion):
        path = build_path(motion, participant.body, network, participant.id)
        limit = concrete.road.arms[motion.arm].speed_limit_mps
        goal = max(0.0, path.length_m - _WALKED_M) if motion.type == "crossing" else 0.0
        return Way(participant, path, limit, 0.0, path.length_m, goal)
    laid = lay_drive(network, motion, participant.id)
    arms = concrete.road.arms
    width, lanes = arms[motion.entry].lane_width_m, arms[motion.entry].lanes_in
    numbers: dict[int, float] = {}
    if motion.entry_lane > lanes and concrete.road.auxiliary is None:
        # Off a strip: how many lanes' widths lie between it and the lane beside it.
        road = network.arm_road(motion.entry)
        strip, beside = (
            road.lane_centre_t_m(arm_lane_id(road, number, inbound=True))
            for number in (motion.entry_lane, lanes)
        )
        numbers = {motion.entry_lane: lanes + abs(strip - beside) / width}
    first = motion.lane_changes[0].position_m if motion.lane_changes else 0.0
    in_ring = motion.ring_lane is not None and first >= laid.turning_starts_m
    said = [((motion.ring_lane or 1) if in_ring else motion.entry_lane, motion.offset_m)]
    said += [(change.lane_after, change.offset_m) for change in motion.lane_changes]
    places = [(numbers.get(number, number), offset) for number, offset in said]
    changes = tuple(
        Sideways(
            laid.path_s_m(change.position_m),
            laid.path_s_m(change.position_m + change.length_m),
            abs((after[0] - before[0]) * width + before[1] - after[1]),
            change,
        )
        for change, before, after in zip(motion.lane_changes, places, places[1:], strict=False)
    )
    turn_end = laid.path_s_m(laid.turning_ends_m)
    leaves = [0.0] if network.plain else [turn_end + _INTO_EXIT_M]
    goal = max([*leaves, *(c.end_m + _BEHIND_CHANGE_M for c in changes)])
    goal = max([goal, *(ends_m + _BEHIND_REVERSING_M for _, ends_m in laid.path.backwards)])
    whole = None
    if motion.reversal is None and not network.plain:
        outer = motion.but(start_m=0.0)
        whole = lay_drive(network, outer, participant.id)
    return Way(
        participant=participant,
        path=laid.path,
        limit_mps=max(arms[motion.entry].speed_limit_mps, arms[motion.exit].speed_limit_mps),
        turn_start_m=laid.path_s_m(laid.turning_starts_m),
        turn_end_m=turn_end,
        goal_m=min(goal, laid.path.length_m) - 1e-3,
        changes=changes,
        laid=laid,
        lanes_in=arms[motion.entry].lanes_in,
        line_m=laid.path_s_m(laid.turning_starts_m) - network.arm_road(motion.entry).stop_line_m,
        whole=None if whole is None else whole.path,
        starts_m=0.0 if whole is None else whole.path_s_m(motion.start_m),
    )
