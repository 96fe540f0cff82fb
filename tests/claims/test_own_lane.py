"""Who keeps its lane up to the junction does so whatever it comes beside beyond it."""

from random_traffic import traffic

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.picking import pick


def test_beyond_a_roundabout_one_may_come_beside_its_own_arm_again():
    functional = traffic("roundabout", 0, breach=False)
    logical = pick(enumerate_scenarios(functional, limit=50), None)[0]
    concrete = concretize(functional, logical, seed=0)
    claims = raise_criticality(functional, concrete, target="avoided", seed=0).proof.claims
    kept = {claim.id: claim.holds for claim in claims if claim.id.startswith("maneuver.lane.")}
    assert kept
    assert all(kept.values()), kept
