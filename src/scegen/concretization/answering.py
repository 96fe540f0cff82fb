"""Who would run into somebody brakes as a driver does, as late as the text leaves it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from math import inf

import numpy as np

from scegen.claims.boxes import same_way
from scegen.concretization.amounts import CLOSEST_M, goes_on_when_free
from scegen.concretization.braking import (
    Contact,
    answer_each,
    answer_of,
    apart_by,
    brake_late,
    had_ahead,
    touch_s,
)
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.parties import same_arm
from scegen.concretization.limits import COMFORTABLE_ACCELERATION_MPS2, REACTION_S
from scegen.concretization.moments import Moments
from scegen.concretization.profile import Sort, SpeedChange
from scegen.concretization.setup import Setup
from scegen.motion.model import Array
from scegen.motion.trigger_steps import STEP_S, just_before_step_s
from scegen.scenario.outcome import OutcomeKind

_AFTER_S = 8.0
_ALONG = 0.5
_GONE_M = 0.1
_GOES_ON_S = (1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0)


def answer(scene: Setup, moments: Moments) -> None:
    """Let everybody brake who would run into somebody ahead, or who crosses as the text says."""
    # Who stops in somebody's way does so when it is said to, whatever is done about it.
    moments.sets_off_s |= {n: moments.leaves_s(n) for n, w in scene.walks.items() if w.stops}
    contacts, brakes = partial(_contacts, scene, moments), partial(_brake_for, scene, moments)
    answer_each(contacts, brakes, 2 * len(scene.drives))


def _times(moments: Moments) -> Array:
    """From the start until everybody has arrived where it goes."""
    drives = moments.scene.drives
    ends = max(moments.offsets_s[n] + float(d.course.time_s[-1]) for n, d in drives.items())
    return np.arange(0.0, ends + _AFTER_S, STEP_S)


def _contacts(scene: Setup, moments: Moments) -> Iterator[Contact]:
    """Who runs in: from behind, or into who crosses or comes back; none that is wanted.

    Into walkers only where the text says when they set off.
    """
    times = _times(moments)
    people = (*scene.drives, *scene.walks, *scene.stands, *(o.id for o in scene.objects))
    tracks = {name: moments.track(name, times)[0] for name in people}
    touching: dict[frozenset[str], float | None] = {}
    for name in scene.drives:
        for other, there in tracks.items():
            if other == name or scene.contact_wanted(name, other):
                continue
            if _comes_back(scene, name):
                continue  # who reverses looks ahead
            if other in scene.walks and other not in moments.sets_off_s:
                continue
            pair = frozenset((name, other))
            if pair not in touching:
                until = _parts_s(moments, name, other)
                touching[pair] = touch_s(times, tracks[name], there, until)
            at = touching[pair]
            if at is not None and _runs_in(scene, moments, Contact(at, name, other)):
                yield Contact(at, name, other)


def _runs_in(scene: Setup, moments: Moments, contact: Contact) -> bool:
    ahead, along = had_ahead(moments, contact)
    if contact.other not in scene.drives or _comes_back(scene, contact.other):
        return ahead
    in_line = same_arm(scene.drives[contact.who], scene.drives[contact.other])
    follows = in_line or contact.other not in scene.endangered_by(contact.who)
    # Who is said not to touch who endangers it does something about it.
    outcome = scene.functional.outcome
    avoided = outcome is not None and outcome.kind is OutcomeKind.AVOIDED
    gets_away = avoided and contact.who in scene.endangered_by(contact.other)
    return ahead and ((along > _ALONG and follows) or gets_away)


def _comes_back(scene: Setup, name: str) -> bool:
    return name in scene.drives and scene.drives[name].reversal is not None


def _parts_s(moments: Moments, *names: str) -> float:
    """When the first of these is gone: at the end of its way; inf if they stay."""
    drives = [(n, moments.scene.drives[n]) for n in names if n in moments.scene.drives]
    return min(
        (
            moments.offsets_s[n] + float(d.course.time_s[-1])
            for n, d in drives
            if float(d.course.s_m[-1]) >= d.laid.path.length_m - _GONE_M
        ),
        default=inf,
    )


def _brake_for(scene: Setup, moments: Moments, contact: Contact) -> bool:
    """Brake as late as leaves a little room; not at all where nothing does."""
    who = scene.drives[contact.who]
    own = scene.loose(who.deeds, who.cruise_mps)
    before = who.deeds
    waits = [m for m in before if m.act is not None and goes_on_when_free(scene.act(m.act).when)]
    rest = [mark for mark in before if mark is not own and mark not in waits]
    slowest = _slowest_mps(scene, moments, contact)
    who.deeds = rest
    free, late = who.course, moments.offsets_s[who.id]

    thing = any(each.id == contact.other for each in scene.objects)
    answer, rates = answer_of(scene, contact, own, slowest, who.braking_mps2(inf), thing=thing)
    there = own is None and _comes_back(scene, contact.other)

    def brake(begins_s: float, rate: float) -> None:
        place = free.s_at(just_before_step_s(begins_s) - late)
        who.deeds = [*rest, replace(answer, s_m=place, rate_mps2=rate, there=there)]

    def leaves(room_m: float) -> bool:
        times = _times(moments)
        there = times[times < _parts_s(moments, who.id, contact.other)]
        return apart_by(moments, contact, there, room_m)

    earliest = max(_seen_s(scene, moments, contact.other) + REACTION_S, late, 0.0)
    found = brake_late(leaves, contact.time_s, rates, earliest, brake)
    if found is None:
        who.deeds = before
        return False
    if waits or own is None:
        _go_on(who, leaves, waits, _most_mps(scene, moments, contact))
    if own is None:
        reason = f"brakes for {contact.other}, as a driver who sees it does"
        scene.note(f"{who.id}.rate_mps2", found[1], reason)
    return True


def _most_mps(scene: Setup, moments: Moments, contact: Contact) -> float:
    """How fast one goes on that has braked for another: no faster than that one, if it follows."""
    who, times = scene.drives[contact.who], _times(moments)[-1:]
    if contact.other not in scene.drives:
        return who.cruise_mps
    (own, _), (other, speed) = (moments.track(name, times) for name in contact[1:])
    follows = float(same_way(own, other)[0]) > _ALONG
    return min(who.cruise_mps, float(speed[0])) if follows else who.cruise_mps


def _go_on(
    who: DriveDraft, leaves: Callable[[float], bool], said: list[SpeedChange], most_mps: float
) -> None:
    """Drive on as soon as that is free, by its own act if that is said; else stay as slow."""
    if not said and (most_mps <= 0.0 or any(mark.act is not None for mark in who.deeds)):
        return
    kept = who.deeds
    rate = who.acceleration_mps2(COMFORTABLE_ACCELERATION_MPS2)
    usual = SpeedChange(most_mps, rate, s_m=kept[-1].s_m, sort=Sort.ACT)
    for then in _GOES_ON_S:
        on = replace(next(iter(said), usual), then_s=then)
        who.deeds = [*kept, on]
        if leaves(CLOSEST_M - 0.1):
            return
    who.deeds = kept


def _slowest_mps(scene: Setup, moments: Moments, contact: Contact) -> float:
    """How slow whoever it runs into becomes; 0 where that one comes and goes by other arms."""
    if contact.other not in scene.drives:
        return 0.0
    since = contact.time_s if scene.sets_off(contact.other) else 0.0
    times = np.arange(since, contact.time_s + _AFTER_S, STEP_S)
    own, other = (moments.track(name, times[-1:])[0] for name in contact[1:])
    in_line = same_arm(scene.drives[contact.who], scene.drives[contact.other])
    if not in_line and float(same_way(own, other)[0]) <= _ALONG:
        return 0.0
    slowest = float(moments.track(contact.other, times)[1].min())
    return slowest if slowest > 0.1 else 0.0


def _seen_s(scene: Setup, moments: Moments, other: str) -> float:
    """When somebody becomes a danger: as it slows down, comes into the lane, or steps out."""
    if other not in scene.drives:
        return moments.leaves_s(other) if other in scene.walks else 0.0
    draft = scene.drives[other]
    late, course = moments.offsets_s[other], draft.course
    slowing = [p.begins_s for p in course.phases if p.target_mps < course.speed_then(p.begins_s)]
    places = [draft.laid.path_s_m(change.position_m) for change in draft.lane_changes]
    begins = [*slowing, *(course.time_at(place) for place in places)]
    return late + min(begins, default=-late)
