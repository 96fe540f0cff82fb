"""What a road is like along its length: medians, one way, hard shoulders, bends."""

import pytest

from scegen.errors import InfeasibleError
from scegen.understanding.reader import read

SHOULDER = frozenset({"hard_shoulder"})


@pytest.mark.parametrize(
    ("text", "carriageway", "strips"),
    [
        ("The ego drives on a motorway.", "divided", SHOULDER),
        ("On the autobahn a van brakes hard in front of the ego.", "divided", SHOULDER),
        ("On a freeway a truck overtakes the ego.", "divided", SHOULDER),
        ("On a highway the car ahead brakes hard.", "divided", SHOULDER),
        ("The ego follows a bus on a dual carriageway.", "divided", frozenset()),
        ("On a one-way street a cyclist rides ahead of the ego.", "one_way", frozenset()),
        ("The ego drives on a country road behind a bus.", "undivided", frozenset()),
        ("The ego follows a bus on a road with a grass median.", "divided", frozenset()),
        ("On a two-lane highway the ego follows a bus.", "undivided", frozenset()),
        ("On a highway an oncoming van swerves into the ego's lane.", "undivided", frozenset()),
        ("A van is parked on the shoulder of a rural road.", "undivided", SHOULDER),
    ],
)
def test_carriageways_and_strips(text, carriageway, strips):
    junction = read(text).junction
    assert (junction.carriageway, junction.strips) == (carriageway, strips)
    fields = {e.field for e in read(text).evidence}
    assert ("junction.carriageway" in fields) == (carriageway != "undivided")


def test_who_has_broken_down_on_the_shoulder_is_in_nobodys_way():
    found = read("A broken-down bus stands on the hard shoulder of a motorway, and the ego passes.")
    (bus,) = [p for p in found.participants if p.kind == "bus"]
    assert bus.parked
    assert not found.hazards


def test_nobody_drives_on_the_shoulder():
    found = read("A police car overtakes the ego on the hard shoulder of a motorway.")
    assert [u.text for u in found.unsupported] == ["hard shoulder"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("At a crossroads with raised medians the ego turns left.", ["raised medians"]),
        ("A van drives across the median towards the ego.", ["median"]),
        ("A man waits on the median of a dual carriageway as the ego comes.", ["median"]),
    ],
)
def test_medians_that_are_not_built_or_not_stood_on_are_told(text, words):
    found = read(text)
    assert [u.text for u in found.unsupported] == words
    assert not [h for h in found.hazards if "ego" in h.by]


@pytest.mark.parametrize(
    ("text", "words", "instead"),
    [
        (
            "A car stands on the left shoulder of the motorway.",
            "on the left shoulder",
            "no shoulder is built along the median",
        ),
        (
            "An oncoming car crosses the median and hits the ego on a motorway.",
            "median",
            "nobody is driven over one",
        ),
        (
            "The ego exits the motorway while a queue stands in the exit lane.",
            "exit lane",
            "no lane of its own is built for the exit",
        ),
    ],
)
def test_what_is_not_built_as_told_is_told(text, words, instead):
    (note,) = read(text).unsupported
    assert note.text == words
    assert note.instead.startswith(instead)


def test_at_a_junction_it_is_said_that_there_is_none():
    found = read("At a crossroads of two dual carriageways, a van runs a red light.")
    assert found.junction.carriageway == "undivided"
    assert any("carriageways" in u.text for u in found.unsupported)


@pytest.mark.parametrize(
    ("text", "side", "radius"),
    [
        ("The ego drives through a left-hand bend of 120 m radius behind a van.", "left", 120),
        ("In a right-hand curve with a radius of 80 m the ego follows a bus.", "right", 80),
        ("The ego drives at 60 km/h in a bend to the left. A car comes towards it.", "left", None),
        ("The ego drives round a bend (radius 50 m) behind a car.", None, 50),
        ("The ego takes a 200 m radius bend when a cyclist appears ahead.", None, 200),
        ("On a motorway, in a bend to the right of 600 m radius, a bus brakes.", "right", 600),
        ("On a motorway bend to the right with a radius of 500 m a van stops.", "right", 500),
        ("The ego drives in a left-hand motorway curve and the bus ahead brakes.", "left", None),
        ("On a bend, an oncoming truck swerves into the ego's lane.", None, None),
    ],
)
def test_bends(text, side, radius):
    found = read(text)
    assert found.junction.bend is not None
    assert (found.junction.bend.side, found.junction.bend.radius_m) == (side, radius)
    assert found.ego.maneuvers <= {"straight"}
    told = " ".join(u.text for u in found.unsupported)
    assert not any(word in told for word in ("bend", "curve", "radius", "left", "right"))


@pytest.mark.parametrize(
    "text",
    [
        "Behind a curve three cars stand in the ego's lane.",
        "After the bend a deer stands in the lane.",
    ],
)
def test_a_bend_somewhere_else_is_said_to_be_left_out(text):
    found = read(text)
    assert found.junction.bend is None
    assert any(word in u.text for u in found.unsupported for word in ("curve", "bend"))


def test_a_bend_that_nobody_builds():
    with pytest.raises(InfeasibleError, match="8 m radius is not built"):
        read("The ego drives through a bend of 8 m radius.")
