"""The ego goes through a junction past one who stands there: nothing more happens."""

import shutil

import pytest
from saying import made, person, said

from scegen.checking import CheckStatus, check_folder
from scegen.pipeline.export import export_scenario
from scegen.pipeline.raising import chosen_target
from scegen.scenario.files import to_yaml

WAITS = person("car", approaches=["right"], maneuvers=["stay"])
EGO = person("ego", maneuvers=["straight"])


def past(**fields):
    junction = {"control": "yield", "lanes": [1] * 3}
    return said("t", EGO, WAITS, junction=junction, **fields)


def test_who_is_driven_past_stands_all_the_time_at_its_line():
    raised = made(past())
    assert raised.proof.target == "avoided"
    assert raised.proof.in_band
    assert not raised.proof.missed
    car = raised.concrete.participant("car")
    assert car.speed_mps == 0.0
    assert 0.0 < car.motion.turning_starts_m - car.motion.start_m < 12.0


def test_a_danger_is_looked_for_with_one_who_moves():
    moving = person("car", approaches=["right"])
    assert made(said("t", EGO, moving)).proof.target == "near-miss"
    assert chosen_target(None, past(outcome={"kind": "collision"})) == "collision"


@pytest.mark.esmini
@pytest.mark.skipif(not shutil.which("esmini"), reason="esmini is not on PATH")
def test_who_stands_at_a_junction_need_not_leave_it(tmp_path):
    concrete = made(past()).concrete
    for name, content in export_scenario(concrete).items():
        (tmp_path / name).write_bytes(content)
    (tmp_path / "concrete.yaml").write_text(to_yaml(concrete))
    assert check_folder(tmp_path, ["esmini"]).result("esmini").status is CheckStatus.PASSED


def test_room_that_is_said_to_be_left_beside_those_who_are_passed_is_kept():
    beside = {"measure": "lateral_gap_m", "participant": "ego", "value": 1.2}
    parked = person("van", parked=True, approaches=["right"], maneuvers=["stay"])
    cyclist = person("rider", "bicycle", approaches=["ahead"], maneuvers=["straight"])
    for other, way in ((parked, "straight"), (cyclist, "overtake")):
        spacing = beside | {"reference": other["id"]}
        told = said("straight", person("ego", maneuvers=[way]), other, spacings=[spacing])
        proof = made(told).proof
        assert (proof.in_band, proof.missed) == (True, ())
