"""Those who stop on their way across: where they stand, and that they do when somebody comes."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged
from scegen.claims.moments import STANDS_MPS
from scegen.claims.series import first
from scegen.claims.statements.spacings import judge_spacing
from scegen.claims.statements.touching import hit_s
from scegen.claims.told import Told
from scegen.claims.tolerances import TIME_S
from scegen.claims.view import View
from scegen.scenario.acts import RESTING, Act
from scegen.scenario.model import Interval
from scegen.scenario.spacings import CONTACT, LENGTHWISE, Measure, Spacing
from scegen.scenario.vocabulary import HazardKind


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody who goes across and is said to stop on the way, before whom it meets."""
    for crossing in told.logical.crossings:
        name = crossing.participant
        stop = next((a for a in told.acts_of(name) if a.kind in RESTING), None)
        dangers = [h for h in told.hazards if name in h.by]
        if stop is None and all(h.kind is not HazardKind.STOPPING for h in dangers):
            continue
        met = next((to for h in dangers for to in h.to if told.drive(to)), told.ego)
        field = f"participants.{name}.maneuvers" if stop is None else f"acts.{stop.id}"
        if not _place_is_said(told, name, stop):
            test = partial(_in_the_way, told, name, met)
            yield _claim(f"{name}.place", f"{name} stops in the way of {met}", field, "m", test)
        if stop is None or stop.when is None:
            does = f"{name} has come to rest when {met} comes to it"
            yield _claim(f"{name}.met", does, field, "s", partial(_rests_before, told, name, met))


def _claim(name: str, statement: str, field: str, unit: str, test: partial[Judged]) -> Claim:
    kind = ClaimKind.STANDS
    return Claim(
        id=f"rests.{name}", kind=kind, statement=statement, field=field, unit=unit, test=test
    )


def _place_is_said(told: Told, name: str, stop: Act | None) -> bool:
    """Whether it is said how far from the kerb it stops, or how far aside of somebody."""
    if any(act.distance_m is not None for act in told.acts_of(name)):
        return True
    return any(
        name in {s.participant, s.reference}
        and s.measure not in LENGTHWISE
        and s.at in {CONTACT, stop and stop.id}
        for s in told.functional.spacings
    )


def _in_the_way(told: Told, name: str, met: str, view: View) -> Judged:
    """How far aside of the other's middle it stands: so that the other would touch it."""
    reach = (view.body(met).width_m + view.body(name).length_m) / 2.0
    value = Interval(low=-reach, high=reach)
    offset = Measure.LATERAL_OFFSET_M
    aside = Spacing(participant=name, reference=met, measure=offset, value=value, at=CONTACT)
    return judge_spacing(told, aside, view)


def _rests_before(told: Told, name: str, met: str, view: View) -> Judged:
    """How long it has stood when the other touches it, or is nearest to it."""
    speed = view.speed_mps(name)
    moved = np.maximum.accumulate(speed > STANDS_MPS, axis=1)
    rests = first(moved & (speed <= STANDS_MPS))
    comes_s = np.minimum(hit_s(told, view, name), view.of_pair("closest_s", name, met))
    stood_s = comes_s - view.time_of(rests)
    margin = np.where(rests < view.steps, stood_s + TIME_S, -NEVER)
    return Judged(margin, stood_s, view.time_of(rests))
