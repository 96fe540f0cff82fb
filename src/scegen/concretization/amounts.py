"""By how much: the speed at which an act ends, and how fast its speed changes on the way."""

from collections.abc import Collection, Sequence
from math import pi, sqrt

from scegen.concretization.limits import (
    COMFORTABLE_ACCELERATION_MPS2,
    HARD_BRAKING_MPS2,
    LATE_BRAKING_MPS2,
    STOPPING_MPS2,
    SUDDEN_ACCELERATION_MPS2,
)
from scegen.concretization.profile import Sort, SpeedChange
from scegen.concretization.tale import Tale
from scegen.scenario.acts import (
    GAINING,
    LEAVING,
    LETS_BY,
    SLOWING,
    Act,
    ActKind,
    AfterAct,
    AfterStart,
    When,
)
from scegen.scenario.bodies import Body
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import HazardKind, Side

OUT_AND_BACK = frozenset({ActKind.SWERVE, ActKind.OVERTAKE})
BRAKING = frozenset({HazardKind.HARD_BRAKING, HazardKind.DELAYED_BRAKING})
"""The dangers that the braking of who comes up behind somebody may be."""
CLOSEST_M = 0.65
"""How near one who may not touch the other comes: a near miss."""
CHANGES_MPS = 8.0
"""By how much speed changes where nobody says."""
_HARDER = (1.0, 1.2, 1.4, 9.0)
_OF_GRIP, _ASIDE = 0.95, 0.8
_RATES_MPS2: dict[HazardKind | None, float] = {
    HazardKind.HARD_BRAKING: HARD_BRAKING_MPS2[0],
    HazardKind.LOSS_OF_CONTROL: HARD_BRAKING_MPS2[0],
    HazardKind.SUDDEN_ACCELERATION: SUDDEN_ACCELERATION_MPS2[0],
}

AS_LONG_AS_NEEDED_S = Interval(low=0.0, high=60.0)
"""How long one waits where the text does not say."""


def overlapping_m(percent: float, one: Body, other: Body) -> float:
    """How far apart the middles of two are of whom so much of the other's width overlaps."""
    if percent >= 100:
        return 0.0
    return (one.width_m + other.width_m) / 2 - percent / 100 * other.width_m


def spelled_out(acts: Sequence[Act], by_rules: Collection[str] = ()) -> tuple[Act, ...]:
    """The acts, those of who waits told as stopping and setting off so much later.

    Who gives way to one of ``by_rules`` does so by the rules of the road, so that is no act here.

    The stop keeps the name of the wait; what sets it off next, if that is an act of the text whose
    moment is not said, begins when the wait is over.
    """
    ruled = {act.id for act in acts if act.kind in LETS_BY and act.into in by_rules}
    acts = [  # what is set off by no act here begins whenever it may
        act.but(when=None) if getattr(act.when, "act", None) in ruled else act
        for act in acts
        if act.id not in ruled
    ]
    found: list[Act] = []
    over: dict[str, AfterAct] = {}
    stands = {act.id: act.duration_s or AS_LONG_AS_NEEDED_S for act in acts if act.kind in LETS_BY}
    for n, act in enumerate(acts):
        when = act.when
        if isinstance(when, AfterAct) and when.act in stands and when.since == "end":
            delay = Interval(
                low=when.later_s.low + stands[when.act].low,
                high=when.later_s.high + stands[when.act].high,
            )
            act = act.but(when=when.but(delay_s=delay))  # noqa: PLW2901
        waited = over.pop(act.participant, None)
        if waited is not None and (act.kind is ActKind.SET_OFF or act.when is None):
            act = act.but(when=waited)  # noqa: PLW2901
        if act.kind not in LETS_BY:
            found.append(act)
            continue
        found.append(act.but(kind=ActKind.STOP, duration_s=None))
        on = AfterAct(act=act.id, since="end", delay_s=stands[act.id])
        later = next((a for a in acts[n + 1 :] if a.participant == act.participant), None)
        if later is not None and later.kind is ActKind.SET_OFF:
            over[act.participant] = on
        else:
            found.append(implied("over", act.id, act.participant, ActKind.SET_OFF, when=on))
    return tuple(found)


def implied(
    what: str, of: str, who: str, kind: ActKind, *, when: When | None = None,
    into: str | None = None, side: Side | None = None,
) -> Act:  # fmt: skip
    """An act that no word tells, named by what it is and of whom, or of which act."""
    name = f"{what}_of_{of}"[:40]
    return Act(id=name, participant=who, kind=kind, when=when, into=into, side=side)


def goes_on_when_free(when: When | None) -> bool:
    """Whether somebody who waits goes on as soon as nobody is in the way any more."""
    return isinstance(when, AfterAct) and when.delay_s == AS_LONG_AS_NEEDED_S


def change_of_speed(
    tale: Tale, act: Act, body: Body, before_mps: float, usual_mps: float
) -> SpeedChange:
    """The change of speed that an act is: as the text says, else as is usual.

    Args:
        tale: what is told.
        act: a change of speed.
        body: whose limits hold.
        before_mps: the speed at which it begins.
        usual_mps: how fast one who sets off becomes, where nobody says.
    """
    hazard = tale.hazard_of(act)
    rate = act.rate_mps2.middle if act.rate_mps2 else None
    target = _target_mps(act, before_mps, body, rate, usual_mps)
    if falls_back(act) and _goes_on(tale, act):
        target = max(before_mps - CHANGES_MPS, before_mps / 2)
    change = abs(target - before_mps)
    if rate is None and act.duration_s is not None and change > 0.1:
        rate = change / max(act.duration_s.middle, 0.1)
    if rate is None and act.distance_m is not None and change > 0.1:
        rate = abs(target**2 - before_mps**2) / (2 * max(act.distance_m.middle, 0.1))
    if rate is None:
        best = body.max_acceleration_mps2 if act.kind in GAINING else body.max_deceleration_mps2
        usual = STOPPING_MPS2 if act.kind in SLOWING else COMFORTABLE_ACCELERATION_MPS2
        usual = _RATES_MPS2.get(hazard, usual)
        rate = min(usual, best, _OF_GRIP * tale.grip_mps2)
    timed = isinstance(act.when, AfterStart)
    return SpeedChange(target, rate, act=act.id, hazard=hazard, sort=Sort.ACT, timed=timed)


def _goes_on(tale: Tale, act: Act) -> bool:
    """``brakes and then changes lanes``, ``and then brakes harder``: it does not stop."""
    later = tale.acts[tale.acts.index(act) + 1 :] if act in tale.acts else ()
    own = [each.kind for each in later if each.participant == act.participant]
    return bool(own) and own[0] in LEAVING | SLOWING | GAINING - {ActKind.SET_OFF}


def _target_mps(
    act: Act, before_mps: float, body: Body, rate: float | None, usual_mps: float
) -> float:
    if act.target_speed_mps is not None:
        return act.target_speed_mps.middle
    if act.duration_s is not None and rate is not None:
        change = rate * act.duration_s.middle
        return max(0.0, before_mps + (change if act.kind in GAINING else -change))
    if act.kind is ActKind.ACCELERATE:
        return min(before_mps + CHANGES_MPS, body.top_speed_mps)
    return usual_mps if act.kind is ActKind.SET_OFF else 0.0


def hardest_mps2(body: Body, grip_mps2: float) -> float:
    """How hard somebody can brake."""
    return min(body.max_deceleration_mps2, _OF_GRIP * grip_mps2)


def falls_back(act: Act) -> bool:
    """Whether one brakes of whom nobody says how far: no more than the one ahead makes it."""
    said = (act.target_speed_mps, act.duration_s, act.distance_m)
    return act.kind is ActKind.BRAKE and all(each is None for each in said)


def answering_rates_mps2(act: Act | None, most_mps2: float, *, hard: bool) -> list[float]:
    """How hard one may brake for another, the usual first; none more than ``most_mps2``.

    Only as hard as the text says, if its own ``act`` is that braking and says so.
    """
    if act is not None and act.rate_mps2 is not None:
        return [act.rate_mps2.middle]
    usual = HARD_BRAKING_MPS2[0] if hard else LATE_BRAKING_MPS2
    return sorted({min(usual * harder, most_mps2) for harder in _HARDER})


def lasting_s(act: Act | None, width_m: float, usual_s: float, grip_mps2: float) -> float:
    """How long a move to the side takes, as said, or as is usual and the tyres hold.

    It is a cosine: its greatest speed is pi/2 of its mean.
    """
    if act is not None and act.duration_s is not None:
        return max(act.duration_s.middle, 0.2)
    if act is not None and act.lateral_mps is not None:
        return width_m * pi / 2 / max(act.lateral_mps.middle, 0.1)
    return max(usual_s, gripped_s(width_m, grip_mps2))


def gripped_s(width_m: float, grip_mps2: float) -> float:
    """How long a move to the side must take for the tyres to hold."""
    return pi * sqrt(width_m / (2 * _ASIDE * grip_mps2))
