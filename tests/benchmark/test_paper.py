"""The source paper's eleven sentences: all understood, all made, none failed by a checker."""

import pytest

from scegen.benchmark.paper import run
from scegen.checking import CHECKERS


@pytest.fixture(scope="module")
def rows():
    return list(run())


def test_there_are_eleven_and_all_are_understood(rows):
    assert len(rows) == 11
    assert [row.case for row in rows if not row.understood] == []


def test_files_are_made_and_no_checker_fails(rows):
    assert [(row.case, row.problem) for row in rows if row.files == 0] == []
    for row in rows:
        assert set(row.checks) == set(CHECKERS)
        assert "failed" not in row.checks.values(), (row.case, row.checks)
    for checker in ("opendrive", "openscenario"):
        assert {row.checks[checker] for row in rows} == {"passed"}


def test_ten_cars_are_ten_cars(rows):
    assert next(row for row in rows if row.case == "paper-b6").participants == 10


def test_every_case_has_a_verdict_and_esmini_agrees(rows):
    assert {row.verdict for row in rows} <= {"avoidable", "unavoidable"}
    assert [row.case for row in rows if row.esmini_agrees is False] == []
    played = {row.checks["esmini"] for row in rows}
    assert ("passed" in played) == any(row.esmini_agrees for row in rows)


def test_every_danger_happens_and_every_target_is_reached(rows):
    """The paper: 8 of 11."""
    assert [(row.case, row.proof.blocked_by) for row in rows if not row.proof.reached] == []
    for row in rows:
        data = row.to_data()
        assert data["in_band"] is True
        assert data["hazards_asked"] == [h["kind"] for h in data["hazards_happened"]]
        assert all(h["margin"] >= 0 for h in data["hazards_happened"])
        low, high = row.proof.band
        assert low <= data["after"] <= high
        assert data["evaluations"] >= 1


def test_most_dangers_survive_a_slower_and_a_faster_ego(rows):
    assert sum(bool(row.to_data()["reactive"]) for row in rows) >= 9


def test_searches_take_less_than_a_second(rows):
    assert sorted(row.search_s for row in rows)[len(rows) // 2] < 1.0
