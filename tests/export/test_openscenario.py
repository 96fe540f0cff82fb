"""The OpenSCENARIO writer: what stands in the file, and that it follows the standard."""

import re
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path as FilePath

import numpy as np
import pytest
from by_hand import by_hand, straight_road
from lxml import etree
from things import thing

from scegen.errors import InputError
from scegen.export.openscenario import write_openscenario
from scegen.export.openscenario_text import LONGEST_TEXT, xml_text
from scegen.motion.model import Path
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    CrossingMotion,
    DistanceBelow,
    DriveMotion,
    SpeedPhase,
    StandingMotion,
    StoodStill,
    Travelled,
)
from scegen.scenario.environment import Environment, RoadSurface, TimeOfDay, Weather
from scegen.scenario.objects import ObjectCategory
from scegen.scenario.vocabulary import ParticipantKind, Role, Side

ROOT = FilePath(__file__).parents[2]
SCHEMAS = sorted((ROOT / ".venv/asam").glob("lib/*/site-packages/qc_openscenario/schema"))
HOSTILE = "CARLA:<b>&\"'\x00\x0b\ufffe\ud800 ü \U0001f697 ]]> ${x} --> \n\t end"


def drive(length_m: float = 100.0) -> Path:
    s = np.linspace(0.0, length_m, 26)
    return Path(s, s - 50.0, np.full_like(s, -1.75), np.zeros_like(s), ())


def standing() -> Path:
    return Path(np.array([0.0]), np.array([5.0]), np.array([-5.0]), np.array([3.5]), ())


DRIVE = DriveMotion(
    entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=0, turning_starts_m=50, turning_ends_m=50
)
PROGRAM = (
    SpeedPhase(trigger=AtTime(time_s=2.0), target_speed_mps=15, rate_mps2=12),
    SpeedPhase(
        trigger=DistanceBelow(participant="ped", distance_m=20), target_speed_mps=0, rate_mps2=6
    ),
    SpeedPhase(
        trigger=Travelled(participant="ego", distance_m=70), target_speed_mps=5, rate_mps2=2
    ),
)


def scenario(description: str = "Two cars", **changes) -> ConcreteScenario:
    walk = CrossingMotion(arm=0, start_side=Side.RIGHT, from_junction_m=5, setback_m=1)
    park = StandingMotion(arm=0, side=Side.RIGHT, from_junction_m=30)
    ego = ConcreteParticipant(
        id="ego",
        kind=ParticipantKind.CAR,
        role=Role.EGO,
        speed_mps=10,
        motion=DRIVE,
        speed_program=PROGRAM,
    )
    ped = ConcreteParticipant(id="ped", kind=ParticipantKind.PEDESTRIAN, speed_mps=1.5, motion=walk)
    van = ConcreteParticipant(
        id="park", kind=ParticipantKind.VAN, parked=True, speed_mps=0, motion=park
    )
    usual = {"description": description, "road": straight_road(100.0), "duration_s": 12.0}
    return by_hand(ego, ped, van, **(usual | changes))


PATHS = {"ego": drive(), "ped": drive(8.0), "park": standing()}


def written(version: str = "1.0", **changes) -> etree._Element:
    return etree.fromstring(write_openscenario(scenario(**changes), PATHS, version=version))


@pytest.mark.parametrize("version", ["1.0", "1.2"])
def test_same_input_gives_same_bytes_without_todays_date(version):
    first = write_openscenario(scenario(), PATHS, version=version)
    assert first == write_openscenario(scenario(), PATHS, version=version)
    assert etree.fromstring(first).find("FileHeader").get("date") == "2024-01-01T00:00:00"


def test_versions_do_not_mix_between_threads():
    alone = {v: write_openscenario(scenario(), PATHS, version=v) for v in ("1.0", "1.2")}
    wanted = ["1.0", "1.2"] * 10
    with ThreadPoolExecutor(4) as pool:
        made = pool.map(lambda v: write_openscenario(scenario(), PATHS, version=v), wanted)
    assert list(made) == [alone[v] for v in wanted]


def test_unknown_version_and_missing_path_are_refused():
    with pytest.raises(InputError, match=r"1\.1"):
        write_openscenario(scenario(), PATHS, version="1.1")
    with pytest.raises(InputError, match="ped"):
        write_openscenario(scenario(), {"ego": drive(), "park": standing()})


def test_entities_are_carla_blueprints_and_mark_the_ego():
    entities = written().findall("Entities/ScenarioObject")
    assert [e.get("name") for e in entities] == ["ego", "ped", "park"]
    ego, ped, park = entities
    assert ego.find("Vehicle").get("name") == BODIES[ParticipantKind.CAR].blueprint
    assert ped.find("Pedestrian").get("model") == BODIES[ParticipantKind.PEDESTRIAN].blueprint
    assert park.find("Vehicle").get("vehicleCategory") == "van"
    types = [e.find(".//Property[@name='type']").get("value") for e in entities]
    assert types == ["ego_vehicle", "simulation", "simulation"]
    assert ego.find(".//Center").get("x") == str(BODIES[ParticipantKind.CAR].centre_ahead_m)


@pytest.mark.parametrize("kind", list(ParticipantKind))
def test_every_kind_can_be_written(kind):
    other = ConcreteParticipant(id="other", kind=kind, speed_mps=1, motion=DRIVE)
    concrete = scenario()
    concrete = scenario(participants=(*concrete.participants, other))
    root = etree.fromstring(write_openscenario(concrete, PATHS | {"other": drive()}))
    assert root.find("Entities/ScenarioObject[@name='other']/*/BoundingBox") is not None


def test_performance_allows_what_the_program_asks():
    performance = written().find(".//ScenarioObject[@name='ego']//Performance")
    assert float(performance.get("maxAcceleration")) >= 12
    assert float(performance.get("maxSpeed")) >= 15


def test_positions_follow_the_path_and_times_rise():
    root = written()
    vertices = root.findall(".//Trajectory[@name='ego_path']//Vertex")
    x = [float(v.find(".//WorldPosition").get("x")) for v in vertices]
    assert x == pytest.approx(list(PATHS["ego"].x_m), abs=1e-4)
    assert all(float(a.get("time")) < float(b.get("time")) for a, b in pairwise(vertices))
    start = root.find(".//Private[@entityRef='ego']//WorldPosition")
    assert (start.get("x"), start.get("y")) == ("-50.0", "-1.75")
    assert root.find(".//Trajectory[@name='park_path']") is None
    assert float(root.find(".//Private[@entityRef='park']//WorldPosition").get("h")) < 3.142


def test_phases_wait_for_their_predecessor_in_every_condition_group():
    root = written()
    for index in (2, 3):
        groups = root.findall(f".//Event[@name='ego_phase_{index}']/StartTrigger/ConditionGroup")
        states = []
        for group in groups:
            own, before = group.findall("Condition")
            assert own.find(".//StoryboardElementStateCondition") is None
            state = before.find(".//StoryboardElementStateCondition")
            assert state.get("storyboardElementRef") == f"ego_phase_{index - 1}"
            states.append(state.get("state"))
        assert states == ["startTransition", "completeState"]
    first = root.findall(".//Event[@name='ego_phase_1']/StartTrigger//Condition")
    assert len(first) == 1


def test_triggers_say_what_the_program_says():
    root = written("1.2")
    time = root.find(".//Event[@name='ego_phase_1']//SimulationTimeCondition")
    assert (time.get("value"), time.get("rule")) == ("2.0", "greaterOrEqual")
    near = root.find(".//Event[@name='ego_phase_2']//RelativeDistanceCondition")
    assert (near.get("entityRef"), near.get("value"), near.get("rule")) == (
        "ped",
        "20.0",
        "lessThan",
    )
    assert near.get("freespace") == "false"
    far = root.find(".//Event[@name='ego_phase_3']//TraveledDistanceCondition")
    assert 70.0 - 1e-4 < float(far.get("value")) < 70.0  # a tie counts as reached
    dynamics = root.find(".//Event[@name='ego_phase_2']//SpeedActionDynamics")
    assert (dynamics.get("dynamicsDimension"), dynamics.get("value")) == ("rate", "6.0")


@pytest.mark.parametrize("version", ["1.0", "1.2"])
def test_waits_and_arrivals_say_what_the_program_says(version):
    ego = scenario().participants[0]
    wait = StoodStill(participant="ped", duration_s=2.5)
    meet = ArrivalBelow(participant="ego", place_m=40.0, time_s=3.2)
    program = tuple(
        SpeedPhase(trigger=trigger, target_speed_mps=5, rate_mps2=2) for trigger in (wait, meet)
    )
    ego = ego.model_copy(update={"speed_program": program})
    root = written(version, participants=(ego, *scenario().participants[1:]))
    stands = root.find(".//Event[@name='ego_phase_1']//StandStillCondition")
    assert 2.5 - 1e-4 < float(stands.get("duration")) < 2.5  # players ask for longer
    arrives = root.find(".//Event[@name='ego_phase_2']//TimeToCollisionCondition")
    assert (arrives.get("value"), arrives.get("rule")) == ("3.2", "lessThan")
    assert arrives.get("freespace") == "false"
    place = arrives.find(".//WorldPosition")
    assert (place.get("x"), place.get("y")) == ("-10.0", "-1.75")
    owner = root.find(".//Event[@name='ego_phase_1']//TriggeringEntities/EntityRef")
    assert owner.get("entityRef") == "ped"


def test_names_of_elements_and_conditions_are_unique():
    root = written()
    for tag in ("Condition", "Event", "Action", "Maneuver", "ManeuverGroup"):
        names = [e.get("name") for e in root.iter(tag)]
        assert len(names) == len(set(names)), tag


def test_1_0_stays_inside_the_common_subset():
    text = write_openscenario(scenario(), PATHS).decode()
    for refused in ("AssignRoute", "Clothoid", "Nurbs", "timeGap", "CatalogReference", "euclid"):
        assert refused not in text
    assert "runningState" not in text
    assert re.search(r'rule="(\w+)"', text)
    assert set(re.findall(r'rule="(\w+)"', text)) <= {"greaterThan", "lessThan", "equalTo"}


@pytest.mark.parametrize("description", [HOSTILE, "$", "CARLA:"])
def test_the_file_does_not_depend_on_how_it_was_said(description):
    told, untold = (scenario(d) for d in (description, ""))
    assert write_openscenario(told, PATHS) == write_openscenario(untold, PATHS)
    root = written(description=description)
    assert root.find("FileHeader").get("description") == "Scenario case"


def test_hostile_names_of_things_stay_text():
    root = written(objects=(CRATE.model_copy(update={"what": HOSTILE}),))
    text = root.find(".//Property[@name='what']").get("value")
    assert text == "CARLA:<b>&\"' ü \U0001f697 ]]> ${x} --> end"
    assert len(xml_text("x" * 1_000_000)) == LONGEST_TEXT


def test_environment_is_the_one_asked_for():
    snow = Environment(
        weather=Weather.SNOW, time_of_day=TimeOfDay.NIGHT, road_surface=RoadSurface.ICY
    )
    root = written(environment=snow)
    assert root.find(".//Precipitation").get("precipitationType") == "snow"
    assert float(root.find(".//Sun").get("elevation")) < 0
    icy = float(root.find(".//RoadCondition").get("frictionScaleFactor"))
    dry = float(written().find(".//RoadCondition").get("frictionScaleFactor"))
    assert icy < 0.3 < dry == 1.0


@pytest.mark.asam
@pytest.mark.skipif(not SCHEMAS, reason="no ASAM environment (make asam)")
@pytest.mark.parametrize("version", ["1.0", "1.2"])
def test_valid_against_the_schema(version):
    schema = etree.XMLSchema(etree.parse(SCHEMAS[0] / f"{version}.0" / "OpenSCENARIO.xsd"))
    for weather in [None, *Weather]:
        root = written(version, environment=Environment(weather=weather), description=HOSTILE)
        assert schema.validate(root), schema.error_log
    still = etree.fromstring(
        write_openscenario(scenario(), dict.fromkeys(PATHS, standing()), version=version)
    )
    assert schema.validate(still), schema.error_log


CRATE = thing("crate_1", 5.0, -1.75, heading_deg=90.0, mass_kg=40.0, blueprint="static.prop.box01")


def test_things_are_misc_objects_named_by_carlas_props():
    root = written(objects=(CRATE,))
    misc = root.find("Entities/ScenarioObject[@name='crate_1']/MiscObject")
    assert dict(misc.attrib) == {
        "mass": "40.0",
        "miscObjectCategory": "obstacle",
        "name": "static.prop.box01",
    }
    box = misc.find("BoundingBox")
    assert dict(box.find("Dimensions").attrib) == {"width": "1.0", "length": "1.0", "height": "1.0"}
    assert box.find("Center").get("z") == "0.5"
    start = root.find(".//Private[@entityRef='crate_1']//WorldPosition")
    assert [float(start.get(k)) for k in "xyh"] == [5.0, -1.75, pytest.approx(np.pi / 2, abs=1e-6)]
    assert root.find(".//ManeuverGroup//EntityRef[@entityRef='crate_1']") is None


@pytest.mark.asam
@pytest.mark.skipif(not SCHEMAS, reason="no ASAM environment (make asam)")
@pytest.mark.parametrize("version", ["1.0", "1.2"])
@pytest.mark.parametrize("category", tuple(ObjectCategory))
def test_things_are_valid_against_the_schema(version, category):
    schema = etree.XMLSchema(etree.parse(SCHEMAS[0] / f"{version}.0" / "OpenSCENARIO.xsd"))
    root = written(version, objects=(CRATE.model_copy(update={"category": category}),))
    assert schema.validate(root), schema.error_log


def external(version: str = "1.0") -> etree._Element:
    written = write_openscenario(scenario(), PATHS, version=version, external_ego=True)
    return etree.fromstring(written)


def test_an_external_ego_is_placed_and_has_no_motion_of_its_own():
    root, scripted = external(), written()
    (ego,) = (o for o in root.iter("ScenarioObject") if o.get("name") == "ego")
    properties = {(p.get("name"), p.get("value")) for p in ego.iter("Property")}
    assert {("type", "ego_vehicle"), ("driven_by", "external")} <= properties
    start = root.find(".//Private[@entityRef='ego']")
    assert start.find(".//TeleportAction") is not None
    assert start.find(".//AbsoluteTargetSpeed") is not None
    actors = [a.get("entityRef") for a in root.iterfind(".//Actors/EntityRef")]
    before = [a.get("entityRef") for a in scripted.iterfind(".//Actors/EntityRef")]
    assert [name for name in before if name != "ego"] == [a for a in actors if a != "ego"]
    acted = [g for g in root.iter("ManeuverGroup") if g.find(".//EntityRef[@entityRef='ego']")]
    assert not any(group.find("Maneuver") is not None for group in acted)
    assert not root.xpath("//FollowTrajectoryAction/Trajectory[starts-with(@name, 'ego')]")
    assert not scripted.xpath("//Property[@name='driven_by']")


@pytest.mark.asam
@pytest.mark.skipif(not SCHEMAS, reason="no ASAM environment (make asam)")
@pytest.mark.parametrize("version", ["1.0", "1.2"])
def test_an_external_ego_is_valid_against_the_schema(version):
    schema = etree.XMLSchema(etree.parse(SCHEMAS[0] / f"{version}.0" / "OpenSCENARIO.xsd"))
    root = external(version)
    assert schema.validate(root), schema.error_log


def test_the_end_waits_for_an_ego_that_is_late_but_not_for_ever():
    root = written()
    story = root.find(".//Storyboard/StopTrigger")
    in_time, at_last = story.findall("ConditionGroup")
    assert in_time.find(".//TraveledDistanceCondition") is not None
    times = [g.find(".//SimulationTimeCondition").get("value") for g in (in_time, at_last)]
    assert [float(t) for t in times] == pytest.approx([12.0, 1.3 * 12.0], abs=1e-4)
    (act,) = root.findall(".//Act/StopTrigger")
    # scenario_runner ends an act when any condition of a group holds: there is one only.
    assert len(act.findall(".//Condition")) == 1
