"""What numbers say of acts and of spacings as clauses, for the rows that ask what it means."""

from __future__ import annotations

from collections.abc import Iterator

from scegen.scenario.model import Interval
from scegen.understanding.chunks import Event
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.happenings import Apart, Doing, Happenings
from scegen.understanding.semantics.context import Clause


def clauses_of(found: Happenings) -> Iterator[Clause]:
    """Acts, what some do, however often, as one; then spacings, named after what is done then.

    Args:
        found: acts and spacings of a text, with their numbers.
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
    return Clause(_event(acts[0].kind.value, first), whose, [], amounts)


def _clause_of_spacing(apart: Apart) -> Clause:
    at = apart.at.kind.value if isinstance(apart.at, Doing) else "follow"
    pair = [[e] if isinstance(e, Entity) else [] for e in (apart.entity, apart.reference)]
    amounts: dict[str, list[Interval | None]] = {apart.measure.value: [apart.amount.value]}
    return Clause(_event(at, apart.amount.basis), pair[0], pair[1], amounts)


def _event(name: str, basis: Basis) -> Event:
    return Event(name, basis.i or 0, basis.j or 0, "")
