"""Logical scenarios are picked by number, range and name; the default is the richest."""

import pytest

from scegen.errors import InputError
from scegen.pipeline.picking import pick
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Certificate, Conflict, Drive, LogicalScenario, LogicalSet

KINDS = ("none", "crossing", "merging", "crossing")


def scenario(index: int, kind: str) -> LogicalScenario:
    drive = {"entry": 0, "move": 1, "exit": 1, "turn": "right", "maneuver": "right"}
    return LogicalScenario(
        index=index,
        slug=f"kind-{kind}",
        pattern=(1, 1),
        assignments=(Drive(participant="ego", **drive), Drive(participant="car_1", **drive)),
        conflicts=(Conflict(first="ego", second="car_1", kind=kind),),
    )


@pytest.fixture
def logical() -> LogicalSet:
    return LogicalSet(
        functional=FunctionalScenario(
            description="",
            junction=Junction(kind="four_way", arms=4),
            participants=(Participant(id="ego", role="ego"), Participant(id="car_1")),
        ),
        reduction="none",
        arms="distinct",
        certificate=Certificate(total=4, count=4, complete=True, method="test"),
        scenarios=tuple(scenario(i, kind) for i, kind in enumerate(KINDS)),
    )


@pytest.mark.parametrize(
    ("expression", "indices"),
    [
        ("all", [0, 1, 2, 3]),
        ("2", [2]),
        ("3,0", [3, 0]),
        ("1-3", [1, 2, 3]),
        ("1-2, 2", [1, 2]),
        ("kind-merging", [2]),
        ("003-kind-crossing", [3]),
    ],
)
def test_expressions(logical, expression, indices):
    assert [s.index for s in pick(logical, expression)] == indices


def test_without_an_expression_conflicts_come_first(logical):
    assert [s.index for s in pick(logical, None)] == [1, 3, 2, 0]


@pytest.mark.parametrize("expression", ["9", "3-1", "2-9", "", "nonsense", "1,,2", "-1"])
def test_unknown_parts_are_named(logical, expression):
    with pytest.raises(InputError, match="names no logical scenario; there are 0-3"):
        pick(logical, expression)
