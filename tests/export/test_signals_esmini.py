"""Lights as esmini evaluates them: red when who runs them goes over the line, green for others."""

import csv
import shutil
import subprocess

import pytest
from lxml import etree
from saying import made, person, said

from scegen.claims.ways import ways_of
from scegen.export.openscenario_signals import LAMPS, LAMPS_AFOOT
from scegen.export.signs import signals_of
from scegen.pipeline.export import LAMPS_FILE, SCENARIO_FILE, export_scenario
from scegen.road import build_network
from scegen.road.cross_section import arm_road_id
from scegen.scenario.signals import SignalState

pytestmark = pytest.mark.skipif(not shutil.which("esmini"), reason="esmini is not on PATH")
STEP_S = 0.01


def run_red(approaches, *more, **car):
    """One who runs a red light, and what else it does to the ego."""
    people = person("ego", maneuvers=["straight"]), person("car", approaches=approaches, **car)
    kinds = ("red_light_running", *more)
    hazards = [{"kind": kind, "by": ["car"], "to": ["ego"]} for kind in kinds]
    return made(said("four_way", *people, junction={"control": "signals"}, hazards=hazards))


def ends_s(folder, conditions):
    """When esmini ends the scenario if these conditions, all of them, are its stop trigger."""
    file = folder / LAMPS_FILE
    root = etree.parse(str(file)).getroot()
    stop = root.find("Storyboard/StopTrigger")
    latest = stop[-1]
    stop.clear()
    group = etree.SubElement(stop, "ConditionGroup")
    for number, condition in enumerate(conditions):
        named = f'name="probe_{number}" delay="0" conditionEdge="none"'
        text = f"<Condition {named}>{condition}</Condition>"
        group.append(etree.fromstring(text))
    stop.append(latest)
    (folder / "probe.xosc").write_bytes(etree.tostring(root))
    command = ["esmini", "--osc", "probe.xosc", "--headless", "--fixed_timestep", str(STEP_S)]
    command += ["--csv_logger", "probe.csv", "--disable_stdout", "--logfile_path", "probe.log"]
    subprocess.run(command, cwd=folder, check=True, timeout=60)
    with (folder / "probe.csv").open() as stream:
        rows = [row for row in csv.reader(stream) if row and row[0].strip().isdigit()]
    return float(rows[-1][1])


def shows(arm, state):
    signal = f'<TrafficSignalCondition name="{arm_road_id(arm)}" state="{LAMPS[state]}"/>'
    return f"<ByValueCondition>{signal}</ByValueCondition>"


def has_gone(name, metres):
    return (
        '<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any">'
        f'<EntityRef entityRef="{name}"/></TriggeringEntities><EntityCondition>'
        f'<TraveledDistanceCondition value="{metres:.4f}"/></EntityCondition></ByEntityCondition>'
    )


@pytest.fixture(
    scope="module",
    params=[
        (["left"], [], {}),
        (["right"], [], {"kind": "truck"}),
        (["opposite"], [], {}),
        (["left", "right"], ["sudden_acceleration"], {}),
        (["right"], ["hard_braking"], {}),
    ],
    ids=["left", "truck", "opposite", "accelerates", "brakes"],
)
def files(request, tmp_path_factory):
    approaches, more, fields = request.param
    raised = run_red(approaches, *more, **fields)
    folder = tmp_path_factory.mktemp("lights")
    for name, content in export_scenario(raised.concrete).items():
        (folder / name).write_bytes(content)
    return folder, raised


def test_red_light_running_is_seen_by_a_condition_on_the_light(files):
    folder, raised = files
    assert raised.proof.in_band
    assert not raised.proof.missed
    concrete = raised.concrete
    ways = ways_of(concrete, build_network(concrete.road, name="x"))
    over = {}
    for name, state in (("car", SignalState.RED), ("ego", SignalState.GREEN)):
        person = concrete.participant(name)
        line = ways[name].line_m - person.body.front_m
        over[name] = ends_s(folder, [has_gone(name, line)])
        seen = ends_s(folder, [has_gone(name, line), shows(person.motion.entry, state)])
        assert seen == pytest.approx(over[name], abs=2 * STEP_S), name
    entry = concrete.participant("car").motion.entry
    plan = concrete.signals
    since = (over["car"] - plan.group_of(entry).green_from_s) % plan.cycle_s
    assert since >= plan.group_of(entry).green_s + plan.amber_s + 0.5


def test_every_light_changes_in_esmini_when_the_plan_says(files):
    folder, raised = files
    concrete, plan = raised.concrete, raised.concrete.signals
    for group in plan.groups:
        for time_s, state in list(plan.changes(group, concrete.duration_s))[1:2]:
            arm = min(group.arms)
            assert ends_s(folder, [shows(arm, state)]) == pytest.approx(time_s, abs=3 * STEP_S)


@pytest.mark.parametrize(
    ("ego", "walker", "state"),
    [
        ({"maneuvers": ["straight"], "light": "green"}, "red", SignalState.GREEN),
        ({"maneuvers": ["left"], "light": "green"}, "green", SignalState.GREEN),
        ({"maneuvers": ["straight"], "light": "amber"}, None, SignalState.AMBER),
    ],
)
def test_the_light_is_as_said_as_one_goes(tmp_path, ego, walker, state):
    people = [person("ego", **ego), person("car", approaches=["left"])]
    if walker is not None:
        crosses = {"crosses": "exit"} if walker == "green" else {"crosses": "entry"}
        people[1] = person("walker", "pedestrian", maneuvers=["cross"], light=walker, **crosses)
    hazard = {"kind": "crossing_pedestrian", "by": ["walker"], "to": ["ego"]}
    told = {"hazards": [hazard] if walker else []}
    raised = made(said("four_way", *people, junction={"control": "signals"}, **told))
    assert not raised.proof.missed
    concrete = raised.concrete
    for name, content in export_scenario(concrete).items():
        (tmp_path / name).write_bytes(content)
    way = ways_of(concrete, build_network(concrete.road, name="x"))["ego"]
    driver = concrete.participant("ego")
    passes = has_gone("ego", way.line_m - driver.body.front_m)
    over = ends_s(tmp_path, [passes])
    shown = shows(driver.motion.entry, state)
    assert ends_s(tmp_path, [passes, shown]) == pytest.approx(over, abs=2 * STEP_S)
    if walker is None:
        return
    on_foot = concrete.participant("walker")
    steps_off = has_gone("walker", on_foot.motion.setback_m - on_foot.body.front_m)
    off = ends_s(tmp_path, [steps_off])
    for signal in signals_of(arm_road_id(on_foot.motion.arm), afoot=True):
        lamps = LAMPS_AFOOT[SignalState(walker)]
        lit = f'<TrafficSignalCondition name="{signal}" state="{lamps}"/>'
        lit = f"<ByValueCondition>{lit}</ByValueCondition>"
        assert ends_s(tmp_path, [steps_off, lit]) == pytest.approx(off, abs=2 * STEP_S)


def test_the_file_for_everybody_has_the_standards_controllers_and_no_actions(files):
    folder, raised = files
    root = etree.parse(str(folder / SCENARIO_FILE)).getroot()
    assert not root.findall(".//InfrastructureAction")
    found = root.findall("RoadNetwork/TrafficSignals/TrafficSignalController")
    plan = raised.concrete.signals
    assert [c.get("name") for c in found] == [str(group.id) for group in plan.groups]
    for controller in found:
        lasts = [float(phase.get("duration")) for phase in controller.findall("Phase")]
        assert sum(lasts) == pytest.approx(plan.cycle_s, abs=0.01)
    road = etree.parse(str(folder / "road.xodr")).getroot()
    signals = {s.get("id"): s for s in road.iter("signal")}
    for controller in road.findall("controller"):
        for control in controller:
            assert signals[control.get("signalId")].get("dynamic") == "yes"


def test_lights_that_are_off_are_dark_in_esmini_when_somebody_passes(tmp_path):
    people = person("ego", maneuvers=["straight"]), person("car", approaches=["left"])
    raised = made(said("four_way", *people, junction={"control": "signals_off"}))
    assert not raised.proof.missed
    concrete = raised.concrete
    for name, content in export_scenario(concrete).items():
        (tmp_path / name).write_bytes(content)
    ways = ways_of(concrete, build_network(concrete.road, name="x"))
    for name in ("car", "ego"):
        mover = concrete.participant(name)
        passes = has_gone(name, ways[name].line_m - mover.body.front_m)
        dark = shows(mover.motion.entry, SignalState.OFF)
        red = shows(mover.motion.entry, SignalState.RED)
        over = ends_s(tmp_path, [passes])
        assert ends_s(tmp_path, [passes, dark]) == pytest.approx(over, abs=2 * STEP_S)
        assert ends_s(tmp_path, [passes, red]) > over + 1.0
    root = etree.parse(str(tmp_path / SCENARIO_FILE)).getroot()
    found = root.findall("RoadNetwork/TrafficSignals//TrafficSignalState")
    assert {state.get("state") for state in found} == {"off;off;off"}
    assert len(found) == 4
