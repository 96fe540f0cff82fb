"""Friction, sight and weather that are said are those of the file, as numbers and as words."""

import pytest
from saying import missed

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.understanding import read

TEXTS = {
    "friction": "On a road with a friction coefficient of 0.3 the lead car brakes with 2 m/s².",
    "visual_range_m": "In fog with a visibility of 80 m the lead car brakes with 2 m/s².",
    "weather": "In fog the lead car brakes with 2 m/s².",
}


@pytest.mark.parametrize("field", TEXTS)
def test_it_holds_as_said_and_not_otherwise(field):
    functional = read(TEXTS[field])
    logical = enumerate_scenarios(functional).scenarios[0]
    concrete = concretize(functional, logical)
    claim = f"road.environment.{field}"
    assert claim not in missed(functional, concrete)
    other = concrete.environment.model_copy(update={field: None})
    changed = concrete.model_copy(update={"environment": other})
    assert claim in missed(functional, changed)
