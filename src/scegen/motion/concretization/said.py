"""What the words behind a danger say of the thing that causes it."""

from __future__ import annotations

import re

from scegen.motion.concretization.drafts import Scene
from scegen.scenario.functional import FunctionalScenario, Hazard


def words_of(functional: FunctionalScenario, hazard: Hazard) -> list[str]:
    """The words that a danger rests on, then those that nothing else could hold."""
    field = f"hazards.{hazard.kind}"
    evidence = [e.text for e in functional.evidence if e.field == field and e.text]
    return [*evidence, *(left.text for left in functional.unsupported)]


def object_id(scene: Scene, what: str) -> str:
    """A name for a thing that nobody has yet."""
    stem = re.sub(r"[^a-z0-9]+", "_", what.lower()).strip("_")[:30]
    taken = {p.id for p in scene.functional.participants} | {o.id for o in scene.objects}
    number = next(n for n in range(1, len(taken) + 2) if f"{stem}_{n}" not in taken)
    return f"{stem}_{number}"
