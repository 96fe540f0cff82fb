import pytest

from scegen.scenario.evidence import EvidenceSource
from scegen.understanding import read
from scegen.understanding.lexicon import load, word_lists
from scegen.understanding.words.lemmas import meant, one_slip


@pytest.mark.parametrize(
    ("written", "key"),
    [
        ("intersecton", "intersection"),
        ("pedestrain", "pedestrian"),
        ("vehcle", "vehicle"),
        ("motorcyle", "motorcycle"),
        ("roundaboutt", "roundabout"),
        ("barkes", "brakes"),
        ("overtekes", "overtakes"),
    ],
)
def test_one_wrong_letter_in_a_long_key_word_is_mended(written, key):
    assert meant(written) == key


@pytest.mark.parametrize(
    "word", ["learning", "burning", "charges", "tuning", "intrsecton", "cra", "xyzzy", "single"]
)
def test_other_words_are_left_alone(word):
    assert meant(word) is None


@pytest.mark.parametrize(
    ("one", "other", "holds"),
    [
        ("bus", "bus", False),
        ("buss", "bus", True),
        ("bsu", "bus", True),
        ("bos", "bus", True),
        ("sub", "bus", False),
        ("busses", "bus", False),
    ],
)
def test_one_slip(one, other, holds):
    assert one_slip(one, other) is holds
    assert one_slip(other, one) is holds


def test_the_evidence_says_what_was_mended():
    scenario = read("At an intersecton a pedestrain crosses in front of the ego.")
    by_field = {e.field: e for e in scenario.evidence}
    kind = by_field["participants.pedestrian_1.kind"]
    assert kind.source is EvidenceSource.INFERRED
    assert kind.text == "a pedestrain"
    assert kind.reason == "'pedestrain' is read as 'pedestrian'"
    junction = by_field["junction.kind"]
    assert junction.text is not None
    assert "intersecton" in junction.text
    assert "'intersecton' is read as 'intersection'" in (junction.reason or "")


def test_key_words_are_known_and_real_words_are_none_of_them():
    spelling = word_lists("spelling")
    assert not spelling["keys"] & spelling["real_words"]
    assert not {w for w in spelling["real_words"] if w in load().words}
