"""scegen check judges what was said on what runs, and names the words that do not hold."""

import re

import pytest

from scegen.checking import CheckStatus, check_folder, recording
from scegen.checking.said import CHECKER
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, EgoMode, Options
from scegen.understanding import read

TEXT = "The ego drives at 50 km/h straight over a crossing while a car comes from the left."


@pytest.fixture
def folder(tmp_path):
    result = generate(read(TEXT), tmp_path, Options(depth=CheckDepth.NONE))
    return tmp_path / "scenarios" / next(iter(result.proofs))


def said(folder):
    return check_folder(folder, [CHECKER]).result(CHECKER)


def test_all_that_is_said_holds_and_the_player_is_named(folder):
    result = said(folder)
    assert result.status is CheckStatus.PASSED, result.findings
    assert "statements hold in esmini" in result.detail or "our own simulation" in result.detail


def test_without_esmini_our_own_simulation_is_judged(folder, monkeypatch):
    monkeypatch.setattr(recording, "esmini", lambda: None)
    result = said(folder)
    assert result.status is CheckStatus.PASSED
    assert "our own simulation" in result.detail


def test_what_does_not_hold_is_named_with_its_words(folder):
    functional = folder.parent.parent / "functional.yaml"
    text, times = re.subn(r"\b13\.8+9?\b", "20.0", functional.read_text())
    assert times == 2
    functional.write_text(text)
    result = said(folder)
    assert result.status is CheckStatus.FAILED
    (finding,) = result.errors
    assert finding.rule == "said.speed"
    assert finding.place == "participants.ego.speed_mps"
    assert "50 km/h" in finding.message


@pytest.mark.parametrize(
    ("name", "told", "changed"),
    [
        ("concrete.yaml", "weather: null", "weather: rain"),
        ("scenario.xosc", 'maxSpeed="60.0"', 'maxSpeed="61.0"'),
    ],
)
def test_weather_is_not_judged_by_numbers_that_the_file_is_not_of(folder, name, told, changed):
    file = folder / name
    text = file.read_text()
    assert told in text
    file.write_text(text.replace(told, changed))
    result = said(folder)
    assert result.status is CheckStatus.NOT_RUN
    assert [finding.rule for finding in result.findings] == ["said.file"]


def test_without_a_description_nothing_is_judged(folder):
    (folder.parent.parent / "functional.yaml").unlink()
    result = said(folder)
    assert result.status is CheckStatus.NOT_RUN
    assert "functional.yaml" in result.detail


def test_an_ego_from_outside_does_as_it_likes(tmp_path):
    options = Options(depth=CheckDepth.NONE, ego=EgoMode.EXTERNAL)
    result = generate(read(TEXT), tmp_path, options)
    folder = tmp_path / "scenarios" / next(iter(result.proofs))
    assert said(folder).status is CheckStatus.NOT_RUN
