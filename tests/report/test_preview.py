"""The preview: a stable picture of the right moment."""

from io import BytesIO

import numpy as np
import pytest
import shapely
from PIL import Image

from scegen.criticality.encounter import closest_encounter
from scegen.motion import simulate
from scegen.motion.footprints import box_corners
from scegen.motion.model import Trace
from scegen.motion.paths import build_paths
from scegen.report.labels import WAY_STEP_PX
from scegen.report.lane_shapes import road_shapes
from scegen.report.preview import preview_svg
from scegen.report.raster import png_of
from scegen.report.stage import make_stage, on_ways
from scegen.report.theme import LIGHT
from scegen.report.world import View
from scegen.road import build_network, plan_road
from scegen.road.model import LaneType
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    CrossingMotion,
    DriveMotion,
    StandingMotion,
)
from scegen.scenario.functional import Hazard
from scegen.scenario.junction import Junction
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.vocabulary import HazardKind, JunctionKind, ParticipantKind, Role, Side


def scenario() -> ConcreteScenario:
    arms = tuple(
        ArmRoad(
            id=i,
            length_m=80,
            angle_deg=90.0 * i,
            angle_to_previous_deg=90,
            lanes_in=1,
            lanes_out=1,
            speed_limit_mps=14,
        )
        for i in range(4)
    )

    def way(entry: int, leaves: int) -> DriveMotion:
        return DriveMotion(
            entry=entry,
            entry_lane=1,
            exit=leaves,
            exit_lane=1,
            start_m=20,
            turning_starts_m=80,
            turning_ends_m=100,
        )

    kind = ParticipantKind
    return ConcreteScenario(
        name="case",
        description="x",
        seed=0,
        logical=LogicalScenario(index=0, slug="x", pattern=(2, 2), assignments=()),
        road=RoadParameters(
            kind=JunctionKind.FOUR_WAY, arms=arms, crosswalks={0}, parking_lanes={0}
        ),
        participants=(
            ConcreteParticipant(
                id="ego", kind=kind.CAR, role=Role.EGO, speed_mps=10, motion=way(0, 2)
            ),
            ConcreteParticipant(id="car_1", kind=kind.CAR, speed_mps=10, motion=way(1, 3)),
            ConcreteParticipant(
                id="ped",
                kind=kind.PEDESTRIAN,
                speed_mps=1,
                motion=CrossingMotion(arm=2, start_side=Side.RIGHT, from_junction_m=5, setback_m=1),
            ),
            ConcreteParticipant(
                id="van",
                kind=kind.VAN,
                parked=True,
                speed_mps=0,
                motion=StandingMotion(arm=0, side=Side.RIGHT, from_junction_m=25),
            ),
        ),
        hazards=(Hazard(kind=HazardKind.FAILURE_TO_YIELD, by=("car_1",), to=("ego",)),),
        duration_s=8.0,
    )


def test_the_picture_is_stable_and_shows_the_ego():
    concrete = scenario()
    network = build_network(concrete.road, name="case")
    paths = build_paths(concrete, network)
    png, again = (png_of(preview_svg(concrete, network, paths)) for _ in range(2))
    assert png == again
    assert b"Software" not in png
    assert b"tIME" not in png
    image = np.asarray(Image.open(BytesIO(png)).convert("RGB"))
    blue = [int(LIGHT.ego[i : i + 2], 16) for i in (1, 3, 5)]
    assert (image == blue).all(axis=2).sum() > 500
    assert image.shape[1] == 900


def test_the_closest_approach_is_the_crossing_car_not_the_parked_van():
    concrete = scenario()
    paths = build_paths(concrete, build_network(concrete.road, name="case"))
    traces = simulate(concrete, paths)
    found = closest_encounter(concrete, traces)
    assert found is not None
    assert found.other == "car_1"
    assert 5.0 < found.time_s < 7.5
    assert found.distance_m == 0.0


def test_a_parked_vehicle_counts_only_where_nobody_else_is():
    concrete = scenario().model_copy(update={"hazards": ()})
    ego, _, ped, van = concrete.participants
    paths = build_paths(concrete, build_network(concrete.road, name="case"))
    for others, closest in (((ped, van), "ped"), ((van,), "van")):
        few = concrete.model_copy(update={"participants": (ego, *others)})
        found = closest_encounter(few, simulate(few, paths))
        assert found is not None
        assert found.other == closest


def test_alone_there_is_no_encounter():
    concrete = scenario()
    alone = concrete.model_copy(update={"participants": concrete.participants[:1]})
    paths = build_paths(alone, build_network(alone.road, name="case"))
    assert closest_encounter(alone, simulate(alone, paths)) is None


def test_boxes_reach_from_rear_to_front_bumper():
    body = BODIES[ParticipantKind.CAR]
    one = np.array([0.0])
    corners = box_corners(body, one, one, one + np.pi / 2)[0]
    assert corners[:2, 1] == pytest.approx(body.front_m)
    assert corners[2:, 1] == pytest.approx(-body.rear_m)
    assert np.ptp(corners[:, 0]) == pytest.approx(body.width_m)


def test_lanes_crosswalks_and_lines_are_where_the_road_has_them():
    shapes = road_shapes(build_network(scenario().road, name="case"))
    assert LaneType.PARKING in shapes.lanes
    assert len(shapes.lane_lines) == 4  # one lane each way: the middle may be crossed
    assert not shapes.centre_lines
    assert len(shapes.edge_lines) == 8
    assert shapes.stripes
    assert all(stripe[:, 0].min() > 0 for stripe in shapes.stripes)  # arm 0 lies in the east


@pytest.mark.parametrize(
    ("kind", "arms"), [("skewed", 4), ("four_way", 4), ("multi_way", 5), ("roundabout", 4)]
)
def test_a_crossing_is_paved_throughout_and_a_roundabout_has_islands(kind, arms):
    network = build_network(plan_road(Junction(kind=kind, arms=arms)))
    lanes = road_shapes(network).lanes[LaneType.DRIVING]
    paved = shapely.union_all([shapely.make_valid(shapely.Polygon(p)).buffer(0.05) for p in lanes])
    holes = sum(len(part.interiors) for part in shapely.get_parts(paved))
    assert holes == (1 + arms if kind == "roundabout" else 0)


def test_who_is_slow_and_who_is_fast_on_a_way_keep_labels_off_it_alike():
    concrete = scenario()
    network = build_network(concrete.road, name="case")
    paths = build_paths(concrete, network)
    stage = make_stage(concrete, network, paths, simulate(concrete, paths), LIGHT)
    view = View(0.0, 0.0, 200.0, 0, 0, 900, 900)
    seen = on_ways(stage, view)
    steps = np.hypot(*np.diff(seen, axis=0).T)
    assert len(seen) > 200
    assert np.isclose(steps, WAY_STEP_PX, atol=0.5).mean() > 0.95
    assert seen.min() >= 0.0
    assert seen.max() <= 900.0


def test_traces_may_be_given():
    concrete = scenario()
    network = build_network(concrete.road, name="case")
    paths = build_paths(concrete, network)
    traces = simulate(concrete, paths)
    assert preview_svg(concrete, network, paths, traces) == preview_svg(concrete, network, paths)
    first: Trace = traces["ego"]
    assert first.participant == "ego"
