"""What things do to a view or a lane, what cannot be seen, and what comes too late."""

import pytest

from scegen.understanding import read


def hazards(text):
    return {h.kind.value for h in read(text).hazards}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The view to the left is blocked by a parked van and a car turns right.", {"occlusion"}),
        ("A car waits at a junction, its view blocked by a lorry.", {"occlusion"}),
        ("With a van parked there I cannot see the car coming from the left.", {"occlusion"}),
        ("A car driver notices the queue too late.", {"delayed_braking"}),
        ("The car behind the ego reacts too late.", {"delayed_braking"}),
        ("The bus behind the ego cannot stop.", {"delayed_braking"}),
        ("A van ahead is unable to see the sign.", {"occlusion"}),
        ("A driver overlooks the red light at a junction.", {"red_light_running"}),
        ("A driver does not see the stop sign and goes on.", {"failure_to_yield"}),
        ("A car ignores the stop sign; a van ignores it too.", {"failure_to_yield"}),
        ("The ego brakes for a child on the crosswalk.", {"crossing_pedestrian"}),
        ("A van makes a left on red.", {"red_light_running"}),
        ("A van makes a right on red.", set()),
        ("A moped undertakes me.", {"overtaking"}),
        ("A lorry jackknifes on the motorway.", {"loss_of_control"}),
        ("A tractor crawls along the road ahead of the ego.", {"slow_driving"}),
        ("The ego goes around a parked van.", {"obstacle"}),
        ("The ego's tyre bursts.", {"loss_of_control"}),
        ("Kids kick a ball on the pavement while a car passes.", set()),
        ("Roadworks blocking the lane make the ego change lanes.", {"obstacle"}),
        ("A bus pulls out to overtake a cyclist.", {"overtaking"}),
        ("A pedestrian crosses on red in front of a car.", {"crossing_pedestrian"}),
        ("A cyclist shoots out from behind a parked van while a bus comes.", None),
        ("Vehicle 1 was northbound and drifted into the southbound lane.", None),
        ("A truck applied its brakes but was unable to avoid the car.", set()),
        ("An oncoming car limits the space for the ego.", set()),
        ("A hedge hiding two cyclists stands near a bus.", {"occlusion"}),
        ("A child crosses, obstructed by a van, in front of a bus.", None),
        ("A van swerves around the ego.", {"swerving"}),
        ("A van with its hazard lights on waits.", set()),
        ("At a junction the tram comes first, but a taxi ignores it.", {"failure_to_yield"}),
        ("V1 pulls into the junction in front of V2.", {"failure_to_yield"}),
        ("A car from the left speeds through the red light.", None),
        ("A cyclist emerges from between two lorries near a bus.", None),
        ("The child steps onto the road and a car brakes for it.", {"crossing_pedestrian"}),
        ("A walker drifts from the pavement onto the road near a car.", {"crossing_pedestrian"}),
        ("A van merges in front of the ego.", {"cut_in"}),
        ("The ego has its view of the road blocked by a bus.", {"occlusion"}),
        ("A taxi meets two pedestrians crossing at a junction.", {"crossing_pedestrian"}),
        ("A bus does not brake for a walker.", {"crossing_pedestrian", "delayed_braking"}),
    ],
)
def test_dangers(text, expected):
    special = {
        "A car from the left speeds through the red light.": {"red_light_running", "speeding"},
        "A child crosses, obstructed by a van, in front of a bus.": {
            "crossing_pedestrian",
            "occlusion",
        },
        "A cyclist emerges from between two lorries near a bus.": {
            "crossing_cyclist",
            "occlusion",
        },
        "A cyclist shoots out from behind a parked van while a bus comes.": {
            "crossing_cyclist",
            "occlusion",
        },
        "Vehicle 1 was northbound and drifted into the southbound lane.": {
            "oncoming_lane",
            "swerving",
        },
    }
    assert hazards(text) == special.get(text, expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego closes in on a stationary van.", {"ahead"}),
        ("The ego drives towards a slow van.", {"ahead"}),
        ("The ego rear-ends a van.", {"ahead"}),
        ("The ego is rear-ended by a van.", {"behind"}),
        ("A van cuts in on the ego.", {"adjacent"}),
        ("A van brakes hard and the ego has to stop.", {"ahead"}),
        ("A van drifts over the centre line towards the ego.", {"opposite"}),
        ("The ego approaches a parked van at a crossroads from the left.", {"ahead"}),
    ],
)
def test_positions_that_follow(text, expected):
    scenario = read(text)
    (van,) = [p for p in scenario.participants if p.kind == "van"]
    assert {str(a) for a in van.approaches} == expected
    held = [e for e in scenario.evidence if e.field == f"participants.{van.id}.approaches"]
    assert held
    assert all(e.text for e in held)


def test_a_stated_heading_is_kept():
    scenario = read("V1 was travelling north and V2 was travelling west; they met at a crossroads.")
    assert [set(p.maneuvers) for p in scenario.participants] == [{"straight"}, {"straight"}]
    reasons = [e.reason for e in scenario.evidence if e.field.endswith("car_1.maneuvers")]
    assert reasons == ["it keeps its heading: nothing says that it turns"]


def test_it_is_who_drives_not_who_walks():
    scenario = read("The ego waits for two pedestrians to cross. A bus behind it moves off.")
    (bus,) = [p for p in scenario.participants if p.kind == "bus"]
    assert {str(a) for a in bus.approaches} == {"behind"}


def test_a_pronoun_is_not_described_further():
    scenario = read("A lorry nearly hit me coming from the right.")
    (lorry,) = [p for p in scenario.participants if p.kind == "truck"]
    assert {str(a) for a in lorry.approaches} == {"right"}


@pytest.mark.parametrize(
    ("text", "things"),
    [
        (
            "A crate lies in the ego's lane and a hedge hides a cyclist who crosses.",
            [("box", "ego", ()), ("hedge", None, ("bicycle_1",))],
        ),
        (
            "A crate lies in the ego's lane and hides a pedestrian who crosses.",
            [("box", "ego", ("pedestrian_1",))],
        ),
    ],
)
def test_what_lies_in_the_way_hides_nobody_whom_something_else_hides(text, things):
    scenario = read(f"The ego drives on a straight road. {text}")
    assert [(str(o.kind), o.in_way_of, o.hides) for o in scenario.objects] == things


@pytest.mark.parametrize(
    ("text", "whose", "touches"),
    [
        ("The ego runs into the open door of a parked van.", "parked_van_1", True),
        ("A cyclist hits the opening door of a parked car before the ego.", "parked_car_1", True),
        ("The ego hits the open door of the third of four parked cars.", "parked_car_3", True),
    ],
)
def test_an_open_door_is_opened_by_whom_it_belongs_to(text, whose, touches):
    found = read(text)
    assert [(a.participant, a.kind) for a in found.acts] == [(whose, "open_door")]
    assert [h.by for h in found.hazards] == [(whose,)]
    assert (found.outcome is not None and whose in found.outcome.between) == touches
    assert not found.unsupported


@pytest.mark.parametrize("whose", ["its left door", "its rear door", "the door"])
def test_who_opens_a_door_that_is_told_apart_does(whose):
    found = read(f"A parked van opens {whose} as the ego passes.")
    assert [(a.participant, a.kind) for a in found.acts] == [("parked_van_1", "open_door")]
