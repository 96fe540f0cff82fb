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
