"""Texts composed of parts, drawn at random, are read as what their parts say."""

import numpy as np
import pytest

from scegen.scenario.acts import ActKind, WhenMeasure
from scegen.scenario.vocabulary import Role
from scegen.understanding import read

TEXTS = 40
EGOS = ["the ego", "the ego vehicle", "the VUT", "the SUT", "our car", "the test vehicle"]
NOUNS = {
    "car": ["passenger car", "sedan", "hatchback"],
    "truck": ["truck", "lorry", "HGV"],
    "van": ["van", "delivery van"],
    "motorcycle": ["motorcycle", "motorbike"],
    "bus": ["bus", "coach"],
}
PLACES = {
    "ahead": ["ahead of {ego}", "in front of {ego}"],
    "behind": ["behind {ego}", "at the rear of {ego}"],
    "left": ["in the left lane next to {ego}", "in the adjacent lane on the left"],
    "right": ["in the right lane beside {ego}", "in the lane to the right of {ego}"],
}
LED = [
    "{ego} follows a {other} at {v} km/h with a gap of {gap} m",
    "{ego} is travelling at {v} km/h. A {other} is {gap} m ahead of it at {v} km/h",
    "a {other} drives {gap} m in front of {ego}, both at {v} km/h",
    "{gap} m ahead of {ego}, which does {v} km/h, a {other} travels at {v} km/h",
    "in front of {ego} ({v} km/h), at a distance of {gap} m, drives a {other} with {v} km/h",
    "a {other} leads {ego} by {gap} m; each of them drives {v} km/h",
    "{ego} keeps {gap} m to a {other}; both drive {v} km/h",
]
CALLED = ["the {other}", "the lead vehicle", "the vehicle in front", "the preceding vehicle"]
BRAKES = ["brakes with {rate} m/s²", "decelerates at {rate} m/s²", "starts braking at {rate} m/s²"]
WHEN = [
    "after 3 s {who} {brakes}",
    "3 s after the start, {who} {brakes}",
    "{who} {brakes} after 3 s",
]
FOLLOWED = [
    "{ego} is followed by a {other} at a distance of {gap} m; both drive at {v} km/h",
    "a {other} follows {ego} with a gap of {gap} m at {v} km/h",
    "{gap} m behind {ego} ({v} km/h) drives a {other} with {v} km/h",
]
STRUCK = [
    "The following vehicle brakes too late and crashes into {ego}",
    "The {other} does not react and hits it",
    "The vehicle behind collides with it",
]
BESIDE = [
    "a {other} drives in the {side} lane at {w} km/h",
    "in the lane to the {side} of {ego} a {other} drives at {w} km/h",
    "a {other} at {w} km/h is ahead of it in the {side} lane",
]
CUTS_IN = [
    "the {other} cuts in in front of {ego} at a gap of {gap} m",
    "when the gap is {gap} m, the {other} cuts in",
    "{gap} m in front of {ego} the {other} swerves into its lane",
    "at a distance of {gap} m the {other} pulls into the lane of {ego}",
]


class Draw:
    """What one text is composed of."""

    def __init__(self, seed):
        self._rng = np.random.default_rng(seed)
        self.ego = self.one(EGOS)
        self.kind = self.one(sorted(NOUNS))
        self.other = self.one(NOUNS[self.kind])
        self.v, self.w = int(self.one([50, 60, 80, 100])), int(self.one([30, 40, 70]))
        self.gap, self.rate = int(self.one([15, 20, 25, 40])), int(self.one([3, 4, 6]))
        self.side = self.one(["left", "right"])

    def one(self, of):
        return of[int(self._rng.integers(len(of)))]

    def some(self, of, count):
        return [of[int(k)] for k in self._rng.choice(len(of), size=count, replace=False)]

    def say(self, way, **more):
        text = way.format(**{**vars(self), **more})
        return text[0].upper() + text[1:]


def _kph(participant):
    return None if participant.speed_mps is None else round(participant.speed_mps.low * 3.6)


def _two(text, draw):
    """The scenario, the ego and the only other, whose kind and speeds are checked."""
    scenario = read(text)
    ego = [p for p in scenario.participants if p.role is Role.EGO]
    others = [p for p in scenario.participants if p.role is not Role.EGO]
    assert [len(ego), [str(p.kind) for p in others]] == [1, [draw.kind]], text
    assert _kph(ego[0]) == draw.v, text
    return scenario, ego[0], others[0]


def _apart_m(scenario):
    return {round(s.value.low) for s in scenario.spacings if s.measure == "gap_m"}


@pytest.mark.parametrize("seed", range(TEXTS))
def test_a_lead_brakes(seed):
    draw = Draw(seed)
    who = draw.say(draw.one(CALLED))
    who = who[0].lower() + who[1:]
    brakes = draw.say(draw.one(BRAKES))
    act = draw.say(draw.one(WHEN), who=who, brakes=brakes[0].lower() + brakes[1:])
    text = f"{draw.say(draw.one(LED))}. {act}."
    scenario, _, other = _two(text, draw)
    assert [*other.approaches] == ["ahead"], text
    assert _kph(other) == draw.v, text
    assert _apart_m(scenario) == {draw.gap}, text
    (act,) = scenario.acts
    assert (act.participant, act.kind, act.rate_mps2.low) == (other.id, "brake", draw.rate), text
    assert (act.when.type, act.when.delay_s.low) == ("start", 3), text


@pytest.mark.parametrize("seed", range(TEXTS))
def test_a_follower_hits_the_braking_ego(seed):
    draw = Draw(seed)
    brakes = f"{draw.say('{ego}')} brakes with {draw.rate} m/s²"
    text = f"{draw.say(draw.one(FOLLOWED))}. {brakes}. {draw.say(draw.one(STRUCK))}."
    scenario, ego, other = _two(text, draw)
    assert [*other.approaches] == ["behind"], text
    assert _apart_m(scenario) == {draw.gap}, text
    assert [a.rate_mps2.low for a in scenario.acts if a.participant == ego.id] == [draw.rate], text
    assert scenario.outcome.kind == "collision", text
    assert {*scenario.outcome.between} == {ego.id, other.id}, text


@pytest.mark.parametrize("seed", range(TEXTS))
def test_traffic_stands_around_the_ego(seed):
    draw = Draw(seed)
    places = draw.some(sorted(PLACES), 2 + seed % 3)
    nouns = {draw.one(NOUNS[kind]): kind for kind in draw.some(sorted(NOUNS), len(places))}
    forms = ["a {noun} drives {there} at {w} km/h", "{there} there is a {noun} at {w} km/h"]
    way = draw.one(forms)
    told = [
        draw.say(way, noun=noun, there=draw.one(PLACES[place]).format(ego=draw.ego))
        for noun, place in zip(nouns, places, strict=True)
    ]
    middle = " in the middle lane" if {"left", "right"} <= {*places} else ""
    text = f"{draw.say('{ego} drives at {v} km/h')}{middle}. {'. '.join(told)}."
    others = [p for p in read(text).participants if p.role is not Role.EGO]
    expected = {
        kind: {place, "adjacent"} if place in {"left", "right"} else {place}
        for kind, place in zip(nouns.values(), places, strict=True)
    }
    assert {str(p.kind): {str(a) for a in p.approaches} for p in others} == expected, text
    assert {_kph(p) for p in others} == {draw.w}, text


@pytest.mark.parametrize("seed", range(TEXTS))
def test_a_neighbour_cuts_in(seed):
    draw = Draw(seed)
    first = draw.say("{ego} drives at {v} km/h")
    text = f"{first}. {draw.say(draw.one(BESIDE))}. {draw.say(draw.one(CUTS_IN))}."
    scenario, ego, other = _two(text, draw)
    assert {draw.side, "adjacent"} <= {str(a) for a in other.approaches}, text
    assert _kph(other) == draw.w, text
    (act,) = scenario.acts
    assert (act.participant, act.kind, act.into) == (other.id, ActKind.CHANGE_LANE, ego.id), text
    when = act.when.value.low if isinstance(act.when, WhenMeasure) else None
    at = [s.value.low for s in scenario.spacings if s.at == act.id]
    assert draw.gap in (when, *at), text


ABOUT = {
    "ahead": ["ahead of {it}", "in front of {it}"],
    "behind": ["behind {it}", "to the rear of {it}"],
    "left": ["on the left of {it}", "in the lane to the left of {it}"],
    "right": ["to the right of {it}", "in the right-hand lane beside {it}"],
}
BOTH = [
    "{ego} drives at {v} km/h with a {one} {here} and a {two} {there}",
    "{ego} drives at {v} km/h, a {one} {here}, a {two} {there}",
    "{ego} drives at {v} km/h. A {one} is {here} and a {two} is {there}",
    "while {ego} drives at {v} km/h, a {one} is {here} and a {two} {there}",
    "{ego} drives at {v} km/h. A {one} drives at {w} km/h {here}, a {two} {there}",
    "while {ego} drives at {v} km/h, a {one} doing {w} km/h is {here} and a {two} {there}",
]
ALIKE = [
    "{ego} drives at {v} km/h with a {one} and a {two} {there}",
    "{ego} drives at {v} km/h, a {one} and a {two} {there}",
    "{ego} drives at {v} km/h. A {one} and a {two} {there} brake",
]


@pytest.mark.parametrize("seed", range(TEXTS))
def test_two_are_placed_in_one_sentence(seed):
    draw = Draw(seed)
    first, second = draw.some(sorted(NOUNS), 2)
    way = draw.one(BOTH if seed % 3 else ALIKE)
    here, there = draw.some(sorted(ABOUT), 2) if "{here}" in way else [draw.one(sorted(ABOUT))] * 2
    told = {"here": draw.one(ABOUT[here]).format(it="it"), "there": draw.one(ABOUT[there])}
    told["there"] = told["there"].format(it="it")
    text = f"{draw.say(way, one=draw.one(NOUNS[first]), two=draw.one(NOUNS[second]), **told)}."
    scenario = read(text)
    (ego,) = (p for p in scenario.participants if p.role is Role.EGO)
    others = [p for p in scenario.participants if p is not ego]
    expected = {
        kind: {place, "adjacent"} if place in {"left", "right"} else {place}
        for kind, place in ((first, here), (second, there))
    }
    assert {str(p.kind): {str(a) for a in p.approaches} for p in others} == expected, text
    fast = draw.w if "{w}" in way else None
    assert [_kph(p) for p in others if p.kind == first] == [fast], text
    assert [_kph(p) for p in others if p.kind == second] == [None], text
    assert _kph(ego) == draw.v, text
    assert not scenario.relations, text
