"""Dangers from slowing down and stopping: hard, late, or where others drive."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, ParticipantKind
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import side_roads
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.meaning.standing import STANDING

_GENTLY = frozenset({"gently", "gentle", "lightly", "light", "softly", "soft", "smoothly", "smooth",
                     "gradually", "gradual", "moderately", "moderate", "mildly", "mild",
                     "slightly", "slight", "carefully", "comfortably"})  # fmt: skip
_BEYOND = frozenset({"past", "beyond", "after"})
_REGULATED = frozenset({"signal", "stop_sign", "stop_line", "yield_sign", "bus_stop", "parking",
                        "shoulder", "sidewalk", "crosswalk"})  # fmt: skip


def brake(scene: Scene, context: Context) -> None:
    """Braking counts when it is sudden; plain braking only where it is not an answer."""
    parent = scene.event.parent
    if parent is not None and parent.name == "delay":
        return
    late = scene.how("late")
    if late is not None:
        context.draft.hazard(HazardKind.DELAYED_BRAKING, late, scene.drivers)
        return
    sudden = scene.sudden
    answer = scene.reaction or any(p.value == "for" for p in scene.event.pps)
    answer = answer or (all(e.ego for e in scene.drivers) and bool(context.draft.dangers))
    if sudden is None and answer:
        return
    if sudden is None and (not scene.drivers or _gentle(scene, context)):
        return
    context.draft.hazard(HazardKind.HARD_BRAKING, sudden or scene.words, scene.drivers)


def hard_brake(scene: Scene, context: Context) -> None:
    """``slams on the brakes``, ``emergency braking``; what one is forced to is no danger."""
    if scene.event.modal and not scene.event.nominal and any(e.ego for e in scene.actors):
        return
    context.draft.hazard(HazardKind.HARD_BRAKING, scene.words, scene.drivers)


def _gentle(scene: Scene, context: Context) -> bool:
    """``brakes gently``, ``a gradual deceleration``."""
    return any(context.tokens[m.j - 1].low in _GENTLY for m in scene.event.mods)


def slow(scene: Scene, context: Context) -> None:
    """Slowing down is hard braking when sudden, or when the vehicle ahead does it."""
    lets = any(c.name == "cause" for c in scene.event.children)  # "slows down to let her cross"
    if not scene.drivers or (lets and scene.sudden is None):
        return
    sudden = scene.sudden
    if sudden is None and all(e.ego for e in scene.drivers):
        return  # "slows for a right turn"
    leads = any(
        p.entity in scene.drivers and Approach.AHEAD in p.approaches
        for p in context.draft.placements
    )
    if scene.event.perfect and sudden is None:
        if leads:
            context.draft.hazard(HazardKind.SLOW_DRIVING, scene.words, scene.drivers)
        return
    if sudden is not None or (leads and not (scene.reaction or _gentle(scene, context))):
        context.draft.hazard(HazardKind.HARD_BRAKING, sudden or scene.words, scene.drivers)


def stop(scene: Scene, context: Context) -> None:
    """Stopping where traffic moves; at a sign or light it is no danger."""
    if scene.event.parent is not None and scene.event.parent.name == "try":
        return  # "tries to stop": nothing that it does unasked
    sudden = scene.sudden
    motor = [e for e in scene.drivers if e.kind is not ParticipantKind.BICYCLE]
    if sudden is not None and motor:
        context.draft.hazard(HazardKind.HARD_BRAKING, sudden, motor)
    too_late(scene, context)
    beyond = {
        id(p.target) for p in scene.event.pps if context.tokens[p.word.i].low in _BEYOND
    }  # "stops just past the crosswalk"
    if any(p.kind in _REGULATED and id(p) not in beyond for p in scene.places()):
        return
    if any(p.value == "for" and isinstance(p.target, Mention) for p in scene.event.pps):
        return  # "stops for her"
    if scene.reaction or not scene.actors or any(e.ego for e in scene.actors):
        return
    if side_roads.stays_there(scene, context):
        return
    context.draft.hazard(HazardKind.STOPPING, sudden or scene.words, scene.actors)


def wait(scene: Scene, context: Context) -> None:
    """``a taxi standing in the lane``: it blocks the way."""
    lanes = any(
        p.word.value == "in"
        and isinstance(p.target, Place)
        and p.target.kind in {"lane", "middle"}
        and not ({"adjacent", "opposite"} & set(p.target.dirs))
        for p in scene.event.pps
    )
    others = [e for e in scene.drivers if not e.ego]
    stands = scene.event.lemma in STANDING
    if lanes and stands and others:
        context.draft.hazard(HazardKind.STOPPING, scene.words, others)


def too_late(scene: Scene, context: Context) -> None:
    """``notices the queue too late``, ``reacts late``."""
    late = scene.how("late")
    if late is not None and scene.drivers:
        context.draft.hazard(HazardKind.DELAYED_BRAKING, late, scene.drivers)


def delay(scene: Scene, context: Context) -> None:
    """``delays braking``, ``hesitates to brake``."""
    if any(c.name in {"brake", "slow", "stop"} for c in scene.event.children):
        child = scene.event.children[0]
        basis = Basis(scene.event.i, child.j)
        context.draft.hazard(HazardKind.DELAYED_BRAKING, basis, scene.drivers)
