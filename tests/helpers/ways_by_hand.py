"""Hand-made functional and logical scenarios: the tests of motion do not need enumeration."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import pytest

from scegen.scenario.arms import arm_angles_deg, exit_arm, turn_name
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Assignment, Crossing, Drive, LogicalScenario, Standing
from scegen.scenario.vocabulary import (
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
    Side,
)

Made = tuple[FunctionalScenario, LogicalScenario]


def make_scenario(
    kind: str,
    arms: int,
    drives: Sequence[dict[str, Any]],
    hazards: Sequence[tuple[str, Sequence[str], Sequence[str]]] = (),
    crossings: Sequence[tuple[int, str]] = (),
    standings: Sequence[tuple[int, str, bool]] = (),
    **junction: Any,
) -> Made:
    """The first drive is the ego, then car_1, car_2; walkers are ped_0, parked parked_0."""
    place = Junction(kind=JunctionKind(kind), arms=arms, **junction)
    angles = arm_angles_deg(place)
    people: list[Participant] = []
    assignments: list[Assignment] = []
    for number, drive in enumerate(drives):
        name = f"car_{number}" if number else "ego"
        role = Role.OTHER if number else Role.EGO
        people.append(Participant(id=name, role=role))
        turn = turn_name(angles, drive["entry"], drive["move"])
        assignments.append(
            Drive(
                participant=name,
                exit=exit_arm(drive["entry"], drive["move"], arms),
                turn=turn,
                **({"maneuver": turn} | drive),
            )
        )
    for number, (arm, side) in enumerate(crossings):
        name = f"ped_{number}"
        people.append(Participant(id=name, kind=ParticipantKind.PEDESTRIAN))
        assignments.append(Crossing(participant=name, arm=arm, start=Side(side)))
    for number, (arm, side, in_lane) in enumerate(standings):
        name = f"parked_{number}"
        people.append(Participant(id=name, parked=True))
        assignments.append(Standing(participant=name, arm=arm, side=Side(side), in_lane=in_lane))
    functional = FunctionalScenario(
        description="made by hand",
        junction=place,
        participants=tuple(people),
        hazards=tuple(
            Hazard(kind=HazardKind(k), by=tuple(by), to=tuple(to)) for k, by, to in hazards
        ),
    )
    logical = LogicalScenario(index=0, slug="by-hand", pattern=(), assignments=tuple(assignments))
    return functional, logical


def drive(entry: int, move: int, **more: Any) -> dict[str, Any]:
    return {"entry": entry, "move": move, **more}


CASES: dict[str, Made] = {
    "four_way_left_turn": make_scenario(
        "four_way",
        4,
        [drive(0, 2), drive(2, 3), drive(1, 2), drive(2, 1, rank=1)],
        [("unprotected_left_turn", ["car_1"], ["ego"])],
    ),
    "t_merge_occluded": make_scenario(
        "t",
        3,
        [drive(0, 1), drive(2, 2)],
        [
            ("speeding", ["ego"], []),
            ("merging_conflict", ["car_1"], ["ego"]),
            ("occlusion", ["parked_0"], []),
        ],
        standings=[(0, "right", False), (2, "right", False)],
    ),
    "ring_cut_in": make_scenario(
        "roundabout",
        4,
        [drive(1, 2), drive(0, 2)],
        [("cut_in", ["car_1"], ["ego"]), ("speeding", ["ego"], [])],
    ),
    "skewed_overtaking": make_scenario(
        "skewed",
        4,
        [drive(0, 2), drive(1, 2), drive(1, 2, rank=1, maneuver=Maneuver.OVERTAKE)],
        [("overtaking", ["car_2"], ["car_1"]), ("speeding", ["car_2"], [])],
    ),
    "tailgated_at_crosswalk": make_scenario(
        "four_way",
        4,
        [drive(0, 2, rank=1), drive(0, 2)],
        [
            ("tailgating", ["ego"], ["car_1"]),
            ("hard_braking", ["car_1"], ["ego"]),
            ("crossing_pedestrian", ["ped_0"], ["car_1"]),
        ],
        crossings=[(0, "right")],
        crosswalks={0},
        control="all_way_stop",
    ),
    "ten_at_t": make_scenario("t", 3, [drive(i % 3, 1 + i % 2, rank=i // 3) for i in range(10)]),
    "walker_from_behind_parked": make_scenario(
        "straight",
        2,
        [drive(0, 1)],
        [
            ("crossing_pedestrian", ["ped_0"], ["ego"]),
            ("stopping", ["ped_0"], ["ego"]),
            ("occlusion", ["parked_0"], []),
        ],
        crossings=[(0, "right")],
        standings=[(0, "right", False)],
    ),
    "blocked_lane": make_scenario(
        "straight",
        2,
        [drive(0, 1, maneuver=Maneuver.OVERTAKE), drive(1, 1)],
        [("obstacle", ["parked_0"], ["ego"]), ("oncoming_lane", ["ego"], [])],
        standings=[(0, "right", True)],
    ),
    "slow_leader": make_scenario(
        "straight",
        2,
        [
            drive(0, 1, rank=1, maneuver=Maneuver.LANE_CHANGE),
            drive(0, 1),
            drive(0, 1, beside="ego"),
        ],
        [("slow_driving", ["car_1"], ["ego"]), ("hard_braking", ["car_2"], ["ego"])],
    ),
    "left_hand": make_scenario("four_way", 4, [drive(0, 2), drive(1, 2)], [], driving_side="left"),
    "u_turn": make_scenario("four_way", 4, [drive(0, 2), drive(2, 0)]),
}


@pytest.fixture(params=sorted(CASES))
def made(request: pytest.FixtureRequest) -> Made:
    return CASES[request.param]


@pytest.fixture(scope="session")
def cases() -> dict[str, Made]:
    return CASES


@pytest.fixture
def scenario() -> Callable[..., Made]:
    return make_scenario
