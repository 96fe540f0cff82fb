"""When everything happens: every act gets its moment."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scegen.concretization.along.frame import ON_RAMP_S
from scegen.concretization.along.parked import door_before
from scegen.concretization.along.performing import perform
from scegen.concretization.along.story import FIRST_ACT_S, Story
from scegen.concretization.amounts import ASIDE, goes_on_when_free
from scegen.concretization.boxes import missing_m
from scegen.concretization.limits import HOLDS_S
from scegen.concretization.profile import NEVER_S
from scegen.scenario.acts import (
    SLOWING,
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    WhenMeasure,
)
from scegen.scenario.spacings import CONTACT, LENGTHWISE

_AT_ONCE_S = 0.3
"""Between two acts of one driver where the next follows at once: long enough to be two acts."""
_LATE_S, _LOOK_S = 60.0, 0.02
_SHIES_S = 0.3
"""Who swerves for a door that opens does so sooner than one brakes: a simple reaction."""


def perform_known(story: Story, acts: Sequence[Act], *, placed: bool) -> list[Act]:
    """Perform the acts whose moment is known, in their order; returns those that wait for more.

    Some wait for distances, which are told where everybody has a place (``placed``).
    """
    waiting: list[Act] = []
    for act in acts:
        moment_s = _moment_s(story, act, placed=placed)
        if moment_s < NEVER_S:
            perform(story, act, moment_s)
        else:
            waiting.append(act)
    return waiting


def is_timed_last(story: Story, act: Act) -> bool:
    """Whether an act follows upon overtaking, at once or by others: that follows from places."""
    name = act.when.act if isinstance(act.when, AfterAct) else None
    before = next((a for a in story.acts if a.id == name), None)
    if before is None:
        return False
    return story.goes_round(before) or story.comes_back(before) or is_timed_last(story, before)


def _is_placed_otherwise(story: Story, act: Act, when: WhenMeasure) -> bool:
    """Whether other statements fix how far apart the two of a trigger are, step by step."""
    pairs = [
        {s.participant, s.reference}
        for s in story.functional.spacings
        if s.measure in LENGTHWISE and s.at != CONTACT
    ]
    earlier = (a.when for a in story.acts[: story.acts.index(act)])
    pairs += [{w.participant, w.reference} for w in earlier if isinstance(w, WhenMeasure)]
    reached = {when.participant}
    for _ in pairs:
        reached |= {name for pair in pairs if pair & reached for name in pair}
    return when.reference in reached


def _moment_s(story: Story, act: Act, *, placed: bool) -> float:
    """When an act begins; ``placed``: everybody has a place, so that distances tell it, too."""
    when = act.when
    if isinstance(when, WhenMeasure) and (placed or _is_placed_otherwise(story, act, when)):
        return _when_measured_s(story, when) if placed else NEVER_S
    if isinstance(when, AfterStart):
        return when.delay_s.middle
    if isinstance(when, AfterDistance):
        runner = story.runners.get(when.participant or act.participant)
        if runner is None or not placed:
            return NEVER_S
        return runner.profile.time_s(when.distance_m.middle)
    if isinstance(when, AfterAct) and not story.is_loose(act.id):
        known = story.ends_s if when.since == "end" else story.begins_s
        if when.act not in known:
            return NEVER_S
        delay = 0.0 if goes_on_when_free(when) else when.later_s.middle
        alone = story.act(when.act).participant == act.participant
        rests = alone and story.runners[act.participant].speed_at_mps(known[when.act]) <= 0.0
        if rests and act.kind in SLOWING:
            return known[when.act]  # it stands already
        if alone and delay == 0.0 and when.since == "end":
            at_once = when.delay_s is not None and when.delay_s.high == 0.0
            delay = _AT_ONCE_S if at_once else HOLDS_S
        return known[when.act] + delay
    own = [story.ends_s[a.id] for a in story.acts if a.participant == act.participant
           and a.id in story.ends_s]  # fmt: skip
    if own:
        return max(own) + HOLDS_S
    door = door_before(story, act.participant)
    if act.kind is ActKind.SWERVE and door is not None:
        return door.appears_s + _SHIES_S
    by_ramp = story.merging - story.joined
    first_s = FIRST_ACT_S + (ON_RAMP_S if act.participant in by_ramp else 0.0)
    told = [a for a in story.acts[: story.acts.index(act)] if a.id in story.begins_s]
    # Who goes aside for one that comes into its lane does so when that one is there.
    gives_way = act.kind in ASIDE
    comes = [story.ends_s[a.id] for a in told if gives_way and a.into == act.participant]
    return max([first_s, *(story.begins_s[a.id] for a in told), *comes])


def _when_measured_s(story: Story, when: WhenMeasure) -> float:
    """The first moment at which the measure has come down to its value."""
    if not {when.participant, when.reference} <= story.runners.keys():
        return NEVER_S
    first, second = story.runners[when.participant], story.runners[when.reference]
    times = np.arange(0.0, _LATE_S, _LOOK_S)
    value = when.value.middle
    reached = missing_m(when.measure, value, second.track(times), first.track(times)) <= 0.0
    return float(times[np.argmax(reached)]) if reached.any() else NEVER_S
