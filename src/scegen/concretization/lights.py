"""Traffic lights: a plan under which those in danger meet as they are to, and others wait.

The plan is laid around whoever is placed first, the ego and those whom it meets in danger; whoever
comes later stands at the line while it has red, and goes with its green. Where the text says how
somebody meets a light, it is laid once more around everybody, when all times are known.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from math import isfinite
from typing import NamedTuple

import numpy as np

from scegen.concretization.drafts import DriveDraft, Wait
from scegen.concretization.setup import Setup
from scegen.concretization.walkers import leaves_s
from scegen.motion.rules.intergreen import (
    LEAST_GREEN_AFOOT_S,
    LEAST_GREEN_S,
    all_red_s,
    amber_s,
    walked_s,
)
from scegen.motion.rules.lights import at_lights, green_phases, light_runners, must_obey
from scegen.scenario.control import LIGHTS, oncoming_arms
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.signals import AtLight, SignalGroup, SignalPlan
from scegen.scenario.vocabulary import ANIMALS, Control, JunctionKind

_ROOM_S: Mapping[AtLight, tuple[float, float]] = {
    AtLight.GREEN: (3.0, 2.5),
    AtLight.AMBER: (0.8, 0.8),
    AtLight.RED: (1.5, 1.5),
    AtLight.WAITS: (0.8, 0.8),
    AtLight.STOPS: (0.3, 0.8),
}
"""For how long the light has shown it, and shows it yet, where that can be."""
_WITHIN_S: Mapping[AtLight, float] = {AtLight.WAITS: 2.5, AtLight.STOPS: 1.5}
"""Who waits goes on so soon after green, who stops brakes so soon after amber.

1 s to react to amber: FHWA, Signal Timing Manual (2008), 5.4.1; quoted from memory.
"""
_STEP_S = 0.25
_STARTS_S = 1.0
"""Lost time of the first in a queue, 1 to 2 s: FHWA, Signal Timing Manual (2008), 3.3."""
_LATE_S = 0.3
WAITS_S, STOOD_S = 4.0, 100.0
"""Who is said to wait for green stands so long; and who stands there when it begins."""
_LEAST_WAIT_S = 0.5
_STARTING_WAVE_MPS = 5.0
"""Of those who queue one sets off after the other, about 18 km/h backwards."""
_TO_THE_LINE_S = 4.0
"""Who sets off late is over the line so soon after."""
_FEW = 1e-3
_EXACTLY = 10.0
"""So much more than room counts it that one sets off when that is said."""


def wait_for_green(scene: Setup, draft: DriveDraft, line: Sequence[DriveDraft] = ()) -> None:
    """Let a drive stand at its line until green where there are lights: at red, or if it is said.

    Those of a ``line`` who wait for green set off one after the other. Who runs into one that
    stands on its arm comes no farther.
    """
    plan, functional = scene.signals, scene.functional
    if plan is None:
        return
    draft.waits = None
    group = plan.group_of(draft.drive.entry)
    obeys = draft.id in must_obey(functional, scene.logical)
    if group is None or not obeys or scene.runs_into_standing(draft.id):
        return
    since = (crosses_s(draft) - group.green_from_s) % plan.cycle_s
    waits = functional.participant(draft.id).light is AtLight.WAITS
    if since < group.green_s - _LATE_S and not waits:
        return
    delay_s = _green_delays_s(functional).get(draft.id)
    goes = crosses_s(draft) + plan.cycle_s - since
    goes += _STARTS_S + draft.queues_m / _STARTING_WAVE_MPS if delay_s is None else delay_s
    for mate in line if waits and delay_s is None else ():
        starts = mate.course.going_on if scene.waits_for_green(mate.id) else None
        if starts is not None:
            behind_m = draft.queues_m - mate.queues_m
            goes = mate.offset_s + starts.begins_s + behind_m / _STARTING_WAVE_MPS
    # One that sets off late has stood for longer: it came to rest before green.
    least = _LEAST_WAIT_S if delay_s is None else delay_s + _STARTS_S
    draft.waits = Wait(least)
    again = draft.course.going_on
    longer = goes - (draft.offset_s + again.begins_s) if again is not None else 0.0
    draft.waits = Wait(least + max(0.0, longer))


def crosses_s(draft: DriveDraft) -> float:
    """When its front goes over the line."""
    return draft.offset_s + draft.course.time_at(draft.stop_line_s_m - draft.body.front_m)


class _Shown(NamedTuple):
    """What the light of an arm is to show at a time, for who drives or for who crosses it.

    ``after_s``: so long after green has begun, where that is said.
    """

    arm: int
    afoot: bool
    time_s: float
    wanted: AtLight
    after_s: float | None = None
    who: str = ""


def lay_lights(scene: Setup, placed: Collection[DriveDraft]) -> None:
    """Lay the plan under which those who are placed pass as they are to, where there are lights.

    Of plans of equal green the one that suits them best, and gives the others green soonest.
    """
    if scene.road.control not in LIGHTS or scene.road.kind is JunctionKind.STRAIGHT:
        return
    scene.signals = _plan(scene, green_phases(scene.functional, scene.logical))
    if scene.signals.working:
        scene.signals = _suiting(scene.signals, list(_driven(scene, placed)))


def _green_delays_s(functional: FunctionalScenario) -> dict[str, float]:
    """How long after green those set off of whom it is said."""
    said = ((p.id, p.green_delay_s) for p in functional.participants)
    return {name: delay.middle for name, delay in said if delay is not None}


def _driven(scene: Setup, placed: Collection[DriveDraft]) -> Iterator[_Shown]:
    """Of those who drive and are placed, as is said, or as the rules want it."""
    functional, logical = scene.functional, scene.logical
    runners, obeying = light_runners(functional, logical), must_obey(functional, logical)
    delays = _green_delays_s(functional)
    for name in at_lights(functional, logical):
        said, draft = functional.participant(name).light, scene.drives.get(name)
        if draft is None or draft not in placed or draft.stands:
            continue
        course, late, time_s = draft.course, draft.offset_s, crosses_s(draft)
        wanted = AtLight.RED if name in runners else said
        if wanted is None and name in obeying:
            wanted = AtLight.GREEN
        elif wanted is AtLight.WAITS:
            time_s = late + course.going_on.begins_s if course.going_on is not None else np.inf
        elif wanted is AtLight.STOPS:
            time_s = late + course.stop.begins_s if course.stop is not None else np.inf
        if wanted is not None and isfinite(time_s):
            after_s = delays.get(name)
            yield _Shown(draft.drive.entry, False, time_s, wanted, after_s, name)


def _walked(scene: Setup) -> Iterator[_Shown]:
    """Of those who cross an arm, as is said: as their front comes over the kerb."""
    for walk in scene.walks.values():
        wanted = scene.functional.participant(walk.id).light
        if wanted is not None:
            way_m = walk.setback_m - walk.body.front_m
            time_s = leaves_s(scene, walk.id) + walk.runs_s(max(way_m, 0.0))
            yield _Shown(walk.crossing.arm, afoot=True, time_s=time_s, wanted=wanted)


def _suiting(plan: SignalPlan, shown: Iterable[_Shown]) -> SignalPlan:
    """The plan so much later that it shows what it is to, as well as it can."""
    best, best_worth = plan, -np.inf
    shown = list(shown)
    exact = [_early_s(plan, each) for each in shown if each.after_s is not None]
    for late in (*exact, *np.arange(0.0, plan.cycle_s, _STEP_S)):
        tried = shifted(plan, float(late))
        worth = sum(_worth(tried, each) for each in shown)
        if worth > best_worth + _FEW:
            best, best_worth = tried, worth
    return best


def _early_s(plan: SignalPlan, shown: _Shown) -> float:
    """By how much a plan is too early for green to begin so long before; below 0: too late."""
    group = plan.group_of(shown.arm, afoot=shown.afoot)
    begins_s = 0.0 if group is None else group.green_from_s
    late_s = shown.time_s - (shown.after_s or 0.0) - begins_s
    return (late_s + plan.cycle_s / 2) % plan.cycle_s - plan.cycle_s / 2


def shifted(plan: SignalPlan, later_s: float) -> SignalPlan:
    """The plan with everything so much later."""
    groups = tuple(
        group.but(green_from_s=round((group.green_from_s + later_s) % plan.cycle_s, 3))
        for group in plan.groups
    )
    return plan.but(groups=groups)


def _plan(scene: Setup, phases: tuple[int, ...]) -> SignalPlan:
    """Every phase in turn, with the shortest times between them that keep them apart."""
    amber = amber_s(max(arm.speed_limit_mps for arm in scene.road.arms))
    between = amber + all_red_s(scene.network, phases, amber)
    numbers = sorted(set(phases))
    # Who crosses goes while nobody comes straight; who turns across has green with it, and yields.
    kinds = {p.id: p.kind for p in scene.functional.participants}
    people = (c for c in scene.logical.crossings if kinds[c.participant] not in ANIMALS)
    crossed = sorted({crossing.arm for crossing in people})
    afoot_s = max((walked_s(scene.network, a) for a in crossed), default=0.0) + LEAST_GREEN_AFOOT_S
    green = max(LEAST_GREEN_S, afoot_s - between) if crossed else LEAST_GREEN_S
    late_s = max(_green_delays_s(scene.functional).values(), default=0.0)
    green = max(green, late_s + _TO_THE_LINE_S) if late_s else green
    groups = [
        SignalGroup(
            id=number + 1,
            arms=frozenset(arm for arm, phase in enumerate(phases) if phase == number),
            green_from_s=place * (green + between),
            green_s=green,
        )
        for place, number in enumerate(numbers)
    ]
    oncoming = oncoming_arms(scene.functional.junction)
    for arm in crossed:
        kept = {phases[arm], *(phases[one] for one, other in oncoming if other == arm)}
        free = [n for n in numbers if n not in kept]
        if not free:
            continue
        first = next((n for n in free if numbers[numbers.index(n) - 1] in kept), free[0])
        begins = numbers.index(first)
        turns = [numbers[(begins + n) % len(numbers)] not in kept for n in range(len(numbers))]
        lasts = turns.index(False) * (green + between)
        groups.append(
            SignalGroup(
                id=len(groups) + 1,
                arms=frozenset({arm}),
                green_from_s=begins * (green + between),
                green_s=lasts - walked_s(scene.network, arm),
                afoot=True,
            )
        )
    return SignalPlan(
        cycle_s=len(numbers) * (green + between),
        amber_s=amber,
        groups=tuple(groups),
        working=scene.road.control is Control.SIGNALS,
    )


def _worth(plan: SignalPlan, shown: _Shown) -> float:
    """How well a plan shows what is wanted at a time; below 0: not at all (s)."""
    group = plan.group_of(shown.arm, afoot=shown.afoot)
    if group is None:
        return 0.0
    since = (shown.time_s - group.green_from_s) % plan.cycle_s
    if shown.after_s is not None:
        return 2 * plan.cycle_s - 10 * _EXACTLY * abs(_early_s(plan, shown))
    begins, ends = plan.window_s(group, shown.wanted)
    ends = min(ends, begins + _WITHIN_S.get(shown.wanted, ends))
    after, before = _ROOM_S[shown.wanted]
    if begins <= since < ends:
        # What is more than enough counts a little against it: others wait for the rest.
        kept = min(since - begins - after, ends - since - before, 0.0)
        return 2 * plan.cycle_s + 10 * kept - (ends - since) * _FEW * 10
    missed = min((begins - since) % plan.cycle_s, (since - ends) % plan.cycle_s)
    return -missed


def set_lights(scene: Setup) -> None:
    """The plan on the scenario's clock."""
    if scene.signals is None:
        return
    scene.signals = shifted(scene.signals, scene.ego.offset_s)
    # An ego that stands all the time has no place on the clock by which the plan was laid.
    if scene.ego.stands or any(p.light is not None for p in scene.functional.participants):
        shown = [*_driven(scene, scene.drives.values()), *_walked(scene)]
        scene.signals = _suiting(scene.signals, shown)
