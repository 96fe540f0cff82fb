"""Amounts, acts, spacings, things and outcomes: own sentences, and laws that hold for all."""

import json
import re
from pathlib import Path

import pytest
from compact_functional import compact
from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import read

HERE = Path(__file__).parent
CASES = [json.loads(line) for line in (HERE / "said.jsonl").read_text("utf-8").splitlines()]
BESIDE = [
    HERE.parents[2] / "shared" / "descriptions" / name
    for name in ("fidelity.jsonl", "catalogue.jsonl")
]
_UNIT = r"m/s²|m/s2|m/s\^2|ft/s2|km/h|kph|mph|m/s|percent|seconds?|metres?|feet|ft|g|m|s|%"
_NUMBER = re.compile(rf"\d+(?:\.\d+)?\s?(?:{_UNIT})(?![\w/])")
_NUMERIC = ("acts.", "spacings.", "outcome", "speed_limit", "_m", "delay_s", "kind", "lanes")


def test_the_own_sentences_are_all_there():
    """None would be green as well: a script once emptied the file."""
    assert len({case["id"] for case in CASES}) == len(CASES) > 500


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["id"])
def test_own_sentences(case):
    assert compact(read(case["text"])) == case["expect"]


def _lost(scenario: FunctionalScenario) -> list[str]:
    """Numbers with a unit that no field holds and no remark names."""
    spans = [
        (e.start, e.end)
        for e in scenario.evidence
        if e.start is not None and any(n in e.field for n in _NUMERIC)
    ]
    spans += [(u.start, u.end) for u in scenario.unsupported]
    found = _NUMBER.finditer(scenario.description)
    return [m[0] for m in found if not any(a <= m.start() < b for a, b in spans)]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["id"])
def test_no_number_is_lost(case):
    assert _lost(read(case["text"])) == []


@pytest.mark.parametrize("path", BESIDE, ids=lambda path: path.stem)
def test_no_number_is_lost_in_texts_beside_the_checkout(path):
    if not path.exists():
        pytest.skip("no descriptions lie beside the checkout")
    texts = [json.loads(line)["text"] for line in path.read_text("utf-8").splitlines()]
    assert [lost for text in texts if (lost := _lost(read(text)))] == []


_TEMPLATES = (
    "The ego drives at {v} and follows a car with a gap of {d}; the car brakes with {a}.",
    "A van at {v} cuts in from the left {d} ahead of the ego and brakes with {a} after {t}.",
    "A pedestrian crosses from the right at {w} when the ego, which drives {v}, is {d} away.",
    "Ego {v}, lead {v}, time gap {t}, lead brakes {a} to {w}.",
    "{t} after the lead has changed to the right lane, the ego at {v} brakes with {a} to {w}.",
    "The stationary bus is {d} ahead of the ego, which drives at {v} with {p} overlap.",
    "While the ego does {v}, the car {d} in front of it slows down at {a} for {t}.",
    "The lorry is {d} long and drives {v} beside the ego, {d} to the left, {t} before the bend.",
)


@settings(max_examples=60)
@given(
    template=st.sampled_from(_TEMPLATES),
    v=st.integers(20, 130),
    w=st.integers(3, 15),
    d=st.integers(3, 90),
    t=st.sampled_from((0.5, 1, 1.2, 2.5, 4)),
    a=st.sampled_from((2, 4.5, 7, 9.81)),
    p=st.sampled_from((25, 50, 100)),
)
def test_no_number_is_lost_in_any_of_many(template, v, w, d, t, a, p):
    text = template.format(
        v=f"{v} km/h", w=f"{w} km/h", d=f"{d} m", t=f"{t} s", a=f"{a} m/s²", p=f"{p} %"
    )
    assert _lost(read(text)) == []


def _close(one: object, other: object) -> bool:
    """The same, with numbers to a hundredth part."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_close(one[k], other[k]) for k in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_close, one, other))
    if isinstance(one, int | float) and isinstance(other, int | float):
        return one == pytest.approx(other, rel=0.01, abs=0.02)
    return one == other


@settings(max_examples=40)
@given(
    template=st.sampled_from(_TEMPLATES),
    v=st.integers(30, 120),
    d=st.integers(5, 80),
    a=st.sampled_from((4.0, 6.0, 8.0)),
)
def test_units_do_not_matter(template, v, d, a):
    metric = template.format(
        v=f"{v} km/h", w="7.2 km/h", d=f"{d} m", t="1.5 s", a=f"{a} m/s2", p="50 %"
    )
    other = template.format(
        v=f"{v / 1.609344:.4f} mph",
        w="2 m/s",
        d=f"{d / 0.3048:.4f} ft",
        t="1500 ms",
        a=f"{a / 9.80665:.4f} g",
        p="50 percent",
    )
    assert _close(compact(read(metric)), compact(read(other)))


@pytest.mark.parametrize("unit", ["m/s²", "m/s2", "m/s^2", "m / s^2", "m/sec2", "m/s**2"])
def test_an_acceleration_is_never_a_speed(unit):
    scenario = read(f"The lead car brakes with 6 {unit} in front of the ego.")
    assert all(p.speed_mps is None for p in scenario.participants)
    rate = scenario.acts[0].rate_mps2
    assert rate is not None
    assert rate.low == rate.high == 6


def test_the_same_traffic_is_counted_once():
    texts = [
        "The ego turns left, yields to oncoming traffic and then crosses the oncoming traffic.",
        "The ego follows a car. The lead vehicle brakes, and the leading car stops. It stands.",
        "The ego drives behind a van; the vehicle ahead slows down, and the ego brakes for it.",
    ]
    assert [len(read(text).participants) for text in texts] == [2, 2, 2]


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("Ein Auto fährt vor dem Ego und bremst auf der Straße.", "German"),
        ("Une voiture tourne à gauche devant un piéton.", "French"),
        ("Un coche gira a la izquierda y un peatón cruza la carretera.", "Spanish"),
        ("El ego sigue a un camión a 50 km/h.", "Spanish"),
        ("Un'auto taglia la strada all'ego a 50 km/h.", "Italian"),
        ("Auto odbočuje vlevo, chodec přechází.", "English"),
        ("Автомобиль поворачивает налево.", "Latin"),
    ],
)
def test_another_language_is_said_to_be_so(text, language):
    with pytest.raises(InputError, match=language):
        read(text)


@pytest.mark.parametrize(
    "text", ["Lead car left, VUT right.", "A car on El Camino Real in San Juan hits a van."]
)
def test_english_with_foreign_names_is_read(text):
    assert read(text).participants
