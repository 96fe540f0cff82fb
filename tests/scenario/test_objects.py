"""Objects in concrete scenarios: written, read back, named once; older files have none."""

from __future__ import annotations

import pytest
import yaml
from by_hand import by_hand
from pydantic import ValidationError

from scegen.errors import VocabularyError
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario, DriveMotion
from scegen.scenario.files import from_data, to_yaml
from scegen.scenario.objects import ObjectCategory, StaticObject
from scegen.scenario.parsing import parse
from scegen.scenario.vocabulary import ParticipantKind, Role

WAY = DriveMotion(
    entry=0, entry_lane=1, exit=1, exit_lane=1, start_m=0, turning_starts_m=50, turning_ends_m=50
)
EGO = ConcreteParticipant(
    id="ego", kind=ParticipantKind.CAR, role=Role.EGO, speed_mps=10, motion=WAY
)

CRATE = StaticObject(
    id="crate_1",
    category=ObjectCategory.OBSTACLE,
    what="crate",
    x_m=60.0,
    y_m=-1.75,
    heading_deg=0.0,
    length_m=0.8,
    width_m=0.8,
    height_m=0.8,
    blueprint="static.prop.box01",
)


def test_objects_are_written_and_read_back():
    made = by_hand(EGO, objects=(CRATE,))
    again = from_data(ConcreteScenario, parse(to_yaml(made), where="x"), where="x")
    assert again == made
    assert [entity.id for entity in made.entities] == ["ego", "crate_1"]


def test_files_without_objects_still_load():
    data = yaml.safe_load(to_yaml(by_hand(EGO)))
    del data["objects"]
    assert from_data(ConcreteScenario, data, where="old").objects == ()


def test_an_object_has_a_name_of_its_own():
    double = CRATE.model_copy(update={"id": "ego"})
    with pytest.raises(ValidationError, match="not unique"):
        by_hand(EGO, objects=(double,))


@pytest.mark.parametrize(
    ("field", "value"),
    [("category", "cardboard"), ("length_m", 0.0), ("blueprint", "vehicle.x"), ("id", "A box")],
)
def test_objects_keep_to_the_vocabulary(field, value):
    data = CRATE.model_dump(mode="json") | {field: value}
    with pytest.raises(VocabularyError):
        from_data(StaticObject, data, where="object")
