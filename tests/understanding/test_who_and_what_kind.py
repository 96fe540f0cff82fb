"""Who a role means by where it is, what kind a counted junction is, and what is a danger."""

from collections import Counter

import pytest

from scegen.scenario.vocabulary import Control, JunctionKind
from scegen.understanding import read


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("The ego follows a van through town; the adversarial van ahead stops.", {"van": 1}),
        (
            "The ego drives behind a bus; the adversarial bus in front of the ego swerves.",
            {"bus": 1},
        ),
        ("The ego tailgates a lorry. The adversarial lorry ahead brakes.", {"truck": 1}),
        ("The ego follows a bus; the adversarial bus behind swerves.", {"bus": 2}),
        ("The ego follows a van; the adversarial bus ahead stops.", {"van": 1, "bus": 1}),
        ("The ego overtakes a van; the adversarial van ahead stops.", {"van": 2}),
        ("The ego follows a van; the adversarial van ahead of a bus stops.", {"van": 2, "bus": 1}),
    ],
)
def test_a_role_is_the_one_who_is_already_there(text, expected):
    others = Counter(p.kind.value for p in read(text).participants if p.role != "ego")
    assert others == expected


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A five-arm roundabout where two cars meet.", JunctionKind.ROUNDABOUT),
        ("Two cars enter a four-legged roundabout.", JunctionKind.ROUNDABOUT),
        ("A three-arm roundabout with a bus.", JunctionKind.ROUNDABOUT),
        ("Two vans meet at a three-leg Y-junction.", JunctionKind.Y),
        ("Two vans meet at a three-leg junction.", JunctionKind.T),
        ("Two vans meet at a four-leg junction.", JunctionKind.FOUR_WAY),
    ],
)
def test_arms_are_counted_but_the_noun_says_what_kind_it_is(text, kind):
    assert read(text).junction.kind is kind


def test_a_counted_signalised_junction():
    junction = read("A 4-leg signalised intersection with two cars.").junction
    assert (junction.kind, junction.control) == (JunctionKind.FOUR_WAY, Control.SIGNALS)
