"""When acts begin and end, and how far apart two then are, while numbers are being chosen."""

from functools import partial

import numpy as np

from scegen.claims.boxes import Boxes
from scegen.claims.moments import along_whose, turned
from scegen.concretization.amounts import OUT_AND_BACK
from scegen.concretization.boxes import box_on, missing_m
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.setup import Setup
from scegen.concretization.traffic import Traffic
from scegen.concretization.walkers import leaves_s
from scegen.motion.model import Array
from scegen.motion.reversing import ROLLS_M
from scegen.motion.standing import object_path
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.acts import LEAVING, Act, ActKind, WhenMeasure
from scegen.scenario.reversing import BacksOut
from scegen.scenario.spacings import Spacing

_GONE_M = 0.1
_STEP_M = 0.05
_AFTER_S = 30.0
"""Those who go on once others are out of their way arrive so much later."""


def during_s(scene: Setup, act: Act) -> tuple[float, float]:
    """When an act begins and ends, on the scenario's clock."""
    name = act.participant
    if name in scene.walks:
        begins, walk = leaves_s(scene, name), scene.walks[name]
        if act is walk.stop:
            return begins + walk.slows_s(), begins + walk.rests_s()
        return begins, begins + walk.runs_s(walk.path.length_m)
    if name not in scene.drives:
        return 0.0, 0.0
    draft = scene.drives[name]
    course, late = draft.course, draft.offset_s
    if act.kind in LEAVING:
        out_m, back_m = _aside_m(scene, draft, act)
        return late + course.time_at(out_m), late + course.time_at(back_m)
    phase = course.phase_of(act.id)
    if phase is not None:
        return late + phase.begins_s, late + course.profile.settles_s(phase.begins_s)
    marked = [mark.s_m for mark in draft.steps if mark.act == act.id]
    if act.kind is ActKind.WAIT:  # by the rules of the road
        marked += [mark.s_m for mark in draft.road_changes() if mark.target_mps == 0.0]
    begins = late + course.time_at(marked[0] if marked else _comes_in_m(draft, act))
    return begins, begins


def _comes_in_m(draft: DriveDraft, act: Act) -> float:
    """Where on its path somebody is as it enters the junction, or begins to turn there."""
    if act.kind is ActKind.ENTER and isinstance(draft.reversal, BacksOut):  # rear first
        return ROLLS_M + draft.reversal.setback_m - draft.body.rear_m
    if act.kind is ActKind.ENTER:
        return draft.junction_s_m - draft.body.front_m
    ways_m = np.arange(draft.junction_s_m, draft.path.length_m, _STEP_M)
    bends = turned(box_on(draft.path, draft.body, np.append(draft.path.s_m[:1], ways_m)))[1:]
    turns = act.kind is ActKind.TURN and bends.any()
    return float(ways_m[bends][0]) if turns else draft.junction_s_m


def _aside_m(scene: Setup, draft: DriveDraft, act: Act) -> tuple[float, float]:
    """From where to where on its path somebody moves to the side by an act."""
    changes = list(draft.lane_changes)
    own = scene.acts_of(draft.id, LEAVING)
    for earlier in own[: own.index(act)]:
        changes = changes[2 if earlier.kind in OUT_AND_BACK else 1 :] or changes[-1:]
    if not changes:
        return draft.junction_s_m, draft.junction_s_m
    last = changes[min(1, len(changes) - 1)] if act.kind in OUT_AND_BACK else changes[0]
    ends = draft.laid.path_s_m(last.position_m + last.length_m)
    return draft.laid.path_s_m(changes[0].position_m), ends


def track(scene: Setup, name: str, times_s: Array) -> tuple[Boxes, Array]:
    """The boxes of somebody over time, and its speeds."""
    if name in scene.drives:
        draft = scene.drives[name]
        own = times_s - draft.offset_s
        way, speed = draft.course.profile.at_times(np.maximum(own, 0.0))
        way = way + np.minimum(own, 0.0) * speed
        return box_on(draft.path, draft.body, way), speed
    if name in scene.walks:
        walk = scene.walks[name]
        way, speed = walk.gone(times_s - leaves_s(scene, name))
        way = np.minimum(way, walk.path.length_m)
        return box_on(walk.path, walk.body, way), speed
    still = np.zeros(len(times_s))
    there = {thing.id: (object_path(thing), thing.body) for thing in scene.objects}
    there |= {stand.id: (stand.path, stand.body) for stand in scene.stands.values()}
    return box_on(*there[name], still), still


def too_long_m(scene: Setup, said: Spacing | WhenMeasure, time_s: float, act: Act | None) -> float:
    """How much longer the free length between two is than is said (m), as an act begins or ends."""
    own, other = along_whose(scene.functional.ego.id, said.participant, said.reference, act)
    at = np.array([time_s])
    tracks = track(scene, own, at), track(scene, other, at)
    return float(missing_m(said.measure, said.value.middle, *tracks)[0])


def traffic_of(scene: Setup) -> Traffic:
    """All who drive here, for those who brake for others: who reverses looks ahead.

    Of walkers those of whom the text says when they set off, or who stop in somebody's way.
    """
    drives = scene.drives
    for name, walk in scene.walks.items():
        if walk.stops_after_m is not None:
            walk.sets_off_s = leaves_s(scene, name)
    timed = (name for name, walk in scene.walks.items() if walk.sets_off_s is not None)
    backs = frozenset(n for n, draft in drives.items() if draft.reversal is not None)
    ends = max(d.offset_s + d.course.ends_s for d in drives.values())
    things = (thing.id for thing in scene.objects)
    return Traffic(
        tale=scene,
        movers={name: draft for name, draft in drives.items() if name not in backs},
        touchable=[*drives, *timed, *scene.stands, *things],
        times_s=np.arange(0.0, ends + _AFTER_S, STEP_S),
        track=partial(_track_until_gone, scene),
        seen_s=lambda _, name: _seen_s(scene, name),
        in_line=lambda one, other: drives[one].drive.entry == drives[other].drive.entry,
        backs=backs,
        go_on=True,
    )


def _track_until_gone(scene: Setup, name: str, times_s: Array) -> tuple[Boxes, Array]:
    """The same, nan once it has come to the end of its way."""
    boxes, speed = track(scene, name, times_s)
    draft = scene.drives.get(name)
    if draft is None:
        return boxes, speed
    leaves = draft.course.profile.time_s(draft.path.length_m - _GONE_M)
    gone = times_s >= draft.offset_s + leaves
    return boxes._replace(x=np.where(gone, np.nan, boxes.x)), speed


def _seen_s(scene: Setup, name: str) -> float:
    """When somebody slows down, moves aside or steps out; at the start if it does not."""
    draft = scene.drives.get(name)
    if draft is None:
        return leaves_s(scene, name) if name in scene.walks else 0.0
    course = draft.course
    begins = [p.begins_s for p in course.phases if p.target_mps < course.speed_then(p.begins_s)]
    begins += [course.time_at(draft.laid.path_s_m(c.position_m)) for c in draft.lane_changes]
    return draft.offset_s + min(begins) if begins else 0.0
