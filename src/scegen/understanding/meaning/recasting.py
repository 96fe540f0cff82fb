"""What a verb of motion amounts to: who moves, and the phrase of place after it, decide.

English says how somebody moves by the verb and what comes of it by the phrase after it: to whip
past somebody is to overtake, to whip in front of somebody is to cut in, to whip out of a drive
is to pull out. On foot, whoever jumps out crosses.
"""

from __future__ import annotations

from scegen.scenario.vocabulary import Approach, Control
from scegen.understanding.chunks import Event, Mention, Place, Prep, Thing
from scegen.understanding.meaning import numbered_lanes
from scegen.understanding.meaning.verbs_of_contact import contact_or_shift
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.ways import into_lane

_OPEN = frozenset({"dash", "breach"})
"""Verbs that say nothing without a phrase of place."""
_MAKING = frozenset({"light", "use"})
_OUT = frozenset({"pull_out", "cut_in", "dash"})
_PAST = frozenset({"past", "by", "around", "round"})
_ROUND = frozenset({"around", "round", "past"})
_MOVING = frozenset({"move", "try", "crawl", "leave", "speed", "accelerate", "swerve",
                     "sharp_turn", "unknown"})  # fmt: skip
"""Verbs that with "round the van" mean to get past it."""
_ACROSS = frozenset({"across", "over"})
_HURRYING = frozenset({"move", "speed", "dash"})
_SPRINGING = frozenset({"shoot", "burst", "bolt", "fly", "race", "dart", "jump", "spring", "lurch",
                        "tear", "pop", "whip", "launch", "dash"})  # fmt: skip
_SWEEPING = frozenset({"encounter", "move", "cross", "speed", "dash"})
_ASIDE = frozenset({"access", "parking", "bus_stop", "sidewalk", "junction"})
_TURNED = frozenset({"side", "access", "road", "junction", "exit", "leg", "highway"})
_ROADS = frozenset({"road", "junction", "crosswalk", "highway", "path"})


def recast(clause: Clause, context: Context) -> str:
    """The name of an event by who acts in it and where that leads.

    Args:
        clause: the event with its participants.
        context: the scenario in the making.
    """
    event = clause.event
    shoved = event.lemma in {"shove", "barge", "push"}
    if event.name == "dash" and shoved and isinstance(event.object, Mention):
        return "send"  # "shoved us into the junction"
    if event.name in {"wait", "stop"} and clause.drivers and _close_behind(clause):
        return "tailgate"
    if _turned(clause, context):
        return "turn"
    if event.name == "walk" and clause.drivers and _runs_it(clause, context):
        return "breach"
    told = contact_or_shift(clause, context)
    if told is not None:
        return told
    if _next_lane(clause, context):
        return "lane_change"
    afoot = _on_foot(clause, context)
    if afoot is not None:
        return afoot
    if _over_lanes(clause, context):
        ahead = any(p.word.cat == "locus" and p.value == "ahead" and p.target for p in event.pps)
        return "cut_in" if ahead else "lane_change"
    driven = _driven(clause, context) if clause.drivers else None
    if driven is not None:
        return driven
    if event.name not in _OPEN or (event.name == "breach" and event.object is not None):
        return event.name
    if not clause.drivers:
        return event.name
    return _by_path(clause, context, riding=_riding(clause, context))


def _turned(clause: Clause, context: Context) -> bool:
    """``turns off to the right``, ``makes a left``."""
    if clause.event.name == "inert":
        return _turns_off(clause, context)
    return clause.event.name in _MAKING and _into_a_turn(clause.event)


def _next_lane(clause: Clause, context: Context) -> bool:
    """``passes into the left lane``, ``a van in lane 1 moves out``."""
    if clause.event.name == "pass":
        return not clause.targets and _into_next_lane(clause.event)
    return numbered_lanes.leaves_it(clause.event, clause.drivers, context.tokens)


def _close_behind(clause: Clause) -> bool:
    """``sits so close behind me``: stays there while both drive."""
    behind = [
        p.target
        for p in clause.event.pps
        if (p.word.cat, p.value) == ("locus", "behind") and isinstance(p.target, Mention)
    ]
    close = clause.how("close") is not None and not clause.event.negated
    if close and behind:
        clause.targets = [e for m in behind if isinstance(m, Mention) for e in m.entities]
    return close and bool(behind)


def _over_lanes(clause: Clause, context: Context) -> bool:
    """``came across two lanes in front of me``: from lane to lane where no roads meet."""
    event = clause.event
    if event.name not in _SWEEPING or context.junction.crossing or not clause.drivers:
        return False
    own = {t.low for t in context.tokens[event.i : event.j]} & _ACROSS
    lanes: list[object] = [event.object] if own else []
    lanes += [p.target for p in event.pps if context.tokens[p.word.i].low in _ACROSS]
    several = [n for n in lanes if isinstance(n, Place) and n.kind == "lane" and n.head is not None]
    several = [n for n in several if n.head and n.head.form == "s" and "opposite" not in n.dirs]
    others = [e for e in clause.drivers if not context.is_cyclist(e) and not context.oncoming(e)]
    return bool(several) and bool(others)


def _over_it(clause: Clause, context: Context) -> bool:
    """``tears across``, ``races over``: with no more said, the road."""
    own = _own(clause, context) | {
        context.tokens[m.j - 1].low for m in clause.event.mods if m.cat in {"manner", "dir"}
    }
    own |= {t.low for t in context.tokens[clause.event.j : clause.event.j + 1]}
    return bool(own & _ACROSS)


def _riding(clause: Clause, context: Context) -> bool:
    return all(context.is_cyclist(e) and not e.ego for e in clause.drivers)


def _driven(clause: Clause, context: Context) -> str | None:
    """The name of an event in which a vehicle moves; None if it keeps its own."""
    event = clause.event
    motor = [e for e in clause.drivers if not context.is_cyclist(e)]
    out = "out" in _own(clause, context) and not _riding(clause, context)
    careless = clause.how("aggressive", "sudden") is not None and event.name == "appear"
    aside = any(p.kind in {"access", "parking"} for p in clause.places())
    if motor and ((event.name == "cross" and out) or (careless and aside)):
        return "pull_out"  # "came out of the side road without looking"
    springs = event.lemma in _SPRINGING
    if event.name == "pull_out" and not motor and springs and not context.junction.crossing:
        return "cross"  # "a cyclist shoots out of a gap in a hedge"
    if event.name == "pull_out" and motor and _between_lanes(clause, context):
        return "cut_in"
    if event.name in {"move", "dash", "speed"} and _ignores_it(clause, context):
        return "breach"
    if event.name == "cross" and motor and _into_a_lane(event):
        return "lane_change"
    if event.name in _MOVING and motor and _goes_round(clause, context):
        return "bypass"
    lane = isinstance(event.object, Place) and event.object.kind == "lane"
    return "move" if event.name == "breach" and lane else None  # "through the opposite lane"


def _on_foot(clause: Clause, context: Context) -> str | None:
    """What people on foot do who move, jump out, or roll off the kerb; None for all else."""
    name = clause.event.name
    if name in _HURRYING and clause.walkers and _over_it(clause, context):
        return "cross"
    if not clause.actors or any(e.is_vehicle for e in clause.actors):
        return None
    if name in _OUT:
        return "cross" if not _around(clause, context) else "walk"
    off = name == "lose_control" and any(p.kind == "sidewalk" for p in clause.places())
    return "cross" if off else None


def _into_next_lane(event: Event) -> bool:
    """``passes into the left lane``: changes to it."""
    return any(
        p.value == "into" and isinstance(p.target, Place) and p.target.kind == "lane"
        for p in event.pps
    )


def _turns_off(clause: Clause, context: Context) -> bool:
    """``turns off to the right``, ``turns off into a side road``: no engine, no light."""
    own = [t.forms[-1][0] for t in context.tokens[clause.event.i : clause.event.j]]
    if own != ["turn", "off"] or not clause.drivers or isinstance(clause.event.object, Thing):
        return False
    ends = [p.target for p in clause.event.pps]
    return bool(clause.event.dirs) or any(isinstance(c, Place) and c.kind in _TURNED for c in ends)


def _into_a_turn(event: Event) -> bool:
    """``makes a left``, ``hangs a right``: turns; the side moves to the verb."""
    side = event.object
    if not isinstance(side, Place) or side.kind != "side" or side.owner is not None:
        return False
    ways = [m for m in side.mods if m.cat == "dir" and m.value in {"left", "right"}]
    if not ways or any(d in side.dirs for d in ("front", "rear", "opposite")):
        return False
    turned = [m for m in event.mods if m.value != "straight"]  # "hangs a right, straight across"
    event.mods, event.object = [*turned, *ways], None
    return True


def _into_a_lane(event: Event) -> bool:
    """``jumps into the ego's lane``: said of a vehicle, from the next lane."""
    lane = event.object if event.object is not None else into_lane(event)
    named = isinstance(lane, Place) and lane.kind == "lane" and "opposite" not in lane.dirs
    return named and isinstance(lane, Place) and (lane.owner is not None or bool(lane.dirs))


def _goes_round(clause: Clause, context: Context) -> bool:
    """``edges round the parked van``: what is passed becomes the object of the verb."""
    event = clause.event
    for prep in event.pps if event.object is None else []:
        passed = prep.target
        if context.tokens[prep.word.i].low not in _ROUND:
            continue
        if isinstance(passed, Event):
            continue
        thing = isinstance(passed, Thing) and passed.kind in {"object", "obstacle"}
        who = passed.entities if isinstance(passed, Mention) else []
        vehicles = [e for e in who if e.is_vehicle and e not in clause.actors]
        if thing or vehicles:
            event.object, clause.targets = passed, vehicles
            event.pps = [p for p in event.pps if p is not prep]
            return True
    return False


def _runs_it(clause: Clause, context: Context) -> bool:
    """``the light changed and he ran it``."""
    it, verb = clause.event.object, clause.event.lemma
    named = isinstance(it, Mention) and context.tokens[it.i].low == "it"
    return named and verb == "run" and context.junction.control is not None


def _ignores_it(clause: Clause, context: Context) -> bool:
    """``I'm at the stop sign, he sails through it``: the sign."""
    if context.junction.control in {None, Control.UNCONTROLLED, Control.PRIORITY_TO_RIGHT}:
        return False
    others = [e for e in context.draft.entities if not e.ego and e not in clause.actors]
    ways = {"through"} if others else {"through", "past"}
    named = [clause.event.object, *(p.target for p in clause.event.pps)]
    return any(
        isinstance(m, Mention)
        and context.tokens[m.i].low == "it"
        and context.tokens[m.i - 1].low in ways
        for m in named
    )


def _by_path(clause: Clause, context: Context, *, riding: bool) -> str:
    event = clause.event
    own = _own(clause, context)
    words = own | {context.tokens[p.word.i].low for p in event.pps}
    ahead = [p for p in event.pps if p.word.cat == "locus" and p.value == "ahead"]
    to_somebody = [*clause.targets, *(e for p in ahead for e in _who(p))]
    places = {p.kind for p in clause.places()}
    if "through" in words and places & {"signal", "stop_sign", "yield_sign", "right_of_way"}:
        return "breach"
    passed = clause.targets or any(_who(p) for p in event.pps if p not in ahead)
    if words & _PAST and passed and not isinstance(event.object, Place):
        return "overtake"
    if "lane" in places and words & (_ACROSS | {"into", "onto"}):
        return "lane_change"
    if words & {"out", "from"} and (places & _ASIDE or not places):
        return "cross" if riding else "pull_out"
    if words & _ACROSS and places & _ROADS:
        return "cross"
    if to_somebody:
        return "cross" if riding else "cut_in"
    beside = any(context.placed(e, Approach.ADJACENT) for e in clause.drivers)
    if beside and words & _ACROSS:
        return "lane_change"  # "the van next to me comes over"
    return "breach" if event.name == "breach" else "move"


def _who(prep: Prep) -> list[object]:
    return list(prep.target.entities) if isinstance(prep.target, Mention) else []


def _own(clause: Clause, context: Context) -> set[str]:
    return {t.low for t in context.tokens[clause.event.i : clause.event.j]}


def _around(clause: Clause, context: Context) -> bool:
    words = {context.tokens[p.word.i].low for p in clause.event.pps}
    return bool(words & {"around", "round"})


def _between_lanes(clause: Clause, context: Context) -> bool:
    """``a coach in the next lane pulls out in front of me``: out of its lane, not of a road."""
    event = clause.event
    leaves = any(
        p.value in {"in", "of", "from"} and isinstance(p.target, Place) and p.target.kind == "lane"
        for p in event.pps
    )
    if leaves and into_lane(event) is not None:
        return True  # "pulls out of the bus lane into the ego's lane"
    if leaves and any(context.placed(e, Approach.ADJACENT) for e in clause.drivers):
        return True  # "pulls out of the left lane ahead"
    ahead = any(
        _who(p) and (p.value == "ahead" or context.tokens[p.word.i].low == "on") for p in event.pps
    )
    aside = any(p.kind in _ASIDE for p in clause.places())
    beside = any(context.placed(e, Approach.ADJACENT) for e in clause.drivers)
    along = context.junction.highway and not context.junction.crossing
    return ahead and not aside and (beside or along)
