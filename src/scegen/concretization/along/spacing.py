"""How two stand to each other: who is ahead, and where one starts so that they are so far apart.

A measure has a value at a moment, or one just misses the other, with both boxes as they turn.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.story import Story
from scegen.concretization.answering import last_that
from scegen.concretization.boxes import apart, missing_m
from scegen.scenario.acts import ActKind
from scegen.scenario.in_line import words_between
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach

JUST_M = 0.5
"""The room that is left between two of whom one just misses the other."""
_LOOK_S = 0.05
_AROUND_S = 3.0


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
        return first.stands
    order = story.ranks()
    if order[who] != order[other]:
        return order[who] < order[other]
    if story.ego.id in {who, other}:
        return who != story.ego.id
    names = list(story.runners)
    return names.index(who) < names.index(other)


def comes_in(mover: Runner, stays: Runner) -> Move | None:
    """The move by which one comes into another's lane, or over it on its way to an exit."""
    others = (({m.lane, *range(mover.lane, m.lane)} - {mover.lane}, m) for m in mover.moves)
    return next((m for lanes, m in others if stays.lane in lanes), None)


def keep_apart(first: Runner, second: Runner, room_m: float, from_s: float, to_s: float) -> bool:
    """Whether two come no nearer than so much within a time, with their boxes as they turn."""
    times = np.arange(max(from_s, 0.0), to_s + _LOOK_S, _LOOK_S)
    return bool(np.all(apart(first.track(times)[0], second.track(times)[0], room_m) >= room_m))


def place_just_missed(
    who: Runner, front: Runner, back: Runner, move: Move, room_m: float = JUST_M
) -> None:
    """Place one of two so that the one behind, which moves aside, just misses the one ahead."""
    other = back if who is front else front
    until_s = move.ends_s + _AROUND_S

    def missed(gap: float) -> bool:
        place(GapAt(who, other, Measure.GAP_M, gap, move.begins_s, ahead=who is front))
        return keep_apart(front, back, room_m, move.begins_s, until_s)

    closing = max(back.speed_at_mps(move.begins_s) - front.speed_at_mps(move.begins_s), 1.0)
    missed(last_that(missed, closing * move.lasts_s, 0.0))


def just_missed_s(who: Runner, other: Runner, back: Move) -> float:
    """When one on its way back is level with another that comes towards it: it just misses it."""
    kept = who.at_m

    def missed(moment_s: float) -> bool:
        who.at_m = level(who, other, moment_s)
        around = _AROUND_S / 2
        return keep_apart(who, other, JUST_M, moment_s - around, moment_s + around)

    found = last_that(missed, back.ends_s + 1.0, back.begins_s)
    who.at_m = kept
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
    return sum(other.ends_m(time_s)) / 2 - sum(from_0.ends_m(time_s)) / 2
