"""The manner of police reports, insurance claims and news: who is who, and what hits what."""

import pytest

from scegen.understanding import read


def kinds(text):
    return sorted(f"{'parked_' * p.parked}{p.kind.value}" for p in read(text).participants)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The insured's pickup hit the claimant's moped at a junction.", ["motorcycle", "truck"]),
        (
            "The claimant was pedalling home when the insured opened a door.",
            ["bicycle", "parked_car"],
        ),
        ("The claimant was walking across the road when a bus hit her.", ["bus", "pedestrian"]),
        ("A student riding a moped was struck by a van turning left.", ["motorcycle", "van"]),
        ("A woman driving a coach ran into a stationary taxi.", ["bus", "car"]),
        ("Pedestrian 1 was crossing when vehicle 1 turned right.", ["car", "pedestrian"]),
        ("Unit 2, a jogger, was struck by unit 1.", ["car", "pedestrian"]),
        ("Vehicle one stopped. Vehicle two ran into the back of vehicle one.", ["car", "car"]),
    ],
)
def test_one_participant_for_each(text, expected):
    assert kinds(text) == expected


@pytest.mark.parametrize(
    ("text", "who"),
    [
        ("A Volvo follows a Kia on a road. The Volvo speeds.", "car_1"),
        ("A Volvo follows a Kia on a road. The Kia speeds.", "car_2"),
        ("A saloon and a taxi drive on a road. The taxi speeds.", "car_2"),
        ("V1 (a Fiat) and V2 (a Skoda) drive on a road. The driver of the Fiat speeds.", "car_1"),
        ("The car behind it, a red Audi, speeds along.", "car_1"),
    ],
)
def test_nouns_tell_them_apart(text, who):
    (hazard,) = read(text).hazards
    assert hazard.by == (who,)


def test_what_an_apposition_does():
    scenario = read("At a junction V1 hit V2, a van turning left.")
    assert scenario.participant("van_1").maneuvers == {"left"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Officers said a van hit a taxi.", ["car", "van"]),
        ("The cyclist told a policeman that the bus had cut in.", ["bicycle", "bus"]),
        ("According to witnesses, a coach overtook a moped.", ["bus", "motorcycle"]),
        ("At approx. 0815 hrs V1 was S/B on Hwy. 7 when V2 cut in.", ["car", "car"]),
        ("At 22:40 a van hit a taxi on the B4009.", ["car", "van"]),
        ("A lorry overtook me on I-80 at 7.15 a.m. on Monday.", ["car", "truck"]),
        ("A father with his daughter crosses the road.", ["car", "pedestrian", "pedestrian"]),
        ("The cyclist, a man of sixty from Ghent, hit a van.", ["bicycle", "van"]),
    ],
)
def test_who_does_not_take_part(text, expected):
    assert kinds(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A man walks along the road as the ego comes up.", set()),
        ("Two girls were strolling down the street.", set()),
        ("A man walked along the road and then across it.", {"crossing_pedestrian"}),
        ("A nurse was knocked down on a zebra crossing by a van.", {"crossing_pedestrian"}),
        ("A gardener then ran across the road.", {"crossing_pedestrian"}),
        ("The car behind the ego did not stop in time at the lights.", {"delayed_braking"}),
        ("A van pulled off the verge. V2 did not slow down.", set()),
        ("A bus brakes hard and the van behind it does not slow down.",
         {"hard_braking", "delayed_braking"}),
    ],
)  # fmt: skip
def test_what_is_dangerous(text, expected):
    assert {h.kind.value for h in read(text).hazards} == expected


def test_reported_speech_keeps_its_subject():
    scenario = read("Police believe the van overtook a bus before it hit an oncoming taxi.")
    assert scenario.participant("van_1").maneuvers == {"overtake"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Three people were injured when a van hit a stationary bus.", ["bus", "van"]),
        ("A man died when his van ran into the back of a lorry.", ["truck", "van"]),
        ("A woman was hurt when she was knocked down by a bus.", ["bus", "pedestrian"]),
        ("A jogger was killed when a van mounted the kerb.", ["pedestrian", "van"]),
        ("A van clipped the vicar's moped.", ["motorcycle", "van"]),
        ("A taxi pursued by a patrol car ran a stop sign.", ["car", "emergency_vehicle"]),
        ("A moped ran into her wing as the taxi set off.", ["car", "motorcycle"]),
    ],
)
def test_people_and_owners_who_take_no_part(text, expected):
    assert kinds(text) == expected


def test_a_bend_to_the_left_is_no_turn():
    scenario = read("V1 was negotiating a bend to the left and crossed into the oncoming lane.")
    assert scenario.junction.kind == "straight"
    assert [h.kind for h in scenario.hazards] == ["oncoming_lane"]


def test_out_of_a_road_named_by_its_direction():
    scenario = read("V1 turned left from northbound Elm Street. V2 was heading south.")
    (other,) = [p for p in scenario.participants if p.role == "other"]
    assert other.approaches == {"opposite"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("V1 waited at a stop sign. V2 did not stop and ran into the back of V1.",
         {"delayed_braking"}),
        ("The van halted at a red light when a taxi failed to stop and hit it from behind.",
         {"delayed_braking"}),
        ("V2 did not stop at the stop sign and hit V1 in the side.", {"failure_to_yield"}),
        ("A van in the next lane accelerated and blocked the ego.", {"sudden_acceleration"}),
        ("A man walks onto the road; the ego brakes.", {"crossing_pedestrian"}),
        ("Two vans were racing each other along the coast road.", {"speeding"}),
    ],
)  # fmt: skip
def test_braking_too_late_and_giving_way(text, expected):
    assert {h.kind.value for h in read(text).hazards} == expected


def test_whose_rear_is_hit_is_ahead():
    scenario = read("V1 slowed and a lorry ran into the back of V1.")
    assert scenario.participant("truck_1").approaches == {"behind"}


def test_a_failing_driver_is_no_failed_light():
    scenario = read("V1 waited at the traffic lights when V2 failed to stop.")
    assert scenario.junction.control == "signals"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A coach driven by a 40-year-old female hit a moped ridden by a student.",
         ["bus", "motorcycle"]),
        ("The 12-year-old was hit by a van.", ["pedestrian", "van"]),
        ("A 52-year-old motorcyclist passed a tram.", ["bus", "motorcycle"]),
        ("The insured was driving her sister's van when a bus hit her.", ["bus", "van"]),
        ("A father with a pram had to leap out of the way of a taxi.", ["car", "pedestrian"]),
    ],
)  # fmt: skip
def test_people_by_age_and_at_the_wheel(text, expected):
    assert kinds(text) == expected


@pytest.mark.parametrize(
    ("text", "who", "does"),
    [
        ("V1 followed a tractor and pulled out to pass.", "car_1", {"overtake"}),
        ("I was stationary at the traffic lights when a van hit me.", "ego", {"stay"}),
        ("At the lights a van turned left across the path of the ego.", "ego", {"straight"}),
        ("V1 pulled out of a yard into the path of V2, northbound on Elm Street.", "car_2",
         {"straight"}),
        ("A jogger ran into the path of the ego as it was turning left.", "ego", {"left"}),
    ],
)  # fmt: skip
def test_ways_that_follow(text, who, does):
    assert read(text).participant(who).maneuvers == does


def test_only_an_open_door_is_in_the_way():
    assert read("A van struck V2 in the driver's door.").hazards == ()
    assert [h.kind for h in read("A cyclist hit the open door of a car.").hazards] == ["obstacle"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Two students survived when their van hit a tree.", ["van"]),
        ("An autonomous van in driverless mode followed a bus.", ["bus", "van"]),
        ("One pedestrian crosses, another waits at the kerb, and the ego stops.",
         ["car", "pedestrian", "pedestrian"]),
        ("The first car in the right lane brakes, the second swerves in front of the ego.",
         ["car", "car", "car"]),
    ],
)  # fmt: skip
def test_how_many(text, expected):
    assert kinds(text) == expected


def test_a_turn_further_ahead_cuts_nobody_off():
    assert read("The ego slows as a van turns left ahead of it at a junction.").hazards == ()


def test_driving_through_is_going_straight_on():
    scenario = read("V1 ignored the stop sign and drove through the crossroads.")
    assert scenario.participant("car_1").maneuvers == {"straight"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The motorcyclist came off his bike and was hit by a van.", ["motorcycle", "van"]),
        ("The pedestrian on the left waits while the one on the right crosses before the ego.",
         ["car", "pedestrian", "pedestrian"]),
    ],
)  # fmt: skip
def test_one_name_for_each(text, expected):
    assert kinds(text) == expected


def test_its_path_is_that_of_the_only_other_one():
    (hazard,) = read("V2 was going north. V1 came out of a yard and pulled into its path.").hazards
    assert (hazard.kind, hazard.by, hazard.to) == ("failure_to_yield", ("car_2",), ("car_1",))
