"""Ways that are said by a noun, a phrase or an adjective rather than by a verb."""

import pytest

from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding import read


def ego_of(text):
    return next(p for p in read(text).participants if p.role.value == "ego")


def other_of(text):
    return next(p for p in read(text).participants if p.role.value != "ego")


def hazards_of(text):
    return {h.kind for h in read(text).hazards}


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("An unprotected left for the ego with a bus coming towards it.", Maneuver.LEFT),
        ("Halfway through its left turn the ego meets a cyclist.", Maneuver.LEFT),
        ("A taxi approaches while the ego is in the middle of a right.", Maneuver.RIGHT),
        ("A van hits the ego on its way straight ahead at a crossroads.", Maneuver.STRAIGHT),
        ("The ego follows a straight course over the junction.", Maneuver.STRAIGHT),
        ("The ego, bound for the left arm of a T-junction, meets a van.", Maneuver.LEFT),
        ("The ego, keen to turn right, waits for a van from the left.", Maneuver.RIGHT),
        ("The ego steers right into the side street.", Maneuver.RIGHT),
    ],
)
def test_the_way_of_the_ego(text, way):
    assert ego_of(text).maneuvers == {way}


def test_a_side_is_no_turn():
    assert ego_of("At a crossroads the ego, a van on its left, drives straight on.").maneuvers == {
        Maneuver.STRAIGHT
    }


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("At a crossroads the van facing the ego turns left.", Approach.OPPOSITE),
        ("At a crossroads the van opposite turns left before the ego.", Approach.OPPOSITE),
        ("The van to the ego's right creeps into the crossroads.", Approach.RIGHT),
        ("At a crossroads the ego meets a van from the right.", Approach.RIGHT),
    ],
)
def test_where_the_other_is(text, side):
    assert other_of(text).approaches == {side}


def test_against_the_rules_is_not_against_the_traffic():
    assert HazardKind.ONCOMING_LANE not in hazards_of("A van enters against the traffic rules.")
    assert HazardKind.ONCOMING_LANE in hazards_of("A van drives against the traffic.")


def test_neither_denies_both_verbs():
    text = "A van from the left neither stops nor yields; the ego drives straight on."
    assert HazardKind.FAILURE_TO_YIELD in hazards_of(text)
    assert HazardKind.STOPPING not in hazards_of(text)


def test_a_light_that_turns_is_nobody_who_turns():
    assert ego_of("With the light just turned green, the ego goes straight.").maneuvers == {
        Maneuver.STRAIGHT
    }


def test_red_for_the_cross_street_binds_who_comes_from_there():
    text = (
        "The light is red for the cross street, yet a van from the left races across the junction."
    )
    assert HazardKind.RED_LIGHT_RUNNING in hazards_of(text)


def test_whoever_goes_out_of_turn_does_not_yield():
    text = "The ego was first at the four-way stop, but the van on its right pulls out."
    assert HazardKind.FAILURE_TO_YIELD in hazards_of(text)


def test_a_turn_without_an_arrow_is_unprotected():
    text = "The ego turns left at the signals; there is no arrow, and a bus comes towards it."
    assert HazardKind.UNPROTECTED_LEFT_TURN in hazards_of(text)


def test_numbers_above_the_limit_are_speeding():
    assert HazardKind.SPEEDING in hazards_of("V1 drove at 80 km/h in a 50 km/h zone.")
    assert HazardKind.SPEEDING not in hazards_of("V1 drove at 50 km/h in a 50 km/h zone.")


def test_parts_of_vehicles_are_no_obstacles():
    assert HazardKind.OBSTACLE not in hazards_of("The truck suffered a burst tyre and swerved.")
    assert HazardKind.OBSTACLE in hazards_of("There is a tyre in the ego's lane.")


def test_no_intention_of_stopping_is_not_stopping():
    text = "A van from the left has no intention of stopping at its red light."
    assert HazardKind.RED_LIGHT_RUNNING in hazards_of(text)


def test_what_the_ego_does_to_get_clear_is_no_danger():
    text = "A van from the left runs the red light and the ego, going straight, speeds up."
    assert hazards_of(text) == {HazardKind.RED_LIGHT_RUNNING}


def test_who_comes_out_of_a_side_road_drives():
    text = "He came out of the side road on my left without looking."
    assert other_of(text).kind.value == "car"
    assert HazardKind.FAILURE_TO_YIELD in hazards_of(text)


def test_what_the_ego_is_blocked_on():
    assert ego_of("A van blocks the ego's way straight on at the crossroads.").maneuvers == {
        Maneuver.STRAIGHT
    }


def test_going_backwards_is_reversing():
    assert HazardKind.REVERSING in hazards_of("A car comes out of a driveway backwards.")


def test_slowing_for_a_turn_is_no_hard_braking():
    text = "A cyclist overtakes the ego as it slows for a right turn."
    assert HazardKind.HARD_BRAKING not in hazards_of(text)


def test_whoever_faces_red_and_does_not_slow_down_runs_it():
    text = "The ego goes straight; a van on its right, though facing red, does not slow down."
    assert HazardKind.RED_LIGHT_RUNNING in hazards_of(text)


def test_somebody_who_reverses_drives():
    assert other_of("Somebody reversed out of their drive in front of me.").kind.value == "car"
