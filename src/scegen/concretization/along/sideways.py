"""Where somebody is across the road: in its lane as distances say, or on a strip beside them."""

from dataclasses import replace
from itertools import accumulate

from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import Story
from scegen.concretization.amounts import overlapping_m
from scegen.concretization.profile import NEVER_S
from scegen.concretization.roads import standing_in_bays
from scegen.concretization.tale import outward
from scegen.errors import MotionInfeasibleError
from scegen.road.cross_section import CARRIAGEWAY, LANE_TYPES, median_half_m, strips_beside
from scegen.road.model import LaneType
from scegen.scenario.concrete import MOST_OFFSET_M
from scegen.scenario.logical import Heading, Walking
from scegen.scenario.roadway import BAYS, Carriageway, Strip
from scegen.scenario.spacings import CONTACT, Measure, Spacing
from scegen.scenario.vocabulary import Side


def edge_y_m(story: Story, *, left: bool) -> float:
    """Where the lanes end on one side, to the ego's left of the centre line."""
    junction = story.functional.junction
    if junction.carriageway is Carriageway.ONE_WAY and left != story.ego.keeps_left:
        return 0.0  # beside the innermost lane there are no others
    width = median_half_m(junction.carriageway) + story.lane_count * story.ego.lane_width_m
    return width * (1 if left else -1)


def strip_m(story: Story, *, left: bool) -> float:
    """How wide the strips for vehicles are beside the lanes of a side; 0 where nobody needs any."""
    needed = story.functional.junction.strips - {Strip.PAVEMENT}
    if not needed and all(p.on_left != left for p in story.parked.values()):
        return 0.0
    return sum(width for kind, width in strips_along(story) if kind in CARRIAGEWAY)


def offset_all(story: Story) -> None:
    """Put those aside of whom the text says how far they are so, or where they are hit."""
    told: set[str] = set()
    parked, known = story.parked.keys(), story.runners | story.parked
    passing = {act.participant for act in story.acts if story.goes_round(act)}
    for spacing in story.functional.spacings:
        who, other = spacing.participant, spacing.reference
        if who == other and who in story.runners:
            story.runners[who].shift(spacing.value.middle)
        elif {who, other} <= known.keys() and {who, other} & story.runners.keys() - parked:
            kept = {story.ego.id, *parked} if other not in parked else {*parked}
            mover, fixed = (other, who) if who in kept else (who, other)
            pair = known[who], known[other]
            turned = mover != who and pair[0].forward == pair[1].forward
            # Two who come towards each other: as they are level.
            meet = spacing.measure is Measure.LATERAL_GAP_M and pair[0].forward != pair[1].forward
            left = _left_m(story, spacing, *pair, NEVER_S if meet else 0.0)
            # With a lateral gap somebody passes the other in its lane.
            passes = spacing.measure is Measure.LATERAL_GAP_M and pair[0].lane == pair[1].lane
            passes &= parked.isdisjoint({who, other})
            if left is not None and not (passes and passing & {who, other}):
                later = meet or spacing.at == CONTACT or spacing.at in story.begins_s
                aside = -left if turned else left
                _put_aside(known[mover], known[fixed], aside, in_the_end=later)
                told |= {who, other}
    outcome = story.functional.outcome
    if outcome is None or outcome.impact_percent is None:
        return
    ego = story.ego
    for name in outcome.between:
        runner = story.runners.get(name)
        if runner is None or runner is ego:
            continue
        if name in told and not (ego.moves or runner.moves):
            continue  # it stays where it is said to be
        _put_aside(runner, ego, story.struck_left_m(ego.body), in_the_end=True)


def _left_m(
    story: Story, spacing: Spacing, who: Runner, other: Runner, at_s: float
) -> float | None:
    """How far to the reference's left the participant's middle is; None: nothing said of that."""
    both = (who.body.width_m + other.body.width_m) / 2
    value = spacing.value.middle
    if spacing.measure is Measure.LATERAL_OFFSET_M:
        return value
    if spacing.measure is Measure.LATERAL_GAP_M:
        return _sign(story, spacing, who, other, at_s) * (value + both)
    if spacing.measure is Measure.OVERLAP_PERCENT:
        apart = overlapping_m(value, who.body, other.body)
        return _sign(story, spacing, who, other, at_s) * apart
    return None


def _sign(story: Story, spacing: Spacing, who: Runner, other: Runner, at_s: float) -> int:
    """1 if it is to the reference's left, as said or as the lanes are; else the ego is inside."""
    if spacing.side is not None:
        return 1 if spacing.side is Side.LEFT else -1
    apart = (who.y_m(at_s) - other.y_m(at_s)) * other.sign
    if abs(apart) > 0.1:
        return 1 if apart > 0 else -1
    turned = who is story.ego and who.forward == other.forward
    return outward(story.functional, Side.LEFT) * (-1 if turned else 1)


def _put_aside(who: Runner, other: Runner, left_m: float, *, in_the_end: bool) -> None:
    """Move one in (or off) its lane, so that it is so far to the other's left.

    Raises:
        MotionInfeasibleError: that is no longer on the road.
    """
    moment = NEVER_S if in_the_end else 0.0
    wanted = other.y_m(moment) + other.sign * left_m
    more = who.sign * (wanted - who.y_m(moment))
    aside = more + (who.moves[-1].offset_m if who.moves and in_the_end else who.offset_m)
    if abs(aside) > MOST_OFFSET_M:
        raise MotionInfeasibleError(
            f"is to be {abs(left_m):.1f} m beside {other.id}: that is off the road",
            where=who.id,
            hint=f"Give at most {MOST_OFFSET_M:g} m from the middle of its lane.",
        )
    if who.moves and in_the_end:
        who.moves[-1] = replace(who.moves[-1], offset_m=who.moves[-1].offset_m + more)
    else:
        who.shift(more)


def put_on_strips(story: Story) -> None:
    """Give those their lane who are on a strip; it is numbered after the lanes.

    Who walks against the traffic is placed from the lane of those who come towards it.
    """
    strips = strips_along(story)
    begins = accumulate((width for _, width in strips), initial=0.0)
    # How far beyond the lanes the middles of the strips lie, outwards.
    middles = {k: begin + width / 2 for begin, (k, width) in zip(begins, strips, strict=False)}
    for name, runner in story.parked.items():
        strip = story.functional.participant(name).strip
        kinds = {LaneType.PARKING, LaneType.SHOULDER} if strip is None else {LANE_TYPES[strip]}
        beyond_m = next(middle for kind, middle in middles.items() if kind in kinds)
        left = story.stands_left(name)
        middle = edge_y_m(story, left=left) + (beyond_m if left else -beyond_m)
        runner.lane = 1
        runner.shift(runner.sign * (middle - runner.y_m(0.0)))
    if story.functional.junction.auxiliary is not None:
        return  # a lane of the road lies there, for a part of the way
    for name, runner in story.people.items():
        runner.lane_count, runner.strips_m = story.lane_count, tuple(middles.values())
        strip, against = story.functional.participant(name).strip, _against_traffic(story, name)
        if strip is None and against is None:
            continue
        if against is not None and strip is None:
            lane = story.ego.lane if against.in_lane else story.lane_count
            out_m = (lane - 1) * runner.lane_width_m + abs(runner.offset_m)
        else:
            number = list(middles).index(LANE_TYPES[strip]) if strip is not None else 0
            runner.lane, runner.offset_m = story.lane_count + 1 + number, 0.0
            out_m = (story.lane_count - 0.5) * runner.lane_width_m + runner.strips_m[number]
        if against is not None:
            outward = 1.0 if runner.keeps_left else -1.0
            runner.lane, runner.offset_m = 0, -outward * out_m


def strips_along(story: Story) -> list[tuple[LaneType, float]]:
    """What lies beside the lanes, outwards, with its width (m)."""
    strips = story.functional.junction.strips
    parked = bool(strips & BAYS or standing_in_bays(story.functional, story.logical))
    return strips_beside(strips, parked=parked)


def _against_traffic(story: Story, name: str) -> Walking | None:
    """How one walks on a side of the road where the traffic comes towards it, if it does."""
    walking = story.logical.assignment(name)
    if not isinstance(walking, Walking):
        return None
    kerb = walking.side.value == story.functional.junction.driving_side.value
    return walking if kerb != (walking.heading is Heading.INWARD) else None
