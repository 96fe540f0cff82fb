"""The report: complete, offline, and deaf to what hostile texts would like it to run."""

import json
import re
from base64 import b64encode
from hashlib import sha256
from urllib.parse import unquote

import pytest
from lxml import html
from scenes import scene

from scegen.report.contents import CheckRow, ConcreteEntry, ReportInput
from scegen.report.evidence import LONGEST_SHOWN, field_rows, spans
from scegen.report.html import report_html
from scegen.report.tables import tables
from scegen.scenario.concrete import (
    AtTime,
    Change,
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
    LaneChange,
    SpeedPhase,
)
from scegen.scenario.environment import Environment, Weather
from scegen.scenario.evidence import Evidence, EvidenceSource, Unsupported
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import (
    Certificate,
    Conflict,
    Drive,
    LogicalScenario,
    LogicalSet,
)
from scegen.scenario.model import Interval
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.vocabulary import (
    ArmsMode,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Reduction,
    Role,
)
from scegen.understanding import read

EVIL = '<script>alert("x")</script>\'"><img src=http://evil.example/x onerror=alert(1)>{{ 7*7 }}'
TEXT = f"A red car overtakes. {EVIL}"


def functional(description: str = TEXT) -> FunctionalScenario:
    return FunctionalScenario(
        description=description,
        junction=Junction(kind=JunctionKind.STRAIGHT, arms=2),
        participants=(
            Participant(id="ego", role=Role.EGO, speed_mps=Interval(low=10, high=10)),
            Participant(id="car_1", speed_mps=Interval(low=8, high=14)),
        ),
        hazards=(Hazard(kind=HazardKind.OVERTAKING, by=("car_1",), to=("ego",)),),
        evidence=(
            Evidence(
                field="participants.car_1.speed_mps",
                source=EvidenceSource.INFERRED,
                text="red car",
                start=2,
                end=9,
                reason=EVIL,
            ),
            Evidence(
                field="participants.car_1.kind",
                source=EvidenceSource.STATED,
                text="car overtakes",
                start=6,
                end=19,
            ),
            Evidence(field="junction.control", source=EvidenceSource.DEFAULT, reason="not said"),
            Evidence(
                field="hazards.overtaking",
                source=EvidenceSource.STATED,
                text="overtakes",
                start=10,
                end=19,
            ),
        ),
        unsupported=(Unsupported(text="red", start=2, end=5, instead=EVIL),),
    )


def logical() -> LogicalScenario:
    straight = Maneuver.STRAIGHT
    return LogicalScenario(
        index=0,
        slug="s",
        pattern=(1, 1),
        class_size=2,
        assignments=tuple(
            Drive(participant=n, entry=0, move=1, exit=1, turn=straight, maneuver=straight, rank=r)
            for r, n in enumerate(("ego", "car_1"))
        ),
        conflicts=(
            Conflict(first="ego", second="car_1", kind="following", yields="car_1", rule="ahead"),
        ),
        deadlock=("ego", "car_1"),
        parameters=(
            ParameterRange(name="ego.speed_mps", low=8, high=14, default=10, reason="usual"),
        ),
    )


def logical_set() -> LogicalSet:
    return LogicalSet(
        functional=functional(),
        reduction=Reduction.EXACT,
        arms=ArmsMode.DISTINCT,
        certificate=Certificate(total=2, count=1, complete=True, method=EVIL),
        notes=(EVIL,),
        scenarios=(logical(),),
    )


def concrete(name: str = "000-s") -> ConcreteScenario:
    arms = tuple(
        ArmRoad(
            id=i,
            length_m=123.4,
            angle_deg=180.0 * i,
            angle_to_previous_deg=180,
            lanes_in=2,
            lanes_out=1,
            speed_limit_mps=14,
        )
        for i in (0, 1)
    )
    motion = DriveMotion(
        entry=0,
        entry_lane=1,
        exit=1,
        exit_lane=2,
        start_m=7.5,
        turning_starts_m=123.4,
        turning_ends_m=123.4,
        lane_changes=(LaneChange(position_m=40, length_m=20, lane_after=0),),
    )
    return ConcreteScenario(
        name=name,
        description=TEXT,
        seed=5,
        logical=logical(),
        road=RoadParameters(kind=JunctionKind.STRAIGHT, arms=arms),
        participants=(
            ConcreteParticipant(
                id="ego",
                kind=ParticipantKind.CAR,
                role=Role.EGO,
                speed_mps=11,
                motion=motion,
                speed_program=(
                    SpeedPhase(trigger=AtTime(time_s=2), target_speed_mps=3, rate_mps2=6),
                ),
            ),
        ),
        environment=Environment(weather=Weather.HEAVY_RAIN),
        hazards=(Hazard(kind=HazardKind.OVERTAKING, by=("ego",)),),
        duration_s=9.0,
        provenance=(Change(parameter="ego.speed_mps", by="seed", after=11, reason=EVIL),),
    )


def entry(scenario: ConcreteScenario, **more) -> ConcreteEntry:
    played = scene()[0] | {"name": scenario.name}
    return ConcreteEntry(scenario, f"scenarios/{scenario.name}", played, **more)


def full() -> ReportInput:
    checks = (
        CheckRow("geometry", "passed", "ok"),
        CheckRow("esmini", "failed", EVIL),
        CheckRow("asam", "not_run", "missing"),
    )
    return ReportInput(
        functional(),
        logical_set(),
        (entry(concrete(), checks=checks, files=("road.xodr", "scenario.xosc")),),
        ((EVIL, EVIL),),
    )


def test_hostile_texts_stay_texts_and_nothing_is_fetched():
    page = html.fromstring(report_html(full()))
    assert not page.xpath("//iframe | //link | //object | //embed | //img | //@src")
    assert not page.xpath("//@*[starts-with(name(), 'on')]")
    *data, script = page.xpath("//script")
    assert [one.get("type") for one in (*data, script)] == ["application/json", "module"]
    assert json.loads(data[0].text)[0]["name"] == "000-s"
    digest = b64encode(sha256(script.text.encode()).digest()).decode()
    (policy,) = page.xpath("//meta[@http-equiv='Content-Security-Policy']/@content")
    assert policy.startswith("default-src 'none'")
    assert f"script-src 'sha256-{digest}';" in policy
    for link in page.xpath("//@href"):
        assert link.startswith(("#", "scenarios/")), link
    assert "49" not in page.xpath("string(//p[@class='text'])")
    assert EVIL in page.xpath("string(//p[@class='text'])")
    style = page.xpath("string(//style)")
    assert "url(" not in style
    assert "@import" not in style
    assert "fetch(" not in script.text
    assert "innerHTML" not in script.text


def test_same_input_same_page():
    assert report_html(full()) == report_html(full())


def test_the_description_is_shown_whole_and_marked():
    page = html.fromstring(report_html(full()))
    assert page.xpath("string(//p[@class='text'])") == TEXT
    marks = [(m.get("class").split()[0], m.text) for m in page.xpath("//p[@class='text']/mark")]
    assert marks == [
        ("unsupported", "red"),
        ("inferred", " "),
        ("understood", "car"),
        ("understood", " "),
        ("understood", "overtakes"),
    ]
    title = page.xpath("//p[@class='text']/mark[2]/@title")
    assert "speed" in title[0]


def test_levels_that_did_not_happen_are_left_out():
    page = html.fromstring(report_html(ReportInput(None, None, full().concretes)))
    assert not page.xpath("//section[@id='logical']")
    assert page.xpath("string(//p[@class='text'])") == TEXT
    html.fromstring(report_html(ReportInput(functional(), None)))
    html.fromstring(report_html(ReportInput(None, None)))


def test_files_are_linked_and_checks_are_told_apart():
    page = html.fromstring(report_html(full()))
    links = [unquote(h) for h in page.xpath("//p[@class='files']/a/@href")]
    assert links == ["scenarios/000-s/road.xodr", "scenarios/000-s/scenario.xosc"]
    rows = page.xpath("//div[@aria-label='Checks']/table/tbody/tr")
    assert [r.xpath("string(td[2]/span/@class)") for r in rows] == [
        "pill held",
        "pill failed",
        "pill open",
    ]
    assert rows[2].xpath("string(td[2])") == "not run"


def test_ids_are_unique_and_anchors_lead_somewhere():
    other = entry(concrete("001-t"))
    page = html.fromstring(
        report_html(ReportInput(functional(), logical_set(), (*full().concretes, other)))
    )
    ids = page.xpath("//@id")
    assert len(ids) == len(set(ids))
    for anchor in page.xpath("//a[starts-with(@href, '#')]/@href"):
        assert anchor[1:] in ids


def test_every_parameter_is_in_a_table():
    words = " ".join(cell for table in tables(concrete()) for row in table.rows for cell in row)
    for wanted in (
        "123.4 m",
        "7.5 m",
        "11.0 m/s (40 km/h)",
        "at 2.00 s: to 3.0 m/s",
        "into the oncoming lane from 40.0 m",
        "heavy rain",
        "8 – 14",
        "car_1 yields to ego (the other is ahead)",
    ):
        assert wanted in words
    assert all(len(row) == len(t.heads) for t in tables(concrete()) for row in t.rows)


def test_a_deadlock_is_named():
    titles = [table.title for table in tables(concrete())]
    assert any("deadlock: ego, car_1 wait for each other" in title for title in titles)


def test_chosen_values_come_from_the_provenance():
    ranges = next(t for t in tables(concrete()) if t.title == "Parameter ranges")
    assert ranges.rows[0][2:4] == ("10", "11")


def test_fields_have_values_with_units():
    rows = {row.field: row for row in field_rows(functional())}
    assert rows["car_1 › speed (m/s)"].value == "8.0 to 14.0"
    assert rows["hazards › overtaking"].value == "overtaking by car_1, endangering ego"
    assert rows["junction › control"].ground == "not said"


@pytest.mark.parametrize("description", ["", "x" * (LONGEST_SHOWN + 50)])
def test_spans_of_odd_descriptions(description):
    bare = FunctionalScenario(
        description=description,
        junction=Junction(kind=JunctionKind.STRAIGHT, arms=2),
        participants=(Participant(id="ego", role=Role.EGO),),
    )
    shown = "".join(span.text for span in spans(bare))
    assert shown.startswith(description[:LONGEST_SHOWN])
    if description:
        assert re.search(r"\(50 more characters\)", shown)


def test_what_sets_an_act_off_is_told_in_words():
    found = read("The car ahead brakes with 4 m/s² and then changes lanes. The ego drives 50 km/h.")
    rows = {row.field: row.value for row in field_rows(found)}
    assert rows["acts › brake 1 › rate (m/s²)"] == "4.0"
    assert rows["acts › change lane 1 › when"] == "some time after brake 1 has ended"
