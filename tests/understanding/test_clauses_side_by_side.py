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


def test_it_is_what_the_sentence_is_about():
    text = "The ego comes to a bend where two vans have stopped, and it changes lanes."
    assert does(text)["ego"][1] == {"lane_change"}


def test_nouns_after_a_comma_do_not_say_what_the_subject_is():
    told = does("I was in the left lane, a van on my right, a bus behind me.")
    assert told["van_1"][0] == {"adjacent", "right"}
    assert told["bus_1"][0] == {"behind"}
    assert read("I was in the left lane, a bus behind me.").participants[0].kind.value == "car"


def test_one_side_and_the_other():
    told = does("The ego drives along, a tanker on one side, a coach on the other.")
    assert told["truck_1"][0] == told["bus_1"][0] == {"adjacent"}


def test_and_then_begins_a_clause():
    text = "A bus is in the left lane, a van behind it, and then the car ahead brakes hard."
    hard = next(h for h in read(text).hazards if h.kind.value == "hard_braking")
    assert hard.by == ("car_1",)


def test_a_single_car_that_approaches_people_is_the_ego():
    scenario = read("A boy crosses the road; an approaching taxi brakes too late.")
    assert [p.kind.value for p in scenario.participants if p.role.value == "ego"] == ["car"]
    assert len(scenario.participants) == 2


@pytest.mark.parametrize(
    "text",
    [
        "A van came across two lanes right in front of me to reach the slip road.",
        "A taxi shot across three lanes in front of the ego.",
        "She came across all the lanes just ahead of us.",
    ],
)
def test_across_lanes_in_front_of_somebody_is_cutting_in(text):
    assert hazards(text) == {"cut_in"}


def test_people_run_across_lanes_on_foot():
    text = "A pedestrian ran across two lanes in front of the ego."
    assert hazards(text) == {"crossing_pedestrian"}
