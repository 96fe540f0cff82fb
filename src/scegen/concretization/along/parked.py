"""Who is parked beside the lanes: before whom it hides, else along the way; and doors that open.

To everybody along the road one that opens a door on the side of the traffic is the ground over
which that swings, from the moment on at which it opens.
"""

from dataclasses import replace

from scegen.concretization.along.crossing import BEFORE_WALKER_M
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import Story
from scegen.concretization.profile import NEVER_S
from scegen.concretization.tale import outward
from scegen.motion.doors import REACH_M, hinge_ahead_m
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.bodies import BODIES, Body
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import START, Measure
from scegen.scenario.vocabulary import HazardKind, ParticipantKind, Side

_BETWEEN_M = 1.2
_PASSED_AT_S = 5.0
_DOOR = BODIES[ParticipantKind.DOOR]
_OPENS_S = 0.8
_IN_THE_WAY_M = 0.3
"""By so much it reaches into the way of who comes along: one rides or drives as near as that."""


def park(story: Story) -> None:
    """Give all who are parked their places, in rows.

    Before those whom they hide, around one that opens its door, and others along the way. Who
    stands in another lane and hides somebody stands so, too, if nothing else tells where.
    """
    hiding = {name for hazard in story.of_kind(HazardKind.OCCLUSION) for name in hazard.by}
    doors = {r.id for r in story.runners.values() if r.opens} - hiding
    opened = {r.on_left: name for name, r in story.parked.items() if name in doors}
    told = {name for s in story.functional.spacings for name in (s.participant, s.reference)}
    standing = story.parked | {
        name: runner
        for name, runner in story.runners.items()
        if story.walks and name in hiding - told and runner.stands and not _leads(story, runner)
    }
    rows: dict[tuple[int, bool, str], list[Runner]] = {}
    for name, runner in standing.items():
        left = runner.on_left
        # Whom it hides: who sets off from its side; from anywhere if it is said to hide somebody.
        hides = name in hiding
        walks = [w for w in story.walks.values() if w.from_left == left]
        walks += story.walks.values() if hides else ()
        walk = walks[0] if walks and (hides or not hiding) else None
        before = opened.get(left) if not hides else None
        before = before or (walk.id if walk is not None else "")
        lane = 0 if name in story.parked else runner.lane
        rows.setdefault((lane, left and bool(before), before), []).append(runner)
    for (_, _, name), row in rows.items():
        _in_a_row(story, row, name)


def _leads(story: Story, runner: Runner) -> bool:
    """Whether it stands in the ego's lane: how far ahead, the ego's answer tells."""
    return (runner.lane, runner.forward) == (story.ego.lane, story.ego.forward)


def _in_a_row(story: Story, row: list[Runner], before: str) -> None:
    """In the order in which they are passed, from the one on whose place something depends."""
    bodies = [runner.body for runner in row]
    first, middle, sense = 0, story.ego.x_m(_PASSED_AT_S), 1
    walk = story.walks.get(before)
    if walk is not None:
        sense = -story.runners[walk.meets].sign
        away = (walk.body.width_m + bodies[0].length_m) / 2 + BEFORE_WALKER_M
        middle = walk.x_m + sense * away
    elif before:
        door = story.runners[before]
        first = next(n for n, runner in enumerate(row) if runner.id == before)
        middle, sense = middle_m(door, bodies[first]), door.sign
    else:
        first, middle = _said_m(story, row) or (first, middle)
    for n, runner in enumerate(row):
        between = bodies[min(n, first) + 1 : max(n, first)]
        away = (bodies[n].length_m + bodies[first].length_m) / 2 + _BETWEEN_M
        away += sum(body.length_m + _BETWEEN_M for body in between)
        x = middle + sense * ((n > first) - (n < first)) * away
        runner.at_m = x - runner.sign * runner.body.centre_ahead_m


def passes_s(story: Story) -> float:
    """When the ego has passed all of whom it is said how far ahead they stand."""
    known = [p for name, p in story.parked.items() if _ahead_m(story, name) is not None]
    said = [p.middle_m(0.0) - story.ego.x_m(0.0) for p in known]
    moments = map(story.ego.profile.time_s, said)
    return max((moment for moment in moments if moment < NEVER_S), default=0.0)


def _said_m(story: Story, row: list[Runner]) -> tuple[int, float] | None:
    """Of whom in a row it is said how far from the ego it is at first, and its place."""
    for n, runner in enumerate(row):
        ahead_m = _ahead_m(story, runner.id)
        if ahead_m is not None:
            return n, story.ego.ends_m(0.0)[1] + ahead_m + runner.body.length_m / 2
    return None


def _ahead_m(story: Story, name: str) -> float | None:
    """How far ahead of the ego's front somebody is said to stand at first."""
    said = story.between(name, story.ego.id, Measure.GAP_M)
    return said.value.middle if said is not None and said.at == START else None


def opens(functional: FunctionalScenario) -> dict[str, Act]:
    """Who is parked and opens a door, and the act."""
    parked = {p.id for p in functional.participants if p.parked}
    acts = (act for act in functional.acts if act.participant in parked)
    return {act.participant: act for act in acts if act.kind is ActKind.OPEN_DOOR}


def cast_doors(story: Story) -> None:
    """Add those who open a door to those along the road; lanes come later."""
    box = replace(_DOOR, length_m=_DOOR.width_m, width_m=REACH_M)
    for name, vehicle in story.parked.items():
        if name in opens(story.functional):
            door = story.made(name, ParticipantKind.DOOR, box, forward=vehicle.forward, thing=True)
            story.runners[name] = door


def is_one_way(story: Story) -> bool:
    """Whether everybody on the road goes the same way."""
    return story.functional.junction.carriageway is Carriageway.ONE_WAY


def inner_doors(story: Story) -> set[str]:
    """Who opens a door beside the innermost lane: on the other side of a one-way road."""
    names = opens(story.functional).keys() & story.parked.keys() if is_one_way(story) else ()
    return {name for name in names if story.stands_left(name) != story.ego.keeps_left}


def hang_doors(story: Story) -> None:
    """Put doors beside the lane next to them, and those whom they endanger within their reach."""
    functional, runners = story.functional, story.runners
    for name, door in ((name, r) for name, r in runners.items() if r.opens):
        vehicle = story.parked[name]
        inner = name in inner_doors(story)
        inward = outward(functional, Side.LEFT) * (1 if inner else -1)
        door.lane = 1 if inner else story.lane_count
        beside_m = abs(vehicle.y_m(0.0) - door.lane_y_m(door.lane)) - vehicle.body.width_m / 2
        tip = REACH_M - beside_m
        door.offset_m = inward * (tip - REACH_M / 2)
        for other in (runners[n] for n in endangered(functional, name) if n in runners):
            said = any(
                spacing.measure is Measure.LATERAL_GAP_M
                and other.id in {spacing.participant, spacing.reference}
                for spacing in functional.spacings
            )
            most = tip - _IN_THE_WAY_M + other.body.width_m / 2
            if other.lane == door.lane and other.forward == door.forward and not said:
                other.offset_m = inward * min(inward * other.offset_m, most)


def endangered(functional: FunctionalScenario, name: str) -> set[str]:
    """Who comes along where somebody opens a door: who suffers it, or is to touch it."""
    found = {to for hazard in functional.hazards if name in hazard.by for to in hazard.to}
    between = functional.outcome.between if functional.outcome is not None else ()
    touching = {*between} - {name} if name in between else set()
    return found or touching or {functional.ego.id}


def door_before(story: Story, who: str) -> Runner | None:
    """The door that opens before somebody, None if none does."""
    doors = sorted((r for r in story.runners.values() if r.opens), key=lambda r: r.id)
    return next((r for r in doors if who in endangered(story.functional, r.id)), None)


def middle_m(door: Runner, vehicle: Body) -> float:
    """Where the middle of the vehicle lies along the road whose door it is."""
    return door.x_m(0.0) + door.sign * (_DOOR.width_m / 2 - hinge_ahead_m(vehicle))


def opening_s(act: Act) -> float:
    """How long a door takes to open."""
    return _OPENS_S if act.duration_s is None else act.duration_s.middle
