"""From the two levels above to a story: who is along the road and how fast, what lies there."""

from collections.abc import Iterator
from itertools import permutations

from scegen.concretization.along.acts import all_acts
from scegen.concretization.along.frame import RAMP_MPS
from scegen.concretization.along.lanes import choose_lanes
from scegen.concretization.along.parked import cast_doors, hang_doors, is_one_way
from scegen.concretization.along.runner import FORTH_M, FORTH_MPS, Runner
from scegen.concretization.along.sideways import put_on_strips
from scegen.concretization.along.story import Story
from scegen.concretization.limits import REVERSING_MPS, REVERSING_MPS2
from scegen.concretization.profile import SpeedChange
from scegen.concretization.tale import as_meant, outward, pace_of, told_at
from scegen.concretization.things import lying_in_the_way, shape_of
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import SLOWING, Act, ActKind, AfterStart, WhenMeasure
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.in_line import is_ahead_at_first, is_said_ahead
from scegen.scenario.logical import Crossing, Drive, Heading, LogicalScenario, Standing, Walking
from scegen.scenario.model import Interval
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import AuxiliaryLane
from scegen.scenario.spacings import LENGTHWISE, START, Measure
from scegen.scenario.vocabulary import ON_FOOT, HazardKind, Maneuver, ParticipantKind, Side

_STANDS_MPS = 1.0
_EDGE_M = 1.5
"""Who walks along the side of the road keeps so far from the middle of its outermost lane."""
_IN_THE_WAY_M = 0.4
"""So far what lies at the edge of a lane reaches into the way of who drives there."""
_PASSES_BY_MPS = 6.0
"""By so much one who overtakes is faster, where no speeds are said."""


def cast(story: Story) -> None:
    """Everybody along the road, at the speed that is said or usual; lanes and places come later."""
    ridden = {p.strip for p in story.functional.participants if p.strip and not p.parked}
    for assignment in story.logical.assignments:
        participant = story.functional.participant(assignment.participant)
        if isinstance(assignment, Crossing):
            continue
        parked = (
            isinstance(assignment, Standing)
            and not (assignment.in_lane or participant.kind in ON_FOOT)
            and participant.strip not in ridden
        )
        among = story.parked if parked else story.runners
        among[participant.id] = _cast(story, assignment, participant, parked=parked)
    _speeds(story)


def _cast(
    story: Story, assignment: Drive | Walking | Standing, participant: Participant, *, parked: bool
) -> Runner:
    arm, keeps = story.ego_arm, story.functional.junction.driving_side.value
    if isinstance(assignment, Drive):
        forward = assignment.entry == arm
    elif isinstance(assignment, Walking):
        forward = (assignment.arm == arm) == (assignment.heading is Heading.INWARD)
    else:
        forward = (assignment.arm == arm) == (assignment.side.value == keeps)
        forward |= parked and is_one_way(story)
    beside = not isinstance(assignment, Drive) and not (assignment.in_lane or parked)
    lane = -1 if assignment.lane is None else assignment.lane
    name, kind, body = participant.id, participant.kind, participant.body
    runner = story.made(name, kind, body, lane, forward=forward)
    if beside:
        # Seen in its own direction, the edge is to the kerb's side if it goes with the traffic.
        runner.offset_m = outward(story.functional, Side.LEFT) * _EDGE_M
    return runner


def _speeds(story: Story) -> None:
    """Said, else by the danger that it causes, else the one speed of cruising traffic."""
    functional, logical = story.functional, story.logical
    said = {p.id: p.speed_mps for p in functional.participants if p.speed_mps is not None}
    cruising = pace_of(functional, logical, functional.ego.id).default
    bays = story.in_bays
    ramps = functional.junction.auxiliary is AuxiliaryLane.ON_RAMP
    on_ramp = story.merging if ramps else frozenset()
    for runner in story.runners.values():
        assignment = logical.assignment(runner.id)
        stays = isinstance(assignment, Standing) or (
            isinstance(assignment, Drive) and assignment.maneuver is Maneuver.STAY
        )
        if (back := _begins_with(story, runner.id, ActKind.REVERSE)) is not None:
            _reverse(runner, said.get(runner.id), back)
        elif stays or runner.id in bays or _begins_with(story, runner.id, ActKind.SET_OFF):
            runner.speed_mps = 0.0
        else:
            pace = pace_of(functional, logical, runner.id)
            with_ego = cruising if runner.forward and cruising > _STANDS_MPS else pace.high
            speed = max(min(pace.default, with_ego), pace.low)
            slow = runner.id in on_ramp and runner.id not in said
            runner.speed_mps = min(speed, RAMP_MPS) if slow else speed
    passing = {a.id for a in functional.acts if a.kind is ActKind.OVERTAKE}
    near = [
        s for s in functional.spacings if s.at in {START, *passing} and s.measure is Measure.GAP_M
    ]
    for hazard in story.of_kind(HazardKind.OVERTAKING):
        # Who is said to be so near at first, or as it pulls out, has followed until then.
        if not any({s.participant, s.reference} <= {*hazard.by, *hazard.to} for s in near):
            _make_faster(story, hazard.by, hazard.to)
    for behind, ahead in _closing(functional):
        _make_faster(story, (behind,), (ahead,))


def _closing(functional: FunctionalScenario) -> Iterator[tuple[str, str]]:
    """Who is said to be so many seconds from a collision with whom, unless that one slows first.

    So it is with who touches, or nearly, another ahead of it that is said to be so fast, or that
    comes into its lane so far ahead.
    """
    slowing: set[str] = set()
    passed: set[str] = set()
    holds = {s.participant for s in functional.spacings if s.at == START}
    comes_in: set[tuple[str, str]] = set()
    for act in (None, *functional.acts):
        if act is not None and act.participant in passed:
            continue  # it is ahead by having been faster
        at = START if act is None else act.id
        for each in (t for t in told_at(functional, act) if t.measure in LENGTHWISE):
            pair = each.participant, each.reference
            ahead = is_said_ahead(functional, functional.hazards, *pair, at)
            back, front = pair[::-1] if ahead else pair
            comes_down = isinstance(each, WhenMeasure) and not holds & {back, front}
            if front not in slowing and (each.measure is Measure.TTC_S or comes_down):
                yield back, front
            if act is not None and act.kind is ActKind.CHANGE_LANE:
                comes_in.add((back, front))
        if act is not None and act.kind in SLOWING:
            slowing.add(act.participant)
        if act is not None and act.kind is ActKind.OVERTAKE:
            passed.add(act.participant)
    outcome = functional.outcome
    near = outcome.between if outcome and outcome.kind is not OutcomeKind.AVOIDED else ()
    for back, front in permutations(near, 2):
        steady = functional.participant(front).speed_mps is not None
        ahead = steady and is_ahead_at_first(functional, front, back)
        if front not in slowing and (ahead or (back, front) in comes_in):
            yield back, front


def _begins_with(story: Story, name: str, kind: ActKind) -> Act | None:
    """The first thing that somebody does, if it is of a kind."""
    first = story.first_act(name, *ActKind)
    return first if first is not None and first.kind is kind else None


def _reverse(runner: Runner, said: Interval | None, act: Act) -> None:
    """Hardly forwards, ever slower, then back: as fast as is said or usual, as far as is said."""
    speed = said.middle if said is not None else sum(REVERSING_MPS) / 2
    if speed <= 0.0:
        raise MotionInfeasibleError(
            "it is to drive backwards, and to stand all the time",
            where=runner.id,
            hint="Give it a speed above 0 km/h, or let it stand and another one reverse.",
        )
    runner.backs = True
    runner.speed_mps = min(FORTH_MPS, speed)
    if isinstance(act.when, AfterStart) and act.when.delay_s.middle > 0.0:
        runner.speed_mps = min(runner.speed_mps, 2 * FORTH_M / act.when.delay_s.middle)
    far = None if act.distance_m is None else act.distance_m.middle
    speed = speed if far is None else min(speed, (REVERSING_MPS2 * far) ** 0.5)
    begins = 1.96 * FORTH_M / runner.speed_mps
    runner.steps = [
        SpeedChange(0.0, runner.speed_mps**2 / (2 * FORTH_M), 0.0),
        SpeedChange(speed, REVERSING_MPS2, begins),
    ]
    if far is None:
        return
    slows = FORTH_M + far - speed**2 / (2 * REVERSING_MPS2)
    runner.steps.append(SpeedChange(0.0, REVERSING_MPS2, runner.profile.time_s(slows)))


def _make_faster(story: Story, by: tuple[str, ...], to: tuple[str, ...]) -> None:
    """Who overtakes is clearly faster; where its speed is said, the other is slower."""
    for fast in (story.runners[name] for name in by if name in story.runners):
        for slow in (story.runners[name] for name in to if name in story.runners):
            enough = 2.0 if story.has_said_speed(slow.id) else _PASSES_BY_MPS
            near = slow.forward == fast.forward and fast.speed_mps - slow.speed_mps < enough
            if not near or fast.stands:
                continue
            if not story.has_said_speed(slow.id):
                slow.speed_mps = max(0.6 * fast.speed_mps, fast.speed_mps - _PASSES_BY_MPS)
            elif not story.has_said_speed(fast.id):
                fast.speed_mps = min(slow.speed_mps + _PASSES_BY_MPS, fast.body.top_speed_mps)


def story_of(functional: FunctionalScenario, logical: LogicalScenario) -> Story:
    """Everybody with its speed and lane, and what is done; no places and no moments yet.

    Raises:
        MotionInfeasibleError: what is said of lanes cannot all be had.
    """
    story = Story(as_meant(functional, logical), logical, ())
    cast(story)
    cast_doors(story)
    _lay_things(story)
    story.acts = all_acts(story)
    choose_lanes(story)
    put_on_strips(story)
    hang_doors(story)
    for thing in story.things.values():
        _lay_aside(story, story.runners[thing.id], story.runners[thing.in_way_of or ""])
    _keep_on_the_road(story)
    return story


def _lay_aside(story: Story, thing: Runner, driver: Runner) -> None:
    """Into somebody's lane; on the side that is said, as far out as it is in the way there."""
    thing.lane, side = driver.lane, story.things[thing.id].side
    if side is None:
        return
    edge_m = (thing.lane_width_m - thing.body.width_m) / 2
    reached_m = (driver.body.width_m + thing.body.width_m) / 2 - _IN_THE_WAY_M
    out_m = max(0.0, min(edge_m, reached_m))
    to_left = (side is Side.LEFT) == (thing.forward is story.ego.forward)
    thing.offset_m = driver.offset_m + (out_m if to_left else -out_m)


def _keep_on_the_road(story: Story) -> None:
    """Nobody is so fast in a bend that no tyre would hold.

    Raises:
        MotionInfeasibleError: somebody is said to be.
    """
    bend = story.functional.junction.bend
    if bend is None:
        return
    radius = bend.radius_at_m(story.limit_mps)
    for runner in story.runners.values():
        asked = runner.fastest_mps**2 / radius
        if asked > story.grip_mps2:
            raise MotionInfeasibleError(
                f"at {runner.fastest_mps * 3.6:.0f} km/h a bend of {radius:g} m radius needs "
                f"{asked:.1f} m/s2 sideways, and tyres give {story.grip_mps2:.1f} on this road",
                where=runner.id,
                hint="Let it drive more slowly, or widen the bend.",
            )


def _lay_things(story: Story) -> None:
    """What lies in somebody's lane: what is said, and what a danger needs that nobody causes."""
    said = [thing for thing in story.functional.objects if thing.in_way_of in story.runners]
    needed = lying_in_the_way(story.functional, story.logical, story.runners)
    for hazard, thing in needed:
        if not hazard.by:
            story.blame(thing, hazard)
    story.things = {thing.id: thing for thing in (*said, *(thing for _, thing in needed))}
    for thing in story.things.values():
        body, forward = shape_of(thing).body, story.runners[thing.in_way_of or ""].forward
        made = story.made(thing.id, ParticipantKind.CAR, body, forward=forward, thing=True)
        story.runners[thing.id] = made
