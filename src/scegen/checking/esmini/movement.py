"""What esmini played, against physics and against the concrete scenario."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from scegen.checking.esmini.recording import Movement
from scegen.checking.opendrive.arms import Arm, match_arms, ramp_of
from scegen.checking.opendrive.locate import lanes_at
from scegen.checking.opendrive.network import Network
from scegen.checking.results import Finding, error, warning
from scegen.scenario.concrete import (
    ConcreteParticipant,
    ConcreteScenario,
    CrossingMotion,
    DriveMotion,
    StandingMotion,
)
from scegen.scenario.reversing import BacksOut
from scegen.scenario.vocabulary import ON_FOOT
from scegen.scenario.wording import with_article

JUMP_M = 0.05
"""How much farther than its speed allows an entity may move in one step."""
LEAST_STEP_M = 0.005
"""Less movement in a step than this has no direction."""
TURNS_MPS = 0.6
"""Faster than this nobody goes from forwards to backwards."""
STILL_MPS = 0.05
"""Slower than this counts as standing."""
SPARE_MPS2 = 0.5
"""How far an acceleration may exceed what the body or the program allows (rounding)."""


def check_movements(
    movements: list[Movement],
    network: Network | None,
    concrete: ConcreteScenario | None,
    driven_from_outside: frozenset[str] = frozenset(),
) -> Iterator[Finding]:
    """All rules on all entities; those of the concrete scenario only where there is one.

    Who is driven from outside need not keep to the way that the concrete scenario gives it.
    """
    for movement in movements:
        yield from _jumps(movement)
    if concrete is None:
        return
    played = {movement.entity: movement for movement in movements}
    arms = match_arms(network, concrete).arms if network is not None else {}
    for participant in concrete.participants:
        found = played.get(participant.id)
        if found is None:
            yield error("esmini.missing", participant.id, "does not take part in what esmini plays")
            continue
        yield from _physics(found, participant)
        yield from _senses(found, participant)
        if network is not None and arms and participant.id not in driven_from_outside:
            yield from _way(found, participant, network, arms)
    for thing in concrete.objects:
        found = played.get(thing.id)
        if found is None:
            yield error("esmini.missing", thing.id, "is not there in what esmini plays")
            continue
        away = float(np.abs(found.point - complex(thing.x_m, thing.y_m)).max())
        if away > JUMP_M:
            yield error("esmini.standing", thing.id, f"is {away:.2f} m from where it should be")


def _jumps(movement: Movement) -> Iterator[Finding]:
    """``esmini.jump``: no step is longer than speed allows."""
    moved = np.abs(np.diff(movement.point))
    speed = np.maximum(movement.speed_mps[1:], movement.speed_mps[:-1])
    beyond = moved - np.abs(speed) * np.diff(movement.time_s)
    if beyond.size and beyond.max() > JUMP_M:
        step = int(beyond.argmax())
        message = f"jumps {moved[step]:.2f} m at {speed[step]:.2f} m/s"
        yield error("esmini.jump", movement.when(step + 1), message)


def _physics(movement: Movement, participant: ConcreteParticipant) -> Iterator[Finding]:
    """``esmini.speed``, ``esmini.acceleration``: within what the body or the program allows."""
    body = participant.body
    fastest = max(body.top_speed_mps, *(p.target_speed_mps for p in participant.speed_program), 0.0)
    step = int(np.abs(movement.speed_mps).argmax())
    if abs(movement.speed_mps[step]) > fastest + STILL_MPS:
        message = (
            f"goes {movement.speed_mps[step]:.1f} m/s; {with_article(participant.kind)} {fastest:g}"
        )
        yield error("esmini.speed", movement.when(step), message)
    rates = [phase.rate_mps2 for phase in participant.speed_program]
    rates += [participant.on_contact.rate_mps2] if participant.on_contact else []
    hardest = max(body.max_acceleration_mps2, body.max_deceleration_mps2, *rates, 0.0)
    change = np.diff(movement.speed_mps) / np.maximum(np.diff(movement.time_s), 1e-6)
    arrival = _arrival(movement)
    if arrival is not None and change[arrival] < -hardest - SPARE_MPS2:
        change[arrival] = 0.0
        message = f"is halted at {movement.speed_mps[arrival]:.1f} m/s where its path ends"
        yield warning("esmini.arrival", movement.when(arrival + 1), message)
    if change.size and np.abs(change).max() > hardest + SPARE_MPS2:
        step = int(np.abs(change).argmax())
        message = f"changes speed by {change[step]:.1f} m/s², more than {hardest:g}"
        yield error("esmini.acceleration", movement.when(step + 1), message)


def _senses(movement: Movement, participant: ConcreteParticipant) -> Iterator[Finding]:
    """``esmini.reversing``: backwards only if it reverses, and never into reverse at speed."""
    moved = np.diff(movement.point) * np.exp(-1j * movement.heading_rad[1:])
    sense = np.where(np.abs(moved) > LEAST_STEP_M, np.sign(moved.real), 0.0)
    reversal = participant.motion.reversal if isinstance(participant.motion, DriveMotion) else None
    if reversal is None and (sense < 0.0).any():
        step = int((sense < 0.0).argmax())
        message = f"goes backwards at {movement.speed_mps[step + 1]:.1f} m/s"
        yield error("esmini.reversing", movement.when(step + 1), message)
    elif reversal is not None and not (sense < 0.0).any():
        yield error("esmini.reversing", participant.id, "should reverse but does not")
    for before, after in pairwise(np.flatnonzero(sense).tolist()):
        fastest = max(movement.speed_mps[before + 1], movement.speed_mps[after + 1])
        if sense[before] != sense[after] and fastest > TURNS_MPS:
            message = f"changes direction at {fastest:.1f} m/s without coming to rest"
            yield error("esmini.reversing", movement.when(after + 1), message)
            return


def _arrival(movement: Movement) -> int | None:
    """The step after which it stands for good, None if it moves at the end or never moved."""
    moving = np.flatnonzero(np.abs(movement.speed_mps) > STILL_MPS)
    last = int(moving[-1]) if moving.size else None
    return None if last is None or last == len(movement.speed_mps) - 1 else last


def _way(
    movement: Movement, participant: ConcreteParticipant, network: Network, arms: dict[int, Arm]
) -> Iterator[Finding]:
    motion = participant.motion
    plain = not network.junctions or ramp_of(network, arms) is not None
    if isinstance(motion, DriveMotion) and plain:
        yield from _on_the_road(movement, participant, network)
    elif isinstance(motion, DriveMotion):
        first = _lanes(network, movement, 0, arms[motion.entry])
        inward = {*arms[motion.entry].inward, *arms[motion.entry].strips}
        if not isinstance(motion.reversal, BacksOut) and not first & inward:
            message = f"does not start on a lane into the junction of arm {motion.entry}"
            yield error("esmini.entry", participant.id, message)
        last = _lanes(network, movement, -1, arms[motion.exit])
        if not last & set(arms[motion.exit].outward) and not _stopped(movement, participant):
            end = movement.point[-1]
            message = (
                f"ends at ({end.real:.1f}, {end.imag:.1f}) at {movement.speed_mps[-1]:.1f} m/s, "
                f"not on a lane out of arm {motion.exit} ({arms[motion.exit].place})"
            )
            yield error("esmini.exit_arm", participant.id, message)
    elif isinstance(motion, CrossingMotion):
        yield from _crossing(movement, participant, motion)
    elif isinstance(motion, StandingMotion):
        away = float(np.abs(movement.point - movement.point[0]).max())
        if away > JUMP_M:
            yield error("esmini.standing", participant.id, f"should stand but moves {away:.2f} m")


def _on_the_road(
    movement: Movement, participant: ConcreteParticipant, network: Network
) -> Iterator[Finding]:
    """On a road without a junction nobody has to leave; whoever drives stays on a lane."""
    motion = participant.motion
    walks = participant.kind in ON_FOOT
    if walks or (isinstance(motion, DriveMotion) and isinstance(motion.reversal, BacksOut)):
        return
    for step, rule in ((0, "esmini.entry"), (-1, "esmini.exit_arm")):
        if not lanes_at(network, movement.point[[step]])[0]:
            point = movement.point[step]
            message = f"is at ({point.real:.1f}, {point.imag:.1f}), off every lane of the road"
            yield error(rule, participant.id, message)


def _stopped(movement: Movement, participant: ConcreteParticipant) -> bool:
    """Whether it stands at the end because its program says so, or a collision."""
    program = participant.speed_program
    told = any(phase.target_speed_mps == 0 for phase in program)
    told |= participant.on_contact is not None
    told |= not program and participant.speed_mps == 0
    return told and abs(float(movement.speed_mps[-1])) < STILL_MPS


def _crossing(
    movement: Movement, participant: ConcreteParticipant, motion: CrossingMotion
) -> Iterator[Finding]:
    away = float(abs(movement.point[-1] - movement.point[0]))
    if motion.stops_after_m is not None and away > motion.stops_after_m + 0.5:
        message = f"should stop after {motion.stops_after_m:g} m but goes {away:.2f} m"
        yield error("esmini.crossing", participant.id, message)
    elif away < 1.0:
        yield error("esmini.crossing", participant.id, "should cross but does not move")


def _lanes(network: Network, movement: Movement, step: int, arm: Arm) -> set[int]:
    return arm.under(lanes_at(network, movement.point[[step]])[0])
