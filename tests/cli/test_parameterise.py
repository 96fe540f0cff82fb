"""scegen parameterise, as a user runs it."""

import pytest

from scegen.checking.environment import esmini

TEXT = "At a four-way intersection the ego turns left and an oncoming car drives straight on."


@pytest.fixture
def logical(scegen, tmp_path):
    done = scegen("enumerate", TEXT, "--json", "-o", "logical.json")
    if done.returncode:
        (tmp_path / "logical.json").write_text(scegen("enumerate", TEXT, "--json").stdout)
    return tmp_path / "logical.json"


def test_tells_parameters_and_what_is_fixed(scegen, logical, tmp_path):
    done = scegen("parameterise", logical, "-i", "0", "-o", "made", "--sets", "2")
    assert done.returncode == 0, done.stderr
    assert "ego_speed_mps" in done.stdout
    assert "fixed: of ego" in done.stdout
    made = sorted(p.name for p in (tmp_path / "made").iterdir())
    assert made == ["parameterised.xosc", "road.xodr", "values.xosc"]


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
def test_confirms(scegen, logical, tmp_path):
    done = scegen("parameterise", logical, "-i", "0", "-o", "made", "--sets", "2", "--confirm")
    assert done.returncode == 0, done.stderr
    assert "parameters passed" in done.stdout
    again = scegen("parameterise", tmp_path / "made/sets/001", "-o", "again", "--sets", "1")
    assert again.returncode == 0, again.stderr


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["-o", "made"], "choose --index"),
        (["-o", "made", "-i", "99"], "99"),
        (["-o", "logical.json", "-i", "0"], "is a file"),
        (["-o", "made", "-i", "0", "--sets", "0"], "at least 1"),
    ],
)
def test_bad_input(scegen, logical, arguments, says):
    done = scegen("parameterise", logical, *arguments)
    assert done.returncode == 2, done.stderr
    assert says in done.stderr


def test_neither_logical_nor_concrete(scegen, tmp_path):
    (tmp_path / "functional.yaml").write_text(scegen("understand", TEXT).stdout)
    done = scegen("parameterise", "functional.yaml", "-o", "made")
    assert done.returncode == 2
    assert "functional" in done.stderr


def test_confirm_without_esmini(scegen, logical):
    done = scegen("parameterise", logical, "-i", "0", "-o", "made", "--confirm", path="/nowhere")
    assert done.returncode == 3
    assert "esmini" in done.stderr
