"""esmini plays what the writer writes exactly as the simulator says."""

import csv
import shutil
import subprocess
from pathlib import Path as FilePath

import numpy as np
import pytest
from by_hand import by_hand

from scegen.export.openscenario import write_openscenario
from scegen.motion import simulate
from scegen.motion.model import Path
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    CrossingMotion,
    DistanceBelow,
    DriveMotion,
    OnContact,
    SpeedPhase,
    StandingMotion,
    StoodStill,
    Travelled,
    Trigger,
)
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import ParticipantKind, Role, Side

pytestmark = [
    pytest.mark.esmini,
    pytest.mark.skipif(shutil.which("esmini") is None, reason="esmini is not on PATH"),
]

LANE = (
    '<lane id="{}" type="driving" level="false"><link/>'
    '<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>'
)
ROAD = f"""<?xml version="1.0"?>
<OpenDRIVE><header revMajor="1" revMinor="7" name="" version="1" date="2024-01-01T00:00:00"
 north="0" south="0" east="0" west="0"/>
<road name="r" length="400" id="1" junction="-1" rule="RHT"><link/><planView>
<geometry s="0" x="-200" y="0" hdg="0" length="400"><line/></geometry></planView>
<elevationProfile><elevation s="0" a="0" b="0" c="0" d="0"/></elevationProfile><lateralProfile/>
<lanes><laneSection s="0"><left>{LANE.format(1)}</left>
<center><lane id="0" type="none" level="false"/></center>
<right>{LANE.format(-1)}</right></laneSection></lanes></road></OpenDRIVE>"""

EXPECTED_WARNINGS = (
    "3D model",
    "Stopping Init",  # what the story starts at t = 0 takes over from the init actions
    "cloudState is deprecated",  # version 1.0 demands both
    "intensity is deprecated",
)


def polyline(points) -> Path:
    points = np.asarray(points, float)
    step = np.diff(points, axis=0)
    heading = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
    s = np.concatenate(([0.0], np.cumsum(np.hypot(*step.T))))
    return Path(s, points[:, 0], points[:, 1], np.append(heading, heading[-1]), ())


def line(x0: float, y0: float, x1: float, y1: float) -> Path:
    return polyline(np.linspace((x0, y0), (x1, y1), 60))


def loop() -> Path:
    """A line and an arc through more than half a turn: headings pass the ±180° seam."""
    straight = np.linspace((60.0, 1.75), (0.0, 1.75), 16)
    angle = np.linspace(0.0, 3.8, 300)
    arc = np.column_stack((-20 * np.sin(angle), -18.25 + 20 * np.cos(angle)))
    return polyline(np.vstack((straight[:-1], arc)))


def phase(trigger: Trigger, speed: float, rate: float) -> SpeedPhase:
    return SpeedPhase(trigger=trigger, target_speed_mps=speed, rate_mps2=rate)


DRIVE = DriveMotion(
    entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=0, turning_starts_m=200, turning_ends_m=200
)
PATHS = {
    "ego": line(-150, -1.75, 190, -1.75),
    "oncoming": line(150, 1.75, -190, 1.75),
    "walker": line(0, -6, 0, 6),
    "turner": loop(),
    "van": Path(np.array([0.0]), np.array([-30.0]), np.array([-5.0]), np.array([0.0]), ()),
}


def scenario(duration_s: float = 10.0) -> ConcreteScenario:
    ego = ConcreteParticipant(
        id="ego",
        kind=ParticipantKind.CAR,
        role=Role.EGO,
        speed_mps=12,
        motion=DRIVE,
        speed_program=(
            phase(DistanceBelow(participant="walker", distance_m=50), 4, 5),
            phase(AtTime(time_s=6), 10, 2.5),  # holds long before its turn comes
        ),
    )
    oncoming = ConcreteParticipant(
        id="oncoming",
        kind=ParticipantKind.TRUCK,
        speed_mps=8,
        motion=DRIVE,
        speed_program=(
            phase(AtTime(time_s=2), 12, 3),
            phase(Travelled(participant="oncoming", distance_m=60), 0, 6),
            phase(StoodStill(participant="oncoming", duration_s=1.5), 9, 3),
        ),
    )
    walker = ConcreteParticipant(
        id="walker",
        kind=ParticipantKind.PEDESTRIAN,
        speed_mps=0,
        motion=CrossingMotion(arm=0, start_side=Side.RIGHT, from_junction_m=5, setback_m=1),
        speed_program=(phase(DistanceBelow(participant="ego", distance_m=60), 1.5, 20),),
    )
    turner = ConcreteParticipant(
        id="turner",
        kind=ParticipantKind.BICYCLE,
        speed_mps=9,
        motion=DRIVE,
        speed_program=(
            phase(AtTime(time_s=0), 10, 2),
            phase(AtTime(time_s=1.3), 14, 2),
            phase(AtTime(time_s=1.3), 5, 4),  # same instant: fires one step later
            phase(DistanceBelow(participant="ego", distance_m=300), 12, 3),
            phase(ArrivalBelow(participant="ego", place_m=120, time_s=8.4), 8, 2),
            phase(Travelled(participant="ego", distance_m=70), 8, 1),
        ),
    )
    van = ConcreteParticipant(
        id="van",
        kind=ParticipantKind.VAN,
        parked=True,
        speed_mps=0,
        motion=StandingMotion(arm=0, side=Side.RIGHT, from_junction_m=30),
    )
    people = (ego, oncoming, walker, turner, van)
    return by_hand(*people, description="A <case> & more", duration_s=duration_s)


def play(folder: FilePath, concrete: ConcreteScenario, version: str, dt_s: float):
    """The columns x, y, speed of every participant, and the log's errors and warnings."""
    (folder / "road.xodr").write_text(ROAD)
    (folder / "s.xosc").write_bytes(write_openscenario(concrete, PATHS, version=version))
    command = "esmini --osc s.xosc --headless --csv_logger a.csv --disable_stdout --logfile_path"
    run = subprocess.run(
        [*command.split(), "a.log", "--fixed_timestep", str(dt_s)],
        cwd=folder,
        timeout=60,
        check=False,
        capture_output=True,
    )
    assert run.returncode == 0
    log = (folder / "a.log").read_text().splitlines()
    complaints = [
        text
        for text in log
        if "[error]" in text
        or ("[warn]" in text and not any(known in text for known in EXPECTED_WARNINGS))
    ]
    with (folder / "a.csv").open() as file:
        rows = [[cell.strip() for cell in row] for row in csv.reader(file)]
    top = next(i for i, row in enumerate(rows) if row and row[0].startswith("Index"))
    tracks = {}
    for column, title in enumerate(rows[top]):
        if title.endswith("Entity_Name [-]"):
            values = np.array(
                [[row[column + k] for k in (11, 12, 2)] for row in rows[top + 1 :]], float
            )
            tracks[rows[top + 1][column]] = values
    return tracks, complaints


@pytest.mark.parametrize(("version", "dt_s"), [("1.0", 0.05), ("1.2", 0.05), ("1.0", 0.01)])
def test_positions_and_speeds_are_those_of_the_simulator(tmp_path, version, dt_s):
    concrete = scenario()
    tracks, complaints = play(tmp_path, concrete, version, dt_s)
    assert complaints == []
    traces = simulate(concrete, PATHS, dt_s=dt_s)
    assert tracks.keys() == traces.keys()
    for name, trace in traces.items():
        x, y, speed = tracks[name].T
        steps = min(len(x), len(trace.x_m))
        assert steps >= len(trace.x_m) - 1
        off = np.hypot(x[:steps] - trace.x_m[:steps], y[:steps] - trace.y_m[:steps])
        assert off.max() < 0.01, name
        assert np.abs(speed[:steps] - trace.speed_mps[:steps]).max() < 0.01, name


def test_a_collision_brings_to_rest(tmp_path):
    concrete = scenario()
    van = next(p for p in concrete.participants if p.id == "van")
    there = PATHS["van"].pose(0.0)
    way = PATHS["ego"]
    near = float(np.hypot(way.x_m - there.x_m, way.y_m - there.y_m).min())
    assert near > 2.0  # it passes beside the van: whoever it is to hit must stand in its way
    pose = way.pose(60.0)
    box = StaticObject(
        id="box", category="obstacle", what="box", x_m=pose.x_m, y_m=pose.y_m,
        heading_deg=float(np.degrees(pose.heading_rad)), length_m=1.0, width_m=1.0, height_m=1.0,
    )  # fmt: skip
    ego = next(p for p in concrete.participants if p.id == "ego")
    halts = ego.model_copy(
        update={"on_contact": OnContact(participant="box", rate_mps2=80.0), "speed_program": ()}
    )
    made = concrete.model_copy(update={"participants": (halts, van), "objects": (box,)})
    tracks, complaints = play(tmp_path, made, "1.2", 0.05)
    assert complaints == []
    trace = simulate(made, PATHS)["ego"]
    x, y, speed = tracks["ego"].T
    steps = min(len(x), len(trace.x_m))
    assert trace.speed_mps[-1] == 0.0
    assert np.hypot(x[:steps] - trace.x_m[:steps], y[:steps] - trace.y_m[:steps]).max() < 0.01
    assert np.abs(speed[:steps] - trace.speed_mps[:steps]).max() < 0.01


def test_who_reaches_the_end_of_the_path_stays_there(tmp_path):
    tracks, complaints = play(tmp_path, scenario(duration_s=25.0), "1.0", 0.05)
    assert complaints == []
    for name in ("walker", "turner"):
        x, y, speed = tracks[name][-1]
        end = PATHS[name]
        # esmini leaves out the last step, the one that would go beyond the end.
        assert np.hypot(x - end.x_m[-1], y - end.y_m[-1]) < 12 * 0.05, name
        assert speed == 0.0
