"""A danger has a beginning: everybody goes on undisturbed before it, none bumper to bumper."""

from collections.abc import Iterator
from functools import partial
from itertools import permutations

import numpy as np

from scegen.claims import tolerances
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged
from scegen.claims.lateral import lateral_m
from scegen.claims.moments import CHANGES_MPS2, STANDS_MPS
from scegen.claims.series import first
from scegen.claims.sideways import LEAVES_M
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.scenario.acts import ActKind, AfterDistance, AfterStart, WhenMeasure
from scegen.scenario.spacings import LENGTHWISE, START, Spacing
from scegen.scenario.vocabulary import Maneuver

LEAD_IN_S = 1.0
"""The shortest time in which an observer sees what somebody does before it does something else."""
CLOSEST_S = 0.2
"""Nobody follows closer; half of the least headway of tailgating."""


def claims(told: Told) -> Iterator[Claim]:
    """Of everybody who causes a danger or does something, but at a moment that the text gives."""
    causes = {name for hazard in told.hazards for name in hazard.by}
    causes |= {act.participant for act in told.functional.acts}
    tolerance, opening = tolerances.TIME_S, ClaimKind.OPENING
    for person in told.people:
        name, drive = person.id, told.drive(person.id)
        backs = drive is not None and drive.reverses is not None
        if name not in causes or backs or _begins_as_said(told, name):
            continue
        does = f"{name} goes on undisturbed for {LEAD_IN_S:g} s at first"
        field, test = f"participants.{name}", partial(_undisturbed, told, name)
        yield Claim(f"opening.{name}", opening, does, field, "s", test, tolerance)
    if told.collides and not any(_begins_as_said(told, p.id) for p in told.people):
        does = f"nobody is hit within the first {LEAD_IN_S:g} s"
        yield Claim("opening.contact", opening, does, "outcome", "s", _unhurt, tolerance)
    # Two who drive, if the text tells of no distance between them along the road.
    said = [{s.participant, s.reference} for s in _along_the_road(told)]
    drivers = [d.participant for d in told.logical.drives if d.maneuver is not Maneuver.STAY]
    if pairs := [pair for pair in permutations(drivers, 2) if {*pair} not in said]:
        does = f"nobody drives less than {CLOSEST_S:g} s behind another at first"
        apart = partial(_apart, pairs)
        yield Claim("opening.apart", opening, does, "participants", "s", apart)


def _unhurt(view: View) -> Judged:
    """When any two first touch; never, if none do."""
    time_s = np.nanmin(view.summary.contact_s, axis=1, initial=np.inf)
    return Judged(np.minimum(time_s, NEVER) - LEAD_IN_S + tolerances.TIME_S, time_s, time_s)


def _along_the_road(told: Told) -> list[Spacing]:
    """The distances along the road that the text tells."""
    return [s for s in told.functional.spacings if s.measure in LENGTHWISE]


def _apart(pairs: list[tuple[str, str]], view: View) -> Judged:
    """The shortest headway at first of those who follow another that moves, too."""
    least, start = np.full(view.count, np.inf), view.at_first()
    for follower, leader in pairs:
        if start.rows_behind(follower, leader) < 0:
            continue
        moves = start.speed_mps(leader)[:, 0] > STANDS_MPS
        headway = start.headway_s(follower, leader)[:, 0]
        least = np.where(moves, np.minimum(least, headway), least)
    return Judged(np.minimum(least, LEAD_IN_S) - CLOSEST_S, least, np.zeros(view.count))


def _begins_as_said(told: Told, name: str) -> bool:
    """Whether the text gives the moment of something that it does, by a number.

    Also who passes another, or comes up to one that stands, is as close to that one at first as
    the text says.
    """
    given = AfterStart | AfterDistance | WhenMeasure
    acts = told.acts_of(name)
    if any(isinstance(act.when, given) for act in acts):
        return True
    passes = any(act.kind is ActKind.OVERTAKE for act in acts)
    pairs = [{s.participant, s.reference} for s in _along_the_road(told) if s.at == START]
    near = {other for pair in pairs if name in pair for other in pair - {name}}
    drive = {d.participant for d in told.logical.drives if d.maneuver is not Maneuver.STAY}
    return bool(near if passes else near - drive)


def _undisturbed(told: Told, name: str, view: View) -> Judged:
    """Until its speed changes, or it leaves its line."""
    upto = min(round(LEAD_IN_S / view.dt_s) + 1, view.steps)
    speed = view.speed_mps(name)[:, : upto + 1]
    changes = np.abs(np.diff(speed, axis=1, append=speed[:, -1:])) > CHANGES_MPS2 * view.dt_s
    changes[:, -1] = False
    aside = np.abs(lateral_m(view, name, told.drive(name), upto + 1)) > LEAVES_M
    time_s = view.time_of(np.minimum(first(changes | aside), upto))
    return Judged(time_s - LEAD_IN_S + tolerances.TIME_S, time_s, time_s)
