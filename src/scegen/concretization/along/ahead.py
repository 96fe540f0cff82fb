"""Which of two along the road is ahead, by words, by what they do, or as usual."""

from __future__ import annotations

from scegen.concretization.along.runner import Move, Runner
from scegen.concretization.along.story import Story
from scegen.scenario.acts import ActKind
from scegen.scenario.in_line import words_between
from scegen.scenario.vocabulary import Approach


def is_ahead(story: Story, who: str, other: str) -> bool:
    """Whether one is ahead of another as that one drives."""
    first, second = story.runners[who], story.runners[other]
    if first.forward != second.forward:
        return True
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
            return sign != story.lets_by(name, reference)
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
    """The move by which one comes into another's lane."""
    return next((m for m in mover.moves if m.lane == stays.lane != mover.lane), None)
