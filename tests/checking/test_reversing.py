"""Bodies that go backwards where they are to pass; a wrong heading is caught all the same."""

from __future__ import annotations

import shutil
from math import pi
from pathlib import Path

import numpy as np
import pytest
from lxml import etree

from scegen.checking import CheckStatus, check_folder
from scegen.checking.environment import esmini
from scegen.checking.esmini.movement import check_movements
from scegen.checking.esmini.recording import Movement
from scegen.checking.replay import CHECKER as REPLAY
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Reverses
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, ParticipantKind, Role

OWN = ("opendrive", "openscenario")
HOW = [*Reverses]


@pytest.fixture(scope="module")
def made(tmp_path_factory, write):
    """A folder for every way in which somebody reverses."""
    folders = {}
    t = Junction(kind=JunctionKind.T, arms=3)
    for junction, ways in (
        (Junction(kind=JunctionKind.STRAIGHT, arms=2), frozenset()),
        (t, frozenset()),
        (t, frozenset({Maneuver.STRAIGHT})),
    ):
        functional = FunctionalScenario(
            description="for tests",
            junction=junction,
            participants=(
                Participant(id="van", kind=ParticipantKind.VAN, maneuvers=ways),
                Participant(id="ego", role=Role.EGO),
            ),
            hazards=(Hazard(kind=HazardKind.REVERSING, by=("van",), to=("ego",)),),
        )
        for logical in enumerate_scenarios(functional).scenarios:
            how = logical.assignment("van").reverses
            if how not in folders:
                folder = tmp_path_factory.mktemp("made") / how.value
                folders[how] = write(folder, concretize(functional, logical))
    assert set(folders) == set(Reverses)
    return folders


@pytest.fixture
def folder(made, tmp_path):
    return Path(shutil.copytree(made[Reverses.BACKS_UP], tmp_path / "s"))


def vertices(root, entity):
    for group in root.iter("ManeuverGroup"):
        if group.find(f"Actors/EntityRef[@entityRef='{entity}']") is not None:
            return [v.find("Position/WorldPosition") for v in group.find(".//Polyline")]
    raise AssertionError(entity)


def found(folder, root):
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    return {(f.rule, f.place) for f in check_folder(folder, OWN).result("openscenario").findings}


@pytest.mark.parametrize("how", HOW)
def test_reversing_is_clean(made, how):
    report = check_folder(made[how], OWN)
    assert [f for r in report.results for f in r.findings] == []
    assert {r.status for r in report.results} == {CheckStatus.PASSED}


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
@pytest.mark.parametrize("how", HOW)
def test_esmini_plays_it_as_predicted(made, how):
    report = check_folder(made[how], ["esmini", REPLAY])
    assert [f for r in report.results for f in r.findings] == []
    assert {r.status for r in report.results} == {CheckStatus.PASSED}


@pytest.mark.parametrize("entity", ["ego", "van"])
def test_a_body_turned_round_is_caught(folder, entity):
    root = etree.parse(folder / "scenario.xosc").getroot()
    for vertex in vertices(root, entity):
        vertex.set("h", repr(float(vertex.get("h")) + pi))
    assert ("xosc.reversing", entity) in found(folder, root)


def test_who_should_reverse_but_turns_round_is_caught(folder):
    concrete = load(folder / "concrete.yaml", ConcreteScenario)
    length = concrete.participant("van").motion.reversal.length_m
    root = etree.parse(folder / "scenario.xosc").getroot()
    places = vertices(root, "van")
    points = [complex(float(v.get("x")), float(v.get("y"))) for v in places]
    way = points[1] - points[0]
    back = [n for n in range(1, len(points)) if ((points[n] - points[n - 1]) / way).real < 0]
    assert abs(points[back[-1]] - points[back[0] - 1]) == pytest.approx(length, abs=0.01)
    for n in back:
        places[n - 1].set("h", repr(float(places[n - 1].get("h")) + pi))
    assert {rule for rule, _ in found(folder, root)} & {"xosc.reversing", "xosc.trajectory"}


def test_a_heading_aslant_is_caught_backwards_too(folder):
    root = etree.parse(folder / "scenario.xosc").getroot()
    places = vertices(root, "van")
    x = [float(v.get("x")) for v in places]
    back = next(n for n in range(2, len(x)) if (x[n] - x[n - 1]) * (x[1] - x[0]) < 0)
    places[back].set("h", repr(float(places[back].get("h")) + 0.4))
    assert ("xosc.trajectory", "van") in found(folder, root)


def played(speeds, heading, name="van"):
    speeds = np.asarray(speeds, dtype=float)
    points = np.concatenate(([0.0], np.cumsum(speeds[1:] * 0.05))).astype(complex)
    heads = np.full(len(speeds), heading)
    return Movement(name, np.arange(len(speeds)) * 0.05, points, np.abs(speeds), heads)


def rules(concrete, movement):
    findings = check_movements([movement], None, concrete)
    return {f.rule for f in findings if f.place.startswith(movement.entity)}


def test_what_esmini_plays_backwards_is_looked_at(folder):
    concrete = load(folder / "concrete.yaml", ConcreteScenario)
    there_and_back = [1.0, 0.9, 0.6, 0.3, 0.0, 0.0, -0.2, -0.5, -0.8, -1.0]
    assert rules(concrete, played(there_and_back, 0.0)) == set()
    assert rules(concrete, played([1.0] * 9, 0.0)) == {"esmini.reversing"}
    at_speed = [1.0, 0.9, 0.8, -0.8, -0.9]
    assert "esmini.reversing" in rules(concrete, played(at_speed, 0.0))
    assert rules(concrete, played([5.0] * 9, pi, "ego")) == {"esmini.reversing"}
