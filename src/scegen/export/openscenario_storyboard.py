"""Who stands where at the start, and what everybody does: the storyboard."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from scegen.export.library import xosc
from scegen.export.openscenario_environment import environment_action
from scegen.export.openscenario_position import vertex_position
from scegen.export.openscenario_signals import first_lamps, lamp_act
from scegen.export.openscenario_triggers import (
    at_end,
    at_once,
    at_the_latest,
    phase_event_name,
    phase_trigger,
    when_complete,
)
from scegen.motion.model import Path
from scegen.motion.simulation import STANDING_MPS, simulate
from scegen.motion.standing import object_paths
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario

_BEFORE_END_S = 1.0
_SHORT_OF_REST_M = 0.1
"""Players come to rest some millimetres off, and must not wait for them."""


def storyboard(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    minor: int,
    *,
    external_ego: bool = False,
    lamps: bool = False,
) -> xosc.StoryBoard:
    """The storyboard: one act, one maneuver group for each participant that moves.

    An ego that somebody else drives has none: it is placed, and keeps its speed until then.
    With ``lamps`` actions change what the lights show.
    """
    duration, goes_m = concrete.duration_s, _ego_goes_m(concrete, paths)
    stop = at_end("scenario_over", concrete, goes_m, minor)
    plan = concrete.signals if lamps else None
    init = _init(concrete, paths, minor)
    for action in first_lamps(plan) if plan else ():
        init.add_global_action(action)
    board = xosc.StoryBoard(init, stop)
    moving = [
        p
        for p in concrete.participants
        if _moves(paths[p.id]) and not (external_ego and p is concrete.ego)
    ]
    act = xosc.Act(
        "act",
        at_once("act_starts", duration),
        at_the_latest("act_over", concrete, minor),
    )
    for participant in moving:
        act.add_maneuver_group(_maneuver_group(participant, paths, duration, minor))
    if not moving:  # the standard wants a story all the same
        act.add_maneuver_group(xosc.ManeuverGroup("nobody_moves").add_actor(concrete.ego.id))
    story = xosc.Story("story")
    story.add_act(act)
    if plan:
        story.add_act(lamp_act(concrete, plan, minor))
    board.add_story(story)
    return board


def _ego_goes_m(concrete: ConcreteScenario, paths: Mapping[str, Path]) -> float:
    """How far the ego has come shortly before the end; a little less if it has stopped by then."""
    trace = simulate(concrete, paths)[concrete.ego.id]
    before = max(0.0, concrete.duration_s - _BEFORE_END_S)
    far = float(np.interp(before, trace.time_s, trace.s_m))
    stopped = np.interp(before, trace.time_s, trace.speed_mps) < STANDING_MPS
    return max(0.0, far - _SHORT_OF_REST_M) if stopped else far


def _moves(path: Path) -> bool:
    return len(path.s_m) > 1


def _init(concrete: ConcreteScenario, paths: Mapping[str, Path], minor: int) -> xosc.Init:
    init = xosc.Init()
    init.add_global_action(environment_action(concrete.environment, minor))
    for participant in concrete.participants:
        path = paths[participant.id]
        init.add_init_action(participant.id, xosc.TeleportAction(vertex_position(path, 0)))
        speed = participant.speed_mps if _moves(path) else 0.0
        init.add_init_action(participant.id, _step_to(speed))
    for name, path in object_paths(concrete).items():
        init.add_init_action(name, xosc.TeleportAction(vertex_position(path, 0)))
    return init


def _maneuver_group(
    participant: ConcreteParticipant, paths: Mapping[str, Path], duration_s: float, minor: int
) -> xosc.ManeuverGroup:
    group = xosc.ManeuverGroup(f"{participant.id}_group")
    group.add_actor(participant.id)
    follow = f"{participant.id}_follows_path"
    # Apart from the way: overwriting an older change of speed must not end the trajectory. And
    # before it: esmini works in file order, and a step must move by the speed that it sets.
    speed = xosc.Maneuver(f"{participant.id}_speed")
    overwrite = xosc.Priority.overwrite if minor < 2 else xosc.Priority.override
    # Last phase first: a phase must not see its predecessor start in the same step.
    for index, phase in reversed(list(enumerate(participant.speed_program))):
        name = phase_event_name(participant, index)
        event = xosc.Event(name, overwrite)
        dynamics = xosc.TransitionDynamics(
            xosc.DynamicsShapes.linear, xosc.DynamicsDimension.rate, phase.rate_mps2
        )
        event.add_action(
            f"{name}_action", xosc.AbsoluteSpeedAction(phase.target_speed_mps, dynamics)
        )
        event.add_trigger(
            phase_trigger(participant, index, paths, duration_s=duration_s, minor=minor)
        )
        speed.add_event(event)
    # At the end of its path a participant stops; without this, players drive on along the road.
    arrived = xosc.Event(f"{participant.id}_arrives", overwrite)
    arrived.add_action(f"{participant.id}_stops", _step_to(0.0))
    arrived.add_trigger(when_complete(f"{participant.id}_path_ends", follow))
    speed.add_event(arrived)
    group.add_maneuver(speed)
    way = xosc.Maneuver(f"{participant.id}_way")
    way.add_event(_follow_event(participant, paths[participant.id], follow, duration_s))
    group.add_maneuver(way)
    return group


def _follow_event(
    participant: ConcreteParticipant, path: Path, name: str, duration_s: float
) -> xosc.Event:
    """Follow the path at whatever speed: no time reference, so the vertex times do not count.

    1.0 demands them all the same; they are those of a constant speed.
    """
    trajectory = xosc.Trajectory(f"{participant.id}_path", False)
    nominal_mps = participant.speed_mps or 1.0
    trajectory.add_shape(
        xosc.Polyline(
            [round(float(s) / nominal_mps, 4) for s in path.s_m],
            [vertex_position(path, i) for i in range(len(path.s_m))],
        )
    )
    event = xosc.Event(f"{participant.id}_sets_out", xosc.Priority.parallel)
    event.add_action(name, xosc.FollowTrajectoryAction(trajectory, xosc.FollowingMode.position))
    event.add_trigger(at_once(f"{participant.id}_at_once", duration_s))
    return event


def _step_to(speed_mps: float) -> xosc.AbsoluteSpeedAction:
    step = xosc.TransitionDynamics(xosc.DynamicsShapes.step, xosc.DynamicsDimension.time, 0.0)
    return xosc.AbsoluteSpeedAction(speed_mps, step)
