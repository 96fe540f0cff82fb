"""Trajectories are smooth, begin at the start, rise in time, and lead backwards only if asked.

A body may go against its heading: straight against it, and from and to a point at which it turns
round without turning. How far is for the concrete scenario to say.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from scegen.checking.opendrive.tolerances import heading_step
from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Trajectory, WorldPoint
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
        yield from _times(trajectory, _place(trajectory))
        yield from _backwards(situation, trajectory, _place(trajectory))


def check_trajectory_shapes(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory``: steps, turns and headings of every polyline."""
    for trajectory in situation.storyboard.trajectories:
        yield from _shape(trajectory, _place(trajectory))


def check_trajectory_starts(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory_start``: an entity stands where it begins to follow its trajectory."""
    for entity in situation.storyboard.entities:
        trajectory = situation.storyboard.trajectory(entity.name)
        start = situation.in_world(situation.storyboard.start(entity.name))
        if trajectory and trajectory.points and start is not None:
            begins = trajectory.at(trajectory.begins_m)
            if begins is None:
                message = f"its trajectory ends before {trajectory.begins_m:.2f} m"
                yield error("xosc.trajectory_start", entity.name, message)
            elif (gap := abs(begins.point - start)) > START_M:
                message = f"starts {gap:.2f} m from where its trajectory begins"
                yield error("xosc.trajectory_start", entity.name, message)


def _place(trajectory: Trajectory) -> str:
    return ", ".join(trajectory.actors) or trajectory.name


def _times(trajectory: Trajectory, place: str) -> Iterator[Finding]:
    stated = [time for time in trajectory.times if time is not None]
    if any(later < earlier for earlier, later in pairwise(stated)):
        yield error("xosc.trajectory", place, "the times of its vertices do not rise")


def _shape(trajectory: Trajectory, place: str) -> Iterator[Finding]:
    points = trajectory.points
    if len(points) < 2:
        yield error("xosc.trajectory", place, "its trajectory has fewer than two vertices")
        return
    chords = [b.point - a.point for a, b in pairwise(points)]
    ways = [chord * _sense(chord, point) for chord, point in zip(chords, points, strict=False)]
    for number, (chord, way) in enumerate(zip(chords, ways, strict=True)):
        ahead = points[number : number + 2]
        offs = [degrees(heading_step(phase(way), vertex.heading)) for vertex in ahead]
        straight = max(abs(off) for off in offs) <= STRAIGHT_DEG
        if abs(chord) < 1e-6 or (abs(chord) > LONGEST_STEP_M and not straight):
            message = f"vertices {number} and {number + 1} are {abs(chord):.3f} m apart"
            yield error("xosc.trajectory", place, message)
            return
        if number and abs(turn := degrees(phase(way / ways[number - 1]))) > SHARPEST_DEG:
            message = f"turns by {turn:.1f}° at vertex {number}"
            yield error("xosc.trajectory", place, message)
            return
        if abs(offs[0]) > SHARPEST_DEG:
            message = f"the heading of vertex {number} is {offs[0]:.1f}° off its way"
            yield error("xosc.trajectory", place, message)
            return


def _sense(chord: complex, start: WorldPoint) -> int:
    """1 where a body goes the way it heads, -1 where it goes backwards."""
    return -1 if abs(degrees(heading_step(phase(chord), start.heading))) > BACKWARDS_DEG else 1


def backwards_m(trajectory: Trajectory) -> list[tuple[float, float]]:
    """The parts of a trajectory on which its body goes backwards: from and to, along it (m)."""
    parts: list[tuple[float, float]] = []
    at = 0.0
    for a, b in pairwise(trajectory.points):
        chord = b.point - a.point
        if _sense(chord, a) < 0:
            begins = parts.pop()[0] if parts and parts[-1][1] == at else at
            parts.append((begins, at + abs(chord)))
        at += abs(chord)
    return parts


def _backwards(situation: Situation, trajectory: Trajectory, place: str) -> Iterator[Finding]:
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
        yield error("xosc.reversing", place, message)
