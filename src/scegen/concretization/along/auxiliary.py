"""Where a lane begins or ends beside the others: laid around those who change out of it or into it.

The joint of the road is where a ramp's lane meets the others. Who merges comes along the ramp,
gains speed in the lane that ends, and leaves it well before; who takes the exit slows down in it.
"""

from __future__ import annotations

from math import ceil

from scegen.concretization.along.story import Story
from scegen.errors import MotionInfeasibleError
from scegen.road.ramps import gore_m
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import AuxiliaryLane

RAMP_MPS = 90 / 3.6
"""A usual speed on ramps of motorways and at the beginning of an acceleration lane."""
ON_RAMP_S = 3.0
"""So much later who merges changes lanes than others: it comes along the ramp first."""
GAINS_MPS2, LOSES_MPS2 = 1.5, 1.5
"""Comfortable rates with which who merges gains speed, and who leaves loses it."""
_SETTLES_M, _SPARE_M = 40.0, 30.0
_LEAST_SETTLES_M = 5.0
_LEAST_M = 60.0
_LONGEST_M = 600.0
_ROUND_M = 10.0


def joint_m(story: Story, otherwise_m: float) -> float:
    """Where the joint must be, by the first who merges or the last who leaves."""
    moves = _moves_m(story)
    if not moves:
        return otherwise_m
    first, last = min(begins for begins, _ in moves), max(ends for _, ends in moves)
    said = story.functional.junction.auxiliary_length_m
    settles = _SETTLES_M
    if said is not None:
        settles = min(settles, max(said - (last - first), _LEAST_SETTLES_M))
    leaves = story.functional.junction.auxiliary is AuxiliaryLane.OFF_RAMP
    return last + settles if leaves else first - settles


def fitted(road: RoadParameters, story: Story, joint: float) -> RoadParameters:
    """The road with its auxiliary lane long enough for all who use it.

    Raises:
        MotionInfeasibleError: they change lanes too far from each other for one.
    """
    if road.auxiliary is None:
        return road
    farthest = 0.0
    for begins, ends in _moves_m(story):
        off = road.auxiliary.kind is AuxiliaryLane.OFF_RAMP
        farthest = max(farthest, joint - begins if off else ends - joint)
    needed = ceil((farthest + _SPARE_M) / _ROUND_M) * _ROUND_M if farthest else 0.0
    said = story.functional.junction.auxiliary_length_m
    most = said or _LONGEST_M
    if farthest > most - (_SPARE_M if said is None else 0.0):
        raise MotionInfeasibleError(
            f"those who use the auxiliary lane would need {farthest:.0f} m of it",
            where="junction.auxiliary",
            hint=f"At most {most:g} m are built: let them change lanes sooner or nearer.",
        )
    if said is not None:
        return road
    length = max(road.auxiliary.length_m, needed)
    update = {"auxiliary": road.auxiliary.model_copy(update={"length_m": length})}
    return road.model_copy(update=update)


def room_m(road: RoadParameters) -> tuple[float, float]:
    """How long the road must be before the joint and beyond it."""
    auxiliary = road.auxiliary
    if auxiliary is None:
        return 0.0, 0.0
    lane = auxiliary.length_m + auxiliary.taper_m + _LEAST_M
    return _on_its_side(auxiliary.kind, gore_m(road) + _LEAST_M, lane)


def gaps_m(road: RoadParameters) -> tuple[float, float]:
    """How far from the joint the inner ends of arms 0 and 1 are."""
    auxiliary = road.auxiliary
    return (0.0, 0.0) if auxiliary is None else _on_its_side(auxiliary.kind, gore_m(road), 0.0)


def _on_its_side(kind: AuxiliaryLane, ramp: float, lane: float) -> tuple[float, float]:
    """What holds where the ramp is and where the lane is, before the joint and beyond it."""
    return (lane, ramp) if kind is AuxiliaryLane.OFF_RAMP else (ramp, lane)


def _moves_m(story: Story) -> list[tuple[float, float]]:
    """Where each who uses the auxiliary lane begins and ends its change of lane."""
    found = []
    for name in (story.merging | story.exiting) & story.runners.keys():
        runner = story.runners[name]
        lanes = [runner.lane, *(move.lane for move in runner.moves)]
        for move, before in zip(runner.moves, lanes, strict=False):
            if max(lanes) in {move.lane, before} and move.lane != before:
                found.append((runner.x_m(move.begins_s), runner.x_m(move.ends_s)))
    return found
