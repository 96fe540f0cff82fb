"""Movements from lane to lane: changes of lane, merging, the oncoming lane."""

from __future__ import annotations

from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import ways
from scegen.understanding.meaning.context import Context, Scene

_HALF = frozenset({"half", "halfway", "partly", "partially", "midway", "way"})


def apply(scene: Scene, context: Context, values: set[Maneuver], basis: Basis) -> None:
    """Says what the drivers of a scene do.

    Args:
        scene: what happens.
        context: the scenario in the making.
        values: the movements that the words allow.
        basis: the words.
    """
    alternative = scene.alternative
    for entity in scene.drivers:
        later = context.in_order(entity.maneuver_basis, scene.event)
        context.draft.maneuver(entity, values, basis, alternative, later=later)


def lane_change(scene: Scene, context: Context) -> None:
    """A change of lane on the way; where the vehicle leaves stays free."""
    basis = Basis(scene.event.i, scene.event.j)
    context.lanes_implied(basis, "a lane change needs a second lane")
    apply(scene, context, {Maneuver.LANE_CHANGE}, basis)


def merge(scene: Scene, context: Context) -> None:
    """Merging on a road without a junction, or into a lane, is a lane change."""
    meets = context.junction.crossing or context.draft.access is not None
    if ways.into_lane(scene.event) is not None or not meets:
        lane_change(scene, context)


def between_lanes(mention: Mention, context: Context) -> None:
    """``the ego is half in its lane and half in the next``: it is changing lanes.

    Args:
        mention: who is there.
        context: the scenario in the making.
    """
    words = {context.tokens[m.j - 1].low for m in mention.mods} | {
        context.tokens[p.word.i - 1].low for p in mention.pps if p.word.i
    }
    lanes = [p.target for p in mention.pps if isinstance(p.target, Place)]
    lanes = [p for p in lanes if p.kind == "lane" and ways.BESIDE & set(p.dirs)]
    movers = [e for e in mention.entities if e.moving_vehicle and not e.maneuvers]
    for entity in movers if lanes and words & _HALF else []:
        basis = Basis(mention.i, lanes[-1].j)
        context.lanes_implied(basis, "a lane change needs a second lane")
        context.draft.maneuver(entity, {Maneuver.LANE_CHANGE}, basis)


def swerve(scene: Scene, context: Context) -> None:
    """``swerves into the oncoming lane``, ``veers into the left lane``."""
    lane = ways.into_lane(scene.event)
    if lane is None or lane.kind != "lane" or lane.owner is not None:
        return
    if "opposite" in lane.dirs and not any(context.oncoming(e) for e in scene.drivers):
        use_oncoming_lane(scene, lane, context)
    elif ways.next_lane(scene.event, context):
        lane_change(scene, context)


def forced(scene: Scene, context: Context) -> None:
    """``is forced into the opposite lane``, ``pushes the ego into the left lane``."""
    lane = ways.into_lane(scene.event)
    moved = [e for e in scene.targets if e.moving_vehicle]
    if lane is None or lane.kind != "lane" or not moved:
        return
    if "opposite" in lane.dirs:
        use_oncoming_lane(Scene(scene.event, moved, []), lane, context)
    elif ways.BESIDE & set(lane.dirs):
        lane_change(Scene(scene.event, moved, []), context)


def use_oncoming_lane(scene: Scene, lane: Place, context: Context) -> None:
    """Whoever is in the oncoming lane passes something there.

    Args:
        scene: what happens.
        lane: the oncoming lane.
        context: the scenario in the making.
    """
    reason = "the oncoming lane is used to get past something"
    basis = Basis(scene.event.i, max(scene.event.j, lane.j), reason)
    apply(scene, context, {Maneuver.OVERTAKE}, basis)


def on_the_wrong_side(mention: Mention, context: Context) -> None:
    """``an oncoming bus in the ego's lane``: it has no business there.

    Args:
        mention: who is there.
        context: the scenario in the making.
    """
    if "opposite" not in mention.dirs:
        return
    for prep in mention.pps:
        lane = prep.target
        owner = lane.owner if isinstance(lane, Place) and lane.kind == "lane" else None
        if prep.value == "in" and owner is not None and any(e.ego for e in owner.entities):
            by = [e for e in mention.entities if e.moving_vehicle]
            basis = Basis(prep.word.i, owner.j)
            context.draft.hazard(HazardKind.ONCOMING_LANE, basis, by, owner.entities)
