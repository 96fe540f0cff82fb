"""Things that hide: on a line of sight until shortly before, off the road, in nobody's way."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scegen.concretization import concretize
from scegen.measures.bodies import body_table
from scegen.measures.occlusion import occlusion_series
from scegen.motion import build_paths
from scegen.motion.batch import compile_program, simulate_batch
from scegen.report.lane_shapes import road_shapes
from scegen.report.world import thing_corners
from scegen.road import build_network
from scegen.road.model import LaneType
from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.vocabulary import DrivingSide, HazardKind

WALKER = [("occlusion", (), ()), ("crossing_pedestrian", ("ped_0",), ("ego",))]


def drive(entry, move, **more):
    return {"entry": entry, "move": move, **more}


def made(case, words=None):
    functional, logical = case
    if words:
        said = Evidence(field="hazards.occlusion", source=EvidenceSource.STATED, text=words)
        functional = functional.model_copy(update={"evidence": (said,)})
    return concretize(functional, logical)


def hidden_s(concrete, target, before_s=None):
    """How long the first object hides somebody from the ego before the two are nearest."""
    paths = build_paths(concrete, build_network(concrete.road))
    program, own = compile_program(concrete, paths)
    traces = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=0.05)
    names = [entity.id for entity in concrete.entities]
    triple = [names.index("ego"), names.index(target), len(concrete.participants)]
    bodies = body_table([entity.body for entity in concrete.entities], friction=1.0)
    flags = occlusion_series(traces.tracks, bodies, np.array([triple]))[0, :, 0]
    a, b = triple[:2]
    apart = np.hypot(
        traces.x_m[0, :, a] - traces.x_m[0, :, b], traces.y_m[0, :, a] - traces.y_m[0, :, b]
    )
    nearest = int(apart.argmin())
    last = np.flatnonzero(flags[:nearest])
    return float(flags[:nearest].sum() * 0.05), float((nearest - last[-1]) * 0.05)


def stands_off_the_road(concrete):
    network = build_network(concrete.road)
    lanes = [
        shapely.make_valid(shapely.Polygon(p)) for p in road_shapes(network).lanes[LaneType.DRIVING]
    ]
    boxes = [shapely.Polygon(thing_corners(thing)) for thing in concrete.objects]
    paths = build_paths(concrete, network)
    ways = [
        shapely.LineString(np.column_stack((path.x_m, path.y_m)))
        for path in paths.values()
        if len(path.s_m) > 1
    ]
    clear = min(box.distance(lane) for box in boxes for lane in lanes) > 0.15
    return clear and min(box.distance(way) for box in boxes for way in ways) > 0.5


@pytest.mark.parametrize("driving_side", tuple(DrivingSide))
@pytest.mark.parametrize("start", ["left", "right"])
@pytest.mark.parametrize("words", [None, "behind a tree", "a bus shelter", "a kiosk", "a pole"])
def test_a_walker_is_hidden_until_shortly_before(scenario, start, words, driving_side):
    case = scenario("straight", 2, [drive(0, 1)], WALKER, [(0, start)], driving_side=driving_side)
    concrete = made(case, words)
    (thing,) = concrete.objects
    hazard = next(h for h in concrete.hazards if h.kind is HazardKind.OCCLUSION)
    assert (hazard.by, hazard.to) == ((thing.id,), ("ego",))
    total, before = hidden_s(concrete, "ped_0")
    assert total > 0.6
    assert before < 6.5
    assert stands_off_the_road(concrete)


@pytest.mark.parametrize("move", [1, 2, 3])
def test_a_walker_on_a_crosswalk_is_hidden_from_who_turns(scenario, move):
    case = scenario("four_way", 4, [drive(0, move)], WALKER, [(0, "right")])
    concrete = made(case, "a hedge")
    assert hidden_s(concrete, "ped_0")[0] > 0.6
    assert stands_off_the_road(concrete)


@pytest.mark.parametrize(
    ("kind", "arms", "ego", "other"),
    [
        ("four_way", 4, (0, 2), (1, 2)),
        ("four_way", 4, (0, 2), (3, 2)),
        ("t", 3, (2, 2), (1, 2)),
        ("t", 3, (2, 2), (0, 1)),
        ("skewed", 4, (1, 2), (0, 2)),
        ("y", 3, (0, 1), (1, 1)),
    ],
)
def test_a_crossing_car_is_hidden_behind_something_long(scenario, kind, arms, ego, other):
    hazards = [("occlusion", (), ()), ("failure_to_yield", ("car_1",), ("ego",))]
    case = scenario(kind, arms, [drive(*ego), drive(*other)], hazards)
    concrete = made(case, "a wall")
    (wall,) = concrete.objects
    assert wall.length_m == 12.0
    assert hidden_s(concrete, "car_1")[0] > 0.4
    assert stands_off_the_road(concrete)


def test_who_is_hidden_by_somebody_parked_needs_no_thing(scenario):
    hazards = [("occlusion", ("parked_0",), ()), WALKER[1]]
    case = scenario("straight", 2, [drive(0, 1)], hazards, [(0, "right")], [(0, "right", False)])
    assert made(case).objects == ()


def test_where_nobody_can_be_hidden_there_is_no_thing(scenario):
    case = scenario("straight", 2, [drive(0, 1)], [("occlusion", (), ())])
    concrete = made(case)
    assert concrete.objects == ()
    assert concrete.hazards[0].by == ()
