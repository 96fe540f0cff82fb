"""Who is said to go round already is in the ring before those come in whom it meets."""

from saying import missed, person, said
from told import first, made


def told(circulating):
    people = [
        person(name, circulating=name == circulating, maneuvers=["exit_2"], **more)
        for name, more in (("ego", {}), ("truck", {"kind": "truck", "approaches": ["right"]}))
    ]
    return said("roundabout", *people, junction={"arms": 4})


def test_the_ego_goes_round_already_and_nobody_else():
    functional, turned = told("ego"), told("truck")
    concrete, proof = made(functional)
    assert "order.ring.ego.truck" in {claim.id for claim in proof.claims if claim.holds}
    assert "order.ring.truck.ego" in missed(turned, concrete, first(turned).logical)


def test_who_goes_round_already_and_brakes_does_so_in_the_ring():
    people = [person("ego"), person("van", "van", circulating=True, approaches=["ahead"])]
    functional = said(
        "roundabout",
        *people,
        junction={"arms": 4},
        hazards=[{"kind": "hard_braking", "by": ["van"], "to": ["ego"]}],
    )
    concrete, proof = made(functional)
    assert not [claim.id for claim in proof.claims if not claim.holds]
    stays_out = concrete.participant("van").model_copy(
        update={"speed_mps": 0.0, "speed_program": ()}
    )
    people = tuple(stays_out if p.id == "van" else p for p in concrete.participants)
    never_in = concrete.model_copy(update={"participants": people})
    assert "order.ring.van.ego" in missed(functional, never_in)
