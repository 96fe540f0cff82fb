"""A motorway or one-way road that is not written as described is found out."""

import pytest
from roads import AHEAD, ego, one, road

from scegen.checking.opendrive import check_opendrive
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.export.opendrive import write_opendrive
from scegen.road import build_network
from scegen.scenario.junction import Junction


@pytest.fixture(scope="module")
def motorway():
    made = Junction(
        kind="straight", arms=2, lanes=(2, 2), carriageway="divided", strips=["hard_shoulder"]
    )
    told = road([ego(100), one("car", "car", AHEAD)]).model_copy(update={"junction": made})
    return concretize(told, enumerate_scenarios(told).scenarios[0])


def findings(concrete, text):
    result = check_opendrive("road.xodr", text.encode(), concrete=concrete)
    return [f"{f.rule} {f.message}" for f in result.result.errors]


def test_it_is_written_as_described(motorway):
    text = write_opendrive(build_network(motorway.road))
    assert findings(motorway, text) == []
    assert 'type="motorway"' in text
    assert text.count('type="median"') == 4


@pytest.mark.parametrize(
    ("written", "instead", "told"),
    [
        ('id="-1" type="median"', 'id="-1" type="border"', "inside lane -2"),
        ('id="-4" type="shoulder"', 'id="-4" type="sidewalk"', "no shoulder beyond lane -3"),
        ('id="2" type="driving"', 'id="2" type="border"', "lanes in and"),
    ],
)
def test_what_is_missing_is_found(motorway, written, instead, told):
    text = write_opendrive(build_network(motorway.road))
    assert written in text
    found = findings(motorway, text.replace(written, instead))
    assert any(told in finding for finding in found), found
