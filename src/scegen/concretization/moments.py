"""When acts begin and end, and how far apart two then are, while numbers are being chosen."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from scegen.claims.boxes import Boxes
from scegen.concretization.amounts import ASIDE, OUT_AND_BACK
from scegen.concretization.boxes import box_on, missing_m
from scegen.concretization.others import gained
from scegen.concretization.setup import Setup
from scegen.concretization.traffic import Traffic
from scegen.concretization.walkers import partner_of, rendezvous
from scegen.motion.model import Array
from scegen.motion.standing import object_path
from scegen.motion.trigger_steps import STEP_S
from scegen.scenario.acts import Act, ActKind, WhenMeasure
from scegen.scenario.spacings import Spacing

_GONE_M = 0.1
_AFTER_S = 30.0
"""Those who go on once others are out of their way arrive so much later."""


@dataclass
class Moments:
    """Everybody in time: how late drives are, and when walkers set off of whom that is said."""

    scene: Setup
    offsets_s: dict[str, float]
    sets_off_s: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._partners = {name: partner_of(self.scene, w) for name, w in self.scene.walks.items()}

    def begins_s(self, act: Act) -> float:
        """When an act begins on the scenario's clock."""
        return self._during(act)[0]

    def ends_s(self, act: Act) -> float:
        """When it is over."""
        return self._during(act)[1]

    def _during(self, act: Act) -> tuple[float, float]:
        name = act.participant
        if name in self.scene.walks:
            begins = self.leaves_s(name)
            walk = self.scene.walks[name]
            return begins, begins + walk.runs_s(walk.path.length_m)
        if name not in self.scene.drives:
            return 0.0, 0.0
        draft, late = self.scene.drives[name], self.offsets_s[name]
        if act.kind in ASIDE:
            places = self._aside_m(act)
            return late + draft.course.time_at(places[0]), late + draft.course.time_at(places[1])
        phase = draft.course.phase_of(act.id)
        if phase is not None:
            ends = draft.course.profile.settles_s(phase.begins_s)
            return late + phase.begins_s, late + ends
        marked = [mark.s_m for mark in draft.deeds if mark.act == act.id]
        front = draft.body.front_m if act.kind is ActKind.ENTER else 0.0
        place = marked[0] if marked else draft.junction_s_m - front
        begins = late + draft.course.time_at(place)
        return begins, begins

    def _aside_m(self, act: Act) -> tuple[float, float]:
        """From where to where on its path somebody moves to the side by an act."""
        draft = self.scene.drives[act.participant]
        changes = list(draft.lane_changes)
        own = [a for a in self.scene.acts if a.participant == act.participant and a.kind in ASIDE]
        for earlier in own[: own.index(act)]:
            changes = changes[2 if earlier.kind in OUT_AND_BACK else 1 :] or changes[-1:]
        if not changes:
            return draft.junction_s_m, draft.junction_s_m
        last = changes[min(1, len(changes) - 1)] if act.kind in OUT_AND_BACK else changes[0]
        ends = draft.laid.path_s_m(last.position_m + last.length_m)
        return draft.laid.path_s_m(changes[0].position_m), ends

    def leaves_s(self, name: str) -> float:
        """When one who stands at first sets off: as is said, or to meet whom it is to meet."""
        if name in self.sets_off_s:
            return self.sets_off_s[name]
        found = self._partners[name]
        if found is None:
            return 1.0
        draft, point = found
        walk = self.scene.walks[name]
        place, way_m = rendezvous(self.scene, draft, walk, point)
        return self.offsets_s[draft.id] + draft.course.time_at(place) - walk.runs_s(way_m)

    def track(self, name: str, times_s: Array) -> tuple[Boxes, Array]:
        """The boxes of somebody over time, and its speeds."""
        scene = self.scene
        if name in scene.drives:
            draft = scene.drives[name]
            own = times_s - self.offsets_s[name]
            way, speed = draft.course.profile.at_times(np.maximum(own, 0.0))
            way = way + np.minimum(own, 0.0) * speed
            return box_on(draft.laid.path, draft.body, way), speed
        if name in scene.walks:
            walk = scene.walks[name]
            way, speed = gained(walk.speed_mps, walk.rate_mps2, times_s - self.leaves_s(name))
            way = np.minimum(way, walk.path.length_m)
            return box_on(walk.path, walk.body, way), speed
        still = np.zeros(len(times_s))
        if name in scene.stands:
            stand = scene.stands[name]
            return box_on(stand.path, stand.body, still), still
        thing = next(thing for thing in scene.objects if thing.id == name)
        return box_on(object_path(thing), thing.body, still), still

    def missing_m(self, said: Spacing | WhenMeasure, time_s: float) -> float:
        """How much longer the free length between two is than is said (m)."""
        ego = self.scene.functional.ego.id
        own, other = said.participant, said.reference
        if own != ego:
            own, other = other, own
        at = np.array([time_s])
        tracks = self.track(own, at), self.track(other, at)
        return float(missing_m(said.measure, said.value.middle, *tracks)[0])

    def traffic(self) -> Traffic:
        """All who drive here, for those who brake for others: who reverses looks ahead.

        Of walkers those of whom the text says when they set off, or who stop in somebody's way.
        """
        scene, drives = self.scene, self.scene.drives
        self.sets_off_s |= {n: self.leaves_s(n) for n, walk in scene.walks.items() if walk.stops}
        backs = frozenset(n for n, draft in drives.items() if draft.reversal is not None)
        ends = max(d.offset_s + float(d.course.time_s[-1]) for d in drives.values())
        things = (thing.id for thing in scene.objects)
        return Traffic(
            tale=scene,
            movers={name: draft for name, draft in drives.items() if name not in backs},
            touchable=[*drives, *self.sets_off_s, *scene.stands, *things],
            times_s=np.arange(0.0, ends + _AFTER_S, STEP_S),
            track=self._track_until_gone,
            seen_s=self._seen_s,
            in_line=lambda one, other: drives[one].drive.entry == drives[other].drive.entry,
            backs=backs,
            go_on=True,
        )

    def _track_until_gone(self, name: str, times_s: Array) -> tuple[Boxes, Array]:
        """The same, nan once it has come to the end of its way."""
        boxes, speed = self.track(name, times_s)
        draft = self.scene.drives.get(name)
        if draft is None:
            return boxes, speed
        leaves_s = draft.course.profile.time_s(draft.laid.path.length_m - _GONE_M)
        gone = times_s >= self.offsets_s[name] + leaves_s
        return boxes._replace(x=np.where(gone, np.nan, boxes.x)), speed

    def _seen_s(self, _: str, name: str) -> float:
        """When somebody slows down, moves aside or steps out; at the start if it does not."""
        draft = self.scene.drives.get(name)
        if draft is None:
            return self.leaves_s(name) if name in self.scene.walks else 0.0
        course = draft.course
        begins = [p.begins_s for p in course.phases if p.target_mps < course.speed_then(p.begins_s)]
        begins += [course.time_at(draft.laid.path_s_m(c.position_m)) for c in draft.lane_changes]
        return self.offsets_s[name] + min(begins) if begins else 0.0
