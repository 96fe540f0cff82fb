"""Reactivity: what is bound to the ego stays critical, what is bound to the clock does not."""

from math import pi

import pytest
from criticality_geometry import line
from criticality_scenarios import participant, phase, scenario

from scegen.criticality.encounter import closest_encounter
from scegen.criticality.reactivity.sensitivity import Start, ego_start_sensitivity
from scegen.motion import simulate
from scegen.scenario.concrete import AtTime, DistanceBelow
from scegen.scenario.functional import Hazard
from scegen.scenario.vocabulary import HazardKind

SPEED = 12.0
EGO_WAY = line(0.0, 0.0, 0.0, 300.0)


def crossing(trigger):
    """A runner who crosses the ego's way 150 m ahead."""
    runner = participant("runner", "pedestrian", 0.0, [phase(trigger, 3.0, 20.0)])
    concrete = scenario(participant("ego", speed=SPEED), runner, duration_s=20.0)
    return concrete, {"ego": EGO_WAY, "runner": line(150.0, -6.0, pi / 2, 12.0)}


def test_a_trigger_on_the_ego_keeps_it_critical():
    found = ego_start_sensitivity(*crossing(DistanceBelow(participant="ego", distance_m=25.0)))
    assert found is not None
    assert found.partner == "runner"
    assert (found.slower.factor, found.own.factor, found.faster.factor) == (0.8, 1.0, 1.2)
    assert found.reactive


def test_a_trigger_on_the_clock_does_not():
    found = ego_start_sensitivity(*crossing(AtTime(time_s=10.4)))
    assert found is not None
    assert found.own.critical
    assert not found.slower.critical
    assert not found.reactive


def test_critical_by_contact_distance_or_pet():
    def start(**values):
        return Start(**({"factor": 1.0, "contact": False, "distance_m": 9.0} | values))

    assert not start(pet_s=1.51, ttc_s=0.1).critical
    assert start(pet_s=1.49, ttc_s=None).critical
    assert start(distance_m=2.9, pet_s=None, ttc_s=2.2).critical
    assert not start(distance_m=2.9, pet_s=None, ttc_s=2.3).critical
    assert start(distance_m=1.19, pet_s=None, ttc_s=None).critical
    assert not start(distance_m=1.21, pet_s=None, ttc_s=None).critical
    assert start(contact=True, pet_s=None, ttc_s=None).critical


def test_who_the_event_is_about():
    ego, far = participant("ego", speed=SPEED), participant("far", speed=SPEED)
    parked = participant("parked", parked=True)
    paths = {
        "ego": EGO_WAY,
        "far": line(0.0, 10.0, 0.0, 300.0),
        "parked": line(50.0, 4.0, 0.0, 0.0),
    }
    plain = scenario(ego, far, parked)
    assert closest_encounter(plain, simulate(plain, paths)).other == "far"
    hazard = Hazard(kind=HazardKind.OBSTACLE, by=("parked",), to=("ego",))
    named = scenario(ego, far, parked, hazards=[hazard])
    assert closest_encounter(named, simulate(named, paths)).other == "parked"
    chosen = ego_start_sensitivity(named, paths, partner="far")
    assert chosen is not None
    assert chosen.partner == "far"
    assert chosen.own.distance_m == pytest.approx(10.0 - 2.16)
    assert ego_start_sensitivity(scenario(ego), paths) is None
