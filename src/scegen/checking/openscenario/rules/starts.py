"""Everybody starts where the concrete scenario says."""

from collections.abc import Iterator

from scegen.checking.opendrive.arms import Arm
from scegen.checking.opendrive.locate import OnLane, in_words
from scegen.checking.openscenario.rules.paths import BESIDE_M
from scegen.checking.openscenario.situation import Situation
from scegen.checking.results import Finding, error, unchecked
from scegen.scenario.concrete import (
    ConcreteParticipant,
    CrossingMotion,
    DriveMotion,
    SwingingMotion,
)
from scegen.scenario.reversing import BacksOut

RULE = "xosc.start"
_ENDS = 2


def check_starts(situation: Situation) -> Iterator[Finding]:
    """``xosc.start``: each entity is placed; drivers on their entry lane, the rest at their arm.

    The numbers beyond the driving lanes are those of the strips beside them.
    """
    starts = {
        entity.name: situation.in_world(situation.storyboard.starts.get(entity.name))
        for entity in situation.storyboard.entities
    }
    placed = [(name, position) for name, position in starts.items() if position is not None]
    under = dict(
        zip((n for n, _ in placed), situation.lanes_at([p for _, p in placed]), strict=True)
    )
    for entity in situation.storyboard.entities:
        position = starts[entity.name]
        if position is None:
            if situation.network is not None:
                found = unchecked if situation.concrete is None else error
                message = "Init does not teleport it to a position that can be placed"
                yield found(RULE, entity.name, message)
            continue
        lanes = under[entity.name]
        participant = situation.participant(entity.name)
        if participant is not None and situation.arms:
            if not _by_ramp(participant, situation, lanes):
                yield from _where_asked(participant, situation.arms, lanes)
        elif entity.kind == "Vehicle" and situation.network is not None and not lanes:
            yield error(RULE, entity.name, "starts on no lane of the road network")


def _by_ramp(participant: ConcreteParticipant, situation: Situation, lanes: list[OnLane]) -> bool:
    """Whether one starts where a ramp is: on it or past it; in its lane only if that is asked."""
    motion, ramp = participant.motion, situation.ramp
    if ramp is None or not isinstance(motion, DriveMotion):
        return False
    aside = motion.entry_lane > len(situation.arms[motion.entry].inward)
    onward = situation.arms[motion.exit]
    through = {(onward.road.id, lane) for lane in onward.outward}
    arms = {arm.road.id for arm in situation.arms.values()}
    for lane in lanes:
        if aside and (lane.road == onward.road.id and (lane.road, lane.lane) not in through):
            return lane.type == "driving"
        if lane.road not in arms and (aside or lane.road != ramp.road.id):
            return True
    return False


def _where_asked(
    participant: ConcreteParticipant, arms: dict[int, Arm], lanes: list[OnLane]
) -> Iterator[Finding]:
    motion = participant.motion
    reversal = motion.reversal if isinstance(motion, DriveMotion) else None
    if isinstance(motion, CrossingMotion | SwingingMotion):
        return  # starts outside the carriageway: its path is checked instead
    number = motion.entry if isinstance(motion, DriveMotion) else motion.arm
    if isinstance(reversal, BacksOut):
        if reversal.arm is None:
            return  # likewise
        number = reversal.arm
    arm = arms[number]
    if isinstance(motion, DriveMotion) and (
        abs(motion.offset_m) > BESIDE_M or not motion.entry_lane
    ):
        return  # beside its lane, or against the traffic: its path is checked instead
    here = [lane for lane in lanes if lane.road == arm.road.id]
    if not here and isinstance(motion, DriveMotion) and _further_on(motion, arms, lanes):
        return
    if not here:
        message = f"starts on {in_words(lanes)} instead of arm {number} ({arm.place})"
        yield error(RULE, participant.id, message)
        return
    if isinstance(motion, DriveMotion):
        out = isinstance(reversal, BacksOut)
        wanted = {*arm.outward} if out else arm.numbered_in(motion.entry_lane)
        if not wanted & {lane.lane for lane in here}:
            message = f"starts on lane {here[0].lane} of {arm.place}, not on {sorted(wanted)}"
            yield error(RULE, participant.id, message)
    elif motion.in_lane and all(lane.type != "driving" for lane in here):
        message = f"should block a lane of {arm.place} but stands beside it"
        yield error(RULE, participant.id, message)


def _further_on(motion: DriveMotion, arms: dict[int, Arm], lanes: list[OnLane]) -> bool:
    """A road without a junction is one road: in the same lane, beyond where its two arms join."""
    if len(arms) != _ENDS or isinstance(motion.reversal, BacksOut):
        return False
    beyond = arms[motion.exit]
    return bool(beyond.under(lanes) & beyond.numbered_out(motion.entry_lane))
