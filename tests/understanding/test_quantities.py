"""Numbers with their units, as they are written and spoken."""

import pytest

from scegen.understanding import read
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.tokens import tokenize


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("40 ± 2 km/h", 38 / 3.6, 42 / 3.6),
        ("40 km/h ± 2 km/h", 38 / 3.6, 42 / 3.6),
        ("40 km/h (± 5 %)", 38 / 3.6, 42 / 3.6),
        ("40 +/- 2 km/h", 38 / 3.6, 42 / 3.6),
        ("two point five seconds", 2.5, 2.5),
        ("one and a half seconds", 1.5, 1.5),
        ("half a second", 0.5, 0.5),
        ("nine metres per second squared", 9, 9),
        ("between 4 and 6 m", 4, 6),
        ("1,5 s", 1.5, 1.5),
    ],
)
def test_how_much_it_is(text, low, high):
    quantity = quantity_at(tokenize(text), 0)
    assert quantity is not None
    assert (quantity.value.low, quantity.value.high) == (pytest.approx(low), pytest.approx(high))


@pytest.mark.parametrize(
    "text",
    [
        "Ego 40 km/h, limit 60 km/h, straight road.",
        "Zone 60 km/h, the ego drives at 40 km/h.",
        "60 km/h limit, ego 40 km/h.",
        "The ego drives at 40 km/h where the limit is 60 km/h.",
    ],
)
def test_a_limit_is_nobodys_speed(text):
    scenario = read(text)
    assert scenario.junction.speed_limit_mps == pytest.approx(60 / 3.6)
    assert [p.speed_mps.low for p in scenario.participants if p.speed_mps] == [
        pytest.approx(40 / 3.6)
    ]


@pytest.mark.parametrize(
    "text",
    [
        "The ego drives at 50 km/h, a van comes from the left at 30.",
        "Ego 50 km/h, the van ahead does 30 and brakes.",
        "The lead vehicle travels at 30 and the ego at 50 km/h.",
    ],
)
def test_a_bare_speed_has_the_unit_of_the_others(text):
    speeds = sorted(p.speed_mps.low for p in read(text).participants if p.speed_mps)
    assert speeds == [pytest.approx(30 / 3.6), pytest.approx(50 / 3.6)]


@pytest.mark.parametrize(
    ("text", "whose"),
    [
        ("My speed was 45 mph when the pickup in front braked.", "ego"),
        ("A van drives at 80 % of the ego's speed of 90 km/h.", "ego"),
        ("A van sets off on the right when the ego is 15 m away and doing 32 km/h.", "ego"),
        ("A man steps into the road with the ego 25 m away and doing 40 km/h.", "ego"),
        ("The cyclist, whom the ego overtakes at 60 km/h, veers to the left.", "ego"),
        ("The ego at 50 km/h meets an oncoming van, also at 50 km/h.", "ego, van_1"),
    ],
)
def test_whose_speed_it_is(text, whose):
    with_speed = [p.id for p in read(text).participants if p.speed_mps]
    assert ", ".join(sorted(with_speed)) == whose


@pytest.mark.parametrize(
    ("text", "lost"),
    [
        ("The ego brakes 0.8 s after the van has passed the sign.", "0.8 s"),
        ("A car from the left is 2.1 s from the collision point; the ego goes straight.", "2.1 s"),
        ("The ego comes within 30 m of the crossing when a child runs onto the road.", "30 m"),
        ("Three cars stand ahead of the ego, each 3 m clear of the next.", "3 m"),
    ],
)
def test_what_no_field_holds_is_reported_and_not_misread(text, lost):
    scenario = read(text)
    assert lost in [u.text for u in scenario.unsupported]
    assert scenario.spacings == ()


@pytest.mark.parametrize("measure", ["50 km/h", "20 m", "1.5 s", "30 %"])
@pytest.mark.parametrize("sign", ["-", "\u2212"])
def test_a_figure_below_zero_is_left_out_and_said(measure: str, sign: str) -> None:
    """No field holds which way it points; without its sign it would be another figure."""
    scenario = read(f"The ego hits a car at {sign}{measure}.")
    assert [i.text for i in scenario.unsupported] == [f"{sign}{measure}"]


def test_who_brakes_may_be_said_to_do_it_with_a_sign() -> None:
    """``brakes with -6 m/s2`` is what ``brakes with 6 m/s2`` is."""
    (act,) = read("The lead car brakes with -6 m/s2.").acts
    assert act.rate_mps2 is not None
    assert act.rate_mps2.low == act.rate_mps2.high == 6
