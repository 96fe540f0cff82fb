"""Those who are on a strip beside the lanes: which number it has, and how far out it lies."""

from __future__ import annotations

from scegen.concretization.along.story import Story
from scegen.concretization.roads import standing_in_bays
from scegen.road.cross_section import LANE_TYPES, strips_beside
from scegen.road.model import LaneType
from scegen.scenario.logical import Heading, Walking
from scegen.scenario.roadway import BAYS


def put_on_strips(story: Story) -> None:
    """Give those their lane who are on a strip; it is numbered after the lanes.

    Who walks against the traffic on a side of the road is placed from the lane of the oncoming.
    """
    if story.functional.junction.auxiliary is not None:
        return  # a lane of the road lies there, for a part of the way
    strips = strips_along(story)
    middles = tuple(
        sum(width for _, width in strips[:k]) + width / 2 for k, (_, width) in enumerate(strips)
    )
    types = [kind for kind, _ in strips]
    for name, runner in story.people.items():
        runner.lane_count, runner.strips_m = story.lane_count, middles
        strip = story.functional.participant(name).strip
        if strip is None:
            continue
        number = types.index(LANE_TYPES[strip])
        runner.lane, runner.offset_m = story.lane_count + 1 + number, 0.0
        if _against_traffic(story, name):
            outward = 1.0 if runner.keeps_left else -1.0
            out_m = (story.lane_count - 0.5) * runner.lane_width_m + middles[number]
            runner.lane, runner.offset_m = 0, -outward * out_m


def strips_along(story: Story) -> list[tuple[LaneType, float]]:
    """What lies beside the lanes, outwards, with its width (m)."""
    strips = story.functional.junction.strips
    parked = bool(strips & BAYS or standing_in_bays(story.functional, story.logical))
    return strips_beside(strips, parked=parked)


def strip_middle_m(story: Story, name: str) -> float:
    """How far beyond the lanes the middle of the strip lies on which somebody stands."""
    said = story.functional.participant(name).strip
    wanted = {LaneType.PARKING, LaneType.SHOULDER} if said is None else {LANE_TYPES[said]}
    before = 0.0
    for kind, width in strips_along(story):
        if kind in wanted:
            return before + width / 2
        before += width
    raise KeyError(f"no strip for {name}")


def _against_traffic(story: Story, name: str) -> bool:
    """Whether one walks on a side of the road where the traffic comes towards it."""
    assignment = story.logical.assignment(name)
    if not isinstance(assignment, Walking):
        return False
    kerb = assignment.side.value == story.functional.junction.driving_side.value
    return kerb != (assignment.heading is Heading.INWARD)
