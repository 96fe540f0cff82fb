"""Protocols, lists, tables and titles say the same as the sentence."""

import pytest

from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.spacings import START
from scegen.understanding import read
from scegen.understanding.words.tokens import tokenize

LEAD = [
    "The ego drives at 50 km/h behind a car at 30 km/h. The gap is 20 m. The car brakes with "
    "5 m/s2.",
    "Ego: 50 km/h\nLead car: 30 km/h\nGap: 20 m\nLead car brakes with 5 m/s2",
    "- Ego: 50 km/h\n- Lead car: 30 km/h\n- Gap: 20 m\n- Lead car brakes with 5 m/s2",
    "* Ego 50 km/h\n* Lead car 30 km/h, gap 20 m\n* Lead car brakes with 5 m/s2",
    "1. The ego drives at 50 km/h behind a car at 30 km/h.\n2. The gap is 20 m.\n"
    "3. The car brakes with 5 m/s2.",
    "1) Ego drives 50 km/h behind a car driving 30 km/h\n2) gap is 20 m\n"
    "3) the car brakes with 5 m/s2",
    "ego | 50 km/h\nlead car | 30 km/h\ngap | 20 m\nlead car | brakes with 5 m/s2",
    "Ego: 50 km/h | Lead: 30 km/h | Gap: 20 m | Lead brakes at 5 m/s2",
    "Ego: 50 km/h, lead: 30 km/h, gap: 20 m. The lead brakes at 5 m/s2",
    "Preconditions:\n- ego at 50 km/h\n- lead car at 30 km/h, 20 m ahead\n"
    "Action:\n- lead car brakes with 5 m/s2",
    "Ego 50 km/h - lead vehicle 30 km/h - gap 20 m - lead vehicle brakes with 5 m/s2.",
    "Ego (50 km/h) follows lead car (30 km/h) / gap 20 m / lead car brakes with 5 m/s2",
    "The ego drives at 50 km/h\nbehind a car at\n30 km/h with a gap of\n20 m, the car brakes\n"
    "with 5 m/s2.",
    "THE EGO DRIVES AT 50 KM/H BEHIND A CAR AT 30 KM/H, GAP 20 M, THE CAR BRAKES WITH 5 M/S2",
    "TC-012: Ego 50 km/h, lead car 30 km/h, gap 20 m, lead car brakes with 5 m/s2.",
    "Step 1: The ego drives at 50 km/h behind a car at 30 km/h, gap 20 m.\n"
    "Step 2: The car brakes with 5 m/s2.",
]
CUT_IN = [
    "A car at 60 km/h in the left lane cuts in 15 m ahead of the ego, which drives at 50 km/h.",
    "Ego:\n- speed 50 km/h\n- right lane\nTarget:\n- car in the left lane\n- 60 km/h\n"
    "- cuts in 15 m ahead of the ego",
    "Cut-in - ego 50 km/h, a car at 60 km/h from the left lane cuts in 15 m ahead of it.",
    "Cut-in of a car\nEgo: 50 km/h\nTarget: car, left lane, 60 km/h, cuts in 15 m ahead of the ego",
    "Title: Cut-in from the left\nDescription: A car at 60 km/h in the left lane cuts in 15 m "
    "ahead of the ego, which drives at 50 km/h.",
]


def told(functional: FunctionalScenario) -> list[object]:
    """Who drives where and how fast, how far apart, and what happens."""
    ego = functional.ego.id
    return [
        sorted((p.id == ego, p.kind, str(p.speed_mps)) for p in functional.participants),
        [(round(s.value.middle, 2), s.measure) for s in functional.spacings],
        [(a.participant == ego, a.kind, a.rate_mps2) for a in functional.acts],
        [(h.kind, [n == ego for n in h.by]) for h in functional.hazards],
        [left.text for left in functional.unsupported if not left.text.isupper()],
    ]


@pytest.mark.parametrize("ways", [LEAD, CUT_IN])
def test_the_layout_changes_nothing(ways):
    meant = told(read(ways[0]))
    assert meant[1], meant
    for text in ways[1:]:
        assert told(read(text)) == meant, text


def test_a_dash_or_a_slash_between_words_is_a_mark_and_within_them_none():
    for text, marks in [
        ("a pedestrian – hidden by a van – steps out", [",", ","]),
        ("rear-end crash at 30 - 50 km/h, 30 km / h", [","]),
        ("Cut-in - the ego brakes", [":"]),
        ("a car and/or a van", []),
        ("Ego: right lane, speed: 50 km/h, target: a van", [":", ",", ".", ":"]),
        ("Roundabout, six exits: ego 4th exit", [",", ":"]),
    ]:
        assert [t.low for t in tokenize(text) if t.kind == "punct"] == marks, text


@pytest.mark.parametrize("measure", ["a TTC of 2 s", "a time to collision of 2 s",
                                     "a distance of 25 m", "a time gap of 1.2 s"])  # fmt: skip
def test_a_measure_that_opens_a_clause_holds_when_its_act_begins(measure):
    before = "The lead vehicle drives at 60 km/h, the ego at 90 km/h."
    for does in ("brakes at 3 m/s2", "starts to brake at 3 m/s2", "changes to the left lane"):
        functional = read(f"{before} At {measure} the lead vehicle {does}.")
        (spacing,) = functional.spacings
        assert spacing.at == functional.acts[0].id, does
    (spacing,) = read(f"{before} At {measure}, the simulation starts.").spacings
    assert spacing.at == START
