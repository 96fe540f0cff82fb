"""Things in the way: where they lie, who stops short of them, who goes round."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scegen.concretization import concretize
from scegen.motion import build_paths, simulate
from scegen.motion.footprints import box_corners
from scegen.report.world import thing_corners
from scegen.road import build_network
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import DrivingSide, HazardKind

SIDES = tuple(DrivingSide)
AHEAD = [("obstacle", (), ())]


def drive(entry, move, **more):
    return {"entry": entry, "move": move, **more}


def made(case, thing=None, **more):
    functional, logical = case
    if thing:
        functional = functional.model_copy(update={"objects": (Thing.model_validate(thing),)})
    concrete = concretize(functional, logical, **more)
    paths = build_paths(concrete, build_network(concrete.road))
    return concrete, paths, simulate(concrete, paths, dt_s=0.02)


def nearest_m(traces, who, thing):
    """The smallest distance of somebody from a thing."""
    trace = traces[who]
    boxes = shapely.polygons(box_corners(trace.body, trace.x_m, trace.y_m, trace.heading_rad))
    return float(shapely.distance(boxes, shapely.Polygon(thing_corners(thing))).min())


def on_way_m(paths, who, thing):
    """How far a thing's middle lies from the way of somebody."""
    path = paths[who]
    return float(np.hypot(path.x_m - thing.x_m, path.y_m - thing.y_m).min())


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize(("kind", "arms"), [("straight", 2), ("t", 3), ("roundabout", 4)])
def test_one_alone_with_it_stops_short_and_stays(scenario, side, kind, arms):
    case = scenario(kind, arms, [drive(0, 1)], AHEAD, driving_side=side)
    concrete, paths, traces = made(case)
    (thing,) = concrete.objects
    assert on_way_m(paths, "ego", thing) < 2.1  # vertices lie up to 4 m apart
    assert 0.5 < nearest_m(traces, "ego", thing) < 1.5
    assert traces["ego"].speed_mps[-1] == 0.0
    (hazard,) = concrete.hazards
    assert (hazard.by, hazard.to) == ((thing.id,), ("ego",))
    assert concrete.ego.speed_program[-1].hazard is HazardKind.OBSTACLE


def test_it_is_the_thing_that_is_said_and_a_plain_box_where_none_is(scenario):
    case = scenario("straight", 2, [drive(0, 1)], AHEAD)
    said = {"id": "crate_1", "kind": "box", "in_way_of": "ego", "called": "a wooden crate"}
    (crate,) = made(case, said)[0].objects
    (plain,) = made(case)[0].objects
    assert (crate.id, crate.category, crate.blueprint) == (
        "crate_1",
        "obstacle",
        "static.prop.box01",
    )
    assert (plain.length_m, plain.width_m, plain.height_m) == (1, 1, 1)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("maneuver", ["overtake", "lane_change"])
def test_who_is_to_go_round_passes_close_by_and_goes_on(scenario, side, maneuver):
    case = scenario("straight", 2, [drive(0, 1, maneuver=maneuver)], AHEAD, driving_side=side)
    concrete, _, traces = made(case)
    assert 0.3 < nearest_m(traces, "ego", concrete.objects[0]) < 0.8
    assert traces["ego"].speed_mps.min() > 3.0


@pytest.mark.parametrize("kind", ["swerving", "oncoming_lane"])
def test_who_leaves_the_lane_leaves_it_because_of_the_thing(scenario, kind):
    case = scenario(
        "straight",
        2,
        [drive(1, 1), drive(0, 1)],
        [("obstacle", (), ()), (kind, ("car_1",), ("ego",))],
    )
    said = {"id": "cone_1", "kind": "cone", "in_way_of": "car_1"}
    concrete, _, traces = made(case, said)
    (thing,) = concrete.objects
    hazard = next(h for h in concrete.hazards if h.kind is HazardKind.OBSTACLE)
    assert hazard.to == ("car_1",)
    assert 0.3 < nearest_m(traces, "car_1", thing) < 1.2
    assert nearest_m(traces, "ego", thing) > 0.3


def test_a_line_comes_to_rest_one_behind_the_other(scenario):
    case = scenario(
        "straight",
        2,
        [drive(0, 1, rank=1), drive(0, 1, rank=0)],
        [("obstacle", (), ()), ("hard_braking", ("car_1",), ("ego",))],
    )
    concrete, _, traces = made(case)
    (thing,) = concrete.objects
    assert 0.5 < nearest_m(traces, "car_1", thing) < 1.5
    for trace in traces.values():
        assert trace.speed_mps[-1] == 0.0
    assert nearest_m(traces, "ego", thing) > 4.5


def test_where_others_wait_at_the_junction_it_is_passed(scenario):
    case = scenario(
        "four_way",
        4,
        [drive(0, 2), drive(1, 2)],
        [("obstacle", (), ()), ("failure_to_yield", ("car_1",), ("ego",))],
    )
    concrete, _, traces = made(case)
    (thing,) = concrete.objects
    assert 0.3 < nearest_m(traces, "ego", thing) < 2.0
    assert nearest_m(traces, "car_1", thing) > 2.0
    assert traces["ego"].s_m[-1] > concrete.ego.motion.turning_ends_m - concrete.ego.motion.start_m


def test_one_who_brakes_first_comes_to_rest_before_going_round(scenario):
    case = scenario(
        "four_way",
        4,
        [drive(0, 2), drive(1, 2)],
        [
            ("obstacle", (), ()),
            ("hard_braking", ("ego",), ()),
            ("failure_to_yield", ("car_1",), ("ego",)),
        ],
    )
    concrete, _, traces = made(case)
    assert traces["ego"].speed_mps.min() == 0.0
    assert traces["ego"].speed_mps[-1] > 5.0
    assert nearest_m(traces, "ego", concrete.objects[0]) > 0.3


def test_a_parked_vehicle_is_what_is_meant_unless_a_thing_is_said(scenario):
    case = scenario("straight", 2, [drive(0, 1)], AHEAD, standings=[(0, "right", False)])
    assert made(case)[0].objects == ()
    said = {"id": "ball_1", "kind": "obstacle", "in_way_of": "ego", "called": "ball"}
    (ball,) = made(case, said)[0].objects
    assert ball.what == "ball"


@pytest.mark.parametrize(("kind", "arms"), [("straight", 2), ("four_way", 4)])
def test_what_lies_in_the_way_does_not_stand_beside_it_too(scenario, kind, arms):
    dangers = [("obstacle", (), ()), ("occlusion", (), ("ego",))]
    case = scenario(kind, arms, [drive(0, arms // 2), drive(1, arms // 2)], dangers)
    crate = {"id": "crate_1", "kind": "container", "in_way_of": "ego", "hides": ["car_1"]}
    concrete, _, _ = made(case, crate)
    assert [thing.id for thing in concrete.objects] == ["crate_1"]


def test_the_same_seed_gives_the_same_object(scenario):
    case = scenario("straight", 2, [drive(0, 1)], AHEAD)
    assert made(case, seed=3)[0] == made(case, seed=3)[0]
