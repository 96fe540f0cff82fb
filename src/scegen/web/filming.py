"""Scenes for the player: a concrete scenario as it moves, and its first timing."""

from __future__ import annotations

import json

from scegen.concretization import concretize
from scegen.errors import InfeasibleError
from scegen.report.player.scene import scene_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.web.jobs import Teller
from scegen.web.made import Made, MadeScenario


def film(made: MadeScenario, whole: Made, tell: Teller) -> bytes:
    """The scene as found and, where a search has changed it, as it was first laid: JSON.

    The object holds ``scene``, ``before`` (or null) and ``environment``.
    """
    tell.progress("drawing the movement")
    before = None
    if made.proof is not None and made.proof.changed:
        first = whole.given or _first_timing(whole.functional, made.concrete)
        before = None if first is None else scene_of(first, made.proof, first=True)
    data = {
        "scene": scene_of(made.concrete, made.proof),
        "before": before,
        "environment": made.concrete.environment.model_dump(mode="json"),
    }
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode()


def _first_timing(
    functional: FunctionalScenario | None, found: ConcreteScenario
) -> ConcreteScenario | None:
    """What the search began from, by the same call; None if it cannot be laid any more."""
    if functional is None:
        return None
    try:
        return concretize(functional, found.logical, seed=found.seed)
    except InfeasibleError:
        return None
