"""To whom is on call everybody gives way, whatever signs and lights say."""

import pytest
from saying import made, missed, person, said

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.motion.rules.lights import must_obey
from scegen.motion.rules.stopping import must_stop

AVOIDED = {"kind": "avoided", "between": []}


def met(control, *, on_call=True, **more):
    ambulance = person("ambulance", "emergency_vehicle", approaches=["left"],
                       maneuvers=["straight"], on_call=on_call)  # fmt: skip
    ego = person("ego", maneuvers=["straight"])
    return said("four_way", ego, ambulance, junction={"control": control}, **more)


@pytest.mark.parametrize(
    "control", ["uncontrolled", "priority_to_right", "yield", "stop", "all_way_stop", "signals"]
)
def test_everybody_gives_way_to_it_and_it_to_nobody(control):
    functional = met(control, outcome=AVOIDED)
    for logical in enumerate_scenarios(functional).scenarios:
        (conflict,) = logical.conflicts
        assert (conflict.yields, conflict.rule) == ("ego", "on_call")
        assert "ambulance" not in must_stop(functional, logical) | must_obey(functional, logical)
        concrete = concretize(functional, logical)
        assert not missed(functional, concrete)


def test_otherwise_it_counts_as_any_other():
    listed = enumerate_scenarios(met("priority_to_right", on_call=False))
    assert {c.yields for s in listed.scenarios for c in s.conflicts} == {"ambulance"}


def test_who_does_not_give_way_to_it_is_in_breach():
    hazard = {"kind": "failure_to_yield", "by": ["ego"], "to": ["ambulance"]}
    found = made(met("priority_to_right", hazards=[hazard]))
    assert found.proof.in_band
    assert not found.proof.missed


def test_only_an_emergency_vehicle_is_on_call():
    with pytest.raises(ValueError, match="only an emergency_vehicle"):
        said("four_way", person("ego"), person("van", "van", on_call=True))
