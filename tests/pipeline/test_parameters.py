"""A scenario with parameters: its numbers, its files, and what esmini makes of them."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from lxml import etree

from scegen.checking import CheckStatus, check_files
from scegen.checking.environment import esmini
from scegen.checking.parameters import check_parameters
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError, InputError
from scegen.export.expressions import Expression
from scegen.pipeline.export import ROAD_FILE
from scegen.pipeline.folder import write_files
from scegen.pipeline.parameter_sets import (
    PARAMETERISED_FILE,
    VALUES_FILE,
    set_files,
    write_parameter_files,
)
from scegen.pipeline.parameterising import parameter_space, parameterised
from scegen.pipeline.picking import pick
from scegen.understanding import read

TEXTS = (
    "At a four-way intersection the ego turns left and an oncoming car drives straight on.",
    "A car cuts in front of the ego on a two-lane road and brakes hard.",
    "A pedestrian crosses the road from behind a parked van in front of the ego.",
)
needs_esmini = pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")


def made_of(text):
    functional = read(text)
    scenario = pick(enumerate_scenarios(functional, limit=200), None)[0]
    return functional, concretize(functional, scenario, seed=3)


@pytest.fixture(scope="module", params=TEXTS, ids=["turn", "cut-in", "pedestrian"])
def said(request):
    return made_of(request.param)


@pytest.fixture(scope="module")
def written(said, tmp_path_factory):
    """The files of three sets, and their folder."""
    made = write_parameter_files(*said, count=3, seed=5, alone=True)
    folder = tmp_path_factory.mktemp("parameters")
    write_files(folder, made.files)
    return made, folder


def evaluated(text, values):
    for name in sorted(values, key=len, reverse=True):
        text = text.replace(f"${name}", f"({values[name]!r})")
    return eval(text.strip("${}"), {"__builtins__": {}}, {"sqrt": sqrt, "pow": pow})  # noqa: S307


def test_expressions_give_the_search_s_candidates(said):
    """Whatever the values: what the file computes is what the search computes."""
    space = parameter_space(*said)
    numbers = parameterised(space).numbers
    low, high = space.bounds
    rng = np.random.default_rng(1)
    for x in rng.uniform(low, high, (20, len(low))):
        values = dict(zip(space.names, x.tolist(), strict=True))
        made = space.problem.space.candidates(x[None, :])
        k = 0
        for i, participant in enumerate(space.concrete.participants):
            name = participant.id
            if name in numbers.starts:
                along = evaluated(numbers.starts[name].along_m.written, values)
                assert along == pytest.approx(made.start_m[0, i])
            for phase in numbers.phases[name]:
                for mine, theirs in (
                    (phase.trigger, made.trigger),
                    (phase.target_speed_mps, made.target_speed_mps),
                    (phase.rate_mps2, made.rate_mps2),
                ):
                    text = mine.written if isinstance(mine, Expression) else repr(float(mine))
                    assert evaluated(text, values) == pytest.approx(theirs[0, k], abs=1e-4)
                k += 1


def test_declared_within_bounds_and_named_once(written):
    made, _ = written
    names = [item.name for item in made.declared]
    assert len(set(names)) == len(names)
    assert all(item.low <= item.value <= item.high for item in made.declared)
    for one in made.sets:
        assert list(one.values) == names
        for item in made.declared:
            assert item.low <= one.values[item.name] <= item.high
    assert len({tuple(one.values.values()) for one in made.sets}) == len(made.sets)


def test_every_parameter_decides_something(written):
    made, folder = written
    text = (folder / PARAMETERISED_FILE).read_text()
    for item in made.declared:
        assert f"${item.name}" in text, item.name


def test_files_pass_all_checks(written):
    _, folder = written
    checkers = ("opendrive", "openscenario", "schema", "esmini")
    for report in check_files([folder / PARAMETERISED_FILE, folder / VALUES_FILE], checkers):
        assert report.ok, [r.errors for r in report.results]
    root = etree.parse(folder / PARAMETERISED_FILE).getroot()
    assert root.find("FileHeader").get("revMinor") == "2"
    assert "Fixed: " in root.find("FileHeader").get("description")


def test_the_same_again(said, written):
    made, _ = written
    assert write_parameter_files(*said, count=3, seed=5, alone=True).files == made.files
    other = write_parameter_files(*said, count=1, seed=6)
    assert other.files[PARAMETERISED_FILE] == made.files[PARAMETERISED_FILE]
    assert other.sets[0].values != made.sets[0].values


@pytest.mark.esmini
@needs_esmini
def test_plays_as_the_scenarios_of_their_own(written):
    _, folder = written
    checked = check_parameters(
        folder / PARAMETERISED_FILE, folder / VALUES_FILE, set_files(folder, 3)
    )
    assert checked.status is CheckStatus.PASSED, checked.findings


@pytest.mark.esmini
@needs_esmini
def test_another_value_is_noticed(written, tmp_path):
    made, folder = written
    for name in ("road.xodr", PARAMETERISED_FILE):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    values = (folder / VALUES_FILE).read_text()
    speed = next(name for name in made.sets[1].values if name.endswith("speed_mps"))
    right = f'"{speed}" value="{made.sets[1].values[speed]:g}"'
    assert right in values
    wrong = values.replace(right, f'"{speed}" value="{made.sets[1].values[speed] + 0.05:g}"')
    (tmp_path / VALUES_FILE).write_text(wrong)
    checked = check_parameters(
        tmp_path / PARAMETERISED_FILE, tmp_path / VALUES_FILE, set_files(folder, 3)
    )
    assert {finding.rule for finding in checked.errors} == {"parameters.position"}
    assert {finding.place for finding in checked.errors} == {"sets/002"}


def test_draws_that_give_no_scenario_are_told():
    made = write_parameter_files(*made_of(TEXTS[2]), count=12, seed=0)
    assert len(made.sets) == 12
    assert sum(made.passed_over.values()) > 0
    reasons = {"somebody does not leave in time", "a trigger ties with a step of time"}
    assert set(made.passed_over) & reasons


def test_refusals(said):
    with pytest.raises(InputError, match="at least 1"):
        write_parameter_files(*said, count=0, seed=0)
    functional, concrete = said
    creeping = concrete.model_copy(
        update={
            "participants": tuple(
                p.model_copy(update={"speed_mps": 0.01, "speed_program": ()})
                for p in concrete.participants
            )
        }
    )
    with pytest.raises(InfeasibleError):
        write_parameter_files(functional, creeping, count=1, seed=0)


def test_the_road_has_the_lights_that_the_scenario_changes():
    text = "A truck from the right runs the red light at a crossing while the ego goes straight on."
    files = write_parameter_files(*made_of(text), count=1, seed=5).files
    road, scenario = (etree.fromstring(files[n]) for n in (ROAD_FILE, PARAMETERISED_FILE))
    lights = {found.get("id") for found in road.iterfind("controller")}
    named = {found.get("name") for found in scenario.iter("TrafficSignalController")}
    assert len(lights) == len(named) > 0
