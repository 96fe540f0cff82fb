"""Which road of a junction somebody on foot crosses, by where another comes from or goes to."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, CrossedArm, Maneuver
from scegen.understanding.chunks import Event, Place, Prep
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.phrases.which_road import AGAINST, ALONG

_TURNS = frozenset({"turn", "sharp_turn", "enter", "move", "merge"})
_OVER = frozenset({"across", "over"})
_INTO = {"into": CrossedArm.EXIT, "from": CrossedArm.ENTRY}
_SIDES = {Maneuver.LEFT: Approach.LEFT, Maneuver.RIGHT: Approach.RIGHT}
_OTHER = {Approach.LEFT: Approach.RIGHT, Approach.RIGHT: Approach.LEFT}


def note_arms(scenes: list[Scene], context: Context) -> None:
    """``crosses the road that the ego turns into``, ``walks over the exit``.

    Args:
        scenes: what happens, in the order of the text.
        context: the scenario in the making.
    """
    used = _used_by_drivers(scenes)
    for scene in scenes:
        whom = scene.walkers + [e for e in scene.actors if context.is_cyclist(e) and not e.ego]
        for prep, place in _crossed(scene.event):
            rides = prep is None and scene.event.name != "cross"
            rides = rides or (prep is not None and context.tokens[prep.word.i].low not in _OVER)
            if rides and not scene.walkers:
                continue  # "a cyclist takes the first exit"
            arm = place.arm or used.get(place.kind)
            arm = CrossedArm.EXIT if arm is None and place.kind == "exit" else arm
            if arm is None:
                continue
            basis = Basis(prep.word.i if prep is not None else place.i, place.j)
            for entity in whom:
                entity.crosses = entity.crosses or (arm, basis)
                if context.is_cyclist(entity):
                    context.draft.maneuver(entity, {Maneuver.CROSS}, basis)
        term = scene.event.how(ALONG, AGAINST)
        if term is None:
            continue
        for entity in whom:
            entity.course = entity.course or (term.value == ALONG, Basis(term.i, term.j))


def crossed_road(event: Event) -> bool:
    """Whether a road that a clause tells is crossed."""
    return any(place.arm is not None for _, place in _crossed(event))


def _crossed(event: Event) -> list[tuple[Prep | None, Place]]:
    """The places that somebody goes over."""
    found: list[tuple[Prep | None, Place]] = []
    if isinstance(event.object, Place):
        found.append((None, event.object))
    found += [(p, p.target) for p in event.pps if p.value == "in" and isinstance(p.target, Place)]
    return found


def _used_by_drivers(scenes: list[Scene]) -> dict[str, CrossedArm]:
    """``turns into a side road``: for who comes by "the side road" later on."""
    found: dict[str, CrossedArm] = {}
    for scene in scenes:
        if scene.event.name not in _TURNS or not scene.drivers:
            continue
        for prep in scene.event.pps:
            place = prep.target
            if isinstance(place, Place) and place.kind == "access" and prep.value in _INTO:
                found.setdefault(place.kind, _INTO[prep.value])
    return found


def settle_arms(draft: Draft, ego: Entity) -> None:
    """From which side they come who walk as the ego drove before it turned, or against it.

    That leads over the road into which it turns. What is said of the side itself comes first.

    Args:
        draft: the scenario in the making.
        ego: its ego.
    """
    for entity in draft.entities:
        if entity.course is None or len(ego.maneuvers & set(_SIDES)) != 1:
            continue
        along, basis = entity.course
        if entity.crosses is None:
            reason = "across the ego's turn only this road is walked that way"
            entity.crosses = (CrossedArm.EXIT, Basis(basis.i, basis.j, reason))
        side = _SIDES[next(iter(ego.maneuvers & set(_SIDES)))]
        side = side if along else _OTHER[side]
        said = [p.approaches & set(_OTHER) for p in draft.placements if p.entity is entity]
        if entity.crosses[0] is CrossedArm.EXIT and all(side in sides for sides in said if sides):
            draft.place(entity, ego, {side}, basis)
