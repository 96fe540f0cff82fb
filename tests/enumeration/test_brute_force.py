"""The encodings against a brute force that knows nothing of them."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.enumeration import count_scenarios, enumerate_scenarios
from scegen.errors import NoScenarioError
from scegen.scenario.functional import FunctionalScenario, Group, Hazard, Participant
from scegen.scenario.hazards import FROM_BESIDE
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import ArmsMode, Reduction

JUNCTIONS = [
    ("straight", 2),
    ("t", 3),
    ("y", 3),
    ("four_way", 4),
    ("skewed", 4),
    ("roundabout", 3),
    ("roundabout", 4),
]
MANEUVERS = [(), (), ("straight",), ("left",), ("right", "straight"), ("u_turn", "left"),
             ("lane_change",), ("overtake",), ("exit_2", "exit_1")]  # fmt: skip
APPROACHES = [(), (), (), ("opposite",), ("left", "right"), ("behind",), ("ahead", "left"),
              ("ahead", "behind"), ("adjacent",)]  # fmt: skip
HAZARDS = ["tailgating", "merging_conflict", "failure_to_yield", "unprotected_left_turn"]


@st.composite
def functionals(draw):
    kind, arms = draw(st.sampled_from(JUNCTIONS))
    side = draw(st.sampled_from(["right", "right", "left"]))
    number = draw(st.integers(2, 4 if arms < 4 else 3))
    exits = kind == "roundabout"  # elsewhere they are refused
    maneuvers = [words for words in MANEUVERS if exits or "exit_1" not in words]
    participants = [
        Participant(
            id=f"car_{index}",
            role="other" if index else "ego",
            kind=draw(st.sampled_from(["car", "car", "car", "van"])),
            maneuvers=draw(st.sampled_from(maneuvers)),
            approaches=draw(st.sampled_from(APPROACHES)) if index else (),
            entries=draw(st.sampled_from([(), (), (), (0,), (0, arms - 1)])),
        )
        for index in range(number)
    ]
    hazards = []
    if draw(st.integers(0, 2)) == 0:
        by, to = draw(st.permutations(range(number)))[:2]
        chosen = draw(st.sampled_from(HAZARDS))
        if kind == "straight" and chosen in FROM_BESIDE:
            chosen = "tailgating"  # the brute force knows no lanes, and so no merging from beside
        both = participants[by].approaches & participants[to].approaches
        in_lanes = "adjacent" in both or (kind == "straight" and both & {"left", "right"})
        if not in_lanes:  # nor one behind the other in the lane beside the ego
            hazards.append(Hazard(kind=chosen, by=(f"car_{by}",), to=(f"car_{to}",)))
    groups = []
    if number > 2 and draw(st.integers(0, 2)) == 0:
        members = [p.id for p in participants[: draw(st.integers(2, number))]]
        words = draw(st.sampled_from([("left",), ("straight", "right")]))
        groups.append(Group(members=members, number=draw(st.integers(0, 2)), maneuvers=words))
    return FunctionalScenario(
        description="drawn",
        junction=Junction(kind=kind, arms=arms, driving_side=side),
        participants=tuple(participants),
        hazards=tuple(hazards),
        groups=tuple(groups),
    )


@settings(max_examples=60)
@given(functional=functionals(), arms=st.sampled_from(list(ArmsMode)))
def test_same_classes_of_the_same_sizes(oracle, functional, arms):
    for reduction in Reduction:
        expected = oracle.classes(functional, reduction, arms)
        if not expected:
            try:
                enumerate_scenarios(functional, reduction=reduction, arms=arms)
            except NoScenarioError:
                continue
            raise AssertionError("brute force finds no scenario")
        listed = enumerate_scenarios(functional, reduction=reduction, arms=arms)
        sizes = sorted(scenario.class_size for scenario in listed.scenarios)
        assert sizes == sorted(expected.values()), reduction
        assert listed.certificate.total == sum(expected.values())
        assert listed.certificate.complete
        counted = count_scenarios(functional, reduction=reduction, arms=arms)
        assert (counted.total, counted.count) == (sum(sizes), len(sizes))


def manner(drive):
    if drive.maneuver is drive.turn:
        return None
    side = "" if drive.changes_to is None else f"_{drive.changes_to}"
    return f"{drive.maneuver}{side}"


@settings(max_examples=60)
@given(functional=functionals())
def test_without_reduction_exactly_the_assignments(oracle, functional):
    expected = {
        tuple((e, d, m if m != "plain" else None) for e, d, m, _ in made)
        for made in oracle.assignments(functional)
    }
    if not expected:
        return
    listed = enumerate_scenarios(functional, reduction=Reduction.NONE)
    found = {
        tuple((d.entry, d.move, manner(d)) for d in scenario.drives)
        for scenario in listed.scenarios
    }
    assert found == expected
