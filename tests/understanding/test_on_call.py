"""Siren and blue lights: an emergency vehicle that everybody lets pass."""

import pytest

from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "called"),
    [
        ("An ambulance with siren and blue lights comes from the left at a crossroads.", True),
        ("At a crossroads a fire engine comes from the right with its siren on.", True),
        ("An ambulance on an emergency call comes towards the ego at a T-junction.", True),
        ("At a crossroads a police car without siren comes from the left.", False),
        ("At a crossroads a police car comes from the left.", False),
    ],
)
def test_it_is_on_call(text, called):
    found = read(text)
    (vehicle,) = [p for p in found.participants if p.kind == "emergency_vehicle"]
    assert vehicle.on_call == called
    assert any(e.field.endswith(".on_call") for e in found.evidence) == called
    assert called <= (not found.unsupported)


def test_lamps_of_others_are_told():
    found = read("A van with flashing lights stops in front of the ego.")
    assert [u.text for u in found.unsupported] == ["flashing lights"]


def test_of_two_the_one_beside_whom_it_is_said():
    text = (
        "A police car comes from the left at a crossroads, an ambulance with siren from the right."
    )
    vehicles = [p for p in read(text).participants if p.kind == "emergency_vehicle"]
    assert [p.on_call for p in vehicles] == [False, True]
