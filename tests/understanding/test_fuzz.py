"""Random texts: a scenario or a clear error, always; a loop without end would hang here."""

import random
import sys

import pytest

from scegen.errors import ScegenError
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import MAX_CHARACTERS, parse_report, read
from scegen.understanding.lexicon import load

STRANGE = "\x00\x07\t\n\r\u200b\u202e\ud800é日🚗 carturns left.-'’\"(){}"


def outcome(text):
    try:
        return read(text)
    except ScegenError as error:
        return error


@pytest.mark.parametrize("seed", range(8))
def test_words_of_the_lexicon_in_any_order(seed):
    rng = random.Random(seed)  # noqa: S311 - test texts
    words = [*sorted(load().words), "V1", "A", "70", ".", ",", ";", ":", "(", ")", "'s", "n't"]
    found = [outcome(" ".join(rng.choices(words, k=rng.randint(1, 80)))) for _ in range(40)]
    assert any(isinstance(f, FunctionalScenario) for f in found)


@pytest.mark.parametrize("seed", range(4))
def test_any_characters(seed):
    rng = random.Random(seed)  # noqa: S311 - test texts
    for _ in range(40):
        outcome("".join(rng.choices(STRANGE, k=rng.randint(1, 300))))


@pytest.mark.parametrize("seed", range(4))
def test_every_script(seed):
    rng = random.Random(seed)  # noqa: S311 - test texts
    for _ in range(40):
        letters = (chr(rng.randrange(sys.maxunicode + 1)) for _ in range(rng.randint(1, 300)))
        outcome("A car " + "".join(letters))


@pytest.mark.parametrize(
    "unit", ["car ", "(", "a car and ", "of the ", "turns left, ", "x", "é ", "1 "]
)
def test_long_texts(unit):
    outcome(unit * (MAX_CHARACTERS // len(unit)))
    assert isinstance(outcome(unit * 1_000_000), ScegenError)


def test_reports_on_random_texts():
    rng = random.Random(0)  # noqa: S311 - test texts
    words = sorted(load().words)
    for _ in range(40):
        text = " ".join(["car", *rng.choices(words, k=30)])
        report = parse_report(text)
        assert all(f.start is None or text[f.start : f.end] == f.words for f in report.findings)


@pytest.mark.parametrize(
    "text",
    [
        "excess cautiously whizz find mobile maim cruising have paddock fridge 4x4 cadillac de was "
        "such shed florist child we",
        "van slowest boomer sky van kill daydream distinct muppet hubcap bride mi passat rush hill "
        "allege guided, bloody scout hyundai cop is soldier toddler host empty caravan we",
    ],
)
def test_several_who_are_called_the_ego_are_one(text):
    scenario = read(text)
    assert [p.role.value for p in scenario.participants].count("ego") == 1
