"""What is wrong with a file is said in words: where, what was found, what may stand there."""

import copy
import json
import math
import re

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from whole import CONCRETE, FUNCTIONAL, LOGICAL, WHOLE

from scegen.errors import VocabularyError
from scegen.scenario.files import LEVELS, from_data, load_any

NOT_OURS = re.compile(
    r"Input should|pydantic|https?:|Value error|validation error|Extra inputs|Field required"
    r"|cannot be used|ctx|Traceback|<class|\bNone\b|\bTrue\b|\bdict\b"
)
"""The words of libraries and of Python, and our own where no sentence was written."""


def places(data, path=()):
    yield path
    if isinstance(data, dict | list):
        for key, value in data.items() if isinstance(data, dict) else enumerate(data):
            yield from places(value, (*path, key))


ANYTHING = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.sampled_from([10**30, -1, 0, 1e308, -0.5, math.nan, math.inf])
    | st.floats()
    | st.sampled_from(["", "left", "ego", "Ego", "drive", "x" * 2000, "1", "true", "\ud800", "é\n"])
    | st.text(max_size=5)
    | st.dates()
    | st.binary(max_size=3),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(["low", "high", "type", "id", "kind", "participant"])
            | st.integers()
            | st.none(),
            inner,
            max_size=3,
        )
    ),
    max_leaves=6,
)


@st.composite
def mutated(draw):
    """A whole file's level, and its data with one to three things changed."""
    level = draw(st.sampled_from(sorted(WHOLE)))
    data = copy.deepcopy(WHOLE[level])
    for _ in range(draw(st.integers(1, 3))):
        path = draw(st.sampled_from([p for p in places(data) if p and p != ("level",)]))
        *way, last = path
        inner = data
        for part in way:
            inner = inner[part]
        match draw(st.sampled_from(["replace", "leave out", "add", "repeat"])):
            case "leave out":
                del inner[last]
            case "add" if isinstance(inner, dict):
                inner[draw(st.sampled_from(["colour", "speed", "typ", 3, None]))] = draw(ANYTHING)
            case "repeat" if isinstance(inner, list):
                inner.append(copy.deepcopy(inner[last]))
            case _:
                inner[last] = draw(ANYTHING)
    return level, data


@settings(max_examples=400)
@given(mutated())
def test_what_is_wrong_is_said_in_words(made):
    level, data = made
    try:
        found = from_data(LEVELS[level], data, where="file.yaml")
    except VocabularyError as error:
        said = error.render()
        assert said.startswith("file.yaml: ")
        assert not NOT_OURS.search(said), said
        said.encode()
    else:
        again = from_data(LEVELS[level], found.model_dump(mode="json"), where="file.yaml")
        assert again == found


@pytest.mark.parametrize("level", WHOLE)
@pytest.mark.parametrize("form", ["yaml", "json"])
def test_what_is_not_broken_is_read(tmp_path, level, form):
    path = tmp_path / f"whole.{form}"
    text = json.dumps(WHOLE[level]) if form == "json" else yaml.safe_dump(WHOLE[level])
    path.write_text(text, encoding="utf-8")
    plain = load_any(path)
    path.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert load_any(path) == plain


def changed(data, path, value):
    """The data with a value at a path; None takes it away."""
    data = copy.deepcopy(data)
    *way, last = path
    inner = data
    for part in way:
        inner = inner[part]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return data


CAR, ACT, DRIVE = ("participants", 1), ("acts", 0), ("scenarios", 0, "assignments", 0)
SAID = [
    (FUNCTIONAL, ("junction",), None, "junction: is missing"),
    (FUNCTIONAL, (*CAR, "speeed_mps"), 3, "participants.car_1.speeed_mps: there is no such field; "
     "did you mean speed_mps?"),
    (FUNCTIONAL, ("junction", "kind"), "roundabut", "junction.kind: 'roundabut' is not one of the "
     "words allowed; did you mean roundabout?"),
    (FUNCTIONAL, ("junction", "control"), "flags", "junction.control: 'flags' is not one of the "
     "words allowed: uncontrolled, priority_to_right, yield, stop, all_way_stop, signals"),
    (FUNCTIONAL, ("junction", "arms"), 99, "junction.arms: 99 is not allowed: it must be at most"),
    (FUNCTIONAL, ("junction", "arms"), "many", "junction.arms: 'many' is not a whole number"),
    (FUNCTIONAL, (*CAR, "id"), "Car 1", "'Car 1' is not a name of small letters, digits and _"),
    (FUNCTIONAL, (*CAR, "maneuvers"), "left", "participants.car_1.maneuvers: 'left' is not a list"),
    (FUNCTIONAL, (*CAR, "maneuvers"), ["fly"], "participants.car_1.maneuvers[0]: 'fly' is not"),
    (FUNCTIONAL, (*CAR, "speed_mps"), "fast", "participants.car_1.speed_mps: 'fast' is neither a "
     "number nor a range with low and high"),
    (FUNCTIONAL, (*CAR, "speed_mps"), math.nan, "participants.car_1.speed_mps: nan is not a number "
     "that is finite"),
    (FUNCTIONAL, (*CAR, "speed_mps"), -5, "participants.car_1.speed_mps: it is at least 0, not -5"),
    (FUNCTIONAL, (*ACT, "rate_mps2"), {"low": -2, "high": 3}, "it is at least 0, not -2 to 3"),
    (FUNCTIONAL, (*CAR, "length_m"), 500, "it is between 0.1 and 25.25, not 500"),
    (FUNCTIONAL, (*CAR, "speed_mps"), {"low": 3, "high": 2}, "low 3 lies above high 2"),
    (FUNCTIONAL, ("participants",), [], "participants: needs at least 1, has 0"),
    (FUNCTIONAL, ("participants",), [7], "participants[0]: 7 stands where fields are needed: id,"),
    (FUNCTIONAL, (*ACT, "when"), {"type": "soon"}, "acts.slows.when: 'soon' is not one of the "
     "types allowed: start, after, measure, driven, before_junction"),
    (FUNCTIONAL, (*ACT, "when"), {"delay_s": 1}, "acts.slows.when: lacks its type"),
    (FUNCTIONAL, ("description",), 3, "description: 3 is not text"),
    (FUNCTIONAL, ("hazards", 0, "by"), ["nobody"], "names the unknown participant 'nobody'"),
    (LOGICAL, (*DRIVE, "entry"), -1, "scenarios[0].assignments[0].entry: -1 is not allowed: it "
     "must be at least 0"),
    (LOGICAL, (*DRIVE, "type"), "fly", "scenarios[0].assignments[0].type: 'fly' is not one of "
     "the types allowed: drive, crossing, standing, walking"),
    (CONCRETE, ("name",), "../etc", "name: '../etc' is not a name of letters, digits, _ and -"),
    (CONCRETE, (*CAR, "speed_program", 0, "trigger", "distance_m"), 0, "participants.car_1."
     "speed_program[0].trigger.distance_m: 0 is not allowed: it must be more than 0"),
]  # fmt: skip


@pytest.mark.parametrize(("data", "path", "value", "words"), SAID)
def test_the_place_what_was_found_and_what_is_allowed(data, path, value, words):
    with pytest.raises(VocabularyError) as caught:
        from_data(LEVELS[data["level"]], changed(data, path, value), where="file.yaml")
    assert words in caught.value.message


def test_a_number_is_a_range_of_one_value():
    data = changed(FUNCTIONAL, (*CAR, "speed_mps"), 10.0)
    speed = from_data(LEVELS["functional"], data, where="x").participant("car_1").speed_mps
    assert (speed.low, speed.high) == (10.0, 10.0)


def test_only_the_first_complaints_are_shown():
    data = {"level": "functional", "junction": {"kind": "x", "arms": "y"}, "a": 1, "b": 2}
    with pytest.raises(VocabularyError, match=r"; and \d more$") as caught:
        from_data(LEVELS["functional"], data, where="file.yaml")
    assert caught.value.message.count("; ") == 3
