"""Speeding: 1.2 to 1.5 times the limit, and faster through bends."""

from __future__ import annotations

from scegen.concretization.drafts import Setup
from scegen.concretization.hazards.rule import Rule, culprits
from scegen.concretization.limits import FAST_LATERAL_MPS2, SPEEDING_FACTOR
from scegen.scenario.functional import Hazard
from scegen.scenario.speed_limits import limit_for_kind_mps

_CLEARLY = 1.1


def _prepare(scene: Setup, hazard: Hazard) -> None:
    for draft in culprits(scene, hazard):
        factor = float(scene.rng.uniform(*SPEEDING_FACTOR))
        limit = limit_for_kind_mps(draft.kind, scene.limit_mps)
        wanted = factor * limit
        low, high = scene.allowed(f"{draft.id}.speed_mps", (wanted, wanted))
        inside = min(max(wanted, low), high)
        # A range that ends at the limit would undo the danger that the text asks for.
        speed = inside if inside >= _CLEARLY * limit else wanted
        speed = min(speed, draft.body.top_speed_mps)
        scene.note(
            f"{draft.id}.speed_mps",
            speed,
            f"speeding: {speed / limit:.2f} times the limit",
            draft.cruise_mps,
        )
        draft.cruise_mps = speed
        draft.lateral_mps2 = FAST_LATERAL_MPS2


SPEEDING = Rule(prepare=_prepare)
