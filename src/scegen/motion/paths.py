"""The paths of a concrete scenario's participants."""

from dataclasses import dataclass, field
from functools import lru_cache

from scegen.errors import MotionInfeasibleError
from scegen.motion.doors import door_path
from scegen.motion.model import Path
from scegen.motion.polyline import LaidDrive
from scegen.motion.reversing import lay_way
from scegen.motion.routing import walk_route
from scegen.motion.standing import crossing_path, standing_path
from scegen.road.model import RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import (
    ConcreteScenario,
    CrossingMotion,
    DriveMotion,
    Motion,
    SwingingMotion,
)

END_MARGIN_M = 2.0
"""Paths end this far before the outer end of the exit arm: esmini must not run off the road."""
KEPT = 256
"""Drives that are kept: trials of one scenario differ in speeds more often than in ways."""
_TOLD = frozenset({"turning_starts_m", "turning_ends_m"})


def build_paths(concrete: ConcreteScenario, network: RoadNetwork) -> dict[str, Path]:
    """The path of every participant's reference point, by participant id.

    Args:
        concrete: the scenario.
        network: its road network, as ``scegen.road.build_network`` makes it.

    Raises:
        MotionInfeasibleError: a participant cannot move as its numbers say on these roads.
    """
    return {p.id: build_path(p.motion, p.body, network, p.id) for p in concrete.participants}


def build_path(motion: Motion, body: Body, network: RoadNetwork, who: str) -> Path:
    """The path of one participant; ``who`` names it in messages."""
    if isinstance(motion, DriveMotion):
        return lay_drive(network, motion, who).path
    if isinstance(motion, CrossingMotion):
        return crossing_path(network, motion, who)
    if isinstance(motion, SwingingMotion):
        return door_path(network, motion)
    return standing_path(network, motion, body, who)


@dataclass(frozen=True, slots=True)
class _Asked:
    """One question for a way: the ``same`` are the network itself, and all that shapes a drive.

    Where it turns is told of a way and does not shape it; nor does who drives it.
    """

    same: tuple[object, ...]
    network: RoadNetwork = field(compare=False)
    motion: DriveMotion = field(compare=False)
    who: str = field(compare=False)


def lay_drive(network: RoadNetwork, motion: DriveMotion, who: str) -> LaidDrive:
    """A drive laid out on the road, with stations for every vertex; nobody changes it.

    Raises:
        MotionInfeasibleError: no such route or lane, a lane change without room, or a start
            beyond the entry arm.
    """
    laid, arrived = lay_towards(network, motion, who)
    if arrived != motion.exit_lane:
        raise MotionInfeasibleError(
            f"the way ends in lane {arrived} of arm {motion.exit}, "
            f"not in exit_lane {motion.exit_lane}",
            where=who,
            hint=f"Set exit_lane to {arrived}, or change lanes on the exit arm.",
        )
    return laid


def lay_towards(network: RoadNetwork, motion: DriveMotion, who: str) -> tuple[LaidDrive, int]:
    """The same, and the lane in which it ends; ``exit_lane`` is only a wish here."""
    shape = (part for name, part in motion if name not in _TOLD)
    return _laid(_Asked((id(network), *shape), network, motion, who))


@lru_cache(maxsize=KEPT)
def _laid(asked: _Asked) -> tuple[LaidDrive, int]:
    network, motion, who = asked.network, asked.motion, asked.who
    stretches, arrived = walk_route(network, motion, who)
    entry_m = stretches[0].end_m
    end_m = stretches[-1].end_m - END_MARGIN_M
    latest = end_m if network.plain else entry_m
    if motion.start_m >= latest:
        raise MotionInfeasibleError(
            f"starts {motion.start_m:.1f} m along the drive, but arm {motion.entry} ends after "
            f"{latest:.1f} m",
            where=who,
            hint="Start earlier or make the arm longer.",
        )
    return lay_way(network, motion, stretches, end_m, who), arrived
