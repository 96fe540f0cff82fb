"""A scene for the player: a crossing with a parked van, somebody on foot and a crate."""

from __future__ import annotations

from whole import CONCRETE

from scegen.motion import build_paths, simulate
from scegen.report.player.scene import player_scene
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.proof import ClaimProof, HazardProof, Proof

EVIL = '</script><img src=x onerror="document.title=1"><b>${1}'


def claim(name, statement, holds=True, kind="speed", **more):
    """A statement about ``name``."""
    return ClaimProof(
        id=f"{name}.{statement[:8]}",
        kind=kind,
        statement=f"{name} {statement}",
        field=f"participants.{name}.speed_mps",
        holds=holds,
        **more,
    )


CLAIMS = (
    claim("car_1", "drives 9 m/s", measured=9.0, unit="m/s", time_s=1.25, words="slowly"),
    claim("ego", f"is calm {EVIL}", holds=False, time_s=4.0),
    claim("van", "is there", kind="body", time_s=0.0),
)
DANGER = HazardProof(kind="failure_to_yield", by=("car_1",), to=("ego",), happened=True, time_s=6.5)
PROOF = Proof(
    target="near-miss",
    in_band=True,
    in_band_before=False,
    measure="pet",
    band=(0.0, 1.0),
    pair=("ego", "car_1"),
    measures=(),
    hazards=(DANGER,),
    hazards_before=(DANGER,),
    claims=CLAIMS,
    unwanted_contacts=(),
    evaluations=1,
    dt_s=0.01,
    changed=True,
    blocked_by=None,
)


def concrete(**fields) -> ConcreteScenario:
    """The scenario, with fields of its own."""
    return ConcreteScenario.model_validate(CONCRETE | fields)


def moved(scenario, dt_s=0.01):
    """(roads, paths, traces) of a scenario."""
    network = build_network(scenario.road, scenario.name)
    paths = build_paths(scenario, network)
    return network, paths, simulate(scenario, paths, dt_s=dt_s)


def scene(scenario=None, proof=PROOF, **more):
    """The player's scene and the traces that it was made from."""
    scenario = scenario or concrete()
    network, paths, traces = moved(scenario)
    return player_scene(scenario, network, traces, proof, paths=paths, **more), traces
