"""Fit starts, and the places of acts, to what the text says: exactly, and else as is usual.

Everybody's lateness, the places of acts that are open and the moments at which walkers set off are
the unknowns; what is said of spacings and triggers are equations between them. What is said
outweighs staying as it was.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from scegen.concretization.deeds import is_open
from scegen.concretization.moments import Moments
from scegen.concretization.setup import Setup
from scegen.motion.model import Array
from scegen.scenario.acts import (
    Act,
    ActKind,
    AfterAct,
    AfterDistance,
    AfterStart,
    BeforeJunction,
    WhenMeasure,
)  # fmt: skip
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START

_AS_IT_WAS = 1e-6
_PER_M = 0.1
"""A metre counts as much as so many seconds."""
_STEP_S, _STEP_M = 0.01, 0.1
_ROUNDS, _ENOUGH = 25, 1e-4
_THEN_S = 0.3
"""Who answers another at once does so after this."""


def fit(scene: Setup, moments: Moments) -> None:
    """Change what is open in ``moments`` until what is said holds, as little as that needs."""
    said = len(list(_missed(scene, moments)))
    if not said:
        return
    unknowns = list(_unknowns(scene, moments))
    first = np.array([_read(scene, moments, *unknown) for unknown in unknowns])
    steps = np.array([_STEP_S if place is None else _STEP_M for _, place in unknowns])

    def missed(x: Array) -> Array:
        for unknown, value in zip(unknowns, x, strict=True):
            _give(scene, moments, *unknown, float(value))
        kept = _AS_IT_WAS * _STEP_S / steps * (x - first)
        return np.concatenate([list(_missed(scene, moments)), kept])

    x, now = first, missed(first)
    for _ in range(_ROUNDS):
        slope = np.empty((len(now), len(x)))
        for n, step in enumerate(steps):
            tried = x.copy()
            tried[n] += step
            slope[:, n] = (missed(tried) - now) / step
        way = -np.linalg.lstsq(slope, now, rcond=1e-12)[0]
        share = 1.0
        while share > 1e-3 and np.linalg.norm(missed(x + share * way)) > np.linalg.norm(now):
            share /= 2
        x = x + share * way
        now = missed(x)
        if np.linalg.norm(now[:said]) < _ENOUGH and np.abs(share * way).max() < _STEP_S:
            break
    missed(x)


def _unknowns(scene: Setup, moments: Moments) -> Iterator[tuple[str, int | None]]:
    """Whose lateness (or setting off) is to be found; with a number, where that act of it is."""
    for name, draft in scene.drives.items():
        yield name, None
        for n, mark in enumerate(draft.deeds):
            stood = n == 0 and mark.act is None and draft.parked_s_m is None
            if is_open(scene, mark) or stood:
                yield name, n
    yield from ((name, None) for name in moments.sets_off_s)


def _read(scene: Setup, moments: Moments, name: str, place: int | None) -> float:
    if place is not None:
        return scene.drives[name].deeds[place].s_m
    return (moments.offsets_s if name in scene.drives else moments.sets_off_s)[name]


def _give(scene: Setup, moments: Moments, name: str, place: int | None, value: float) -> None:
    if place is None:
        (moments.offsets_s if name in scene.drives else moments.sets_off_s)[name] = value
        return
    deeds = scene.drives[name].deeds
    if deeds[place].s_m != value:
        deeds[place] = replace(deeds[place], s_m=value)


def _missed(scene: Setup, moments: Moments) -> Iterator[float]:
    """By how much distances and moments are not as the text says."""
    known = {*scene.drives, *scene.walks, *scene.stands}
    for spacing in scene.functional.spacings:
        pair = {spacing.participant, spacing.reference}
        if spacing.measure in LENGTHWISE and spacing.at != CONTACT and known >= pair:
            at = None if spacing.at == START else scene.act(spacing.at)
            moment = moments.ends_s if spacing.since == "end" else moments.begins_s
            if at is None or at.participant in known:
                yield _PER_M * moments.missing_m(spacing, 0.0 if at is None else moment(at))
    for act in scene.acts:
        if act.when is not None and act.participant in known:
            yield from _mistimed(scene, moments, act, known)


def _mistimed(scene: Setup, moments: Moments, act: Act, known: set[str]) -> Iterator[float]:
    when, begins_s = act.when, moments.begins_s(act)
    if isinstance(when, WhenMeasure) and when.measure in LENGTHWISE:
        if known >= {when.participant, when.reference}:
            yield _PER_M * moments.missing_m(when, begins_s)
    elif isinstance(when, AfterStart):
        yield begins_s - when.delay_s.middle
    elif isinstance(when, AfterDistance | BeforeJunction):
        # How far one has come, or has still to go to the junction; one's own place is fixed.
        name, way_m = when.participant or act.participant, when.distance_m.middle
        draft = scene.drives.get(name)
        if draft is None:
            return
        course, late = draft.course, moments.offsets_s[name]
        if isinstance(when, AfterDistance):
            yield _PER_M * (course.s_at(begins_s - late) - course.s_at(-late) - way_m)
        elif when.participant is not None:
            place = draft.junction_s_m - draft.body.front_m - way_m
            yield begins_s - (late + course.time_at(place))
    elif isinstance(when, AfterAct):
        other = scene.act(when.act)
        own = scene.drives.get(act.participant)
        marks = own.deeds if own is not None else ()
        chained = any(mark.act == act.id and mark.then_s is not None for mark in marks)
        if other.participant in known and not chained:
            since = moments.ends_s(other) if when.since == "end" else moments.begins_s(other)
            yield begins_s - since - (when.delay_s.middle or _THEN_S)


def conditioned(scene: Setup, name: str) -> bool:
    """Whether the text says when somebody who crosses sets off."""
    crosses = [a for a in scene.acts if a.participant == name and a.kind is ActKind.CROSS]
    named = {spacing.at for spacing in scene.functional.spacings}
    return any(act.when is not None or act.id in named for act in crosses)
