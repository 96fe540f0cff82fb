"""Who passes another, from behind or in the lane beside, does so when and where it is said."""

import pytest
from saying import KMH, missed
from told import act, after, apart, first, told, who

BESIDE, ON = ["adjacent", "left"], ["straight"]
THREE = {"lanes": 3, "carriageway": "divided"}


def ego(speed, maneuvers=ON, lanes=()):
    return who("ego", maneuvers=maneuvers, speed=speed * KMH, lanes=lanes)


def other(name, speed, approaches, maneuvers=ON, kind="car"):
    return who(name, kind, approaches, maneuvers, speed=speed * KMH)


CASES = {
    "past in the lane beside, as far away as is said": told(
        "straight",
        [ego(70), other("x", 90, BESIDE, ["overtake"])],
        acts=[act("o", "x", "overtake", into="ego")],
        spacings=[apart("x", "ego", "lateral_gap_m", 1.2, "o")],
        lanes=2,
    ),
    "past in the lane beside, and then in": told(
        "straight",
        [ego(110, lanes=[2]), other("x", 140, BESIDE, ["lane_change"])],
        [("cut_in", "x", "ego")],
        acts=[
            act("o", "x", "overtake", into="ego"),
            act("c", "x", "change_lane", side="right", into="ego"),
        ],
        spacings=[apart("x", "ego", "gap_m", 12, "c")],
        **THREE,
    ),
    "what another does after it has begun": told(
        "straight",
        [ego(80, ["overtake"], [2]), other("x", 70, ["ahead"])],
        acts=[
            act("o", "ego", "overtake", into="x"),
            act("a", "x", "accelerate", target_speed_mps=80 * KMH, when=after("o", 1, "begin")),
        ],
        outcome={"kind": "avoided", "between": ["ego", "x"]},
        lanes=2,
    ),
    "past another among those who come towards the ego": told(
        "straight",
        [
            ego(80),
            other("x", 100, ["opposite"], ["overtake"]),
            other("slow", 60, ["opposite"], kind="truck"),
        ],
        [("oncoming_lane", "x", "ego")],
        outcome={"kind": "near_miss", "between": ["ego", "x"]},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_it_holds_from_the_first(name):
    functional = CASES[name]
    assert missed(functional, first(functional)) == set()


def passes(maneuver, side="left"):
    people = [ego(100), other("x", 130, ["behind"], [maneuver])]
    acts = [act("o", "x", "overtake", into="ego", side=side)]
    return told("straight", people, [("overtaking", "x", "ego")], acts=acts)


@pytest.mark.parametrize("side", ["left", None])
def test_who_is_told_to_change_lanes_stays_out_in_a_lane_of_its_direction(side):
    out = first(passes("lane_change", side))
    assert missed(passes("lane_change", side), out) == set()
    assert len(out.participant("x").motion.lane_changes) == 1
    home = first(passes("overtake"))
    assert missed(passes("overtake"), home) == set()
    assert "maneuver.lane_change.x" in missed(passes("lane_change"), home, out.logical)
