"""Which lanes a drive may take: those from which its exit can be reached."""

from __future__ import annotations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.setup import Setup
from scegen.errors import MotionInfeasibleError
from scegen.road.model import Route


def routes_of(scene: Setup, draft: DriveDraft) -> tuple[Route, ...]:
    """The routes between a drive's arms.

    Raises:
        MotionInfeasibleError: there is none.
    """
    key = (draft.drive.entry, draft.drive.exit)
    routes = scene.network.routes.get(key, ())
    if not routes:
        raise MotionInfeasibleError(
            f"no route leads from arm {key[0]} to arm {key[1]}", where=draft.id
        )
    return routes


def entry_lanes(scene: Setup, draft: DriveDraft) -> tuple[int, ...]:
    """The lanes from which a drive's exit can be reached, outermost first."""
    return tuple(sorted({r.entry_lane for r in routes_of(scene, draft)}, reverse=True))


def lanes_in(scene: Setup, draft: DriveDraft) -> int:
    """Number of lanes towards the junction on a drive's entry arm."""
    return scene.road.arms[draft.drive.entry].lanes_in
