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
]


@pytest.mark.parametrize("text", SENTENCES)
def test_it_holds_from_the_first(text):
    functional = read(text)
    assert functional.acts
    crash = functional.outcome is not None  # halts them only in the end
    assert missed(functional, first(functional)) <= ({"contacts"} if crash else set())


@pytest.mark.parametrize("kind", [HazardKind.OCCLUSION, HazardKind.OBSTACLE])
def test_a_danger_by_somebody_and_by_a_thing_has_both(kind):
    functional = read("The ego goes straight at a crossroads. A cyclist comes from the right.")
    thing = Thing(id="wall_1", kind=ThingKind.WALL, hides=("bicycle_1",))
    danger = Hazard(kind=kind, by=("bicycle_1", "wall_1"), to=("ego",))
    made = first(functional.model_copy(update={"objects": (thing,), "hazards": (danger,)}))
    assert [thing.id for thing in made.objects] == ["wall_1"]
    assert made.objects[0].height_m == SHAPES[ThingKind.WALL].height_m
