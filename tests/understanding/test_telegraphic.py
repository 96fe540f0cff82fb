"""Telegraphic notes: directions and nouns for verbs, titles, references back and forth."""

import pytest

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding import read


def doings(text):
    """Maneuvers of everybody, the ego first."""
    found = sorted(read(text).participants, key=lambda p: p.role != "ego")
    return [set(p.maneuvers) for p in found]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Ego straight, adversary left turn.", [Maneuver.STRAIGHT, Maneuver.LEFT]),
        ("Ego: turning left. Oncoming bus: straight.", [Maneuver.LEFT, Maneuver.STRAIGHT]),
        (
            "Crossroads with stop signs; ego right turn, van from the left, straight.",
            [Maneuver.RIGHT, Maneuver.STRAIGHT],
        ),
        (
            "Ego on the major road of a T-junction, straight. Adversary from the left, right turn.",
            [Maneuver.STRAIGHT, Maneuver.RIGHT],
        ),
        (
            "Crossroads: VUT straight on, truck approaching from the right, also straight.",
            [Maneuver.STRAIGHT, Maneuver.STRAIGHT],
        ),
    ],
)
def test_a_direction_or_a_noun_is_what_somebody_does(text, expected):
    assert doings(text) == [{maneuver} for maneuver in expected]


def test_a_title_names_nobody_new():
    text = "Car-to-cyclist, longitudinal. The cyclist rides ahead of the host vehicle in its lane."
    assert [p.kind.value for p in read(text).participants] == ["bicycle", "car"]


@pytest.mark.parametrize(
    "text",
    [
        "Before it can complete its right turn, the ego has to let three cyclists pass.",
        "As it turns right at the junction, the ego meets an oncoming bus.",
    ],
)
def test_it_may_be_named_later(text):
    assert doings(text)[0] == {Maneuver.RIGHT}


@pytest.mark.parametrize(
    "text",
    [
        "A coach takes the first exit of the roundabout; the ego behind it takes the second.",
        "In a roundabout, a van leaves at the first exit and the ego continues to the second.",
    ],
)
def test_the_second_is_an_exit(text):
    assert doings(text) == [{Maneuver.EXIT_2}, {Maneuver.EXIT_1}]


@pytest.mark.parametrize(
    "text",
    [
        "Pedestrian walking on the edge of a rural road, ahead of the ego, in the same direction.",
        "A jogger runs along the road ahead of the VUT, in the same direction.",
    ],
)
def test_who_walks_along_does_not_cross(text):
    scenario = read(text)
    walker = next(p for p in scenario.participants if p.kind.value == "pedestrian")
    assert walker.approaches == {Approach.AHEAD}
    assert HazardKind.CROSSING_PEDESTRIAN not in {h.kind for h in scenario.hazards}


def test_pulling_out_into_the_next_lane_is_a_change_of_lane():
    assert doings("The ego pulls out into the left lane as the car ahead brakes.")[0] == {
        Maneuver.LANE_CHANGE
    }


def test_who_approaches_on_the_oncoming_lane_is_met_there():
    text = "The ego has to drive round roadworks through the oncoming lane while a bus approaches."
    bus = next(p for p in read(text).participants if p.kind.value == "bus")
    assert bus.approaches == {Approach.OPPOSITE}


@pytest.mark.parametrize(
    "text",
    [
        "Three cars in a row. The first stops, the second swerves and the ego, last, brakes hard.",
        "Four cars in single file: the first brakes, then the second, the third and the ego brake.",
    ],
)
def test_the_ego_is_the_last_of_a_row(text):
    others = [p for p in read(text).participants if p.role != "ego"]
    assert len(others) < 4
    assert {a for p in others for a in p.approaches} == {Approach.AHEAD}


def test_who_turns_left_from_the_next_lane_turns_suddenly():
    text = "A van in the lane to the right of the ego turns left in front of it at a junction."
    assert [h.kind for h in read(text).hazards] == [HazardKind.SUDDEN_TURN]


def where(text, kind):
    return next(set(p.approaches) for p in read(text).participants if p.kind.value == kind)


@pytest.mark.parametrize(
    ("text", "kind", "side"),
    [
        ("Adult pedestrian, farside, 8 km/h; VUT 50 km/h.", "pedestrian", Approach.LEFT),
        ("A child nearside, partly hidden by a van; ego 30 km/h.", "pedestrian", Approach.RIGHT),
        ("The ego stops and the lorry following fails to react.", "truck", Approach.BEHIND),
        ("A truck cuts out and the ego meets a stopped car.", "truck", Approach.AHEAD),
    ],
)
def test_where_they_are(text, kind, side):
    assert where(text, kind) == {side}


@pytest.mark.parametrize(
    "text",
    [
        "Right turn on red: ego must first yield to a pedestrian on the crosswalk.",
        "Right turn at a crossroads. The host has to give way to two cyclists.",
        "Turning right at a T-junction: ego must wait for a bus.",
    ],
)
def test_a_title_says_what_the_ego_does(text):
    assert doings(text)[0] == {Maneuver.RIGHT}


@pytest.mark.parametrize(
    "text",
    [
        "The ego waits at a red light; the van behind does not stop in time.",
        "The ego slows down and the car following does not react.",
    ],
)
def test_who_is_behind_brakes_too_late(text):
    assert [h.kind for h in read(text).hazards] == [HazardKind.DELAYED_BRAKING]


def test_what_is_to_be_done_is_done():
    text = "The leading vehicle, a moped, is slow; the ego is to overtake it."
    assert doings(text)[0] == {Maneuver.OVERTAKE}


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Overtaking truck. The ego is passed by a lorry which moves back in too early.", 2),
        ("Lead vehicle stopped. A minivan stands in the lane; the following subject car nears.", 2),
        ("Oncoming car turning left. Ego going straight. A second car waits behind the ego.", 3),
    ],
)
def test_a_title_with_a_full_stop(text, count):
    assert len(read(text).participants) == count


def test_a_title_describes_the_first_one_named():
    text = "Slow vehicle: an excavator doing 15 km/h, which the ego has to overtake."
    assert HazardKind.SLOW_DRIVING in {h.kind for h in read(text).hazards}
    assert where(text, "truck") == {Approach.AHEAD}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Red-light violation by a van: it enters as the ego has green.", "red_light_running"),
        (
            "Stop sign violation: a van from the right does not stop for the ego.",
            "failure_to_yield",
        ),
        ("Two vehicles on perpendicular roads, neither stops.", "failure_to_yield"),
        ("A lorry overtakes the ego and moves back in too soon.", "cut_in"),
        ("The ego does not notice the car ahead until too late.", "delayed_braking"),
    ],
)
def test_breaches_named_by_nouns_and_late_doings(text, kind):
    assert kind in {h.kind.value for h in read(text).hazards}


def test_who_waits_for_a_verb_gets_it():
    text = "A van enters from the left when the ego has green and is turning right."
    assert doings(text)[0] == {Maneuver.RIGHT}


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("A parked van on the right pulls out in front of the ego.", Approach.RIGHT),
        (
            "At dusk a van pulls onto the country road from the left, the ego doing 90.",
            Approach.LEFT,
        ),
        ("A van parked on the right leaves its parking space as the ego passes.", Approach.RIGHT),
    ],
)
def test_who_sets_off_is_parked_and_pulls_out(text, side):
    scenario = read(text)
    van = next(p for p in scenario.participants if p.kind.value == "van")
    assert van.parked == van.pulls_out == ("parked" in text)
    assert van.approaches == {side}
    assert HazardKind.FAILURE_TO_YIELD in {h.kind for h in scenario.hazards}


def test_vehicles_side_by_side():
    text = "Vehicle A and vehicle B travel side by side; vehicle A drifts into B's lane."
    assert [set(p.approaches) for p in read(text).participants] == [set(), {Approach.ADJACENT}]


def test_who_goes_after_another():
    text = "All-way stop. The ego arrives second, after a car on its right, and goes straight."
    assert doings(text)[0] == {Maneuver.STRAIGHT}
    assert len(read("The ego and three other vehicles arrive at a junction.").participants) == 4


def test_who_is_out_of_control():
    text = "An out-of-control van comes across the median toward the ego."
    kinds = {h.kind for h in read(text).hazards}
    assert kinds == {HazardKind.LOSS_OF_CONTROL, HazardKind.ONCOMING_LANE}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Cut-in from the left at a gap of 8 m, cut-in car slower than the VUT.", "cut_in"),
        ("Moving at lower speed, lead vehicle: the VUT catches up with a bus.", "slow_driving"),
        ("A car coming from the left rolls over the stop line at a junction.", "failure_to_yield"),
        ("An oncoming van leaves its lane, the ego keeps its lane.", "oncoming_lane"),
        ("A ball rolls onto the road, followed by a boy.", "crossing_pedestrian"),
        ("The ego leaves the road on a curve.", "loss_of_control"),
    ],
)  # fmt: skip
def test_what_is_dangerous(text, kind):
    assert kind in {h.kind.value for h in read(text).hazards}


def test_the_truck_is_the_ego():
    text = "Right-turning truck, cyclist going straight on its right side: the truck is the ego."
    scenario = read(text)
    assert [p.kind.value for p in scenario.participants if p.role == "ego"] == ["truck"]
    assert len(scenario.participants) == 2


@pytest.mark.parametrize(
    ("text", "kind", "side"),
    [
        ("A bus in the oncoming lane, children about to run out from the left.", "bus",
         Approach.OPPOSITE),
        ("A man falls onto the roadway ahead of the VUT from the right-hand pavement.",
         "pedestrian", Approach.RIGHT),
        ("Ego on the main road. Van on the left-hand side road does not yield.", "van",
         Approach.LEFT),
        ("Junction ahead of the ego; a van from the left also going straight.", "van",
         Approach.LEFT),
    ],
)  # fmt: skip
def test_who_is_placed_by_which_words(text, kind, side):
    assert where(text, kind) == {side}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Junction; adversary from the left has to yield but does not; ego straight.",
         "failure_to_yield"),
        ("A bus making a left turn from the opposite direction at a permissive signal, ego "
         "straight.", "unprotected_left_turn"),
        ("Host vehicle departing its lane on a bend as the driver falls asleep.", "swerving"),
        ("A car turns right; conflict with a pedestrian walking straight across.",
         "crossing_pedestrian"),
    ],
)  # fmt: skip
def test_further_dangers(text, kind):
    assert kind in {h.kind.value for h in read(text).hazards}


@pytest.mark.parametrize(
    ("text", "kind", "side"),
    [
        ("Ego stopped in a queue, struck from behind by a pickup.", "truck", Approach.BEHIND),
        ("Cyclist from the nearside path rides onto the road, ego ahead.", "bicycle",
         Approach.RIGHT),
        ("A coach merging from the ramp at the same speed alongside; ego on the motorway.", "bus",
         Approach.ADJACENT),
    ],
)  # fmt: skip
def test_who_is_where(text, kind, side):
    beside = {Approach.RIGHT} if side is Approach.ADJACENT else set()
    assert where(text, kind) == {side} | beside


def test_two_lanes_are_changed_and_traffic_is_the_scene():
    text = "The ego has to change two lanes to the right to reach its exit."
    assert doings(text) == [{Maneuver.EXIT}]
    text = "Stop-and-go traffic on a ring road; the car ahead rolls back towards the ego."
    assert len(read(text).participants) == 2


def test_one_from_each_side():
    text = "At the T-junction the ego turns left; a van approaches from each side."
    vans = [set(p.approaches) for p in read(text).participants if p.kind.value == "van"]
    assert vans == [{Approach.LEFT}, {Approach.RIGHT}]
    text = "The ego crosses a junction while two vans from left and right wait."
    vans = [set(p.approaches) for p in read(text).participants if p.kind.value == "van"]
    assert vans == [{Approach.LEFT}, {Approach.RIGHT}]


@pytest.mark.parametrize(
    ("text", "kind", "side"),
    [
        ("A van pulling out of a parking space on the left side, ego passing.", "van",
         Approach.LEFT),
        ("A taxi makes a U-turn from the right-hand kerb, ego behind it.", "car",
         Approach.RIGHT),
        ("The car ahead swerves, exposing a broken-down van to the ego.", "van", Approach.AHEAD),
        ("Ego nears a zebra crossing with two pupils about to step onto it from the right.",
         "pedestrian", Approach.RIGHT),
    ],
)  # fmt: skip
def test_sides_of_those_who_set_off(text, kind, side):
    assert side in {a for p in read(text).participants if p.kind.value == kind
                    for a in p.approaches}  # fmt: skip


def test_what_is_prevented_is_not_done():
    text = "The ego stays behind a cyclist since oncoming cars prevent overtaking."
    assert HazardKind.OVERTAKING not in {h.kind for h in read(text).hazards}


def test_who_is_oncoming_in_the_ego_lane():
    text = "An oncoming ambulance in the ego's lane; the ego has to stop."
    assert HazardKind.ONCOMING_LANE in {h.kind for h in read(text).hazards}


def test_what_stands_behind_the_lead_vehicle_is_not_the_ego():
    text = "Cut-out: the lead vehicle moves to the right lane because of a stopped motorcycle."
    assert where(text, "motorcycle") == {Approach.AHEAD}


def test_who_crosses_behind_a_stationary_bus_is_hidden():
    text = "Pedestrian crossing from the nearside behind a stationary bus; ego at 40 km/h."
    assert HazardKind.OCCLUSION in {h.kind for h in read(text).hazards}
