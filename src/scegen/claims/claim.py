"""A claim: one statement of a description as a predicate on what moves."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

import numpy as np

from scegen.claims.series import chosen
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats
from scegen.scenario.model import Interval

NEVER = 1e3
"""The margin, below 0, of what does not happen at all; any unit."""


class ClaimKind(StrEnum):
    """What a statement is about."""

    ROAD = "road"
    APPROACH = "approach"
    LANE = "lane"
    ENTRY = "entry"
    EXIT = "exit"
    CONFLICT = "conflict"
    ORDER = "order"
    BESIDE = "beside"
    MANEUVER = "maneuver"
    STANDS = "stands"
    SPEED = "speed"
    SPACING = "spacing"
    ACT = "act"
    RULE = "rule"
    HAZARD = "hazard"
    OBJECT = "object"
    OUTCOME = "outcome"
    CONTACT = "contact"
    OPENING = "opening"
    ENDING = "ending"
    BODY = "body"


class Judged(NamedTuple):
    """What was found in each candidate (c,): at least 0 where it holds, the value, when."""

    margin: Floats
    measured: Floats
    time_s: Floats


Test = Callable[[View], Judged]


@dataclass(frozen=True, slots=True)
class Claim:
    """One statement.

    ``id`` is the same for the same scenario; ``field`` is the path of the functional field that
    it rests on, ``words`` are the words behind that field, if any. Margins, measured values and
    ``tolerance`` are in ``unit``; ``scale`` is a margin that is worth as much as another claim's.
    ``fixed``: it lies in roads, ways, lanes and bodies, and not in when or how fast somebody moves.
    """

    id: str
    kind: ClaimKind
    statement: str
    field: str
    unit: str
    test: Test
    tolerance: float = 0.0
    scale: float = 1.0
    fixed: bool = False
    words: str | None = None

    def judge(self, view: View) -> Judged:
        """Whether it holds in every candidate."""
        return view.once(self.test, lambda: self._judged(view))

    def _judged(self, view: View) -> Judged:
        found = self.test(view)
        return Judged(np.where(found.margin > -np.inf, found.margin, -NEVER), *found[1:])


def rule_claim(
    name: str, statement: str, test: Test, *, unit: str = "s", tolerance: float = 0.0,
    scale: float = 1.0, field: str = "junction.control",
) -> Claim:  # fmt: skip
    """A statement that a rule of the road is kept, or broken by who is said to break it."""
    return Claim(f"rule.{name}", ClaimKind.RULE, statement, field, unit, test, tolerance, scale)


def way_claim(
    name: str, statement: str, field: str, test: Test, *, unit: str = "m", fixed: bool = True
) -> Claim:
    """A statement of what somebody does on its way; see Claim."""
    kind, scale = ClaimKind.MANEUVER, 2.0
    return Claim(f"maneuver.{name}", kind, statement, field, unit, test, scale=scale, fixed=fixed)


def within(value: Floats, wanted: Interval, tolerance: float) -> Floats:
    """How far a value lies inside a range with its tolerance; below 0 outside (c,)."""
    return np.minimum(value - (wanted.low - tolerance), wanted.high + tolerance - value)


def as_wanted(
    value: Floats, wanted: Interval, tolerance: float, time_s: Floats, *, there: Bools | None = None
) -> Judged:
    """A value that is to lie in a range; undefined where it is not ``there`` to be measured."""
    margin = within(value, wanted, tolerance)
    return Judged(margin if there is None else np.where(there, margin, np.nan), value, time_s)


def best_of(view: View, found: Sequence[Judged]) -> Judged:
    """Of several, the one with the greatest margin in each candidate; of none, that it never is."""
    never = np.full(view.count, -NEVER)
    return Judged(*chosen(found or [(never, never, np.zeros(view.count))], np.argmax))


def always(view: View, *, holds: bool, measured: float = np.nan) -> Judged:
    """The same for all candidates: what movements cannot change."""
    margin = np.full(view.count, 0.0 if holds else -1.0)
    return Judged(margin, np.full(view.count, measured), np.zeros(view.count))
