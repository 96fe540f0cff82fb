"""Scenes for the player: a concrete scenario as it moves, and its first timing."""

from __future__ import annotations

import json

from scegen.concretization import concretize
from scegen.errors import ScegenError
from scegen.report.player.scene import scene_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof
from scegen.web.made import MadeScenario


def film(made: MadeScenario, functional: FunctionalScenario | None) -> bytes:
    """The scene as found and, where a search has changed it, as it was first laid: JSON.

    The object holds ``scene``, ``before`` (or null) and ``environment``.
    """
    before = None
    if functional is not None and made.proof is not None and made.proof.changed:
        before = _before(functional, made.concrete, made.proof)
    data = {
        "scene": scene_of(made.concrete, made.proof),
        "before": before,
        "environment": made.concrete.environment.model_dump(mode="json"),
    }
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode()


def _before(
    functional: FunctionalScenario, found: ConcreteScenario, proof: Proof
) -> dict[str, object] | None:
    """The scenario that the search began from; None if it cannot be laid any more."""
    try:
        first = concretize(functional, found.logical, seed=found.seed)
        return scene_of(first, proof, first=True)
    except ScegenError:
        return None
