"""Clauses that say what is done to the noun before them, or by whom it suffers it."""

import pytest

from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding import read


def culprits(text, hazard):
    scenario = read(text)
    kinds = {p.id: "ego" if p.role == "ego" else p.kind.value for p in scenario.participants}
    return [kinds[name] for h in scenario.hazards if h.kind == hazard for name in h.by]


@pytest.mark.parametrize(
    "text",
    [
        "The van that the ego is following brakes hard.",
        "The van the ego is following brakes hard.",
        "The van, which the ego is following, brakes hard.",
        "The ego slows because the van it is following brakes hard.",
        "When the van that the ego follows brakes hard, a bus comes.",
    ],
)
def test_who_is_followed_brakes(text):
    assert culprits(text, HazardKind.HARD_BRAKING) == ["van"]
    van = next(p for p in read(text).participants if p.kind == "van")
    assert van.approaches == {Approach.AHEAD}


@pytest.mark.parametrize(
    ("text", "who"),
    [
        ("The bus that was overtaken by a van brakes hard in front of the ego.", "bus"),
        ("The bus that overtook a van brakes hard in front of the ego.", "bus"),
        ("After passing the van the ego brakes hard.", "ego"),
        ("A bus that a van has overtaken brakes hard near the ego.", "bus"),
    ],
)
def test_who_goes_on_after_the_clause(text, who):
    assert culprits(text, HazardKind.HARD_BRAKING) == [who]


def test_who_overtakes_is_the_one_in_the_clause():
    assert culprits("The bus that the ego overtakes swerves.", HazardKind.OVERTAKING) == ["ego"]
    assert culprits("The bus that overtakes the ego swerves.", HazardKind.OVERTAKING) == ["bus"]
