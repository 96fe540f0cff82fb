"""Ranges of the parameters that concretization chooses from, as data."""

from collections.abc import Iterator

from scegen.scenario.acts import WhenMeasure
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import Assignment, ConflictKind, Drive, Standing
from scegen.scenario.model import FrozenModel, Interval
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.speed_limits import (
    FAST_FOR_KIND_MPS,
    comfortable_mps,
    driven_before_mps,
    implied_limit_mps,
    limit_for_kind_mps,
)
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver, ParticipantKind

Range = tuple[float, float, float, str]
"""Low, high, default, reason."""

KIND_SPEED_MPS: dict[ParticipantKind, Range] = {
    ParticipantKind.PEDESTRIAN: (0.8, 2.5, 1.4, "walking to running"),
    ParticipantKind.BICYCLE: (3.0, 8.0, 5.0, "cycling"),
    ParticipantKind.ANIMAL: (1.0, 9.0, 5.0, "trotting to running"),
    ParticipantKind.LARGE_ANIMAL: (1.5, 12.0, 7.0, "trotting to running"),
}
USUAL_SHARE: Range = (0.6, 1.0, 0.8, "usual")
CRUISING_SHARE: Range = (0.8, 1.0, 1.0, "cruising")
PASSED_SHARE: Range = (0.6, 1.0, 1.0, "cruising")
"""Where nobody turns, and where moreover somebody passes another, who is slower than that.

Free-flowing traffic goes about as fast as the limit, by the Highway Capacity Manual (6th edition,
chapter 12) a few km/h faster; none here breaks the limit unasked.
"""
MOST_FOR_KIND_MPS: dict[ParticipantKind, float] = {
    ParticipantKind.TRUCK: 90 / 3.6,
    ParticipantKind.BUS: 100 / 3.6,
}
"""What speed limitation devices let them drive (EU directives 92/6/EEC and 2002/85/EC)."""

_MOVES_MPS = 1.0

OFFSET_S: Range = (-2.0, 2.0, 0.0, "arrives at the conflict within 2 s of the ego")
AHEAD_OFFSET_S: Range = (-4.0, -1.0, -2.0, "arrives before the ego, on the same arm")
BEHIND_OFFSET_S: Range = (1.0, 4.0, 2.0, "arrives after the ego, on the same arm")
BESIDE_OFFSET_S: Range = (-0.5, 0.5, 0.0, "arrives beside the ego")


def speed_range(functional: FunctionalScenario, assignment: Assignment) -> ParameterRange:
    """How fast a moving participant may be."""
    participant = functional.participant(assignment.participant)
    stays = isinstance(assignment, Drive) and assignment.maneuver is Maneuver.STAY
    chosen = (0.0, 0.0, 0.0, "stays where it is") if stays else _speed(functional, participant)
    return _parameter(f"{participant.id}.speed_mps", chosen)


def _speed(functional: FunctionalScenario, participant: Participant) -> Range:
    if participant.speed_mps is not None:
        said = participant.speed_mps
        return said.low, said.high, (said.low + said.high) / 2, "stated"
    kind = participant.kind
    own = {hazard.kind for hazard in functional.hazards if participant.id in hazard.by}
    if kind in KIND_SPEED_MPS and not (kind in FAST_FOR_KIND_MPS and HazardKind.SPEEDING in own):
        return _before_acts(functional, participant, KIND_SPEED_MPS[kind])
    share = USUAL_SHARE
    if functional.junction.kind is JunctionKind.STRAIGHT:
        passing = any(Maneuver.OVERTAKE in p.maneuvers for p in functional.participants)
        share = PASSED_SHARE if passing else CRUISING_SHARE
    ordinary = share
    for hazard in functional.hazards:
        own_share = HAZARDS[hazard.kind].speed_share
        if own_share is not None and participant.id in hazard.by:
            share = (*own_share, str(hazard.kind).replace("_", " "))
    limit = limit_for_kind_mps(kind, implied_limit_mps(functional))
    if share is ordinary:
        limit = min(limit, MOST_FOR_KIND_MPS.get(kind, limit), comfortable_mps(functional))
    low, high, default, reason = share
    low, high, default = low * limit, high * limit, default * limit
    pace = functional.ego.speed_mps
    if share is ordinary and pace is not None and pace.low > _MOVES_MPS:
        # Who drives in line with the ego may be as slow as that is said to be.
        in_line = participant.approaches & {Approach.AHEAD, Approach.BEHIND}
        low, default = (min(low, pace.low), min(default, pace.high)) if in_line else (low, default)
    if share is ordinary:  # nobody drives away from who follows
        default = max([default, *_followed_mps(functional, participant)])
        high = max(high, default)
    reason = f"{reason}, limit {limit:.4g} m/s"
    return _before_acts(functional, participant, (low, high, default, reason))


def _followed_mps(functional: FunctionalScenario, participant: Participant) -> Iterator[float]:
    """How fast those are said to be whom somebody follows: the ego, or, as that, who is ahead."""
    ego, people = functional.ego, functional.participants
    followed = (
        [p for p in people if p.approaches == {Approach.AHEAD}] if participant is ego
        else [ego] if participant.approaches == {Approach.BEHIND}
        else []
    )  # fmt: skip
    yield from (p.speed_mps.low for p in followed if p.speed_mps is not None)


def _before_acts(functional: FunctionalScenario, participant: Participant, usual: Range) -> Range:
    """So that it can slow down, or speed up, to what is said."""
    least, most = driven_before_mps(functional, participant.id)
    low, high, default = (min(max(speed, least), most) for speed in usual[:3])
    return low, high, default, usual[3]


def offset_range(
    functional: FunctionalScenario, ego: Assignment, other: Assignment, kind: ConflictKind
) -> ParameterRange | None:
    """When another participant arrives, against the ego; None if the two never meet.

    Those whom a hazard puts together with the ego get a range even if their paths do not meet.
    """
    if isinstance(other, Standing):
        return None
    two = {other.participant, functional.ego.id}
    concerned = any(two <= {*h.by, *h.to} for h in functional.hazards)
    if kind is ConflictKind.NONE and not concerned:
        return None
    return _parameter(f"{other.participant}.arrival_offset_s", _offset(ego, other))


def _offset(ego: Assignment, other: Assignment) -> Range:
    if not (isinstance(ego, Drive) and isinstance(other, Drive) and ego.entry == other.entry):
        return OFFSET_S
    if ego.rank == other.rank:
        return BESIDE_OFFSET_S
    return AHEAD_OFFSET_S if other.rank < ego.rank else BEHIND_OFFSET_S


def _parameter(name: str, chosen: Range) -> ParameterRange:
    low, high, default, reason = chosen
    return ParameterRange(
        name=name, low=round(low, 3), high=round(high, 3), default=round(default, 3), reason=reason
    )


def said_numbers(functional: FunctionalScenario) -> tuple[ParameterRange, ...]:
    """What is said of acts, spacings, the outcome and sizes, alike in every scenario."""
    found: list[ParameterRange] = []
    for act in functional.acts:
        found += _quantities(act.id, act)
        if act.when is not None:
            found += _quantities(f"{act.id}.when", act.when)
    for index, spacing in enumerate(functional.spacings):
        found.append(_stated(f"spacing_{index}.{spacing.measure}", spacing.value))
    if functional.outcome is not None:
        found += _quantities("outcome", functional.outcome)
    sized = [(one.id, one.length_m, one.width_m) for one in functional.participants]
    sized += [(one.id, one.length_m, one.width_m) for one in functional.objects]
    for person in functional.participants:
        if person.green_delay_s is not None:
            found.append(_stated(f"{person.id}.green_delay_s", person.green_delay_s))
    for name, length, width in sized:
        found += [_stated(f"{name}.length_m", length)] if length is not None else []
        found += [_stated(f"{name}.width_m", width)] if width is not None else []
    return tuple(found)


def _quantities(name: str, said: FrozenModel) -> list[ParameterRange]:
    """The ranges among the fields; that of a measure is named after the measure."""
    return [
        _stated(f"{name}.{said.measure if isinstance(said, WhenMeasure) else field}", value)
        for field, value in said
        if isinstance(value, Interval)
    ]


def _stated(name: str, value: Interval) -> ParameterRange:
    return _parameter(name, (value.low, value.high, value.middle, "stated"))
