"""A law: what one short sentence says of one or two is made, and all of it holds.

Who is where is crossed with what is done, numbers with how it ends; the rest are sentences of one
construction each.
"""

import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.attempts import make_some
from scegen.pipeline.options import Options
from scegen.pipeline.picking import pick
from scegen.pipeline.raising import chosen_target
from scegen.understanding import read

WHO = ("The car ahead", "A van in the lane to the right of the ego", "A motorcycle beside the ego")
DOES = ("swerves to the left", "swerves to the right", "changes lanes to the left", "cuts in",
        "drifts to the right", "loses control")  # fmt: skip
COMES = ("A car cuts in 20 m in front of the ego", "A van cuts in with a time gap of 0.8 s",
         "A car cuts in at a TTC of 3 s", "The car 8 m ahead brakes hard")  # fmt: skip
ENDS = ("and the ego, at 60 km/h, hits it", "and the ego, at 60 km/h, nearly hits it",
        "and the ego, at 60 km/h, avoids a collision")  # fmt: skip
GOES_ACROSS = ("A pedestrian", "A cyclist", "A deer")
ACROSS = ("crosses behind the ego", "waits until the ego has passed and then crosses",
          "crosses from the right, stops on the centre line for 2 s and goes on",
          "crosses from the left and stands in the ego's lane for 3 s")  # fmt: skip
MEANWHILE = ("As soon as the ego is alongside the truck", "While the ego overtakes the truck",
             "When the ego draws level with the truck")  # fmt: skip
TRUCK = ("changes lanes to the left", "swerves to the left", "brakes")
FIRST = ("changes to the ego's lane", "accelerates to 90 km/h")
SENTENCES = (
    "The ego turns left at a crossroads with a stop sign.",
    "The ego drives at 70 km/h. A lorry at 80 km/h in the right lane, 10 m ahead, cuts in.",
    "A van overtakes the ego on the left and cuts in when it is 8 m ahead of the ego.",
    "A car at 120 km/h overtakes the ego, at 100 km/h, and cuts in with a headway of 0.6 s.",
    "A wrong-way driver comes towards the ego in the left lane of a motorway; the ego drives in "
    "the left lane and collides with it.",
    "The ego reverses at 4 km/h and hits a box behind it.",
    "A truck ahead of the ego hides a stationary car and changes to the left lane.",
    "A car backs out of a driveway on the left and stops in the ego's lane.",
    "The ego, at 70 km/h, overtakes a cyclist at 20 km/h at a lateral distance of 1.5 m while an "
    "oncoming car at 80 km/h is 150 m away.",
    "A car runs a red light.",
    "The ego ignores the stop sign and goes straight.",
    "The ego drives at 50 km/h and a car hits it from behind.",
    "The ego stops for a pedestrian and is rear-ended.",
    "The ego is overtaken on the left while the car ahead brakes.",
    "The car ahead overtakes a truck.",
    "An oncoming car changes lanes to the right.",
    "A crate lies on the right edge of the road.",
    "The ego passes a parked van at a lateral distance of 1 m.",
    "The lead car swerves around a broken-down lorry 30 m ahead of the ego.",
    "A pedestrian runs at 10 km/h from behind a parked van 25 m ahead; the ego drives at 40 km/h.",
    "A van drives 20 m behind a truck ahead of the ego and a child runs across the road.",
    "A car from the left runs a red light and it is hit by the ego's left front corner.",
    "The ego drives at 50 km/h and turns left at a crossroads, where it hits a standing car.",
    "The ego, at 50 km/h, approaches a stationary truck and brakes at a TTC of 3 s but hits it.",
    "A car at 90 km/h behind the ego, at 60 km/h, brakes 20 m behind it and hits it.",
    "The ego changes to the left lane in front of a car that drives at 80 km/h 20 m behind it.",
    "At a T-junction the truck ahead, at 55 km/h, brakes hard.",
    "Head-on: ego 50 km/h, car 50 km/h, 50 % overlap.",
    "A car does 80 in a 50 and hits the ego at a crossroads.",
    "Two cars stand side by side, one in each lane, 80 m ahead of the ego, which brakes to a stop.",
    "The ego turns left at a junction. A car from the left drifts into its lane and hits it.",
    "The ego and a truck ahead wait at a red light. At green the truck sets off, the ego follows.",
    "Behind a bus the ego stands at a red light. At green the bus sets off and stops again at "
    "once, and the ego hits it.",
    "The car 3 m ahead sets off when the light turns green, and the ego stays where it is.",
    "A pedestrian steps out in front of a car stopped in the oncoming lane.",
    "A truck on the left lane hides a pedestrian who crosses from the left.",
    "A van swerves into the ego's lane.",
    "A pedestrian crosses from the right; the ego brakes when the pedestrian is 20 m away.",
    "A dog runs onto the road and a child runs after it.",
    "The ego turns right while a pedestrian walks over the crosswalk of the road it turns into.",
    "A cyclist rides ahead of the ego at 15 km/h; the ego, at 50 km/h, hits it at 50 % overlap.",
    "A van pulls out from the minor road of a T-junction in front of the ego. "
    "The time gap is 1.5 s.",
    "A van pulls out of a side road in front of the ego with a TTC of 2 s.",
    "The ego pulls out of a side road 25 m in front of a truck doing 50 km/h.",
    "At a T-junction without signs, a car from the right does not yield to the ego. TTC is 2 s.",
    "A truck pulls out of a driveway behind the ego, which drives 50 km/h.",
    "The ego enters the roundabout 1 s after a bicycle coming from the left and nearly hits it.",
    "The ego follows a car into the roundabout at a gap of 8 m, and the car lets a bus pass.",
    "A bus ahead of the ego in the roundabout brakes hard and the ego rear-ends it.",
    "The car ahead slows down to turn right into a driveway; the ego, at 45 mph and 1.2 s behind, "
    "nearly hits it.",
    "The target cuts in, then cuts out again.",
    "A car overtakes the ego and brakes hard.",
    "A car closes in to 5 m behind the ego, then overtakes it.",
    "The lead vehicle decelerates with 2 m/s² and then brakes with 8 m/s².",
    "Car A brakes, then car B, which drives behind A, changes into the ego's lane.",
    "The car ahead cuts out to reveal a truck at 20 km/h; the ego avoids a collision.",
)
WALKERS = (
    "The car ahead brakes for a pedestrian.",
    "A car ahead brakes for a pedestrian in a roundabout.",
    "The light turns green, the car ahead sets off and then brakes again for a pedestrian.",
)


def made(text):
    functional = read(text)
    assert not functional.unsupported
    target, options = chosen_target(None, functional), Options()
    listed = pick(enumerate_scenarios(functional, limit=50), None)
    ((_, proof),) = make_some(functional, listed, target, options, lambda _: None).proofs.items()
    return proof


@pytest.mark.parametrize("text", [f"{who} {does}." for who in WHO for does in DOES])
def test_where_somebody_is_and_what_it_does_hold_together(text):
    assert not made(text).missed


@pytest.mark.parametrize("text", [f"{who} {does}." for who in GOES_ACROSS for does in ACROSS])
def test_who_goes_across_and_when_hold_together(text):
    assert not made(text).missed


@pytest.mark.parametrize("text", [f"{comes} {ends}." for comes in COMES for ends in ENDS])
def test_how_far_it_is_and_how_it_ends_hold_together(text):
    proof = made(text)
    assert not proof.missed
    assert proof.in_band


@pytest.mark.parametrize("text", WALKERS)
def test_whom_somebody_brakes_for_crosses_before_that_one(text):
    proof = made(text)
    assert not proof.missed
    assert proof.in_band
    ways = {claim.statement for claim in proof.claims}
    assert "crossing pedestrian by pedestrian_1 to car_1 happens" in ways


@pytest.mark.parametrize("text", [f"{a}, the truck {b}." for a in MEANWHILE for b in TRUCK])
def test_what_is_done_beside_another_is_done_there(text):
    assert not made(text).missed


@pytest.mark.parametrize("text", [f"Before braking to a stop, the van {does}." for does in FIRST])
def test_what_comes_first_may_be_told_last(text):
    assert not made(text).missed


@pytest.mark.parametrize("text", SENTENCES)
def test_one_sentence_is_made_as_it_is_said(text):
    proof = made(text)
    assert not proof.missed
    assert proof.in_band
