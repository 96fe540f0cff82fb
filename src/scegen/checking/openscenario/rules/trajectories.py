"""Trajectories are smooth, begin at the start, rise in time, and lead backwards only if asked.

A body may go against its heading: straight against it, and from and to a point at which it turns
round without turning. How far is for the concrete scenario to say.
"""

from collections.abc import Iterator
from math import pi

import numpy as np
from numpy.typing import NDArray

from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Trajectory
from scegen.checking.results import Finding, error
from scegen.scenario.concrete import DriveMotion
from scegen.scenario.reversing import BacksOut, BacksUp

LONGEST_STEP_M = 10.0
"""Vertices farther apart than this must lie straight ahead of each other, or it is a jump."""
STRAIGHT_DEG = 1.0
SHARPEST_DEG = 10.0
"""Largest turn from one chord to the next, and of a vertex's heading against its chords."""
BACKWARDS_DEG = 120.0
"""A chord that points so far away from the heading is driven backwards."""
ROLLS_AT_MOST_M = 0.5
"""One that comes out backwards rolls forwards so far at most before it does."""
BACK_OFF = 0.15
"""How far the way back may be off its length, which counts along the middle of a lane."""
START_M = 0.05
"""How far the first vertex may lie from where Init puts the entity."""


def check_trajectories(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory``: times rise; ``xosc.reversing``: backwards only where that is asked."""
    for trajectory in situation.storyboard.trajectories:
        yield from _times(trajectory)
        yield from _backwards(situation, trajectory)


def check_trajectory_shapes(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory``: steps, turns and headings of every polyline."""
    for trajectory in situation.storyboard.trajectories:
        yield from _shape(trajectory)


def check_trajectory_starts(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory_start``: an entity stands where it begins to follow its trajectory."""
    for entity in situation.storyboard.entities:
        trajectory = situation.storyboard.trajectory(entity.name)
        start = situation.in_world(situation.storyboard.starts.get(entity.name))
        if trajectory and len(trajectory.points) and start is not None:
            begins = trajectory.at(trajectory.begins_m)
            if begins is None:
                message = f"its trajectory ends before {trajectory.begins_m:.2f} m"
                yield error("xosc.trajectory_start", entity.name, message)
            elif (gap := abs(begins.point - start)) > START_M:
                message = f"starts {gap:.2f} m from where its trajectory begins"
                yield error("xosc.trajectory_start", entity.name, message)


def _times(trajectory: Trajectory) -> Iterator[Finding]:
    stated = trajectory.times[~np.isnan(trajectory.times)]
    if (np.diff(stated) < 0.0).any():
        yield error("xosc.trajectory", trajectory.place, "the times of its vertices do not rise")


def _shape(trajectory: Trajectory) -> Iterator[Finding]:
    points = trajectory.points
    if len(points) < 2:
        yield error(
            "xosc.trajectory", trajectory.place, "its trajectory has fewer than two vertices"
        )
        return
    chords = np.diff(points)
    ways = np.where(_backwards_at(trajectory), -chords, chords)
    offs = _turn_deg(np.angle(ways), trajectory.headings[:-1])
    onward = _turn_deg(np.angle(ways), trajectory.headings[1:])
    straight = np.maximum(np.abs(offs), np.abs(onward)) <= STRAIGHT_DEG
    length = np.abs(chords)
    apart = (length < 1e-6) | ((length > LONGEST_STEP_M) & ~straight)
    turns = np.degrees(np.angle(ways * np.roll(ways, 1).conj()))
    turns[0] = 0.0
    wrong = apart | (np.abs(turns) > SHARPEST_DEG) | (np.abs(offs) > SHARPEST_DEG)
    if not wrong.any():
        return
    number = int(wrong.argmax())
    if apart[number]:
        message = f"vertices {number} and {number + 1} are {length[number]:.3f} m apart"
    elif abs(turns[number]) > SHARPEST_DEG:
        message = f"turns by {turns[number]:.1f}° at vertex {number}"
    else:
        message = f"the heading of vertex {number} is {offs[number]:.1f}° off its way"
    yield error("xosc.trajectory", trajectory.place, message)


def _turn_deg(before: NDArray[np.float64], after: NDArray[np.float64]) -> NDArray[np.float64]:
    """The changes of heading."""
    return np.degrees((after - before + pi) % (2 * pi) - pi)


def _backwards_at(trajectory: Trajectory) -> NDArray[np.bool_]:
    """On which chords a body goes backwards, against its heading."""
    chords = np.angle(np.diff(trajectory.points))
    return np.abs(_turn_deg(chords, trajectory.headings[:-1])) > BACKWARDS_DEG


def backwards_m(trajectory: Trajectory) -> list[tuple[float, float]]:
    """The parts of a trajectory on which its body goes backwards: from and to, along it (m)."""
    passed = np.abs(np.diff(trajectory.points)).cumsum()
    along = [0.0, *passed.tolist()]
    edges = np.flatnonzero(np.diff(_backwards_at(trajectory), prepend=False, append=False))
    return [(along[begins], along[ends]) for begins, ends in edges.reshape(-1, 2)]


def _backwards(situation: Situation, trajectory: Trajectory) -> Iterator[Finding]:
    """``xosc.reversing``: it goes backwards where the concrete scenario says, and only there."""
    if situation.concrete is None or len(trajectory.points) < 2:
        return
    parts = backwards_m(trajectory)
    for actor in trajectory.actors:
        participant = situation.participant(actor)
        motion = participant.motion if participant else None
        asked = motion.reversal if isinstance(motion, DriveMotion) else None
        total = sum(ends - begins for begins, ends in parts)
        if asked is None and parts:
            message = f"heads against its way for {total:.1f} m, but does not reverse"
        elif asked is not None and len(parts) != 1:
            message = f"should reverse once, but goes backwards {len(parts)} times"
        elif isinstance(asked, BacksUp) and abs(total - asked.length_m) > BACK_OFF * total:
            message = f"should go {asked.length_m:.1f} m back, but does for {total:.1f} m"
        elif isinstance(asked, BacksOut) and parts[0][0] > ROLLS_AT_MOST_M:
            message = f"should come out backwards, but first goes {parts[0][0]:.1f} m forwards"
        else:
            continue
        yield error("xosc.reversing", trajectory.place, message)
