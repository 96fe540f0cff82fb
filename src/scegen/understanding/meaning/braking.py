"""Dangers from slowing down and stopping: hard, late, or where others drive."""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, HazardKind, ParticipantKind
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.meaning import side_roads
from scegen.understanding.meaning.standing import STANDING
from scegen.understanding.semantics.context import Clause, Context

_GENTLY = frozenset({"gently", "gentle", "lightly", "light", "softly", "soft", "smoothly", "smooth",
                     "gradually", "gradual", "moderately", "moderate", "mildly", "mild",
                     "slightly", "slight", "carefully", "comfortably"})  # fmt: skip
_BEYOND = frozenset({"past", "beyond", "after"})
_REGULATED = frozenset({"signal", "stop_sign", "stop_line", "yield_sign", "bus_stop", "parking",
                        "shoulder", "sidewalk", "crosswalk"})  # fmt: skip


def brake(clause: Clause, context: Context) -> None:
    """Braking counts when it is sudden; plain braking only where it is not an answer."""
    parent = clause.event.parent
    if parent is not None and parent.name == "delay":
        return
    late = clause.how("late")
    if late is not None:
        context.draft.hazard(HazardKind.DELAYED_BRAKING, late, clause.drivers)
        return
    sudden = clause.sudden
    answer = clause.reaction or any(p.value == "for" for p in clause.event.pps)
    answer = answer or (all(e.ego for e in clause.drivers) and bool(context.draft.dangers))
    if sudden is None and answer:
        return
    if sudden is None and (not clause.drivers or _gentle(clause, context)):
        return
    context.draft.hazard(HazardKind.HARD_BRAKING, sudden or clause.words, clause.drivers)


def hard_brake(clause: Clause, context: Context) -> None:
    """``slams on the brakes``, ``emergency braking``; what one is forced to is no danger."""
    if clause.event.modal and not clause.event.nominal and any(e.ego for e in clause.actors):
        return
    context.draft.hazard(HazardKind.HARD_BRAKING, clause.words, clause.drivers)


def _gentle(clause: Clause, context: Context) -> bool:
    """``brakes gently``, ``a gradual deceleration``."""
    return any(context.tokens[m.j - 1].low in _GENTLY for m in clause.event.mods)


def slow(clause: Clause, context: Context) -> None:
    """Slowing down is hard braking when sudden, or when the vehicle ahead does it."""
    lets = any(c.name == "cause" for c in clause.event.children)  # "slows down to let her cross"
    if not clause.drivers or (lets and clause.sudden is None):
        return
    sudden = clause.sudden
    if sudden is None and all(e.ego for e in clause.drivers):
        return  # "slows for a right turn"
    leads = any(
        p.entity in clause.drivers and Approach.AHEAD in p.approaches
        for p in context.draft.placements
    )
    if clause.event.perfect and sudden is None:
        if leads:
            context.draft.hazard(HazardKind.SLOW_DRIVING, clause.words, clause.drivers)
        return
    if sudden is not None or (leads and not (clause.reaction or _gentle(clause, context))):
        context.draft.hazard(HazardKind.HARD_BRAKING, sudden or clause.words, clause.drivers)


def stop(clause: Clause, context: Context) -> None:
    """Stopping where traffic moves; at a sign or light it is no danger."""
    if clause.event.parent is not None and clause.event.parent.name == "try":
        return  # "tries to stop": nothing that it does unasked
    sudden = clause.sudden
    motor = [e for e in clause.drivers if e.kind is not ParticipantKind.BICYCLE]
    if sudden is not None and motor:
        context.draft.hazard(HazardKind.HARD_BRAKING, sudden, motor)
    too_late(clause, context)
    beyond = {
        id(p.target) for p in clause.event.pps if context.tokens[p.word.i].low in _BEYOND
    }  # "stops just past the crosswalk"
    if any(p.kind in _REGULATED and id(p) not in beyond for p in clause.places()):
        return
    if any(p.value == "for" and isinstance(p.target, Mention) for p in clause.event.pps):
        return  # "stops for her"
    if clause.reaction or not clause.actors or any(e.ego for e in clause.actors):
        return
    if side_roads.stays_there(clause, context):
        return
    context.draft.hazard(HazardKind.STOPPING, sudden or clause.words, clause.actors)


def wait(clause: Clause, context: Context) -> None:
    """``a taxi standing in the lane``: it blocks the way."""
    lanes = any(
        p.word.value == "in"
        and isinstance(p.target, Place)
        and p.target.kind in {"lane", "middle"}
        and not ({"adjacent", "opposite"} & set(p.target.dirs))
        for p in clause.event.pps
    )
    others = [e for e in clause.drivers if not e.ego]
    stands = clause.event.lemma in STANDING
    if lanes and stands and others:
        context.draft.hazard(HazardKind.STOPPING, clause.words, others)


def too_late(clause: Clause, context: Context) -> None:
    """``notices the queue too late``, ``reacts late``."""
    late = clause.how("late")
    if late is not None and clause.drivers:
        context.draft.hazard(HazardKind.DELAYED_BRAKING, late, clause.drivers)


def delay(clause: Clause, context: Context) -> None:
    """``delays braking``, ``hesitates to brake``."""
    if any(c.name in {"brake", "slow", "stop"} for c in clause.event.children):
        child = clause.event.children[0]
        basis = Basis(clause.event.i, child.j)
        context.draft.hazard(HazardKind.DELAYED_BRAKING, basis, clause.drivers)
