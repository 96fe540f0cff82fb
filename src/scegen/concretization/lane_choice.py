"""Which lane a drive takes where the text leaves it open."""

from __future__ import annotations

from collections.abc import Sequence

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.setup import Setup
from scegen.errors import MotionInfeasibleError
from scegen.road.model import Route
from scegen.scenario.concrete import LaneChange
from scegen.scenario.vocabulary import HazardKind


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


def neighbour_lane(scene: Setup, draft: DriveDraft, *, oncoming: bool) -> int:
    """The lane into which a drive pulls out: towards the centre line, else outwards.

    ``oncoming`` allows (and where there is one lane, chooses) the oncoming lane.

    Raises:
        MotionInfeasibleError: there is only one lane and the oncoming one is not allowed.
    """
    if draft.entry_lane > 1:
        return draft.entry_lane - 1
    if oncoming:
        return 0
    if lanes_in(scene, draft) > 1:
        return 2
    raise MotionInfeasibleError(
        f"arm {draft.drive.entry} has one lane: there is no lane to change into", where=draft.id
    )


def change_lanes(
    scene: Setup,
    draft: DriveDraft,
    changes: Sequence[tuple[float, float, int]],
    hazard: HazardKind | None = None,
    *,
    offset_m: float = 0.0,
) -> None:
    """Add lane changes (position, length, lane after) and lay the drive out anew.

    The first ends ``offset_m`` to the left of its lane's centre.
    """
    draft.lane_changes += [
        LaneChange(
            position_m=round(max(0.0, position), 3),
            length_m=round(length, 3),
            lane_after=lane,
            offset_m=offset_m if n == 0 else 0.0,
            hazard=hazard,
        )
        for n, (position, length, lane) in enumerate(changes)
    ]
    draft.lay(scene.network)
