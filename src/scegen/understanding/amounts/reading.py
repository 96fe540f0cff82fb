"""Reads all numbers of a text, by rows, what is done, and how it ends; then what that means."""

from collections.abc import Callable, Iterable, Iterator
from functools import cache, lru_cache
from typing import Any

from scegen.scenario.acts import FAR, LASTING, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.understanding.amounts import in_its_lane, struck
from scegen.understanding.amounts.acting import read_acts
from scegen.understanding.amounts.as_fast import as_fast, kept_apart, relative
from scegen.understanding.amounts.aside import off_its_lane
from scegen.understanding.amounts.doings import comes_to, fill, made, rests, until_the_next
from scegen.understanding.amounts.elsewhere import INSTEAD, of_something_else
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.items import read_items, sized
from scegen.understanding.amounts.letting_by import go_on
from scegen.understanding.amounts.outcomes import impact, read_outcome
from scegen.understanding.amounts.placed import apart, at_rest, to_a_thing
from scegen.understanding.amounts.releasing import driven, order, sets_off
from scegen.understanding.amounts.speeds import held
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.amounts.timing import at_green, delayed, earlier
from scegen.understanding.chunks import Chunk, Event
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.frames import Numbers
from scegen.understanding.frames.loader import read
from scegen.understanding.happenings import Apart, Doing, Happenings, name_them
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rows import Families, read_rows, say


def read_amounts(
    numbers: Numbers, chunks: list[Chunk], scenes: list[Clause], context: Context, ego: Entity
) -> Happenings:
    """Acts, spacings and the outcome; every number in its field or reported.

    Speeds are filled in, notes are added.
    """
    text = Telling(chunks, scenes, context, ego)
    read_acts(text)
    read_outcome(text)
    figures = [Figure(q, numbers, text) for q in numbers.quantities]
    _place([f for f in figures if f.role == "speed"])
    _place([f for f in figures if f.role == "relative_speed"])
    as_fast(text)
    read_items(text)
    figures.sort(key=lambda figure: not says_how(figure.role))
    _place([f for f in figures if f.role not in {"speed", "relative_speed"}])
    in_its_lane.within(text)
    in_its_lane.reaching_in(text)
    in_its_lane.on_the_line(text)
    struck.settle(text)
    order(text)
    go_on(text)
    kept_apart(text)
    text.found.acts = _kept(text.found)
    for clause in clauses_of(text.found):
        say("dangers.told", clause, context)
    return text.found


def _place(figures: list[Figure]) -> None:
    for figure in figures:
        if of_something_else(figure):
            figure.note(INSTEAD)
        elif not place(figure):
            figure.note()


def _kept(found: Happenings) -> list[Doing]:
    """Acts that are ones by themselves, or that a number or another act makes ones."""
    named = [d.when.act for d in found.acts if d.when is not None and d.when.act is not None]
    named += [s.at for s in found.spacings if isinstance(s.at, Doing)]
    home = [(d.entity, d.i) for d in found.acts if d.kind is ActKind.CHANGE_LANE]
    kept = [
        d
        for d in found.acts
        if d.always or d.amounts or d.when is not None or d in named
        or (d.kind is ActKind.OVERTAKE  # "overtakes it on the right", "overtakes it and cuts in"
            and (d.side is not None or any(e is d.entity and i > d.i for e, i in home)))
    ]  # fmt: skip
    name_them(kept)
    return kept


_VERBS = {ActKind.CHANGE_LANE: "lane_change", ActKind.SET_OFF: "leave"}
"""What rows call an act, where that is not its own name."""


def clauses_of(found: Happenings) -> Iterator[Clause]:
    """Acts, what some do, however often, as one; then spacings, named after what is done then.

    A gap at a lane change is a headway as well, by the speed of the one who keeps its lane.
    """
    own: dict[tuple[str, int], list[Doing]] = {}
    for doing in found.acts:
        own.setdefault((doing.kind.value, doing.entity.index), []).append(doing)
    alike: dict[tuple[str, ...], list[Doing]] = {}
    for (kind, _), acts in own.items():
        alike.setdefault((kind, *(str(act.i) for act in acts)), []).extend(acts)
    yield from map(_clause_of_acts, alike.values())
    yield from map(_clause_of_spacing, found.spacings)


def _clause_of_acts(acts: list[Doing]) -> Clause:
    fields = dict.fromkeys(name for act in acts for name in act.amounts)
    told = {name: [act.amounts.get(name) for act in acts] for name in fields}
    first = next((a.basis for found in told.values() for a in found if a), acts[0].basis)
    amounts = {n: [a.value if a else None for a in found] for n, found in told.items()}
    whose = list(dict.fromkeys(act.entity for act in acts))
    amounts.setdefault("rate_mps2", [_rate(act) for act in acts])
    befores = [a.when.act for a in acts if a.when is not None and a.when.since == "end"]
    kind = acts[0].kind
    passed_by = [o.entity for o in befores if o is not None and o.kind is ActKind.OVERTAKE]
    if kind is ActKind.GIVE_WAY:
        passed_by = [act.into for act in acts if act.into is not None]
    return Clause(_event(_VERBS.get(kind, kind.value), first), whose, passed_by, amounts)


def _rate(act: Doing) -> Interval | None:
    """``from 70 mph to a stop within 5 s``: what the speeds and the time amount to."""
    to, within = (act.amounts.get(name) for name in ("target_speed_mps", "duration_s"))
    if act.entity.speed is None or to is None or within is None:
        return None
    gained = to.value.low - act.entity.speed.high, to.value.high - act.entity.speed.low
    return _divided(Interval(low=min(map(abs, gained)), high=max(map(abs, gained))), within.value)


def _clause_of_spacing(apart: Apart) -> Clause:
    doing = apart.at if isinstance(apart.at, Doing) else None
    pair = [[e] if isinstance(e, Entity) else [] for e in (apart.entity, apart.reference)]
    amounts: dict[str, list[Interval | None]] = {apart.measure.value: [apart.amount.value]}
    mover = doing.entity if doing is not None and doing.kind is ActKind.CHANGE_LANE else None
    others = [e.speed for e in (*pair[0], *pair[1]) if mover is not None and e is not mover]
    if apart.measure is Measure.GAP_M and others and others[0] is not None:
        amounts["headway_s"] = [_divided(apart.amount.value, others[0])]
    name = "follow" if doing is None else _VERBS.get(doing.kind, doing.kind.value)
    return Clause(_event(name, apart.amount.basis), pair[0], pair[1], amounts)


def _divided(whole: Interval, by: Interval) -> Interval | None:
    return Interval(low=whole.low / by.high, high=whole.high / by.low) if by.low > 0 else None


def _event(name: str, basis: Basis) -> Event:
    return Event(name, basis.i or 0, basis.j or 0, "")


_KEYS = frozenset({"if", "also", "take", "fills", "of", "makes"})
TAKES: dict[str, Callable[[Figure], bool]] = {
    "held": held,
    "comes_to": comes_to,
    "relative": relative,
    "rests": rests,
    "until_the_next": until_the_next,
    "driven": driven,
    "earlier": earlier,
    "at_green": at_green,
    "delayed": delayed,
    "impact": impact,
    "length": lambda figure: sized(figure, "length_m"),
    "width": lambda figure: sized(figure, "width_m"),
    "sets_off": sets_off,
    "at_rest": at_rest,
    "to_a_thing": to_a_thing,
    "off_its_lane": off_its_lane,
    "apart": apart,
}
"""What gives a number its place, if there is one."""
_ACTS = {
    "along": frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.STOP, ActKind.SET_OFF}),
    "aside": frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE}),
    "lasting": LASTING,
    "far": FAR,
}


def _effects(row: dict[str, Any]) -> Iterable[Any]:
    if "take" in row:
        take = TAKES[row["take"]]
        yield lambda figure, _: take(figure)
    if "makes" in row:
        makes = ActKind(row["makes"])
        yield lambda figure, _: made(figure, makes, row["fills"])
    elif "fills" in row:
        kinds = _ACTS[row.get("of", "along")]
        yield lambda figure, _: fill(figure, row["fills"], kinds)


@lru_cache(maxsize=1)
def rows() -> Families:
    """All rows by what is measured, read once.

    Raises:
        KeyError: names the family, and what in it means nothing.
    """
    return read_rows("figures", effects=_effects, keys=_KEYS)


@cache
def says_how(role: str) -> bool:
    """Whether numbers that measure this say how something is done."""
    told = (rows for roles, rows in read("figures").items() if role in roles.split(", "))
    return any("fills" in row for rows in told for row in rows)


def place(figure: Figure) -> bool:
    """Gives a number its place; whether it has one."""
    context = figure.text.context
    for row in rows().asked(f"figures.{figure.role}", figure, context):
        if all(test(figure, context) for test in row.tests):
            taken = [effect(figure, context) for effect in row.effects]
            if any(taken) or not row.also:
                return any(taken)
    return False
