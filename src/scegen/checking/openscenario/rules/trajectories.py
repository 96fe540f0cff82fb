"""Trajectories are smooth, begin at the start, and rise in time."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from itertools import pairwise
from math import degrees

from scegen.checking.opendrive.tolerances import heading_step
from scegen.checking.openscenario.situation import Situation
from scegen.checking.openscenario.storyboard import Trajectory
from scegen.checking.results import Finding, error

LONGEST_STEP_M = 10.0
"""Vertices farther apart than this must lie straight ahead of each other, or it is a jump."""
STRAIGHT_DEG = 1.0
SHARPEST_DEG = 10.0
"""Largest turn from one chord to the next, and of a vertex's heading against its chords."""
START_M = 0.05
"""How far the first vertex may lie from where Init puts the entity."""


def check_trajectories(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory``: times, steps, turns and headings of every polyline."""
    for trajectory in situation.storyboard.trajectories:
        place = ", ".join(trajectory.actors) or trajectory.name
        yield from _times(trajectory, place)
        yield from _shape(trajectory, place)


def check_trajectory_starts(situation: Situation) -> Iterator[Finding]:
    """``xosc.trajectory_start``: an entity stands at the first vertex of its trajectory."""
    for entity in situation.storyboard.entities:
        trajectory = situation.storyboard.trajectory(entity.name)
        start = situation.in_world(situation.storyboard.start(entity.name))
        if trajectory and trajectory.points and start is not None:
            gap = abs(trajectory.points[0].point - start)
            if gap > START_M:
                message = f"starts {gap:.2f} m from the first vertex of its trajectory"
                yield error("xosc.trajectory_start", entity.name, message)


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
    for number, chord in enumerate(chords):
        ahead = points[number : number + 2]
        offs = [degrees(heading_step(phase(chord), vertex.heading)) for vertex in ahead]
        straight = max(abs(off) for off in offs) <= STRAIGHT_DEG
        if abs(chord) < 1e-6 or (abs(chord) > LONGEST_STEP_M and not straight):
            message = f"vertices {number} and {number + 1} are {abs(chord):.3f} m apart"
            yield error("xosc.trajectory", place, message)
            return
        if number and abs(turn := degrees(phase(chord / chords[number - 1]))) > SHARPEST_DEG:
            message = f"turns by {turn:.1f}° at vertex {number}"
            yield error("xosc.trajectory", place, message)
            return
        if abs(offs[0]) > SHARPEST_DEG:
            message = f"the heading of vertex {number} is {offs[0]:.1f}° off its way"
            yield error("xosc.trajectory", place, message)
            return
