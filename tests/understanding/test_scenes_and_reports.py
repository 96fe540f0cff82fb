"""Scenes and reports: sides of things, nouns that gather, time left to somebody, files of cars."""

import pytest

from scegen.understanding import read


def seen(text):
    """Kind -> where they come from, without the ego."""
    scenario = read(text)
    return [
        (p.kind.value, {a.value for a in p.approaches})
        for p in scenario.participants
        if p.role.value != "ego"
    ]


def does(text):
    scenario = read(text)
    return next({m.value for m in p.maneuvers} for p in scenario.participants if p.role == "ego")


def dangers(text):
    return {h.kind.value for h in read(text).hazards}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego drives on; a child waits behind a bus stop on the left and dashes across.",
         ("pedestrian", {"left"})),
        ("A cyclist shoots out from behind a billboard on the right and crosses the ego's path.",
         ("bicycle", {"right"})),
        ("An oncoming bus is overtaken by a motorcycle as the ego turns left.",
         ("motorcycle", {"opposite"})),
        ("The ego goes straight when a van pulls out of an alley into its path.",
         ("van", {"left", "right"})),
        ("At a T-junction a taxi from the side road on the left turns right and a van waits "
         "behind it while the ego goes straight.", ("van", {"left"})),
        ("The ego follows a bus in the left lane. The bus brakes hard.", ("bus", {"ahead"})),
        ("The ego passes a parked bus via the oncoming lane.", ("bus", set())),
    ],
)  # fmt: skip
def test_where_others_come_from(text, expected):
    kind, sides = expected
    found = dict(seen(text))[kind]
    assert found == sides or (not sides and "opposite" not in found)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("The ego joins a steady stream of traffic.", 4),
        ("A long line of slow-moving trucks blocks the right lane ahead of the ego.", 4),
        ("The ego travels with the flow of traffic when a bus cuts in.", 1),
        ("Two cars and a van reach a junction. All vehicles turn left.", 2),
        ("Vehicle 1 was parked on the left. Vehicle 2 hit the parked vehicle.", 1),
        ("The ego passes a parked van as the vehicle behind the ego pulls out to overtake.", 2),
        ("The ego yields to oncoming traffic. A taxi following it fails to stop.", 2),
        ("A car comes from the left, another from the right as the ego goes straight. "
         "The one from the left turns right.", 2),
    ],
)  # fmt: skip
def test_who_is_there(text, number):
    assert len(seen(text)) == number


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("During a left turn at a crossroads the ego meets an oncoming bus.", {"left"}),
        ("Midway through its right turn, the ego notices a child.", {"right"}),
        ("The ego moves into the middle lane.", {"lane_change"}),
        ("The ego steers into a gap in the next lane.", {"lane_change"}),
        ("The ego pulls out around a stalled lorry.", {"overtake"}),
        ("A stalled bus blocks the lane, so the ego detours through the opposite lane.",
         {"overtake"}),
        ("The ego reaches a spot where two vans block the road, and must change lane.",
         {"lane_change"}),
    ],
)  # fmt: skip
def test_what_the_ego_does(text, expected):
    assert does(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A dog runs out, leaving the ego no time to brake.", {"crossing_animal"}),
        ("The ego approaches a fallen tree that blocks its lane.", {"obstacle"}),
        ("The ego overtakes a bus while an oncoming van does not slow down.", {"overtaking"}),
        ("The car ahead is going really slow.", {"slow_driving"}),
        ("The car in front of the ego stops just past the crosswalk.", {"stopping"}),
        ("A car coming the other way brakes abruptly as the ego overtakes a bus.",
         {"hard_braking", "overtaking"}),
    ],
)  # fmt: skip
def test_dangers(text, expected):
    assert dangers(text) == expected


def test_no_junction_where_none_is():
    assert read("A cyclist crosses the road at a non-junction location.").junction.arms == 2


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego gets past a bin lorry using the oncoming lane.", {"oncoming_lane"}),
        ("A parked taxi's door is flung open by a passenger as the ego passes.", {"obstacle"}),
        ("A ball rolls onto the street, followed by a boy.", {"obstacle", "crossing_pedestrian"}),
        ("The leading truck's cargo falls onto the carriageway.", {"obstacle"}),
        ("Vehicle 1 was waiting at a red light. Vehicle 2 failed to brake and struck Vehicle 1.",
         {"delayed_braking"}),
        ("A delivery van is unloading in the ego's lane.", {"obstacle"}),
    ],
)  # fmt: skip
def test_dangers_of_things_and_of_those_who_stand(text, expected):
    assert dangers(text) == expected


def test_a_list_after_a_colon_holds_the_ego():
    text = (
        "Three vehicles meet at a junction: the ego turns left, a taxi goes straight, a van waits."
    )
    assert len(read(text).participants) == 3


def test_who_drives_up_behind_a_walker_is_the_ego():
    text = "A hiker walks along the road in the same direction as a van, which comes from behind."
    assert [p.kind.value for p in read(text).participants if p.role == "ego"] == ["van"]


def test_both_sides_of_the_ego_are_the_lanes_beside():
    text = "Two vans on either side of the ego drift towards its lane."
    assert seen(text) == [("van", {"adjacent", "left"}), ("van", {"adjacent", "right"})]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("V1's front struck the back of V2, which was slowing.", [("car", {"ahead"})]),
        ("The front of V2 hit the rear of V1. V1 was a van.", [("car", {"behind"})]),
        ("V1 was northbound in lane one of a motorway. V2 was northbound in lane two and changed "
         "lanes. V2's right side contacted V1's left side.", [("car", {"adjacent"})]),
    ],
)  # fmt: skip
def test_parts_of_vehicles_that_touch(text, expected):
    assert seen(text) == expected


def test_a_text_without_articles_is_about_its_first_vehicle():
    text = "Vehicle is turning right and cuts across the path of another vehicle at a junction."
    assert does(text) == {"right"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A skateboarder rolls off the kerb in front of the ego.", {"crossing_pedestrian"}),
        ("V2 had slowed down. V1 did not notice and its front struck V2's back.",
         {"delayed_braking"}),
        ("A van overtakes the ego and returns to its lane too soon.", {"overtaking", "cut_in"}),
        ("The ego passes a car parked with a flat tyre.", set()),
    ],
)  # fmt: skip
def test_more_dangers(text, expected):
    assert dangers(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego reacts to a cut-in by a van from the left lane.", {"straight"}),
        ("The ego waits at the light; when it turns green, a bus from the left is still crossing.",
         {"straight"}),
        ("A parked bus blocks the lane of the ego; the ego turns on its hazard lights.",
         {"straight"}),
        ("The ego reverses in a car park behind a van.", {"straight"}),
    ],
)  # fmt: skip
def test_what_the_ego_does_not_do(text, expected):
    assert does(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego turns right; a cyclist comes from behind and crosses the street without slowing.",
         {"crossing_cyclist"}),
        ("The car ahead of the ego slows down to let a bus merge.", {"merging_conflict"}),
        ("A lorry with an open tailgate is parked beside a bus.", set()),
        ("A van in the next lane leaves it and moves back into the ego's lane.", {"cut_in"}),
    ],
)  # fmt: skip
def test_what_is_no_danger_of_its_own(text, expected):
    assert dangers(text) == expected


def test_a_sign_that_somebody_holds_regulates_no_junction():
    text = "A worker with a stop sign steps onto the road in front of the ego."
    assert read(text).junction.arms == 2


def test_a_turn_signal_is_no_turn():
    text = "An oncoming van approaches with its left turn signal on but goes straight."
    assert next(p.maneuvers for p in read(text).participants) == {"straight"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A van drifts out of its lane and crosses into oncoming traffic.",
         {"swerving", "oncoming_lane"}),
        ("A cyclist on the right front of the ego loses his balance.", {"loss_of_control"}),
        ("A skateboarder shoots out of a driveway in front of the ego.", {"crossing_pedestrian"}),
        ("The ego accelerates away from a green light.", set()),
    ],
)  # fmt: skip
def test_dangers_at_the_edge(text, expected):
    assert dangers(text) == expected
