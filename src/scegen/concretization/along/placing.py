"""How those along the road stand to each other: what is said, and what is usual where it is not."""

from collections.abc import Collection, Iterator
from dataclasses import replace
from math import inf
from typing import Literal

from scegen.concretization.along.runner import FORTH_M, Move, Runner
from scegen.concretization.along.spacing import (
    JUST_M,
    GapAt,
    comes_in,
    is_ahead,
    just_misses,
    level,
    place,
)
from scegen.concretization.along.story import Story
from scegen.concretization.limits import HOLDS_S, LANE_CHANGE_S, TAILGATING_HEADWAY_S
from scegen.concretization.profile import NEVER_S
from scegen.concretization.tale import at_odds
from scegen.concretization.things import THINGS_APART_M
from scegen.scenario.acts import SLOWING, Act, ActKind, WhenMeasure
from scegen.scenario.in_line import is_said_ahead, words_between
from scegen.scenario.outcome import BodySide
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START, Measure, Spacing
from scegen.scenario.vocabulary import Approach, HazardKind

_FOLLOWING_S = 1.8
"""The time gap of ordinary following: a little below the two seconds of driving schools."""
_BRAKES_AT_S = 1.1
_CLOSES_IN_S = 7.0
_LEAST_FREE_M = 20.0
_CUTS_IN_S = 0.6
_CLOSING_CUT_S = 2.2
_REVEALED_S = 2.5
_MEETS_S = 6.5
_SLOWER_MPS = 0.5
_STOPS_BEFORE_M = 1.0
_AT_REST_S = 60.0
_PASSED_M = 2.0


def place_all(story: Story, *, wider: float = 1.0) -> None:
    """Give everybody a place at the start: by what is said first, by what is usual else.

    ``wider`` stretches what is usual, where it turns out too close.
    """
    for runner in story.runners.values():
        runner.at_m = None
    story.ego.at_m = 0.0
    said, order = list(_said(story)), story.ranks()
    while open_ := [n for n, runner in story.runners.items() if runner.at_m is None]:
        tied = next((t for t in said if (t.who.at_m is None) != (t.other.at_m is None)), None)
        if tied is not None:
            place(tied if tied.who.at_m is None else tied.turned())
        else:
            name = min(open_, key=lambda n: _urgency(story, n, order))
            _place_as_usual(story, name, order, wider)
    _past_things(story, {each.id for tie in said for each in (tie.who, tie.other)})


def _past_things(story: Story, told: set[str]) -> None:
    """Put those who would drive over what lies in another's way beyond it, where nothing is told.

    They have lost it, or passed it before.
    """
    for name, thing in story.things.items():
        lies, behind = story.runners[name], story.runners[thing.in_way_of or story.ego.id]
        ahead = [
            r for r in story.people.values()
            if (r.lane, r.forward) == (lies.lane, lies.forward) and r.id not in told
            and not (r.stands or r.moves) and (r.x_m(0.0) - behind.x_m(0.0)) * r.sign > 0.0
        ]  # fmt: skip
        ends_m = lies.x_m(0.0) * lies.sign + lies.body.front_m
        rears_m = [runner.x_m(0.0) * runner.sign - runner.body.rear_m for runner in ahead]
        short_m = ends_m + _PASSED_M - min(rears_m, default=inf)
        for runner in ahead if short_m > 0.0 else []:
            runner.at_m = runner.x_m(0.0) + runner.sign * short_m


def place_again(story: Story, act: Act, fixed: Collection[str]) -> None:
    """Keep what is told of an act whose moment has changed: all but those who are ``fixed`` move.

    Who is as far from one of them as is said when it begins starts elsewhere.
    """
    for tie in _said(story, act.id):
        free = [each for each in (tie.who, tie.other) if each.id not in fixed]
        if len(free) == 1:
            place(tie if free == [tie.who] else tie.turned())


def _said(story: Story, at: str | None = None) -> Iterator[GapAt]:
    """The ties of the text: spacings along the road, and measures that set acts off.

    Who has passed another comes back so far ahead of it as is said, wherever it starts. Only those
    told of an act, if it is given.
    """
    back = {act.id for act in story.acts if story.comes_back(act)}
    for spacing in story.functional.spacings:
        pair = {spacing.participant, spacing.reference}
        if at not in {None, spacing.at}:
            continue
        known = pair <= story.runners.keys() and spacing.measure in LENGTHWISE
        if known and spacing.at != CONTACT and spacing.at not in back:
            time_s = (
                0.0 if spacing.at == START else story.begins_s.get(spacing.at, story.first_act_s)
            )
            if spacing.since == "end":
                time_s = _ends_s(story, story.act(spacing.at), pair, time_s)
            yield _gap_at(story, spacing, time_s, spacing.at, spacing.since)
    for act in story.acts:
        when = act.when
        if not isinstance(when, WhenMeasure) or when.measure not in LENGTHWISE or at:
            continue
        if {when.participant, when.reference} <= story.runners.keys() and act.id in story.begins_s:
            yield _gap_at(story, when, story.begins_s[act.id], act.id)


def _ends_s(story: Story, act: Act, pair: set[str], since_s: float) -> float:
    """When an act has ended: when the last of two who come to rest by then does so."""
    if act.kind not in SLOWING:
        return story.ends_s.get(act.id, since_s)
    rests = [story.runners[name].profile.rests_s(since_s) for name in pair]
    return max((r for r in rests if r < NEVER_S), default=since_s)


def _gap_at(
    story: Story, told: Spacing | WhenMeasure, time_s: float, at: str,
    since: Literal["begin", "end"] = "begin",
) -> GapAt:  # fmt: skip
    names, ahead, functional = (told.participant, told.reference), None, story.functional
    who, other = (story.runners[name] for name in names)
    if who.forward == other.forward:
        ahead = is_said_ahead(functional, functional.hazards, *names, at, since)
    if ahead is None:
        ahead = is_ahead(story, *names)
    return GapAt(who, other, told.measure, told.value.middle, time_s, ahead)


def _urgency(story: Story, name: str, order: dict[str, int]) -> tuple[bool, bool, bool, int]:
    """Whom to place first: the ego's lane, nearest to it in line; things come last."""
    runner, ego = story.runners[name], story.ego
    same_way = runner.forward == ego.forward
    away = abs(order[name] - order[ego.id])
    return (runner.thing, not same_way, runner.lane != ego.lane, away)


def _place_as_usual(story: Story, name: str, order: dict[str, int], wider: float) -> None:
    runner = story.runners[name]
    lying = [story.runners[n] for n in story.things if story.runners[n].at_m is not None]
    here = [r for r in lying if (r.lane, r.forward) == (runner.lane, runner.forward)]
    if name in story.things and here:  # one thing behind the other
        beyond_m = here[-1].body.front_m + THINGS_APART_M + runner.body.rear_m
        runner.at_m = here[-1].x_m(0.0) + runner.sign * beyond_m
        return
    other = story.runners[_reference(story, name, order)]
    if runner.forward != other.forward:
        # Level at a moment: then and there they meet.
        meets_s = max([_MEETS_S, *(m.ends_s + 0.4 for m in runner.moves)])
        runner.at_m = level(runner, other, meets_s)
        return
    front, back = (runner, other) if is_ahead(story, name, other.id) else (other, runner)
    aside = back.moves[0] if back.moves and back.moves[0].lane != back.lane else None
    if front.thing and back.moves and aside is None:  # it swerves round it
        out, then = back.moves[0], next(iter(back.moves[1:]), None)
        runner.at_m = level(runner, other, (out.ends_s + (then or out).begins_s) / 2)
        return
    near = front.stands and front.lane == back.lane and (front.thing or back is story.ego)
    if near and aside is not None:  # it goes round as late as it can
        tie = GapAt(runner, other, Measure.GAP_M, 0.0, aside.begins_s, ahead=runner is front)
        far_m = max(back.speed_at_mps(aside.begins_s), 1.0) * aside.lasts_s

        def put(gap_m: float) -> None:
            place(replace(tie, value=gap_m))

        just_misses((front, back), put, far_m, 0.0, JUST_M * wider)
        return
    kind = _usual(story, front, back, wider)
    if kind is None:
        moves = [m.begins_s for m in (*runner.moves, *other.moves)]
        runner.at_m = level(runner, other, min(moves, default=story.first_act_s))
        return
    place(GapAt(runner, other, *kind, ahead=runner is front))


def _reference(story: Story, name: str, order: dict[str, int]) -> str:
    """To whom a place is told: who it is beside, the next in its line, else the ego."""
    known = [n for n, r in story.runners.items() if r.at_m is not None]
    for other in known:
        both = (words_between(story.functional, *pair) for pair in ((name, other), (other, name)))
        if other != story.ego.id and any(Approach.ADJACENT in words for words in both):
            return other
    names = list(story.runners)
    thing = story.things.get(name)
    if thing is not None and thing.in_way_of in known:
        return thing.in_way_of
    runner = story.runners[name]
    line = [
        n for n in known
        if story.runners[n].lane == runner.lane and story.runners[n].forward == runner.forward
    ]  # fmt: skip
    if line:
        here = names.index(name)
        return min(line, key=lambda n: (abs(order[n] - order[name]), abs(names.index(n) - here)))
    return story.functional.ego.id


def _side_on(story: Story, front: Runner, back: Runner) -> bool:
    """Whether one who comes over is to touch the other's side: it neither cuts in nor is hit so."""
    if not story.contact_wanted(front.id, back.id) or story.functional.outcome is None:
        return False
    struck = story.functional.outcome.struck
    cuts = HazardKind.CUT_IN in story.kinds_by(front.id)
    return struck in {BodySide.LEFT, BodySide.RIGHT} or (struck is None and not cuts)


def _usual(
    story: Story, front: Runner, back: Runner, wider: float
) -> tuple[Measure, float, float] | None:
    """The measure that two of one direction usually have, and when; None: side by side."""
    backing = next((each for each in (front, back) if each.backs), None)
    if backing is not None:
        met = back if backing is front else front
        closing_m = met.profile.way_m(_MEETS_S) * (1 if backing is front else -1)
        return Measure.GAP_M, backing.profile.way_m(_MEETS_S) - 2 * FORTH_M + closing_m, 0.0
    over = comes_in(front, back)
    if over is not None:
        return None if _side_on(story, front, back) else _cutting_in(front, back, over, wider)
    if front.lane != back.lane:
        names = front.id, back.id
        words = (words_between(story.functional, *each) for each in (names, names[::-1]))
        diagonal = frozenset().union(*words) & {Approach.AHEAD, Approach.BEHIND}
        return (Measure.HEADWAY_S, 1.0, story.first_act_s) if diagonal else None
    if front.stands and back.speed_mps > 0 and back.speed_at_mps(_AT_REST_S) == 0.0:
        return Measure.GAP_M, _STOPS_BEFORE_M, _AT_REST_S
    if front.speed_mps < back.speed_mps - _SLOWER_MPS:
        moving_away = back.moves[0] if back.moves else None
        if moving_away is not None and moving_away.lane != front.lane:
            return Measure.TTC_S, _REVEALED_S * wider, moving_away.begins_s
        return _closing_in(story, front, back, wider)
    if back.speed_mps == 0.0:
        return Measure.GAP_M, 2.0, 0.0
    return Measure.HEADWAY_S, _headway_s(story, front, back, wider), 0.0


def _closing_in(
    story: Story, front: Runner, back: Runner, wider: float
) -> tuple[Measure, float, float]:
    """How far behind a slower one somebody starts: in time to pass it, where that is said."""
    own = (a for a in story.acts_of(back.id) if a.when is not None)
    moments = (story.begins_s[a.id] for a in own if story.goes_round(a) and a.id in story.begins_s)
    for passes_s in moments:
        return Measure.TTC_S, LANE_CHANGE_S * wider, passes_s
    # Who is said to speed up has done so before it is there.
    gains = story.acts_of(back.id, {ActKind.ACCELERATE})
    ends_s = max([story.ends_s.get(a.id, 0.0) + HOLDS_S for a in gains], default=0.0)
    closing_m = _CLOSES_IN_S * (back.speed_mps - front.speed_mps)
    faster_m = back.profile.way_m(ends_s) - front.profile.way_m(ends_s)
    return Measure.GAP_M, max(closing_m, faster_m, _LEAST_FREE_M) * wider, 0.0


def _cutting_in(
    front: Runner, back: Runner, over: Move, wider: float
) -> tuple[Measure, float, float]:
    """How close one comes over before another, and when."""
    closing = back.speed_mps - front.speed_at_mps(over.begins_s)
    gap = max(_CUTS_IN_S * back.speed_mps, _CLOSING_CUT_S * closing, 4.0)
    return Measure.GAP_M, gap * wider, over.begins_s


def _headway_s(story: Story, front: Runner, back: Runner, wider: float) -> float:
    if HazardKind.TAILGATING in story.kinds_by(back.id):
        return sum(TAILGATING_HEADWAY_S) / 2
    slows = any(s.target_mps < front.speed_mps for s in front.steps)
    concerned = at_odds(story.functional, front.id, back.id) or story.ego.id in {front.id, back.id}
    if not slows and not concerned:
        return story.driver(back.id).time_gap_s * wider
    return (_BRAKES_AT_S if slows else _FOLLOWING_S) * wider
