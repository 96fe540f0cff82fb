"""Who has to wait, brake or look out where a clause says that somebody does not."""

from __future__ import annotations

from collections.abc import Callable

from scegen.scenario.vocabulary import Approach, Control, HazardKind, JunctionKind, Maneuver
from scegen.understanding.chunks import Mention, Place, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_SIGNS = frozenset({"stop_sign", "stop_line", "yield_sign"})
_CROSSING = frozenset({HazardKind.CROSSING_PEDESTRIAN, HazardKind.CROSSING_CYCLIST})
"""What concerns those who come from the front, too."""
_TO_BRAKE_FOR = _CROSSING | {HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.OBSTACLE,
                             HazardKind.SLOW_DRIVING, HazardKind.CUT_IN}  # fmt: skip
_SIGNED = frozenset({Control.STOP, Control.ALL_WAY_STOP})
_FREE = frozenset({None, Control.UNCONTROLLED, Control.PRIORITY_TO_RIGHT,
                   Control.SIGNALS_OFF})  # fmt: skip
_TURNS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN})
_NEAR = 12
_PHRASE = 5


def _all_behind(clause: Clause, context: Context) -> bool:
    return all(context.placed(e, Approach.BEHIND) for e in clause.drivers)


def _signed(clause: Clause, *kinds: str) -> bool:
    return any(p.kind in (kinds or _SIGNS) for p in clause.places())


def _at_signals(clause: Clause, context: Context) -> bool:
    regulated = clause.event.name == "stop" and context.junction.control is Control.SIGNALS
    follows = bool(clause.drivers) and _all_behind(clause, context)
    return _signed(clause, "signal") or (regulated and not follows)


def _for_the_one_ahead(clause: Clause, context: Context) -> bool:
    """``the car behind it did not stop in time``: not for the light."""
    behind = bool(clause.drivers) and _all_behind(clause, context)
    return (behind or not _signed(clause, "signal")) and _behind_or_late(clause, context)


def _behind_or_late(clause: Clause, context: Context) -> bool:
    """``does not brake in time``: for whoever is in front, not for a sign."""
    if _signed(clause):
        return False
    late = any(context.tokens[m.j - 1].low == "time" for m in clause.event.mods)
    crosses = any(Maneuver.CROSS in e.maneuvers for e in clause.drivers)
    return late or clause.event.late or (_all_behind(clause, context) and not crosses)


def _has_to_wait(clause: Clause, context: Context) -> bool:
    """A sign, another road, or a crossing that is driven over "without stopping"."""
    event, junction = clause.event, context.junction
    if _signed(clause):
        return True
    if junction.control in _SIGNED or any(context.comes_across(e) for e in clause.drivers):
        return True
    awaited = any(p.value == "for" and isinstance(p.target, Mention) for p in event.pps)
    joins = junction.crossing or context.draft.access is not None or junction.control is not None
    return (event.link == "ing" or (awaited and event.name == "wait")) and joins


def _answer_due(clause: Clause, context: Context) -> bool:
    """``does not slow down``: whether there is something to slow down for."""
    drivers = clause.drivers
    oncoming = bool(drivers) and all(context.oncoming(e) for e in drivers)
    owed = _CROSSING if oncoming else _TO_BRAKE_FOR
    met = any(d.kind in owed and not any(e in drivers for e in d.by) for d in context.draft.dangers)
    ahead = any(context.placed(e, Approach.AHEAD) for e in overlooked(clause, context))
    return met or (not oncoming and ahead)


def overlooked(clause: Clause, context: Context) -> list[Entity]:
    """Who may be overlooked: on whom it is done, else anybody else."""
    return clause.targets or [e for e in context.draft.entities if e not in clause.actors]


def in_the_way(clause: Clause, context: Context) -> list[Entity]:
    """Who is said to keep somebody from seeing; else the one that is parked there."""
    named = clause.event.whom("due", "with", "for", "by")
    named = [e for e in named if e.is_vehicle and not e.ego]
    parked = [e for e in context.draft.entities if e.parked and e not in clause.targets]
    return named or (parked if len(parked) == 1 else [])


def _no_leeway(clause: Clause, context: Context) -> bool:
    """``has no chance to stop``, ``with no time left to brake``: the other's fault."""
    before = {*context.lows(clause.event.i - _PHRASE, clause.event.i)}
    return bool(before & word_list("leeway")) and bool(before & word_list("none_of"))


def _it(mention: object, context: Context) -> bool:
    return isinstance(mention, Mention) and context.tokens[mention.i].low == "it"


def _ignores_it(clause: Clause, context: Context) -> bool:
    """``I'm at the stop sign, he sails through it``: the sign."""
    if context.junction.control in _FREE:
        return False
    others = [e for e in context.draft.entities if not e.ego and e not in clause.actors]
    ways = {"through"} if others else {"through", "past"}
    named = [m for m in clause.event.nouns() if _it(m, context)]
    return any(context.tokens[m.i - 1].low in ways for m in named)


def _turns_on_red(clause: Clause, context: Context) -> bool:
    """A turn across the oncoming lane, which a red light forbids everywhere."""
    event = clause.event
    side = event.object.dirs if isinstance(event.object, Place) else []
    named = {*side, *(t.value for t in event.dirs)}
    return event.name in {"turn", "light"} and context.across in named


def _object_sign(clause: Clause, context: Context) -> bool:
    """``ignores its sign``: one that says who waits."""
    noun = clause.event.object
    return isinstance(noun, Thing) and context.tokens[noun.j - 1].forms[-1][0] == "sign"


def _out_of_the_stem(clause: Clause, context: Context) -> bool:
    """Who crosses on red, or leaves the side road of a T, comes across the way of the ego."""
    event, junction = clause.event, context.junction
    ego = context.draft.ego
    implied = context.draft.access is not None and junction.straight is None
    if ego is None or ego in clause.actors or not (junction.crossing or implied):
        return False
    red = [d.by for d in context.draft.dangers if d.kind is HazardKind.RED_LIGHT_RUNNING]
    if event.name == "cross" and clause.drivers in red:
        return True
    sources = [*event.pps, *(p for m in event.subject for p in m.pps)]
    out = event.name in {"pull_out", "reverse", "leave", "appear"}
    words = {"from", "in", "of"} if out or event.name == "wait" else {"from", "in"}
    stem = [p.target for p in sources if p.value in words] + ([event.object] if out else [])
    along = junction.kind is JunctionKind.T and ego.maneuvers == {Maneuver.STRAIGHT}
    along = along or (not junction.crossing and not ego.maneuvers & _TURNS)
    return along and any(isinstance(p, Place) and p.kind == "access" for p in stem)


FACTS: dict[str, Callable[[Clause, Context], bool]] = {
    "at_signals": _at_signals,
    "for_the_one_ahead": _for_the_one_ahead,
    "behind_or_late": _behind_or_late,
    "has_to_wait": _has_to_wait,
    "answer_due": _answer_due,
    "no_leeway": _no_leeway,
    "ignores_it": _ignores_it,
    "turns_on_red": _turns_on_red,
    "object_sign": _object_sign,
    "object_it": lambda clause, c: _it(clause.event.object, c),
    "out_of_the_stem": _out_of_the_stem,
    "noted": lambda clause, _: any(m.cat == "noted" for m in clause.event.mods),
    "screen_before": lambda clause, c: any(0 < clause.event.i - i < _NEAR for i in c.screens),
    "nobody_acts": lambda clause, _: any(
        m.pronoun in {"everybody", "neither", "nobody"} for m in clause.event.subject
    ),
}
"""Words of conditions that ask for a duty."""
