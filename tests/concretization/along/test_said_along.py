"""What plain sentences say along a road holds before any search."""

import pytest
from saying import missed
from told import first

from scegen.concretization.things import SHAPES
from scegen.scenario.functional import Hazard
from scegen.scenario.things import Thing, ThingKind
from scegen.scenario.vocabulary import HazardKind
from scegen.understanding import read

SENTENCES = [
    "A child runs across the road at 10 km/h, stops in the ego's lane for 2 s and runs on.",
    "A woman stops at the kerb for 3 s and then crosses the road.",
    "A van cuts in from the right at a time to collision of 4 s.",
    "The lead car brakes when the time to collision is 3 s.",
    "The ego stands behind a van. After 4 s the van reverses at 4 km/h and bumps into the ego.",
    "The ego stands 7 m behind a stopped truck. After 2 s the truck reverses into it.",
    "The ego drives at 30 km/h towards a van. The van reverses towards it at 5 km/h.",
    "An oncoming van swerves into the ego's lane and collides with it; both drive 60 km/h.",
    "A van is parked on the right. When the ego, doing 40 km/h, is 25 m from the van, "
    "a child runs out in front of it.",
    "Behind the ego, which brakes at 5 m/s² from 50 km/h for a stationary car, a truck follows "
    "9 m behind and runs into it.",
    "While the ego cruises in the right lane at 90 km/h, a bus passes it at 110 km/h in the left "
    "lane.",
    "An ambulance comes up from behind at 100 km/h with blue lights; we, doing 80 km/h, move to "
    "the right lane and it passes us on the left.",
    "A cyclist rides 20 m ahead of the ego at 15 km/h. The ego overtakes it with 1.5 m of "
    "clearance at 45 km/h.",
    "A cyclist rides 20 m ahead of the ego at 15 km/h on the right of the lane. The ego passes "
    "with 1.5 m of clearance at 45 km/h.",
    "The ego follows a car at 80 km/h with a gap of 25 m. The car changes to the left lane and "
    "reveals a stationary van 60 m ahead of the ego.",
    "A car from the left lane cuts in; when it has changed lanes it is 8 m ahead of the ego.",
    "The test car is parked on the right. Only after a truck that comes from behind at 40 km/h has "
    "gone by does the test car pull out.",
    "The ego pulls out of a parking space on the right in front of a van that comes from behind at "
    "50 km/h. The van brakes and there is no contact.",
    "Our lane is blocked by a van that is double-parked. Approaching at 30 km/h, we pull out, pass "
    "without contact and pull in again.",
    "The ego drives at 60 mph in the right lane of a motorway. A truck travelling at 20 mph on the "
    "hard shoulder changes into that lane ahead of the ego, and the ego slows down.",
    "A motorbike behind the ego, doing 100 km/h, swings out, passes the ego and goes back to its "
    "lane. The ego drives at 80 km/h.",
    "A police car approaches us from behind at 80 km/h, swings to the left and passes. We keep "
    "40 km/h.",
    "A car cuts in ahead of us and shortly after goes back to its old lane. We and the car drive "
    "at 80 km/h in the middle and in the right lane of three at first.",
    "The ego drives at 60 km/h. A van passes it on the left at 130 km/h and cuts back in 8 m in "
    "front of it.",
    "The truck ahead swerves to the right.",
    "The ego drives at 70 km/h; the car 30 m ahead of it drives at 60 km/h and brakes at a headway "
    "of 1.2 s.",
    "The ego drives at 60 km/h and overtakes a stationary truck at a TTC of 3 s.",
    "The ego drives at 80 km/h behind a truck at 60 km/h and overtakes it, starting 20 m behind.",
    "The ego drives at 30 km/h. A child runs out from behind a parked van 20 m ahead.",
]


@pytest.mark.parametrize("text", SENTENCES)
def test_it_holds_from_the_first(text):
    functional = read(text)
    assert functional.acts
    crash = functional.outcome is not None  # halts them only in the end
    assert missed(functional, first(functional)) <= ({"contacts"} if crash else set())


@pytest.mark.parametrize("who", ["cyclist rides at 15", "van drives at 50"])
def test_two_who_face_each_other_pass_with_the_gap_that_is_said(who):
    functional = read(
        f"An oncoming {who} km/h. The ego does 40 km/h. The gap to the side is 1.4 m."
    )
    assert [spacing.measure for spacing in functional.spacings] == ["lateral_gap_m"]
    assert not missed(functional, first(functional))


@pytest.mark.parametrize("kind", [HazardKind.OCCLUSION, HazardKind.OBSTACLE])
def test_a_danger_by_somebody_and_by_a_thing_has_both(kind):
    functional = read("The ego goes straight at a crossroads. A cyclist comes from the right.")
    thing = Thing(id="wall_1", kind=ThingKind.WALL, hides=("bicycle_1",))
    danger = Hazard(kind=kind, by=("bicycle_1", "wall_1"), to=("ego",))
    made = first(functional.model_copy(update={"objects": (thing,), "hazards": (danger,)}))
    assert [thing.id for thing in made.objects] == ["wall_1"]
    assert made.objects[0].height_m == SHAPES[ThingKind.WALL].height_m
