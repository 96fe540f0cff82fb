"""What is said in short: verbs and units left out, second names, shares in words."""

import pytest

from scegen.scenario.spacings import Measure
from scegen.understanding import read


def of_kind(scenario, kind):
    return [p for p in scenario.participants if p.kind.value == kind]


def test_a_clause_without_its_verb_takes_the_one_before():
    scenario = read("One car stands in the ego's lane, another in the lane to the left.")
    assert [sorted(p.maneuvers) for p in of_kind(scenario, "car") if p.id != "ego"] == [
        ["stay"]
    ] * 2
    braking = read("The car ahead brakes, the ego 0.9 s after the car.").acts
    assert [a.participant for a in braking] == ["car_1", "ego"]
    assert braking[1].when.act == braking[0].id
    assert braking[1].when.delay_s.middle == pytest.approx(0.9)


@pytest.mark.parametrize(
    ("words", "kph"),
    [
        ("The ego is passed at 100 km/h by a van. Its own speed is 80.", (80, 100)),
        ("A van follows the ego, 100 km/h against the ego's 80.", (80, 100)),
        ("The ego and a van meet at a crossroads, 30 km/h each.", (30, 30)),
        ("A van ahead drives 90 km/h and the ego drives just as fast.", (90, 90)),
    ],
)
def test_speeds_without_a_unit_or_of_each(words, kph):
    speeds = {p.kind.value: p.speed_mps.middle * 3.6 for p in read(words).participants}
    assert speeds["van"] == pytest.approx(kph[1])
    ego = next(p for p in read(words).participants if p.id == "ego")
    assert ego.speed_mps.middle * 3.6 == pytest.approx(kph[0])


@pytest.mark.parametrize(
    ("words", "share"),
    [("one third of the ego's width is overlapped", 100 / 3), ("the fronts have half overlap", 50)],
)
def test_shares_of_a_width_in_words(words, share):
    (spacing,) = read(f"The ego hits a stationary car; {words}.").spacings
    assert spacing.measure is Measure.OVERLAP_PERCENT
    assert spacing.value.middle == pytest.approx(share)


def test_what_the_road_is_like_in_numbers():
    around = read("Visibility 90 m, friction 0.4: the ego follows a van.").environment
    assert (around.visual_range_m, around.friction) == (90.0, 0.4)


def test_every_number_is_used_or_named():
    scenario = read("The ego follows a van on a road of class 7.")
    assert "7" in [u.text for u in scenario.unsupported]
    assert scenario.unjudged.endswith(
        "not expressed and not judged: " + ", ".join(f'"{u.text}"' for u in scenario.unsupported)
    )
    assert read("The ego follows a van.").unjudged is None
