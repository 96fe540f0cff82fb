"""Random scenarios in which cars are in each other's way, for the benchmarks.

Every junction kind, two to five cars at any arms, one or two lanes, any control, limits from 30
to 100 km/h, both driving sides. The same generator state gives the same scenarios.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeVar

import numpy as np

from scegen.enumeration import enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.logical import Assignment, ConflictKind, Drive, LogicalScenario
from scegen.scenario.vocabulary import (
    Control,
    DrivingSide,
    JunctionKind,
    Maneuver,
    Reduction,
    Role,
)

LIMITS_KMH = (30, 50, 70, 100)
MOST_CARS = 5
_MOST_ARMS = 6
_ALONG = {1: (Maneuver.OVERTAKE,), 2: (Maneuver.LANE_CHANGE, Maneuver.OVERTAKE)}
"""What a car may do on a road without a crossing but follow it, by its lanes."""
_T = TypeVar("_T")


def draw(
    kind: JunctionKind, rng: np.random.Generator
) -> Iterator[tuple[FunctionalScenario, LogicalScenario]]:
    """Scenarios of one junction kind with at least two cars in conflict, without end."""
    while True:
        functional = _functional(kind, rng)
        try:
            listed = enumerate_scenarios(functional, reduction=Reduction.PATTERN).scenarios
        except NoScenarioError:
            continue
        logical = listed[int(rng.integers(len(listed)))]
        in_conflict = any(c.kind is not ConflictKind.NONE for c in logical.conflicts)
        if in_conflict and all(_has_whom_to_overtake(drive) for drive in logical.assignments):
            yield functional, logical


def _has_whom_to_overtake(drive: Assignment) -> bool:
    return not (isinstance(drive, Drive) and drive.maneuver is Maneuver.OVERTAKE and not drive.rank)


def _functional(kind: JunctionKind, rng: np.random.Generator) -> FunctionalScenario:
    fewest, most = ARM_COUNTS[kind]
    arms = int(
        rng.integers(
            max(fewest, 5 if kind is JunctionKind.MULTI_WAY else 0), min(most, _MOST_ARMS) + 1
        )
    )
    ring = int(rng.integers(1, 3)) if kind is JunctionKind.ROUNDABOUT else None
    lanes = int(rng.integers(1, 3))
    junction = Junction(
        kind=kind,
        arms=arms,
        lanes=(lanes,) * arms,
        ring_lanes=ring,
        speed_limit_mps=_one(rng, LIMITS_KMH) / 3.6,
        driving_side=DrivingSide.LEFT if rng.random() < 0.2 else DrivingSide.RIGHT,
        control=_one(rng, _controls(kind)),
    )
    odd = int(rng.integers(2 * MOST_CARS))  # who changes lanes or overtakes on a straight road
    cars = tuple(
        Participant(
            id="ego" if n == 0 else f"car_{n}",
            role=Role.EGO if n == 0 else Role.OTHER,
            entries=frozenset({int(rng.integers(arms))}),
            maneuvers=frozenset({_one(rng, _ALONG[lanes])})
            if n == odd and kind is JunctionKind.STRAIGHT
            else frozenset(),
        )
        for n in range(int(rng.integers(2, MOST_CARS + 1)))
    )
    return FunctionalScenario(description=f"drawn: {kind}", junction=junction, participants=cars)


def _controls(kind: JunctionKind) -> tuple[Control, ...]:
    if kind is JunctionKind.STRAIGHT:
        return (Control.UNCONTROLLED,)
    if kind is JunctionKind.ROUNDABOUT:
        return (Control.UNCONTROLLED, Control.YIELD)
    return tuple(Control)


def _one(rng: np.random.Generator, values: Sequence[_T]) -> _T:
    return values[int(rng.integers(len(values)))]
