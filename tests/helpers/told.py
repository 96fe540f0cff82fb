"""Functional scenarios told in short, without the reader, and what becomes of them."""

from __future__ import annotations

from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.attempts import make_some
from scegen.pipeline.options import Options
from scegen.pipeline.picking import pick
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import JunctionKind


def who(name, kind="car", approaches=(), maneuvers=(), *, speed=None, parked=False, lanes=()):
    """A participant; the one called ego is the ego."""
    return {
        "id": name,
        "kind": kind,
        "role": "ego" if name == "ego" else "other",
        "parked": parked,
        "lanes": list(lanes),
        "approaches": list(approaches),
        "maneuvers": list(maneuvers),
        "speed_mps": None if speed is None else {"low": speed, "high": speed},
    }


def told(
    kind,
    people,
    hazards=(),
    *,
    acts=(),
    spacings=(),
    objects=(),
    relations=(),
    outcome=None,
    lanes=0,
    side="right",
    **junction,
):
    """A functional scenario; ``hazards`` as (kind, by, to), one name each."""
    arms = ARM_COUNTS[JunctionKind(kind)][0]
    return FunctionalScenario.model_validate(
        {
            "description": "by hand",
            "junction": {
                "kind": kind,
                "arms": arms,
                "lanes": [lanes] * arms if lanes else [],
                "driving_side": side,
                **junction,
            },
            "participants": list(people),
            "hazards": [{"kind": k, "by": [by], "to": [to]} for k, by, to in hazards],
            "acts": list(acts),
            "spacings": list(spacings),
            "objects": list(objects),
            "relations": list(relations),
            "outcome": outcome,
        }
    )


def act(name, by, kind, **more):
    """Something that somebody does."""
    return {"id": name, "participant": by, "kind": kind, **more}


def apart(who, reference, measure, value, at="start", **more):
    """How far one is from another."""
    more |= {"participant": who, "reference": reference, "measure": measure}
    return {**more, "value": value, "at": at}


def as_soon_as(who, reference, measure, value):
    """The moment at which a measure has come down to a value."""
    found = {"participant": who, "reference": reference, "measure": measure, "value": value}
    return {"type": "measure", **found}


def driven(metres):
    """The moment at which one has gone so far since the start."""
    return {"type": "driven", "distance_m": metres}


def after(name, delay=0.0, since="end"):
    """The moment so long after an act; None is some time after it."""
    return {"type": "after", "act": name, "since": since, "delay_s": delay}


def at_time(delay):
    """The moment so long after the start."""
    return {"type": "start", "delay_s": delay}


def first(functional, seed=0):
    """Its first listed scenario, with numbers."""
    return concretize(functional, enumerate_scenarios(functional).scenarios[0], seed=seed)


def raised(functional, seed=0, target="near-miss"):
    """The same, with its danger raised."""
    return raise_criticality(functional, first(functional, seed), target=target, seed=seed)


def made(functional, seed=0, target="near-miss"):
    """(scenario, proof) of the first scenario in which all that is told comes about."""
    listed = pick(enumerate_scenarios(functional), None)
    raising = make_some(functional, listed, target, Options(seed=seed), lambda _: None)
    (concrete,) = raising.concretes
    return concrete, raising.proofs[concrete.name]
