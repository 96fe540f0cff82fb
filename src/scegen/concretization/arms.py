"""What is done on an arm before the junction: laid as along a road, and then put there.

Those of an arm on which somebody leaves its lane are a story of their own, with the arm as its
road. It is over before anybody slows down to turn.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from scegen.concretization.along.compose import lay
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import FIRST_ACT_S, Story
from scegen.concretization.along.telling import story_of
from scegen.concretization.along.writing import written_changes
from scegen.concretization.amounts import implied
from scegen.concretization.aside import over_by_m
from scegen.concretization.deeds import stand
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import ahead_on_arm
from scegen.concretization.meetings import STRUCTURAL, Meeting
from scegen.concretization.profile import Sort
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.stationary import BLOCKS_AT_M, blocking_m, may_stay
from scegen.concretization.tale import SIDEWAYS, changes_before_turning, outward, pace_of
from scegen.concretization.things import lying_in_the_way, made_of, shape_of
from scegen.scenario.acts import GAINING, LEAVING, SLOWING, Act, ActKind, AfterAct
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS, Case
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.spacings import CONTACT, START
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import HazardKind, JunctionKind, Maneuver, Role

_BEND_RAD = 0.35
_LEAST_RUN_UP_M, _SPARE_M = 5.0, 10.0


def lay_on_arms(scene: Setup) -> list[Meeting]:
    """Lay what is done on each arm on which somebody leaves its lane; tells who is where when.

    So is what lies in the way there.
    """
    meetings: list[Meeting] = []
    lying = lying_in_the_way(scene.functional, scene.logical, scene.drives)
    owners = {thing.in_way_of for _, thing in lying}
    for arm in scene.road.arms:
        here = (draft for draft in scene.drives.values() if draft.drive.entry == arm.id)
        line = [draft for draft in here if _comes_along(draft) or draft.id in owners]
        names = {draft.id for draft in line}
        things = [thing for _, thing in lying if thing.in_way_of in names]
        dangers = list(_hazards(scene, names))
        causing = {n for hazard in dangers if _leaves_lane(hazard.kind) for n in hazard.by}
        if things or any(_goes_aside(scene, draft, causing) for draft in line):
            meetings += _put(scene, line, _story(scene, line, things))
    for hazard, thing in lying:
        scene.blame(thing, hazard)
    return meetings


def _comes_along(draft: DriveDraft) -> bool:
    """Whether somebody is on its arm at first: not in the ring, as if it had come from there."""
    in_ring = draft.drive.circulating and draft.drive.maneuver not in SIDEWAYS
    return draft.reversal is None and not in_ring


def _goes_aside(scene: Setup, draft: DriveDraft, causing: set[str]) -> bool:
    """Whether somebody leaves its lane before the junction, and has not done so yet.

    Who turns suddenly does so where its way bends; with no bend, it turns the wheel all the same.
    """
    if draft.lane_changes or blocking_m(scene, draft) or draft.stands or _passes_by(scene, draft):
        return False
    changes = changes_before_turning(scene.functional, draft.drive)
    if changes or draft.drive.maneuver in SIDEWAYS:
        return True
    heading = draft.path.heading_rad
    turns = HazardKind.SUDDEN_TURN in scene.kinds_by(draft.id)
    return draft.id in causing and not (turns and abs(heading - heading[0]).max() > _BEND_RAD)


def _passes_by(scene: Setup, draft: DriveDraft) -> bool:
    """Whether it "overtakes" only who is parked, or reverses into its way: in its own lane."""
    ahead = ahead_on_arm(scene, draft)
    drives = any(o.drive.beside is None and o.drive.reverses is None for o in ahead)
    arms = {draft.drive.entry, draft.drive.exit}
    there = bool(ahead) or any(s.motion.arm in arms for s in scene.stands.values())
    return draft.drive.maneuver is Maneuver.OVERTAKE and there and not drives


def _leaves_lane(kind: HazardKind) -> bool:
    return kind is HazardKind.SUDDEN_TURN or not LEAVING.isdisjoint(HAZARDS[kind].acts)


def _story(scene: Setup, line: Sequence[DriveDraft], things: Sequence[Thing]) -> Story:
    functional = _functional(scene, line, things)
    logical = _logical(scene, line, functional)
    story = story_of(functional, logical)
    # What one does to those of other arms happens where it meets them.
    inner = {by for hazard in logical.hazards if hazard.to for by in hazard.by}
    told = {act.id for act in logical.acts}
    story.acts = [
        a for a in story.acts if a.kind in LEAVING or a.participant in inner or a.id in told
    ]
    for thing in things:
        if not may_stay(scene, scene.drives[thing.in_way_of or ""]):
            story.acts += _round(story, story.runners[thing.id])
    lay(story)
    return story


def _round(story: Story, lies: Runner) -> list[Act]:
    """How those who come to a thing in their lane get past who do not leave that anyway."""
    aside = {act.participant for act in story.acts if act.kind in LEAVING}
    ranks, owner = story.ranks(), story.things[lies.id].in_way_of or ""
    return [
        implied("round", name, name, ActKind.SWERVE)
        for name, runner in story.people.items()
        if (runner.lane, runner.forward) == (lies.lane, lies.forward)
        and ranks[name] >= ranks[owner]
        and name not in aside
    ]


def _functional(
    scene: Setup, line: Sequence[DriveDraft], things: Sequence[Thing]
) -> FunctionalScenario:
    """What is said of those on an arm, with that as a road; without the ego the first is it."""
    whole, names = scene.functional, {draft.id for draft in line}
    people = [whole.participant(d.id).but(lanes=_lanes(scene, d)) for d in line]
    if whole.ego.id not in names:
        first, *rest = (p.but(approaches=frozenset(), role=Role.OTHER) for p in people)
        people = [first.but(role=Role.EGO), *rest]
    outcome = whole.outcome
    if outcome is not None and not ({*outcome.between} or {whole.ego.id}) <= names:
        outcome = None
    acts = tuple(_acts(scene, names))
    moments = {START, CONTACT, *(act.id for act in acts)}
    spacings = (s for s in whole.spacings if {s.participant, s.reference} <= names)
    return whole.but(
        junction=whole.junction.but(
            kind=JunctionKind.STRAIGHT, lanes=(scene.lanes_in(line[0]),), crosswalks=frozenset()
        ),
        participants=tuple(people),
        relations=tuple(r for r in whole.relations if {r.participant, r.reference} <= names),
        objects=tuple(things),
        hazards=tuple(_hazards(scene, names)),
        acts=acts,
        spacings=tuple(said for said in spacings if said.at in moments),
        outcome=outcome,
    )


def _lanes(scene: Setup, draft: DriveDraft) -> frozenset[int]:
    """The lanes in which one may start, so that it ends in one that leads where it goes."""
    leads, said = {*scene.entry_lanes(draft)}, scene.functional.participant(draft.id).lanes
    for_good = draft.drive.maneuver is Maneuver.LANE_CHANGE
    for_good |= HazardKind.CUT_IN in scene.kinds_by(draft.id)
    if for_good or changes_before_turning(scene.functional, draft.drive):
        side, count = draft.drive.changes_to, scene.lanes_in(draft)
        steps = (-1, 1) if side is None else (outward(scene.functional, side),)
        leads = {n - step for n in leads for step in steps if 1 <= n - step <= count} or leads
    return frozenset(leads & said if said else leads)


def _logical(
    scene: Setup, line: Sequence[DriveDraft], functional: FunctionalScenario
) -> LogicalScenario:
    names, drives = {draft.id for draft in line}, []
    for drive in (draft.drive for draft in line):
        beside = drive.maneuver in {*SIDEWAYS, Maneuver.STAY}
        changes = changes_before_turning(scene.functional, drive)
        along = Maneuver.LANE_CHANGE if changes else Maneuver.STRAIGHT
        drives.append(drive.but(entry=0, exit=1, maneuver=drive.maneuver if beside else along))
    conflicts = scene.logical.conflicts
    return scene.logical.but(
        assignments=tuple(drives),
        hazards=functional.hazards,
        acts=functional.acts,
        conflicts=tuple(c for c in conflicts if {c.first, c.second} <= names),
        parameters=tuple(
            pace_of(scene.functional, scene.logical, draft.id).but(low=mps, high=mps, default=mps)
            for draft in line
            for mps in (draft.speed_mps,)
        ),
    )


def _hazards(scene: Setup, names: set[str]) -> Iterator[Hazard]:
    """The dangers among those of an arm, and those by which one leaves its lane there."""
    for hazard in scene.functional.hazards:
        by, to = (tuple(n for n in who if n in names) for who in (hazard.by, hazard.to))
        if hazard.kind is HazardKind.ONCOMING_LANE:
            to = ()  # those on one arm do not face each other
        row, leaves = HAZARDS[hazard.kind], _leaves_lane(hazard.kind)
        together = to or not hazard.to or (leaves and Case.ONE_ARM not in row.needs)
        if by and together and (leaves or not (SLOWING | GAINING).isdisjoint(row.acts)):
            yield hazard.but(by=by, to=to)


def _acts(scene: Setup, names: set[str]) -> Iterator[Act]:
    """What they do by themselves, or as others of them do something."""
    known: set[str] = set()
    for act in scene.functional.acts:
        whom = {getattr(act.when, role, None) for role in ("participant", "reference")}
        alone = {act.participant, act.into, *whom} - {None} <= names
        after = isinstance(act.when, AfterAct) and act.when.act not in known
        if alone and not after and act.kind in LEAVING | SLOWING | GAINING:
            known.add(act.id)
            yield act


def _put(scene: Setup, line: Sequence[DriveDraft], story: Story) -> list[Meeting]:
    """On the arm, over before anybody slows down to turn; who is where when follows."""
    runners = {draft: _by_acts(story.runners[draft.id]) for draft in line}
    moves = [(runner, move) for runner in runners.values() for move in runner.moves]
    lying = [story.runners[name] for name in story.things]
    if not moves and not lying:
        return []
    first_s = min((move.begins_s for _, move in moves), default=FIRST_ACT_S)
    away_m = over_by_m(*line) - max(
        runner.x_m(move.ends_s) if move is not None else runner.ends_m(0.0)[1] + BLOCKS_AT_M
        for runner, move in moves or ((each, None) for each in lying)
    )
    for each in lying:
        _lay_thing(scene, story, each, each.x_m(0.0) + away_m)
    where: dict[str, float] = {}
    for draft, runner in runners.items():
        station_m = partial(_station_m, runner, away_m)
        _take_lanes(scene, draft, runner, station_m)
        if draft.stands:
            stand(draft, draft.laid.path_s_m(station_m(0.0)))
            continue
        if runner.speed_mps != draft.speed_mps:
            before, draft.speed_mps = draft.speed_mps, runner.speed_mps
            scene.note(f"{draft.id}.speed_mps", draft.speed_mps, "passes, or is passed", before)
        where[draft.id] = draft.laid.path_s_m(station_m(first_s))
        draft.steps = [
            replace(
                step,
                s_m=draft.laid.path_s_m(station_m(step.begins_s)),
                begins_s=0.0,
                act=step.act if step.act in {act.id for act in scene.acts} else None,
                sort=Sort.ACT,
            )
            for step in runner.steps
        ]
    return [
        Meeting(STRUCTURAL, one, other, one_m, other_m, 0.0, "as along a road")
        for (one, one_m), (other, other_m) in pairwise(where.items())
    ]


def _lay_thing(scene: Setup, story: Story, lies: Runner, station_m: float) -> None:
    """Put a thing on the arm of whom it lies in the way of, who may end its drive before it."""
    thing = story.things[lies.id]
    draft, shape = scene.drives[thing.in_way_of or ""], shape_of(thing)
    pose = scene.network.arm_road(draft.drive.entry).line.pose(station_m, lies.y_m(0.0))
    scene.objects.append(made_of(thing.id, shape, thing.called, pose))
    away = draft.laid.turning_starts_m - station_m
    scene.note(f"{thing.id}.from_junction_m", away, f"lies in the way of {draft.id}")
    if may_stay(scene, draft):
        draft.halts_s_m = draft.laid.path_s_m(station_m) - shape.length_m / 2 - draft.body.front_m


def _station_m(runner: Runner, away_m: float, time_s: float) -> float:
    return runner.x_m(time_s) + away_m


def _take_lanes(
    scene: Setup, draft: DriveDraft, runner: Runner, station_m: Callable[[float], float]
) -> None:
    """Lay a drive anew in the lanes of its story; in a ring in the one to which the last leads.

    Raises:
        NeedsLongerArms: the arm is too short for a run-up.
    """
    draft.entry_lane, draft.offset_m = runner.lane, runner.offset_m
    draft.lane_changes = list(written_changes(runner, station_m))
    for change in draft.lane_changes[:1]:
        require_room(draft.id, change.position_m, _LEAST_RUN_UP_M, _SPARE_M)
    last = [runner.lane, *(move.lane for move in runner.moves)][-1]
    rings = [way.ring_lane for way in scene.routes_of(draft) if way.entry_lane == last]
    if rings and draft.ring_lane not in rings:
        draft.ring_lane = rings[0]
    draft.lay(scene.network)


def _by_acts(runner: Runner) -> Runner:
    """One without what it does of its own accord for others: for whom all do so is found later."""
    acts = [step for step in runner.steps if step.act is not None or step.reacts_to is None]
    return replace(runner, steps=acts)
