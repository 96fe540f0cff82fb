"""Scenes for the player: a concrete scenario as it moves, and its first timing."""

from __future__ import annotations

import json

from scegen.concretization import concretize
from scegen.errors import ScegenError
from scegen.motion import build_paths, simulate
from scegen.report.player.scene import player_scene
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.web.made import MadeScenario

_DT_S = 0.01
"""The step in which proofs are made, so that what is plotted is what was judged."""


def film(made: MadeScenario, functional: FunctionalScenario | None) -> bytes:
    """The scene as found and, where a search has changed it, as it was first laid: JSON.

    The object holds ``scene``, ``before`` (or null) and ``environment``.
    """
    before = None
    if functional is not None and made.proof is not None and made.proof.changed:
        before = _before(functional, made.concrete)
    data = {
        "scene": _scene(made.concrete, made.proof),
        "before": before,
        "environment": made.concrete.environment.model_dump(mode="json"),
    }
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode()


def _before(functional: FunctionalScenario, found: ConcreteScenario) -> dict[str, object] | None:
    """The scenario that the search began from; None if it cannot be laid any more."""
    try:
        first = concretize(functional, found.logical, seed=found.seed)
        return _scene(first, None)
    except ScegenError:
        return None


def _scene(concrete: ConcreteScenario, proof: Proof | None) -> dict[str, object]:
    network = build_network(concrete.road, name=concrete.name)
    paths = build_paths(concrete, network)
    traces = simulate(concrete, paths, dt_s=_DT_S)
    return player_scene(concrete, network, traces, proof, paths=paths)
