"""Whether the dangers asked for happen: predicates applied to who causes and who suffers.

A danger happens if everybody who is said to cause it does, to at least one of its sufferers.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite

import numpy as np

from scegen.claims.hazards.predicate import NEVER, Part
from scegen.claims.hazards.table import PREDICATES
from scegen.claims.series import chosen
from scegen.claims.view import View
from scegen.motion.batch.arrays import Floats
from scegen.scenario.control import STOPS
from scegen.scenario.functional import Hazard
from scegen.scenario.proof import HazardProof, PartProof
from scegen.scenario.vocabulary import Control, HazardKind

_ANY_CULPRIT = frozenset({HazardKind.OCCLUSION})
"""One of several parked cars that hides the other is enough."""


@dataclass(frozen=True)
class Couple:
    """The conditions between one cause and one sufferer; margin and time of the weakest (c,)."""

    by: str
    to: str
    parts: list[Part]
    relative: Floats
    time_s: Floats


def hazard_pairs(hazard: Hazard) -> list[tuple[str, str]]:
    """(cause, sufferer) whom a predicate looks at; alone, both are the same."""
    predicate = PREDICATES[hazard.kind]
    if predicate.pairwise:
        return both_sides(hazard)
    others = hazard.to if predicate.order else ()
    pairs = ([(by, to) for to in others if to != by] or [(by, by)] for by in hazard.by)
    return [pair for those in pairs for pair in those]


def both_sides(hazard: Hazard) -> list[tuple[str, str]]:
    """Everybody who causes it with everybody else who suffers it; several alone, one another."""
    return [(by, to) for by in hazard.by for to in hazard.to or hazard.by if by != to]


def decisive(view: View, hazard: Hazard) -> tuple[Floats, Floats]:
    """Relative margin of a danger in each candidate, and when its weakest condition holds (c,)."""
    best = [
        chosen([(c.relative, c.time_s) for c in couples], np.argmax)
        for couples in _couples(view, hazard)
    ]
    never = np.full(view.count, NEVER), np.full(view.count, np.nan)
    any_one = hazard.kind in _ANY_CULPRIT
    margin, time_s = chosen(best or [never], np.argmax if any_one else np.argmin)
    return margin, time_s


def in_order(view: View, hazard: Hazard, time_s: Floats) -> Floats:
    """Relative margin by which its causes are where they belong to endanger somebody (c,)."""
    order = PREDICATES[hazard.kind].order
    rows: dict[str, list[Floats]] = {}
    for by, to in hazard_pairs(hazard):
        if order is not None and by != to:
            rows.setdefault(by, []).append(order(view, by, to, time_s).relative)
    best = [np.max(margins, axis=0) for margins in rows.values()]
    return np.asarray(np.min([*best, np.full(view.count, -NEVER)], axis=0))


def judge(view: View, hazard: Hazard, candidate: int = 0) -> HazardProof:
    """The danger in one candidate, with who, whom, when and by which margin."""
    worst = [
        max(couples, key=lambda couple: float(couple.relative[candidate]))
        for couples in _couples(view, hazard)
    ]
    if not worst:
        return HazardProof(
            kind=hazard.kind,
            by=hazard.by,
            to=hazard.to,
            happened=False,
            note="nobody is there to cause or to suffer it",
        )
    pick = max if hazard.kind in _ANY_CULPRIT else min
    decisive = pick(worst, key=lambda couple: float(couple.relative[candidate]))
    weakest = min(decisive.parts, key=lambda part: float(part.relative[candidate]))
    return HazardProof(
        kind=hazard.kind,
        by=tuple(dict.fromkeys(couple.by for couple in worst)),
        to=tuple(dict.fromkeys(couple.to for couple in worst if couple.to != couple.by)),
        happened=bool(decisive.relative[candidate] >= 0.0),
        margin=number(weakest.margin[candidate]),
        unit=weakest.unit,
        threshold=number(weakest.threshold),
        time_s=number(weakest.time_s[candidate]),
        parts=tuple(
            PartProof(
                name=part.name,
                value=number(part.value[candidate]),
                threshold=round(part.threshold, 4),
                unit=part.unit,
                happened=bool(part.relative[candidate] >= 0.0),
            )
            for part in decisive.parts
        ),
    )


def _stopped(view: View) -> bool:
    """Whether there is but one on the road, and a sign or light that says stop."""
    return len(view.index) == 1 and view.concrete.road.control in {*STOPS, Control.SIGNALS}


def number(value: float) -> float | None:
    """A value as written to files; None where it is undefined or infinite."""
    return round(float(value), 4) if isfinite(value) else None


def _couples(view: View, hazard: Hazard) -> Iterator[list[Couple]]:
    """By cause, the couples with every sufferer."""
    groups: dict[str, list[Couple]] = {}
    predicate = PREDICATES[hazard.kind]
    alone = [(by, by) for by in hazard.by if predicate.before_nobody and _stopped(view)]
    for by, to in hazard_pairs(hazard) or alone:
        parts = predicate.test(view, by, to)
        if predicate.order is not None and by != to:
            parts = [*parts, predicate.order(view, by, to, parts[0].time_s)]
        weakest = chosen([(part.relative, part.time_s) for part in parts], np.argmin)
        groups.setdefault(by, []).append(Couple(by, to, parts, *weakest))
    yield from groups.values()
