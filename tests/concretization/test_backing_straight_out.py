"""Backing straight out of a bay or a drive, with somebody who comes past behind."""

import numpy as np
import pytest
from saying import KMH, made, missed, person, said

from scegen.motion import build_paths, simulate
from scegen.road import build_network

REVERSE = {"id": "back", "participant": "ego", "kind": "reverse"}
THEN = {"type": "after", "act": "back", "since": "end"}
STOP = {"id": "stop", "participant": "ego", "kind": "stop", "when": THEN}


def backing_out(kind, side, outcome, *, driving_side="right", acts=(REVERSE,), other="bicycle"):
    road = {"driving_side": driving_side}
    ego = person("ego", speed=5, maneuvers=["straight"])
    if kind == "t":
        ego["entries"] = [2]
    else:
        ego["strip"], road["strips"] = "parking", ["parking"]
    people = ego, person("x", other, speed=15, approaches=[side], maneuvers=["straight"])
    hazards = [{"kind": "reversing", "by": ["ego"], "to": ["x"]}]
    return said(kind, *people, junction=road, hazards=hazards, acts=acts, outcome=outcome)


def run(functional):
    raised = made(functional)
    assert not raised.proof.missed
    concrete = raised.concrete
    return concrete, simulate(concrete, build_paths(concrete, build_network(concrete.road)))


def comes_from_left(traces):
    """Whether the other goes to the right of one that heads as the ego does."""
    ego, x = traces["ego"], traces["x"]
    heading = ego.heading_rad[0]
    to_left = np.cos(heading) * np.diff(x.y_m) - np.sin(heading) * np.diff(x.x_m)
    return to_left.max() <= 1e-6 < -to_left.min()


@pytest.mark.parametrize("driving_side", ["right", "left"])
@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("kind", ["straight", "t"])
def test_it_is_up_to_speed_and_stops_before_who_comes_from_its_side(kind, side, driving_side):
    outcome = {"kind": "avoided", "between": ["ego", "x"]}
    functional = backing_out(kind, side, outcome, driving_side=driving_side, acts=[REVERSE, STOP])
    _, traces = run(functional)
    ego = traces["ego"]
    back = np.abs(ego.speed_mps) > 4.9 * KMH
    assert np.ptp(ego.time_s[back]) > 1.0
    assert ego.speed_mps[-1] == 0.0
    assert np.ptp(ego.heading_rad) < 0.01
    assert comes_from_left(traces) == (side == "left")


@pytest.mark.parametrize("percent", [25, 75])
@pytest.mark.parametrize("kind", ["straight", "t"])
def test_its_rear_hits_who_comes_past_where_that_is_said(kind, percent):
    outcome = {"kind": "collision", "between": ["ego", "x"], "struck": "rear"}
    concrete, _ = run(backing_out(kind, "left", outcome | {"impact_percent": percent}))
    other = backing_out(kind, "left", outcome | {"impact_percent": 100 - percent})
    assert missed(other, concrete) == {"outcome.impact_percent"}


def backs_before_the_ego(outcome, speed=4, acts=()):
    people = (
        person("ego", speed=30, maneuvers=["straight"]),
        person("x", "truck", speed=speed, approaches=["left"], maneuvers=["straight"]),
    )
    hazards = [{"kind": "reversing", "by": ["x"], "to": ["ego"]}]
    return said("t", *people, hazards=hazards, outcome=outcome, acts=acts)


def test_the_ego_runs_square_into_who_backs_out_before_it():
    outcome = {"kind": "collision", "between": ["ego", "x"], "struck": "front"}
    concrete, traces = run(backs_before_the_ego(outcome))
    turned = np.degrees(traces["x"].heading_rad - traces["ego"].heading_rad[0])
    assert np.abs(np.cos(np.radians(turned))).max() < 0.01
    assert missed(backs_before_the_ego(outcome, speed=7), concrete) == {"speed.x"}


def test_the_ego_brakes_for_who_stays_across_its_lane():
    brakes = {"id": "brake", "participant": "ego", "kind": "stop"}
    _, traces = run(backs_before_the_ego({"kind": "avoided", "between": ["ego", "x"]}, 4, [brakes]))
    assert traces["ego"].speed_mps[-1] == traces["x"].speed_mps[-1] == 0.0


def test_who_is_turned_does_not_back_out_square():
    concrete, _ = run(backing_out("t", "left", {"kind": "avoided", "between": ["ego", "x"]}))
    ego = concrete.ego
    turns = ego.motion.model_copy(
        update={"reversal": ego.motion.reversal.model_copy(update={"straight_m": None})}
    )
    turned = ego.model_copy(
        update={"motion": turns.model_copy(update={"entry": 0, "exit": 1, "start_m": 20.0})}
    )
    people = tuple(turned if p is ego else p for p in concrete.participants)
    lost = missed(
        backing_out("t", "left", {"kind": "avoided", "between": ["ego", "x"]}),
        concrete.model_copy(update={"participants": people}),
    )
    assert "square.ego" in lost


def test_what_is_parked_behind_stands_in_its_way():
    ego = person("ego", speed=4, maneuvers=["straight"])
    parked = person("x", parked=True, maneuvers=["stay"], approaches=["behind"])
    hazards = [{"kind": "reversing", "by": ["ego"]}]
    _, traces = run(said("straight", ego, parked, hazards=hazards, acts=[REVERSE]))
    assert abs(traces["x"].y_m[0] - traces["ego"].y_m[0]) < 0.1
