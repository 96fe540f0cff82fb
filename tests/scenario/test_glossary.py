"""Every word of the contract is defined, and pages and schemas are made from the definitions."""

from __future__ import annotations

from enum import StrEnum

import pytest

from scegen.scenario.definitions import Word
from scegen.scenario.files import json_schema
from scegen.scenario.functional import Participant
from scegen.scenario.glossary import VOCABULARY, defined, meaning_of, page
from scegen.scenario.outcome import BodySide
from scegen.scenario.vocabulary import DrivingSide, HazardKind, Maneuver

_WORDS = [word for words in VOCABULARY for word in words]
_ALONE = {*BodySide, *DrivingSide, *(m for m in Maneuver if m.startswith("exit_"))}


def test_no_list_of_words_is_left_out():
    lists = {HazardKind, *(words for words in Word.__subclasses__() if len(words) > 0)}
    assert lists == set(VOCABULARY)


@pytest.mark.parametrize("word", _WORDS, ids=lambda w: f"{type(w).__name__}.{w}")
def test_every_word_is_defined(word):
    meaning = meaning_of(word)
    assert len(meaning.text.split()) > 1
    for part in meaning:
        assert not part.endswith("."), part
        assert part == part.strip()
    assert "|" not in meaning.sentence


@pytest.mark.parametrize("words", VOCABULARY, ids=lambda words: words.__name__)
def test_no_two_words_of_a_list_mean_the_same(words):
    assert len({meaning_of(word).text for word in words}) == len(words)


@pytest.mark.parametrize("words", VOCABULARY, ids=lambda words: words.__name__)
def test_a_word_is_not_its_own_neighbour(words):
    for word in words:
        assert f"`{word}`" not in meaning_of(word).is_not.replace(f"`{word}` alone", "")


def test_neighbours_are_words_or_fields():
    known = {str(word) for word in _WORDS} | {"outcome.impact_percent", "Approach.right"}
    known |= {"Approach.left", *Participant.model_fields}
    for word in _WORDS:
        assert set(meaning_of(word).is_not.split("`")[1::2]) <= known, word


def test_a_word_without_meaning_is_refused():
    class Stranger(StrEnum):
        X = "x"

    with pytest.raises(KeyError):
        meaning_of(Stranger.X)


@pytest.mark.parametrize("level", ["functional", "logical", "concrete"])
def test_schemas_define_their_words(level):
    definitions = json_schema(level)["$defs"]
    named = {words.__name__: words for words in VOCABULARY if words.__name__ in definitions}
    assert named
    for name, words in named.items():
        assert defined(words) in definitions[name]["description"]


def test_every_word_is_on_the_page():
    written = page()
    assert all(f"| `{word}` | {meaning_of(word).text} |" in written for word in _WORDS)
