"""The course: every curve, the critical moment, the same bytes. And the verdict in words."""

from math import pi

import numpy as np
import pytest
from by_hand import by_hand
from lxml import etree, html

from scegen.criticality.careful_driver import Outcome, Verdict
from scegen.criticality.course import Course, ego_course
from scegen.criticality.reactivity.sensitivity import Sensitivity, Start
from scegen.motion.model import Path
from scegen.report.html import ConcreteEntry, ReportInput, report_html
from scegen.report.judgement import judgement_tables, verdict_words
from scegen.report.plots import LEFT, RIGHT, WIDTH, plots_svg
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    DriveMotion,
)
from scegen.scenario.vocabulary import ParticipantKind, Role

SVG = "{http://www.w3.org/2000/svg}"


def way(x, y, heading, length=200.0) -> Path:
    s = np.array([0.0, length])
    return Path(s, x + s * np.cos(heading), y + s * np.sin(heading), np.full(2, heading), ())


def scenario(*names, duration_s=10.0) -> ConcreteScenario:
    motion = DriveMotion(
        entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=0, turning_starts_m=1, turning_ends_m=1
    )
    people = (
        ConcreteParticipant(
            id=name,
            kind=ParticipantKind.CAR,
            role=Role.OTHER if number else Role.EGO,
            speed_mps=10,
            motion=motion,
        )
        for number, name in enumerate(names)
    )
    return by_hand(*people, duration_s=duration_s)


@pytest.fixture
def crossing() -> tuple[ConcreteScenario, Course]:
    """Two cars that cross at right angles and touch."""
    concrete = scenario("car_1", "car_2")
    paths = {"car_1": way(-60.0, 0.0, 0.0), "car_2": way(0.0, -62.0, pi / 2)}
    return concrete, ego_course(concrete, paths)


def test_same_input_same_drawing(crossing):
    assert plots_svg(*crossing) == plots_svg(*crossing)


def test_three_panels_with_the_critical_moment_where_it_is(crossing):
    concrete, course = crossing
    root = etree.fromstring(plots_svg(concrete, course).encode())
    texts = [text.text for text in root.iter(f"{SVG}text")]
    for title in ("speed, m/s", "distance to the ego, m", "time to collision, s"):
        assert title in texts
    assert {"car_1 (ego)", "car_2"} <= set(texts)
    moment_s = float(course.time_s[course.step])
    assert course.distance_m["car_2"][course.step] == 0.0
    assert course.distance_m["car_2"][course.step - 1] > 0.0
    assert f"contact with car_2 at {moment_s:.2f} s" in texts
    (mark,) = (p for p in root.iter(f"{SVG}path") if p.get("stroke-dasharray") == "5 3")
    x = float(mark.get("d")[1:].split(" ")[0])
    assert x == pytest.approx(LEFT + (WIDTH - LEFT - RIGHT) * moment_s / 10.0, abs=0.06)


def test_curves_show_the_series(crossing):
    concrete, course = crossing
    root = etree.fromstring(plots_svg(concrete, course).encode())
    curves = [p.get("d") for p in root.iter(f"{SVG}path") if p.get("fill") == "none"]
    assert len(curves) == 4  # two speeds, one distance, one time to collision
    assert course.time_s[-1] == pytest.approx(10.0)
    assert all(curve.startswith(f"M{LEFT:.1f} ") for curve in curves[:2])
    assert "nan" not in " ".join(curves)


def test_the_ego_alone():
    concrete = scenario("ego")
    course = ego_course(concrete, {"ego": way(0.0, 0.0, 0.0)})
    root = etree.fromstring(plots_svg(concrete, course).encode())
    assert course.partner == ""
    assert "distance to the ego, m" not in [text.text for text in root.iter(f"{SVG}text")]


def verdict(**changes) -> Verdict:
    fields = {
        "outcome": Outcome.AVOIDABLE,
        "contact_as_driven": ("car_2",),
        "danger": "car_2",
        "perceived_s": 1.0,
        "brakes_s": 2.15,
        "contact": (),
        "secondary": (),
        "distance_m": 1.25,
        "contact_speed_mps": None,
        "spare_s": 0.3,
    }
    return Verdict(**(fields | changes))


def test_verdicts_in_words():
    words = verdict_words(verdict(secondary=("van",)))
    for part in (
        "would not touch car_2",
        "from 1.00 s",
        "at 2.15 s",
        "1.25 m",
        "0.3 s later",
        "van",
    ):
        assert part in words
    hit = verdict(
        outcome=Outcome.UNAVOIDABLE, contact=("car_2",), contact_speed_mps=4.0, spare_s=-0.6
    )
    words = verdict_words(hit)
    for part in ("would touch car_2", "4.0 m/s", "0.6 s earlier"):
        assert part in words
    assert "0.00 m" not in words
    quiet = verdict(
        contact_as_driven=(), danger=None, perceived_s=None, brakes_s=None, spare_s=None
    )
    assert "No danger ahead" in verdict_words(quiet)


def test_the_report_shows_course_verdict_and_reactivity(crossing):
    concrete, course = crossing
    starts = [Start(f, f > 0.9, 0.0 if f > 0.9 else 12.0, None, None) for f in (1.0, 0.8, 1.2)]
    sensitivity = Sensitivity("car_2", *starts)
    entry = ConcreteEntry(
        concrete,
        b"x",
        "scenarios/case",
        plots_svg=plots_svg(concrete, course),
        verdict=verdict(),
        sensitivity=sensitivity,
    )
    page = html.fromstring(report_html(ReportInput(None, None, (entry,))))
    assert len(page.xpath("//figure[@class='plots']/svg")) == 1
    text = page.text_content()
    assert "avoidable" in text
    assert "our extension" in text
    assert "does not always stay critical" in text
    rows = judgement_tables(None, sensitivity)[0].rows
    assert [(row[0], row[-1]) for row in rows] == [
        ("−20 %", "no"),
        ("as it is", "yes"),
        ("+20 %", "yes"),
    ]
    assert judgement_tables(None, None) == []
