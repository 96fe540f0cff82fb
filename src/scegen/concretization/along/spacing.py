"""How two stand to each other: who is ahead, and where one starts so that they are so far apart.

A measure has a value at a moment.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from scegen.claims.boxes import gap_m
from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.story import Story
from scegen.concretization.answering import last_that
from scegen.concretization.boxes import apart, missing_m
from scegen.motion.batch.arrays import Bools
from scegen.motion.model import Array
from scegen.scenario.acts import ActKind
from scegen.scenario.in_line import words_between
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach

JUST_M = 0.5
"""The room that is left between two of whom one just misses the other."""
_LOOK_S, _LONGEST_S = 0.05, 60.0
_TIMES_S = np.arange(0.0, 40.0, _LOOK_S)


def is_ahead(story: Story, who: str, other: str) -> bool:
    """Whether one is ahead of another as that one drives."""
    first, second = story.runners[who], story.runners[other]
    if first.forward != second.forward:
        return True
    if story.lets_by(who, other) or story.lets_by(other, who):
        return story.lets_by(other, who)
    for name, reference, sign in ((who, other, True), (other, who, False)):
        words = words_between(story.functional, name, reference)
        if (Approach.AHEAD in words) != (Approach.BEHIND in words):
            return (Approach.AHEAD in words) == sign
        into = any(
            act.participant == name and act.into == reference
            and act.kind is ActKind.CHANGE_LANE for act in story.acts
        )  # fmt: skip
        mover, stays = story.runners[name], story.runners[reference]
        over = comes_in(mover, stays) is not None
        if into or (over and not stays.moves):
            return sign
    if first.stands != second.stands:
        return first.stands != story.lies_behind(who if first.stands else other)
    names, order, ego = list(story.runners), story.ranks(), story.ego.id
    one, two = ((order[n], n == ego, names.index(n)) for n in (who, other))
    return one < two


def comes_in(mover: Runner, stays: Runner) -> Move | None:
    """The move by which one comes into another's lane, or over it on its way to an exit."""
    others = (({m.lane, *range(mover.lane, m.lane)} - {mover.lane}, m) for m in mover.moves)
    return next((m for lanes, m in others if stays.lane in lanes), None)


def keep_apart(first: Runner, second: Runner, room_m: float) -> bool:
    """Whether two never come nearer than so much, with their boxes as they turn."""
    one, other = (runner.track(_TIMES_S)[0] for runner in (first, second))
    return bool(np.all(apart(one, other, room_m) >= room_m))


def just_misses(
    pair: tuple[Runner, Runner], put: Callable[[float], None], good: float, bad: float,
    room_m: float = JUST_M,
) -> float:  # fmt: skip
    """The last value from a good one on with which, once ``put``, two still miss each other."""

    def missed(value: float) -> bool:
        put(value)
        return keep_apart(*pair, room_m)

    found = last_that(missed, good, bad)
    put(found)
    return found


_FAR_M = 1e4
"""Farther than anybody drives."""


@dataclass(frozen=True, slots=True)
class GapAt:
    """The ``measure`` of two is ``value`` at ``time_s``; ``ahead``: ``who`` is ahead of ``other``.

    That is as ``other`` drives: in its direction.
    """

    who: Runner
    other: Runner
    measure: Measure
    value: float
    time_s: float
    ahead: bool

    def turned(self) -> GapAt:
        """The same, told of the other."""
        ahead = self.ahead != (self.who.forward == self.other.forward)
        return replace(self, who=self.other, other=self.who, ahead=ahead)


def place(tie: GapAt) -> None:
    """Let ``who`` start so that the tie holds; ``other`` has its place."""
    who, other = tie.who, tie.other
    away = _FAR_M if tie.ahead == other.forward else -_FAR_M
    at = np.array([tie.time_s])
    who.at_m = away
    missing = missing_m(tie.measure, tie.value, other.track(at), who.track(at))
    who.at_m = away - float(missing[0]) * (1 if away > 0 else -1)


def level(who: Runner, other: Runner, time_s: float) -> float:
    """Where ``who`` starts so that the middles of both are level at a moment."""
    from_0 = replace(who, at_m=0.0)
    return other.middle_m(time_s) - from_0.middle_m(time_s)


def first_s(true: Callable[[Array], Bools], from_s: float) -> float:
    """The first moment at which something holds, from another one on; that one if never."""
    times = from_s + np.arange(0.0, _LONGEST_S, _LOOK_S)
    return float(times[np.argmax(true(times))])


def is_level(first: Runner, second: Runner, within_m: float, times_s: Array) -> Bools:
    """When two are level along the road, or have no more than so much between them."""
    return gap_m(first.track(times_s)[0], second.track(times_s)[0]) <= within_m
