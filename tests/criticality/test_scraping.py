"""Who comes over into the side of another goes no farther than to its side."""

import numpy as np
import pytest

from scegen.claims.boxes import boxes, seen
from scegen.concretization import concretize
from scegen.criticality.raising.raising import named_pair, raise_criticality
from scegen.criticality.raising.stage import Stage
from scegen.criticality.target import parse_target
from scegen.enumeration import enumerate_scenarios
from scegen.road import build_network
from scegen.understanding import read

_INTO_M = 0.3


def collided(text):
    functional = read(text)
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    raised = raise_criticality(functional, concrete, target="collision")
    network = build_network(raised.concrete.road)
    between = named_pair(functional, raised.concrete)
    stage = Stage(functional, raised.concrete, network, parse_target("collision"), between)
    return raised, stage.examine(raised.concrete).view


@pytest.mark.parametrize(
    "text",
    [
        "A car sideswipes the ego from the left.",
        "A van in the lane on the right drifts over and scrapes along the ego.",
        "A car in the left lane changes lane into the ego and hits its side.",
    ],
)
def test_no_body_goes_into_another(text):
    raised, view = collided(text)
    assert raised.proof.in_band
    other = next(p.id for p in raised.concrete.participants if p.id != "ego")
    one, two = boxes(view, "ego"), boxes(view, other)
    beside = one.half_width + two.half_width
    assert float(np.abs(seen(one, two).y[0]).min()) > beside - _INTO_M


@pytest.mark.parametrize(
    "text",
    [
        "An oncoming car drifts into our lane and hits us.",
        "A car merging from the ramp hits the side of the ego.",
    ],
)
def test_who_cannot_stay_beside_is_halted_otherwise(text):
    raised, _ = collided(text)
    assert raised.proof.in_band
    assert any(p.on_contact for p in raised.concrete.participants)
