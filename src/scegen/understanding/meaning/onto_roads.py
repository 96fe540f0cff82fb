"""Turns that are said by the road they lead onto: "joins the main road to the left"."""

from __future__ import annotations

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.chunks import Place
from scegen.understanding.meaning import ways
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.meaning.lane_moves import apply, merge

_ROADS = frozenset({"road", "highway", "leg", "access"})
_ENTERING = frozenset({"enter", "merge", "pull_out"})


def onto_a_road(scene: Scene, context: Context) -> bool:
    """``enters the main road to the right``: the side to which it leads is the turn.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    event = scene.event
    goals = [event.object, *(p.target for p in event.pps if p.value == "into")]
    road = any(isinstance(g, Place) and g.kind in _ROADS for g in goals)
    found = ways.directions(event, context.tokens) if road and event.name in _ENTERING else {}
    sideways = {m: basis for m, basis in found.items() if m is not Maneuver.STRAIGHT}
    if sideways:
        basis = next(iter(sideways.values()))
        context.crossing_implied(basis, "vehicles turn")
        apply(scene, context, set(sideways), basis)
    return bool(sideways)


def join(scene: Scene, context: Context) -> None:
    """``joins the traffic``: merging, unless a turn onto another road is told.

    Args:
        scene: what happens.
        context: the scenario in the making.
    """
    if not onto_a_road(scene, context):
        merge(scene, context)
