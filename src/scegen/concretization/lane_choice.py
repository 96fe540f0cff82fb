"""Which lane a drive takes where the text leaves it open."""

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


def choose_lanes(scene: Setup, draft: DriveDraft) -> None:
    """Start in the outermost lane that leads to the exit."""
    draft.entry_lane = draft.exit_lane = entry_lanes(scene, draft)[0]
    choose_ring_lane(scene, draft)


def choose_ring_lane(scene: Setup, draft: DriveDraft, *, inner: bool = False) -> None:
    """The outermost ring lane (or the innermost) that can be reached from the drive's lane."""
    routes = (r for r in routes_of(scene, draft) if r.entry_lane == draft.entry_lane)
    rings = sorted(r.ring_lane for r in routes if r.ring_lane is not None)
    if rings:
        draft.ring_lane = rings[0] if inner else rings[-1]
