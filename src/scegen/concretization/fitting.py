"""Fit starts, and the places of acts, to what the text says: exactly, and else as is usual.

Everybody's lateness, the places of acts that are open and the moments at which walkers set off are
the unknowns; what is said of spacings and triggers are equations between them. What is said
outweighs staying as it was.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from scegen.concretization.deeds import is_open
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.measures import LENGTHWISE
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
)
from scegen.scenario.spacings import CONTACT, START

_AS_IT_WAS = 1e-6
_PER_M = 0.1
"""A metre counts as much as so many seconds."""
_STEP_S, _STEP_M = 0.01, 0.1
_ROUNDS, _ENOUGH = 25, 1e-4
_THEN_S = 0.3
"""Who answers another at once does so after this."""

Residual = Callable[[Moments], float]


@dataclass(frozen=True, slots=True)
class Unknown:
    """A number to be found: how it is read and set, and the step to try it with."""

    step: float
    read: Callable[[Moments], float]
    give: Callable[[Moments, float], None]


def fit(scene: Setup, moments: Moments) -> None:
    """Change what is open in ``moments`` until what is said holds, as little as that needs."""
    said = list(_said(scene))
    if not said:
        return
    unknowns = list(_unknowns(scene, moments))
    first = np.array([unknown.read(moments) for unknown in unknowns])

    def missed(x: Array) -> Array:
        for unknown, value in zip(unknowns, x, strict=True):
            unknown.give(moments, float(value))
        own = [residual(moments) for residual in said]
        scale = np.array([_AS_IT_WAS * _STEP_S / unknown.step for unknown in unknowns])
        return np.concatenate([own, scale * (x - first)])

    x, now = first, missed(first)
    for _ in range(_ROUNDS):
        slope = np.empty((len(now), len(x)))
        for n, unknown in enumerate(unknowns):
            tried = x.copy()
            tried[n] += unknown.step
            slope[:, n] = (missed(tried) - now) / unknown.step
        way = -np.linalg.lstsq(slope, now, rcond=1e-12)[0]
        share = 1.0
        while share > 1e-3 and np.linalg.norm(missed(x + share * way)) > np.linalg.norm(now):
            share /= 2
        x = x + share * way
        now = missed(x)
        if np.linalg.norm(now[: len(said)]) < _ENOUGH and np.abs(share * way).max() < _STEP_S:
            break
    missed(x)


def _unknowns(scene: Setup, moments: Moments) -> Iterator[Unknown]:
    for name, draft in scene.drives.items():
        yield Unknown(
            _STEP_S,
            lambda m, name=name: m.offsets_s[name],  # type: ignore[misc]
            lambda m, value, name=name: m.offsets_s.__setitem__(name, value),  # type: ignore[misc]
        )
        for n, mark in enumerate(draft.deeds):
            stood = n == 0 and mark.act is None and draft.parked_s_m is None
            if is_open(scene, mark) or stood:
                yield Unknown(
                    _STEP_M,
                    lambda _, draft=draft, n=n: draft.deeds[n].s_m,  # type: ignore[misc]
                    lambda _, value, draft=draft, n=n: _move(draft, n, value),  # type: ignore[misc]
                )
    for name in moments.sets_off_s:
        yield Unknown(
            _STEP_S,
            lambda m, name=name: m.sets_off_s[name],  # type: ignore[misc]
            lambda m, value, name=name: m.sets_off_s.__setitem__(name, value),  # type: ignore[misc]
        )


def _move(draft: DriveDraft, n: int, place_m: float) -> None:
    if draft.deeds[n].s_m != place_m:
        draft.deeds[n] = replace(draft.deeds[n], s_m=place_m)
        draft.course_ = None


def _said(scene: Setup) -> Iterator[Residual]:
    """What the text says of distances and moments."""
    known = {*scene.drives, *scene.walks, *scene.stands}
    for spacing in scene.functional.spacings:
        pair = spacing.participant, spacing.reference
        if spacing.measure in LENGTHWISE and spacing.at != CONTACT and known >= {*pair}:
            at = None if spacing.at == START else scene.act(spacing.at)
            if at is None or at.participant in known:
                said = WhenMeasure(
                    measure=spacing.measure,
                    participant=pair[0],
                    reference=pair[1],
                    value=spacing.value,
                )
                yield _measured(said, at, spacing.since)
    for act in scene.acts:
        when = act.when
        if act.participant not in known:
            continue
        if isinstance(when, WhenMeasure) and when.measure in LENGTHWISE:
            if known >= {when.participant, when.reference}:
                yield _measured(when, act)
        elif isinstance(when, AfterStart):
            yield lambda m, act=act, when=when: m.begins_s(act) - when.delay_s.middle  # type: ignore[misc]
        elif isinstance(when, AfterDistance | BeforeJunction):
            yield from _on_its_way(when, act, scene)
        elif isinstance(when, AfterAct):
            other = scene.act(when.act)
            if other.participant in known and not _is_chained(scene, act):
                yield _after(act, other, when)


def _is_chained(scene: Setup, act: Act) -> bool:
    draft = scene.drives.get(act.participant)
    marks = draft.deeds if draft is not None else ()
    return any(mark.act == act.id and mark.then_s is not None for mark in marks)


def _measured(when: WhenMeasure, act: Act | None, since: str = "begin") -> Residual:
    def residual(moments: Moments) -> float:
        moment = moments.ends_s if since == "end" else moments.begins_s
        time_s = 0.0 if act is None else moment(act)
        return _PER_M * moments.missing_m(
            when.measure, when.participant, when.reference, when.value.middle, time_s
        )

    return residual


def _on_its_way(when: AfterDistance | BeforeJunction, act: Act, scene: Setup) -> Iterator[Residual]:
    """How far one has come, or has still to go to the junction; one's own place is fixed."""
    name, way_m = when.participant or act.participant, when.distance_m.middle
    if name not in scene.drives:
        return
    if isinstance(when, AfterDistance):
        yield lambda moments: _PER_M * (moments.gone_m(name, act) - way_m)
    elif when.participant is not None:
        yield lambda moments: moments.begins_s(act) - moments.before_junction_s(name, way_m)


def _after(act: Act, other: Act, when: AfterAct) -> Residual:
    delay = when.delay_s.middle or _THEN_S

    def residual(moments: Moments) -> float:
        since = moments.ends_s(other) if when.since == "end" else moments.begins_s(other)
        return moments.begins_s(act) - since - delay

    return residual


def conditioned(scene: Setup, name: str) -> bool:
    """Whether the text says when somebody who crosses sets off."""
    crosses = [a for a in scene.acts if a.participant == name and a.kind is ActKind.CROSS]
    named = {spacing.at for spacing in scene.functional.spacings}
    return any(act.when is not None or act.id in named for act in crosses)
