"""How long and how wide somebody, something and the lanes are said to be."""

import pytest

from scegen.understanding import read


def sizes(text):
    """Length and width of all of whom one is said."""
    functional = read(text)
    return {
        one.id: tuple(None if said is None else said.middle for said in (one.length_m, one.width_m))
        for one in (*functional.participants, *functional.objects)
        if one.length_m is not None or one.width_m is not None
    }


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego follows a 12 m bus at 40 km/h.", {"bus_1": (12.0, None)}),
        ("The ego overtakes a lorry, 16.5 m long, at 90 km/h.", {"truck_1": (16.5, None)}),
        ("The ego follows a van (length 6 m, speed 60 km/h).", {"van_1": (6.0, None)}),
        ("A bus, 18 m in length, comes towards the ego.", {"bus_1": (18.0, None)}),
        ("The length of the truck is 10 m and the ego overtakes it.", {"truck_1": (10.0, None)}),
        ("A 2.5 m wide and 12 m long bus is ahead of the ego.", {"bus_1": (12.0, 2.5)}),
        ("The ego, 5 m long and 2 m wide, follows a van.", {"ego": (5.0, 2.0)}),
        ("A box half a metre long lies in the ego's lane.", {"box_1": (0.5, None)}),
        ("A 2 m wide skip stands in the ego's lane.", {"container_1": (None, 2.0)}),
        (
            "The ego passes two parked cars, each 4.5 m long, at 30 km/h.",
            {"parked_car_1": (4.5, None), "parked_car_2": (4.5, None)},
        ),
    ],
)
def test_a_size_belongs_to_whom_it_is_said_of(text, expected):
    assert sizes(text) == expected
    assert not [u for u in read(text).unsupported if " m" in u.text]


@pytest.mark.parametrize(
    "text",
    [
        "The ego follows a bus at 12 m.",
        "The ego drives 20 m behind a truck.",
        "The ego follows a van at a distance of 30 m.",
        "A pedestrian steps out when the ego is 18 m away.",
        "The ego keeps a 40 m gap to the bus.",
        "The ego passes a parked car with a side clearance of 1.5 m.",
        "A cyclist rides beside the ego in a cycle lane that is 1.5 m wide.",
        "A van is parked on a stretch that is 25 m long.",
    ],
)
def test_other_lengths_are_no_sizes(text):
    assert not sizes(text)


def test_what_is_too_long_is_told():
    (left_out,) = read("The ego overtakes a truck that is 60 m long.").unsupported
    assert (left_out.text, "25.25 m" in left_out.instead) == ("60 m", True)


@pytest.mark.parametrize(
    ("text", "length_m"),
    [
        ("A van merges from a 150 m acceleration lane in front of the ego.", 150.0),
        ("A van merges from an acceleration lane of 150 m in front of the ego.", 150.0),
        ("A van leaves by a 200 m long deceleration lane in front of the ego.", 200.0),
        ("The acceleration lane is 180 m long; a van merges from it before the ego.", 180.0),
        ("A van 6 m long merges from the acceleration lane 30 m ahead of the ego.", None),
    ],
)
def test_a_lane_that_ends_is_as_long_as_is_said(text, length_m):
    assert read(text).junction.auxiliary_length_m == length_m


@pytest.mark.parametrize(
    ("text", "width_m"),
    [
        ("The ego follows a car on a road with lanes 2.75 m wide.", 2.75),
        ("The ego follows a car. The lanes are just 3 m wide.", 3.0),
        ("The ego follows a car on a road with 3.25 m lanes.", 3.25),
        ("Lane width 10 ft: the ego follows a car.", 3.048),
        ("At roadworks with lanes narrowed to 2.6 m the ego follows a car.", 2.6),
        ("A car 2.1 m wide is in the lane ahead of the ego.", None),
        ("The ego follows a car in its lane, 3 m behind.", None),
        ("A cyclist rides in a 1.5 m wide lane ahead of the ego.", None),
    ],
)
def test_lanes_are_as_wide_as_is_said(text, width_m):
    found = read(text).junction.lane_width_m
    assert found == (None if width_m is None else pytest.approx(width_m))
