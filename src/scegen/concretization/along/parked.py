"""Where those stand who are parked beside the lanes: before whom they hide, else along the way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from scegen.concretization.along.crossing import BEFORE_WALKER_M
from scegen.concretization.along.doors import middle_m, opens
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.sideways import (
    edge_y_m,
    on_left,
    standings_beside,
    strip_middle_m,
)
from scegen.concretization.along.story import Story
from scegen.concretization.others import Walk
from scegen.concretization.profile import NEVER_S
from scegen.scenario.bodies import Body
from scegen.scenario.logical import Standing
from scegen.scenario.spacings import START, Measure, Spacing
from scegen.scenario.vocabulary import HazardKind

_BETWEEN_M = 1.2
_PASSED_AT_S = 5.0


@dataclass(frozen=True, slots=True)
class Parked:
    """One who is parked: the middle of its box lies at ``x_m`` of the road."""

    id: str
    body: Body
    standing: Standing
    x_m: float


def shift_to_pass(story: Story) -> None:
    """Let who passes parked ones keep the distance that the text gives, within its lane."""
    for spacing in story.functional.spacings:
        if spacing.measure not in {Measure.LATERAL_GAP_M, Measure.LATERAL_OFFSET_M}:
            continue
        for standing in standings_beside(story):
            pair = {spacing.participant, spacing.reference}
            if standing.participant not in pair:
                continue
            name = next(iter(pair - {standing.participant}), None)
            if name in story.runners:
                _keep_off(story, story.runners[name], standing, spacing)


def _keep_off(story: Story, runner: Runner, standing: Standing, spacing: Spacing) -> None:
    left = on_left(story, standing)
    body = story.functional.participant(standing.participant).body
    sign = 1 if left else -1
    middle = edge_y_m(story, left=left) + sign * strip_middle_m(story, standing.participant)
    away = spacing.value.middle
    if spacing.measure is Measure.LATERAL_GAP_M:
        wanted = middle - sign * (away + (body.width_m + runner.body.width_m) / 2)
    elif spacing.participant == runner.id:
        wanted = middle + runner.sign * away
    else:
        wanted = middle - runner.sign * away
    runner.shift(runner.sign * (wanted - runner.y_m(0.0)))


def park(story: Story) -> list[Parked]:
    """Places for all who are parked, in rows.

    Before those whom they hide, around one that opens its door, and others along the way.
    """
    hiding = {name for hazard in story.of_kind(HazardKind.OCCLUSION) for name in hazard.by}
    doors = opens(story.functional).keys() & story.runners.keys() - hiding
    beside = standings_beside(story)
    opened = {on_left(story, s): s.participant for s in beside if s.participant in doors}
    rows: dict[tuple[bool, str], list[Standing]] = {}
    for standing in beside:
        left, name = on_left(story, standing), standing.participant
        walk = _hidden(story, standing, hiding)
        before = opened.get(left) if name not in hiding else None
        before = before or (walk.id if walk is not None else "")
        rows.setdefault((left and bool(before), before), []).append(standing)
    return [p for (_, name), row in rows.items() for p in _in_a_row(story, row, name)]


def _in_a_row(story: Story, row: list[Standing], before: str) -> Iterator[Parked]:
    """In the order in which they are passed, from the one on whose place something depends."""
    bodies = [story.functional.participant(s.participant).body for s in row]
    first, middle, sense = 0, story.ego.x_m(_PASSED_AT_S), 1
    walk = story.walks.get(before)
    if walk is not None:
        sense = -story.runners[walk.meets].sign
        away = (walk.body.width_m + bodies[0].length_m) / 2 + BEFORE_WALKER_M
        middle = walk.x_m + sense * away
    elif before:
        door = story.runners[before]
        first = next(n for n, s in enumerate(row) if s.participant == before)
        middle, sense = middle_m(door, bodies[first]), door.sign
    else:
        first, middle = _said_m(story, row, bodies) or (first, middle)
    for n, standing in enumerate(row):
        between = bodies[min(n, first) + 1 : max(n, first)]
        away = (bodies[n].length_m + bodies[first].length_m) / 2 + _BETWEEN_M
        away += sum(body.length_m + _BETWEEN_M for body in between)
        x = middle + sense * ((n > first) - (n < first)) * away
        yield Parked(standing.participant, bodies[n], standing, x)


def passes_s(story: Story, parked: list[Parked]) -> float:
    """When the ego has passed all of whom it is said how far ahead they stand."""
    said = [p.x_m - story.ego.x_m(0.0) for p in parked if _ahead_m(story, p.id) is not None]
    moments = map(story.ego.profile.time_s, said)
    return max((moment for moment in moments if moment < NEVER_S), default=0.0)


def _said_m(story: Story, row: list[Standing], bodies: list[Body]) -> tuple[int, float] | None:
    """Of whom in a row it is said how far from the ego it is at first, and its place."""
    for n, standing in enumerate(row):
        ahead_m = _ahead_m(story, standing.participant)
        if ahead_m is not None:
            return n, story.ego.ends_m(0.0)[1] + ahead_m + bodies[n].length_m / 2
    return None


def _ahead_m(story: Story, name: str) -> float | None:
    """How far ahead of the ego's front somebody is said to stand at first."""
    for spacing in story.functional.spacings:
        first = spacing.measure is Measure.GAP_M and spacing.at == START
        if first and {spacing.participant, spacing.reference} == {name, story.ego.id}:
            return spacing.value.middle
    return None


def _hidden(story: Story, standing: Standing, hiding: set[str]) -> Walk | None:
    """Whom one hides: who sets off from its side; from anywhere if it is said to hide somebody."""
    hides = standing.participant in hiding
    same = [w for w in story.walks.values() if w.from_left == on_left(story, standing)]
    found = [*same, *(story.walks.values() if hides else ())]
    return found[0] if found and (hides or not hiding) else None
