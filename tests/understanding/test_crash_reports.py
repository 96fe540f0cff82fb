"""The manner of police reports, insurance claims and news: who is who, and what hits what."""

import pytest

from scegen.understanding import read


def kinds(text):
    return sorted(f"{'parked_' * p.parked}{p.kind.value}" for p in read(text).participants)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The insured's pickup hit the claimant's moped at a junction.", ["motorcycle", "truck"]),
        ("The claimant was pedalling home when the insured opened a door.", ["bicycle", "car"]),
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
