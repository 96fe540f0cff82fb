"""Lanes called by number, and changes of lane that force others to react."""

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.reader import read


def test_another_number_is_the_next_lane() -> None:
    scenario = read("The ego drives in lane 1 while a bus drives in lane 2 of the motorway.")
    bus = next(p for p in scenario.participants if p.id == "bus_1")
    assert set(bus.approaches) == {Approach.ADJACENT}


def test_moving_out_of_a_numbered_lane_changes_lanes() -> None:
    scenario = read("The ego is in lane 3; a van in lane 2 of the motorway moves out.")
    van = next(p for p in scenario.participants if p.id == "van_1")
    assert set(van.maneuvers) == {Maneuver.LANE_CHANGE}


def test_a_change_of_lane_that_forces_others_cuts_in() -> None:
    scenario = read("A lorry changes lanes, forcing the ego to swerve.")
    assert [h.kind for h in scenario.hazards] == [HazardKind.CUT_IN]


def test_being_forced_out_of_a_lane_is_no_cut_in() -> None:
    scenario = read("A stopped van forces the ego to change lanes.")
    assert HazardKind.CUT_IN not in {h.kind for h in scenario.hazards}
