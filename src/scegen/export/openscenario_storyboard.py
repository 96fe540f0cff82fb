"""Who stands where at the start, and what everybody does: the storyboard."""

from collections.abc import Mapping

from scegen.export.expressions import written
from scegen.export.library import xosc
from scegen.export.openscenario_environment import environment_action
from scegen.export.openscenario_numbers import Numbers, Start
from scegen.export.openscenario_position import Polyline, world_position
from scegen.export.openscenario_signals import first_lamps, lamp_act
from scegen.export.openscenario_triggers import (
    at_end,
    at_once,
    at_the_latest,
    phase_event_name,
    phase_trigger,
    when_complete,
    when_touching,
)
from scegen.motion.model import Path
from scegen.motion.standing import object_paths
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario


def storyboard(
    concrete: ConcreteScenario,
    paths: Mapping[str, Path],
    numbers: Numbers,
    minor: int,
    *,
    external_ego: bool = False,
    lamps: bool = False,
) -> xosc.StoryBoard:
    """The storyboard: one act, one maneuver group for each participant that moves.

    An ego that somebody else drives has none: it is placed, and keeps its speed until then.
    With ``lamps`` actions change what the lights show.
    """
    stop = at_end("scenario_over", concrete.ego.id, numbers, minor)
    plan = concrete.signals if lamps else None
    init = _init(concrete, paths, numbers, minor)
    for action in first_lamps(plan) if plan else ():
        init.add_global_action(action)
    board = xosc.StoryBoard(init, stop)
    moving = [
        p
        for p in concrete.participants
        if _moves(paths[p.id]) and not (external_ego and p is concrete.ego)
    ]
    act = xosc.Act(
        "act", at_once("act_starts", concrete.duration_s), at_the_latest("act_over", numbers, minor)
    )
    for participant in moving:
        group = _maneuver_group(participant, paths, numbers, concrete.duration_s, minor)
        act.add_maneuver_group(group)
    if not moving:  # the standard wants a story all the same
        act.add_maneuver_group(xosc.ManeuverGroup("nobody_moves").add_actor(concrete.ego.id))
    story = xosc.Story("story")
    story.add_act(act)
    if plan and plan.working:
        story.add_act(lamp_act(concrete, plan, numbers, minor))
    board.add_story(story)
    return board


def _moves(path: Path) -> bool:
    return len(path.s_m) > 1


def _init(
    concrete: ConcreteScenario, paths: Mapping[str, Path], numbers: Numbers, minor: int
) -> xosc.Init:
    init = xosc.Init()
    init.add_global_action(environment_action(concrete.environment, minor))
    for participant in concrete.ego_first:
        path = paths[participant.id]
        place = world_position(path.start)
        if start := numbers.starts.get(participant.id):
            place = xosc.TrajectoryPosition(
                _trajectory(participant, start.path),
                written(start.along_m),
                0.0,
                xosc.Orientation(reference=xosc.ReferenceContext.relative),
            )
        init.add_init_action(participant.id, xosc.TeleportAction(place))
        speed = written(numbers.speeds_mps[participant.id]) if _moves(path) else 0.0
        init.add_init_action(participant.id, _step_to(speed))
    for name, path in object_paths(concrete).items():
        init.add_init_action(name, xosc.TeleportAction(world_position(path.start)))
    return init


def _maneuver_group(
    participant: ConcreteParticipant,
    paths: Mapping[str, Path],
    numbers: Numbers,
    duration_s: float,
    minor: int,
) -> xosc.ManeuverGroup:
    group = xosc.ManeuverGroup(f"{participant.id}_group")
    group.add_actor(participant.id)
    follow = f"{participant.id}_follows_path"
    # Apart from the way: overwriting an older change of speed must not end the trajectory. And
    # before it: esmini works in file order, and a step must move by the speed that it sets.
    speed = xosc.Maneuver(f"{participant.id}_speed")
    overwrite = xosc.Priority.overwrite if minor < 2 else xosc.Priority.override
    # Last phase first: a phase must not see its predecessor start in the same step.
    for index, phase in reversed(list(enumerate(numbers.phases[participant.id]))):
        name = phase_event_name(participant, index)
        event = xosc.Event(name, overwrite)
        target, rate = written(phase.target_speed_mps), written(phase.rate_mps2)
        event.add_action(f"{name}_action", _speed_at_rate(target, rate))
        event.add_trigger(
            phase_trigger(
                participant, index, phase.trigger, paths, duration_s=duration_s, minor=minor
            )
        )
        speed.add_event(event)
    if participant.on_contact is not None:
        struck = participant.on_contact
        collides = xosc.Event(f"{participant.id}_collides", overwrite)
        halt = _speed_at_rate(0.0, struck.rate_mps2)
        collides.add_action(f"{participant.id}_is_halted", halt)
        collides.add_trigger(when_touching(participant.id, struck.participant))
        speed.add_event(collides)
    # At the end of its path a participant stops; without this, players drive on along the road.
    arrived = xosc.Event(f"{participant.id}_arrives", overwrite)
    arrived.add_action(f"{participant.id}_stops", _step_to(0.0))
    arrived.add_trigger(when_complete(f"{participant.id}_path_ends", follow))
    speed.add_event(arrived)
    group.add_maneuver(speed)
    way = xosc.Maneuver(f"{participant.id}_way")
    start = numbers.starts.get(participant.id)
    way.add_event(_follow_event(participant, paths[participant.id], start, follow, duration_s))
    group.add_maneuver(way)
    return group


def _follow_event(
    participant: ConcreteParticipant, path: Path, start: Start | None, name: str, duration_s: float
) -> xosc.Event:
    """Follow the path at whatever speed: no time reference, so the vertex times do not count."""
    follow = xosc.FollowTrajectoryAction(
        _trajectory(participant, start.path if start else path),
        xosc.FollowingMode.position,
        initialDistanceOffset=start and written(start.along_m),
    )
    event = xosc.Event(f"{participant.id}_sets_out", xosc.Priority.parallel)
    event.add_action(name, follow)
    event.add_trigger(at_once(f"{participant.id}_at_once", duration_s))
    return event


def _trajectory(participant: ConcreteParticipant, path: Path) -> xosc.Trajectory:
    trajectory = xosc.Trajectory(f"{participant.id}_path", False)
    trajectory.add_shape(Polyline(path, participant.speed_mps or 1.0))
    return trajectory


def _speed_at_rate(speed_mps: float | str, rate_mps2: float | str) -> xosc.AbsoluteSpeedAction:
    linear, rate = xosc.DynamicsShapes.linear, xosc.DynamicsDimension.rate
    return xosc.AbsoluteSpeedAction(speed_mps, xosc.TransitionDynamics(linear, rate, rate_mps2))


def _step_to(speed_mps: float | str) -> xosc.AbsoluteSpeedAction:
    step = xosc.TransitionDynamics(xosc.DynamicsShapes.step, xosc.DynamicsDimension.time, 0.0)
    return xosc.AbsoluteSpeedAction(speed_mps, step)
