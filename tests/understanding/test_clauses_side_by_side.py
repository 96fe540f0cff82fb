"""Who acts where clauses stand side by side: after "does not", "there is", "one of them"."""

import pytest

from scegen.understanding import read


def does(text):
    return {
        p.id: ({a.value for a in p.approaches}, {m.value for m in p.maneuvers})
        for p in read(text).participants
    }


def hazards(text):
    return {h.kind.value for h in read(text).hazards}


def test_a_verb_after_do_has_the_same_subject():
    text = "As the ego slows, the van behind does not slow and swings around it."
    assert does(text)["van_1"] == ({"behind"}, {"overtake"})


def test_there_is_opens_a_clause_of_its_own():
    told = does("The ego follows a bus and there is a van behind the ego.")
    assert told["bus_1"][0] == {"ahead"}
    assert told["van_1"][0] == {"behind"}


def test_being_somewhere_is_a_clause():
    told = does("I'm in the left lane of the bypass and a coach comes right up behind me.")
    assert told["bus_1"][0] == {"behind"}


def test_one_of_them_does_not_take_the_verb():
    text = "Three cars, one of them a speeder, meet at a crossroads."
    assert len(read(text).participants) == 3
    assert hazards(text) == {"speeding"}


@pytest.mark.parametrize(
    "text",
    [
        "The ego lets a tram going straight pass before it turns left.",
        "The ego joins the main road to the left.",
        "The ego pulls out onto the high street to the left.",
        "The ego enters the main road to the left.",
    ],
)
def test_turning_left(text):
    assert does(text)["ego"][1] == {"left"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A cyclist rides through the crosswalk as the ego turns right.", {"crossing_cyclist"}),
        ("The ego turns right and there is a cyclist on the crosswalk.", {"crossing_cyclist"}),
        ("A van heads north in the southbound lane and meets a truck.", {"oncoming_lane"}),
        ("On the motorway a bus changed lanes and hit the ego's side.", {"cut_in"}),
        ("The driver behind was tearing along at 60 in a 30.", {"speeding"}),
        ("My neighbour reversed out of his drive in front of me.", {"reversing"}),
    ],
)
def test_what_happens(text, expected):
    assert expected <= hazards(text)


def test_the_bike_is_the_motorcycle_where_there_is_no_other():
    text = "A motorcyclist takes the bend too fast and the bike slides into the oncoming lane."
    assert [p.kind.value for p in read(text).participants if p.id != "ego"][:1] == ["motorcycle"]
    assert not any(p.kind.value == "bicycle" for p in read(text).participants)
