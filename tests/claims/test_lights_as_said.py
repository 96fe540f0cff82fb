"""How somebody meets its light: made as it is said, and missed under any other plan."""

import pytest
from saying import made, missed, person, said

from scegen.concretization.lights import shifted
from scegen.errors import ScegenError
from scegen.scenario.signals import SignalState

LIGHTS = {"control": "signals"}
RED = [{"kind": "red_light_running", "by": ["car"], "to": ["ego"]}]
STEPS_OFF = [{"kind": "crossing_pedestrian", "by": ["walker"], "to": ["ego"]}]


def driven(lit, kind="four_way", hazards=(), **car):
    people = person("ego", maneuvers=["straight"], light=lit), person("car", **car)
    return said(kind, *people, junction=LIGHTS, hazards=list(hazards))


def walked(light, crosses, way):
    walker = person("walker", "pedestrian", maneuvers=["cross"], light=light, crosses=crosses)
    ego = person("ego", maneuvers=[way], light="green")
    return said("four_way", ego, walker, junction=LIGHTS, hazards=STEPS_OFF)


SAID = {
    "green": driven("green", approaches=["left"]),
    "amber": driven("amber", approaches=["left"], light="green"),
    "waits": driven("waits", hazards=RED, approaches=["left"]),
    "other waits": driven("green", approaches=["right"], light="waits"),
    "stops": driven("stops", approaches=["right"]),
    "T": driven("amber", kind="t", approaches=["behind"]),
    "walks at red": walked("red", "entry", "straight"),
    "walks at green": walked("green", "exit", "left"),
}


@pytest.mark.parametrize("functional", SAID.values(), ids=SAID)
def test_it_is_as_said_and_under_no_other_plan(functional):
    raised = made(functional)
    assert not raised.proof.missed
    concrete = raised.concrete
    lit = {f"rule.light.{p.id}" for p in functional.participants if p.light is not None}
    assert lit <= {claim.id for claim in raised.proof.claims}
    plan = concrete.signals
    found = set()
    for part in range(1, 6):
        other = shifted(plan, part * plan.cycle_s / 6)
        found |= missed(functional, concrete.model_copy(update={"signals": other}))
    assert lit <= found


def test_people_on_foot_have_green_while_nobody_drives_straight_over_their_way():
    concrete = made(SAID["walks at red"]).concrete
    plan = concrete.signals
    group = next(g for g in plan.groups if g.afoot)
    (arm,) = group.arms
    for time_s in range(int(plan.cycle_s)):
        if plan.state(group, time_s) is SignalState.GREEN:
            for other in (arm, (arm + 2) % 4):
                assert plan.state(plan.group_of(other), time_s) is SignalState.RED
    assert SignalState.AMBER not in {state for _, state in plan.changes(group, 60.0)}


@pytest.mark.parametrize(
    ("junction", "people"),
    [
        ({"control": "stop"}, [person("ego", light="green")]),
        (LIGHTS, [person("ego"), person("w", "pedestrian", maneuvers=["cross"], light="amber")]),
    ],
)
def test_no_light_is_met_where_none_can_show_it(junction, people):
    with pytest.raises((ValueError, ScegenError), match="light"):
        said("four_way", *people, junction=junction)
