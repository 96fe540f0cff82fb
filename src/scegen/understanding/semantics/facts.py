"""Facts: words of conditions that hold of a clause, or of the scenario in the making."""

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.entity import Entity
from scegen.understanding.semantics import lanes, met, seen, ways
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.marks import rounded
from scegen.understanding.semantics.met import goal_of_contact

Test: TypeAlias = Callable[[Clause, Context], bool]
_PASSING = frozenset({"overtake", "bypass", "pass", "undertake"})
_OF_THE_EVENT = ("modal", "nominal", "passive", "perfect", "negated", "late", "unable", "reduced",
                 "finite")  # fmt: skip


def _is(name: str) -> Test:
    return lambda clause, _: bool(getattr(clause.event, name))


def _implied(name: str) -> Test:
    return lambda _, context: name in context.draft.implied


def _rests(entity: Entity, i: int) -> bool:
    """``has stopped in the lane``: where somebody is, nothing that one does."""
    said = [b for b in (entity.stands, entity.told.get("held"), *entity.rests) if b is not None]
    stays = entity.parked or (entity.stands is not None and entity.sets_off < 0)
    return stays or any(b.i == i for b in said)


def _moves_over(clause: Clause, _: Context) -> bool:
    """Whether it is this verb that says that somebody changes lanes."""
    event = clause.event
    moved = [e for e in clause.actors if Maneuver.LANE_CHANGE in e.maneuvers]
    told = [e.maneuver_basis for e in moved if e.maneuver_basis is not None]
    return event.name not in _PASSING and any(b.i == event.i or b.j == event.j for b in told)


FACTS: dict[str, Test] = {
    **{name: _is(name) for name in _OF_THE_EVENT},
    "supposed": lambda clause, c: any(c.lows(m.i - 1, m.i) == ["if"] for m in clause.event.subject),
    "premodifier": lambda clause, _: clause.event.premod_of is not None,
    "subject": lambda clause, _: bool(clause.event.subject),
    "sided": lambda clause, _: any(t.value in {"left", "right"} for t in clause.event.dirs),
    "directed": lambda clause, _: bool(clause.event.dirs),
    "told_of_now": lambda clause, c: (
        not c.told_in_the_past and all(m.cat == "quantity" for m in clause.event.mods)
    ),
    "verbless": lambda clause, _: not clause.event.name,
    "crossing": lambda _, context: context.junction.crossing,
    "on_a_road": lambda _, context: context.junction.road is not None,
    "highway": lambda _, context: context.junction.highway,
    "meeting": lambda _, context: context.meeting,
    "kerbwards": lambda clause, c: any(
        [
            c.draft.kerb in [d for place in clause.places() for d in place.dirs],
            c.draft.kerb in [term.value for term in clause.event.dirs],
        ]
    ),
    "ramp": lambda _, context: context.draft.ramp is not None,
    **{name: _implied(name) for name in ("access", "from_kerb", "lanes")},
    "controlled": lambda _, context: context.junction.control is not None,
    "dangerous": lambda _, context: bool(context.draft.dangers),
    "endangered": lambda _, c: any(d.by and not any(e.ego for e in d.by) for d in c.draft.dangers),
    "prevents": lambda clause, _: any(c.link == "ing" or c.nominal for c in clause.event.children),
    "barred": lambda _, context: context.barred,
    "above_denied": lambda clause, _: (
        clause.event.parent is not None and clause.event.parent.negated
    ),
    "noted": lambda clause, _: any(m.cat == "noted" for m in clause.event.mods),
    "screen_before": lambda clause, c: any(i < clause.event.i for i in c.screens),
    "people_act": lambda clause, _: any(
        h.value == "pedestrian" for m in clause.event.subject for h in m.heads
    ),
    "rests_there": lambda clause, _: (
        bool(clause.actors) and all(_rests(e, clause.event.i) for e in clause.actors)
    ),
    "braked_before": lambda clause, _: any(
        e.brakes_from is not None and e.brakes_from < clause.event.i for e in clause.actors
    ),
    "from_rest": lambda clause, _: any(  # "accelerates from standstill"
        e.stands is not None and e.sets_off >= clause.event.i for e in clause.actors
    ),
    "gone_at_green": lambda clause, _: any(  # "sets off at green and stops again"
        e.light is not None and "held" not in e.told and (e.light[1].i or 0) < clause.event.i
        for e in clause.actors
    ),
    "moves_over": _moves_over,
    **lanes.FACTS,
    **ways.FACTS,
    **met.FACTS,
    **seen.FACTS,
    "passes_round": lambda clause, c: rounded(clause, c) is not None,  # "edges round the van"
    "into_somebody": lambda clause, c: goal_of_contact(clause, c) is not None,
}
