"""No number of the text gets lost between reader and agents, and both mean the same by it."""

import pytest

from scegen.understanding.agents import Kept

TEXT = "The ego follows a van at 72 km/h. The van brakes with 5 m/s2 to 36 km/h."


def interval(value):
    return {"low": value, "high": value}


def people(**speed):
    return {
        "participants": [
            {"id": "ego", "role": "ego", "maneuvers": ["straight"], **speed},
            {"id": "van_1", "kind": "van", "approaches": ["ahead"], "maneuvers": ["straight"]},
        ],
        "basis": [
            {"field": "participants.ego.role", "words": "The ego"},
            {"field": "participants.ego.speed_mps", "words": "at 72 km/h"},
            {"field": "participants.van_1.kind", "words": "a van"},
            {"field": "participants.van_1.approaches", "words": "follows a van"},
        ],
    }


def braking(rate, target, words="with 5 m/s2"):
    act = {"id": "brake_1", "participant": "van_1", "kind": "brake", "rate_mps2": interval(rate)}
    if target is not None:
        act["target_speed_mps"] = interval(target)
    return {
        "acts": [act],
        "basis": [
            {"field": "acts.brake_1", "words": "brakes"},
            {"field": "acts.brake_1.rate_mps2", "words": words},
            {"field": "acts.brake_1.target_speed_mps", "words": "to 36 km/h"},
        ],
    }


@pytest.fixture
def read_by(understood):
    def run(acts, **changes):
        answers = {
            "road": {"junction": {"kind": "straight", "arms": 2}},
            "participants": people(speed_mps=interval(20.0)),
            "hazards": {
                "hazards": [{"kind": "hard_braking", "by": ["van_1"], "to": ["ego"]}],
                "basis": [{"field": "hard_braking", "words": "brakes with 5 m/s2"}],
            },
            "acts": acts,
            "reviewer": {"objections": []},
            **changes,
        }
        return understood(answers, TEXT)

    return run


def test_the_same_numbers_are_no_matter(read_by, chat_server):
    result = read_by(braking(5.0, 10.0))
    assert not [d for d in result.disagreements if d.field.startswith("acts")]
    assert len(chat_server.asked("acts")) == 1


def test_a_number_that_is_lost_goes_back(read_by, chat_server):
    result = read_by([braking(5.0, None), braking(5.0, 10.0)])
    assert len(chat_server.asked("acts")) == 2
    assert "36 km/h" in result.objections[0].problem
    assert result.functional.acts[0].target_speed_mps.exact


def test_a_number_said_not_to_fit_is_not_lost(read_by, chat_server):
    acts = braking(5.0, None)
    acts["unsupported"] = [{"words": "to 36 km/h", "instead": "left out"}]
    read_by(acts)
    assert len(chat_server.asked("acts")) == 1


def test_of_two_amounts_on_the_same_words_the_readers_stands(read_by):
    result = read_by(braking(0.5, 10.0))
    (item,) = [d for d in result.disagreements if d.field.startswith("acts")]
    assert (item.field, item.reader, item.agents) == ("acts.brake_1.rate_mps2", "5", "0.5")
    assert item.kept is Kept.READER
    assert result.functional.acts[0].rate_mps2.low == 5.0


def reviewed(server):
    (request,) = server.asked("reviewer")
    return request["messages"][-1]["content"]


def test_the_reviewer_sees_types_paths_and_neighbours(read_by, chat_server):
    acts = braking(5.0, 10.0)
    driven = {"type": "driven", "participant": "van_1", "distance_m": interval(30.0)}
    acts["acts"][0]["when"] = driven
    acts["outcome"] = {"kind": "avoided", "between": ["ego", "van_1"]}
    acts["basis"].append({"field": "outcome.between", "words": "The ego follows a van"})
    seen = people(speed_mps=interval(20.0))
    seen["participants"].append({"id": "car_1"})
    relation = {"participant": "car_1", "reference": "van_1", "approaches": ["behind"]}
    seen["relations"] = [relation]
    seen["basis"].append({"field": "relations[0]", "words": "follows"})
    result = read_by(acts, participants=seen)
    text = str(reviewed(chat_server))
    assert '{"type": "driven", "participant": "van_1"' in text
    assert '- outcome.between: stated "The ego follows a van"' in text
    assert '- relations.0: stated "follows"' in text
    assert "- hazards[].kind `stopping`: " in text, "the neighbour of hard_braking"
    assert "car_1.kind" not in text, "a car is what anything is of which no more is said"
    assert result.functional.acts[0].when.distance_m.low == 30.0


def test_two_notes_on_the_same_words_are_both_kept(read_by):
    acts = braking(5.0, 10.0)
    acts["unsupported"] = [{"words": "follows a van", "instead": "no following in acts"}]
    seen = people(speed_mps=interval(20.0))
    seen["unsupported"] = [{"words": "follows a van", "instead": "read as ahead"}]
    (phrase,) = read_by(acts, participants=seen).functional.unsupported
    assert phrase.instead == "read as ahead; no following in acts"
