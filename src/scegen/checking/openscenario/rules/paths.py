"""Trajectories lie where the concrete scenario says: on lanes, and out by the exit arm."""

from collections.abc import Iterator, Sequence
from itertools import islice

import numpy as np

from scegen.checking.opendrive.arms import STRIPS
from scegen.checking.opendrive.locate import OnLane, in_words
from scegen.checking.openscenario.rules.trajectories import backwards_m
from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Trajectory
from scegen.checking.results import Finding, error
from scegen.scenario.concrete import (
    ConcreteParticipant,
    CrossingMotion,
    DriveMotion,
    StandingMotion,
)
from scegen.scenario.reversing import BacksOut
from scegen.scenario.vocabulary import ON_FOOT

BESIDE_M = 1.0
"""Who keeps so far beside the middle of its lane may be above the next one."""


def check_paths(situation: Situation) -> Iterator[Finding]:
    """``xosc.off_road``, ``xosc.exit``, ``xosc.crossing``, ``xosc.missing_trajectory``.

    ``xosc.external``: who is driven from outside has no trajectory.
    """
    people = situation.concrete.participants if situation.concrete else ()
    under = _under(situation, [p.id for p in people if isinstance(p.motion, DriveMotion)])
    for participant in people:
        trajectory = situation.storyboard.trajectory(participant.id)
        motion = participant.motion
        if participant.id in situation.storyboard.driven_from_outside:
            if trajectory is not None:
                message = "is said to be driven from outside, but has a trajectory"
                yield error("xosc.external", participant.id, message)
        elif not isinstance(motion, StandingMotion) and trajectory is None:
            yield error("xosc.missing_trajectory", participant.id, "moves but has no trajectory")
        elif trajectory is None or not situation.arms or not len(trajectory.points):
            continue
        elif isinstance(motion, DriveMotion):
            yield from _drive(situation, participant, motion, trajectory, under[participant.id])
        elif isinstance(motion, CrossingMotion):
            yield from _crossing(situation, participant.id, motion, trajectory)


def _under(situation: Situation, names: Sequence[str]) -> dict[str, list[list[OnLane]]]:
    """The lanes under every vertex of trajectories, looked for at once: that is quicker."""
    ways = [(name, situation.storyboard.trajectory(name)) for name in names]
    points = {name: way.points for name, way in ways if way is not None}
    lanes = iter(situation.lanes_at([point for way in points.values() for point in way]))
    return {name: list(islice(lanes, len(way))) for name, way in points.items()}


def _drive(
    situation: Situation,
    participant: ConcreteParticipant,
    motion: DriveMotion,
    trajectory: Trajectory,
    under: Sequence[list[OnLane]],
) -> Iterator[Finding]:
    name, on_foot = participant.id, participant.kind in ON_FOOT
    inward = situation.arms[motion.entry].inward
    numbers = [motion.entry_lane, *(change.lane_after for change in motion.lane_changes)]
    on_a_strip = max(numbers) > len(inward)
    usable = {"driving", *STRIPS} if on_a_strip or on_foot else {"driving"}
    beside = _comes_from_beside(motion, trajectory)
    for number, (vertex, lanes) in enumerate(zip(trajectory.points, under, strict=True)):
        if number >= beside and all(lane.type not in usable for lane in lanes):
            at = f"({vertex.real:.2f}, {vertex.imag:.2f})"
            yield error("xosc.off_road", name, f"vertex {number} {at} lies on no driving lane")
            break
    if isinstance(motion.reversal, BacksOut) and motion.reversal.straight_m is not None:
        return  # it stays where it has come to
    if situation.network is not None and not situation.network.junctions and _is_aside(motion):
        return  # off the middle of its lane: which lane is below it says nothing
    arm = situation.arms[motion.exit]
    number = motion.exit_lane
    if situation.ramp is not None and number > len(arm.outward):
        arm, number = situation.ramp, 1
    # Lane 0 is that of the oncoming: it stays there.
    wanted = arm.numbered_out(number) if number else {*arm.inward[:1]}
    if not arm.under(under[-1]) & wanted:
        said = in_words(under[-1])
        message = f"ends on {said} instead of arm {motion.exit} ({arm.place}) lane {sorted(wanted)}"
        yield error("xosc.exit", name, message)


def _is_aside(motion: DriveMotion) -> bool:
    """Whether a drive ends beside the middle of its lane."""
    last = motion.lane_changes[-1].offset_m if motion.lane_changes else motion.offset_m
    return abs(last) > BESIDE_M


def _comes_from_beside(motion: DriveMotion, trajectory: Trajectory) -> int:
    """How many vertices lead one that backs out from beside the road onto it.

    Straight back it may come across, and beyond it.
    """
    reversal = motion.reversal
    if not isinstance(reversal, BacksOut):
        return 0
    if reversal.straight_m is not None:
        return len(trajectory.points)
    if reversal.side is None:
        return 0
    last = max((ends for _, ends in backwards_m(trajectory)), default=0.0)
    passed = np.abs(np.diff(trajectory.points)).cumsum()
    return int((passed < last - 0.01).sum()) + 1


def _crossing(
    situation: Situation, name: str, motion: CrossingMotion, trajectory: Trajectory
) -> Iterator[Finding]:
    arm = situation.arms[motion.arm]
    first, last = trajectory.points[0], trajectory.points[-1]
    # Sampled finely: the vertices of a walk straight across may all lie beside the lanes.
    count = max(2, int(abs(last - first) / 0.5))
    line = [first + (last - first) * i / count for i in range(count + 1)]
    crossed = set().union(*(arm.under(lanes) for lanes in situation.lanes_at(line)))
    missing = {*arm.inward, *arm.outward} - crossed
    if missing and (motion.stops_after_m is None or not crossed):
        message = f"does not cross lanes {sorted(missing)} of arm {motion.arm} ({arm.place})"
        yield error("xosc.crossing", name, message)
