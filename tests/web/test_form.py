"""The form is told from the types: every field and word of the scenario, with its definition."""

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.vocabulary import HazardKind, ParticipantKind
from scegen.understanding import read, report_on
from scegen.web.form import LEFT_OUT, form_spec, standings
from scegen.web.provenance import carried_over, confirmed, without

SPEC = {section["name"]: section for section in form_spec()}


def fields(section):
    return {field["name"]: field for field in SPEC[section]["fields"]}


def test_every_field_of_the_scenario_is_in_the_form():
    assert set(SPEC) | LEFT_OUT == set(FunctionalScenario.model_fields)
    assert set(fields("participants")) == set(Participant.model_fields)


def test_words_bring_their_definitions():
    words = fields("hazards")["kind"]["words"]
    assert [word["value"] for word in words] == list(HazardKind)
    assert all(word["means"] for word in words)


def test_a_door_is_no_participant():
    kinds = [word["value"] for word in fields("participants")["kind"]["words"]]
    assert kinds == [kind for kind in ParticipantKind if kind is not ParticipantKind.DOOR]


def test_types_become_inputs_with_units():
    assert fields("participants")["speed_mps"]["type"] == "interval"
    assert fields("participants")["speed_mps"]["unit"] == "km/h"
    assert fields("acts")["into"] == fields("acts")["into"] | {"type": "name", "optional": True}
    assert [m["tag"] for m in fields("acts")["when"]["members"]][:2] == ["start", "after"]
    assert fields("spacings")["at"]["of"] == "moments"
    assert SPEC["outcome"]["optional"]


TEXT = "The ego turns left at a four-way intersection; an oncoming truck goes straight at 36 km/h."


def test_what_was_changed_rests_on_whoever_changed_it():
    old = read(TEXT)
    assert standings(report_on(old))["participants.truck_1.kind"]["standing"] == "understood"
    data = old.model_dump(mode="json")
    truck = next(p for p in data["participants"] if p["id"] == "truck_1")
    truck["kind"] = "bus"
    new = FunctionalScenario.model_validate(data)
    new = new.model_copy(update={"evidence": carried_over(old, new)})
    found = standings(report_on(new))
    assert found["participants.truck_1.kind"] == {"standing": "inferred", "why": "set by hand"}
    assert found["participants.truck_1.speed_mps"]["standing"] == "understood"


def test_an_assumption_that_is_confirmed_is_none_any_more():
    scenario = read(TEXT)
    assert standings(report_on(scenario))["junction.driving_side"]["standing"] == "assumed"
    after = standings(report_on(confirmed(scenario, "junction.driving_side")))
    assert after["junction.driving_side"]["standing"] == "inferred"


def test_who_is_taken_out_takes_along_what_cannot_be_without():
    scenario = read("A car cuts in 8 m ahead of the ego and then brakes with 6 m/s2.")
    other = next(p.id for p in scenario.participants if p.role == "other")
    left = FunctionalScenario.model_validate(without(scenario.model_dump(mode="json"), other))
    assert other not in {p.id for p in left.participants}
    assert not left.acts
    assert not left.spacings
    assert all(other not in (*hazard.by, *hazard.to) for hazard in left.hazards)
