"""What a candidate is worth: how far it is from everything that is wanted at once."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from scegen.claims.claim import Claim, ClaimKind
from scegen.claims.moments import CHANGES_MPS2
from scegen.claims.near_miss import Band
from scegen.claims.statements.endings import GOES_ON_S
from scegen.claims.view import View, view_of
from scegen.claims.ways import Way
from scegen.criticality.search.lead_in import early_contact_missing, early_missing
from scegen.criticality.search.variables import Space
from scegen.criticality.target import Target
from scegen.measures.registry import measure_named
from scegen.measures.tables import Tables
from scegen.motion.batch.arrays import Bools, Candidates, Floats, Program
from scegen.motion.batch.simulation import simulate_batch
from scegen.motion.friction import GRAVITY_MPS2
from scegen.motion.model import STANDING_MPS
from scegen.scenario.concrete import ConcreteScenario, DriveMotion

PROVED = tuple(
    measure_named(name)
    for name in ("pet", "distance", "ttc", "headway", "drac", "contact_time", "impact_speed")
)
"""Measures of pairs that a target may name and a proof shows."""

SEARCH_DT_S = 0.05
HAZARD_ROOM = 0.08
CLAIM_ROOM = 0.15
"""As share of a claim's tolerance."""
BAND_ROOM = 0.08
"""A search aims inside of what it must prove, by this share, so that finer steps do not undo it."""
CLEAR_M = 0.2
"""Those who are not to touch keep this distance."""
AFTER_S = 1.0
"""The scenario goes on this long after everybody has left."""
LATERAL_ROOM = 1.03
_EVERYDAY_MPS2 = 4.0
_NEVER = 3.0
_SAME = 1e-6
_STRANGE = 0.02
_SPREAD = 0.12
_HARD_MPS = 10.0


@dataclass(frozen=True)
class Outcome:
    """What candidates miss, by demand (c,); all 0: found. ``loss`` adds how strange they are.

    ``margins`` are those of the claims that are looked at.
    """

    missing: Mapping[str, Floats]
    strangeness: Floats
    made: Candidates
    duration_s: Floats
    margins: Mapping[str, Floats] = field(default_factory=dict)

    @property
    def total(self) -> Floats:
        """The sum of what is missing (c,)."""
        total: Floats = np.sum(list(self.missing.values()), axis=0)
        return total

    @property
    def loss(self) -> Floats:
        """What a search makes small (c,)."""
        return self.total + _STRANGE * np.minimum(self.strangeness, 25.0)

    @property
    def found(self) -> Bools:
        """Which candidates miss nothing (c,)."""
        return self.total <= 0.0

    def in_words(self) -> str:
        """How far the best of these is."""
        best = int(self.loss.argmin())
        lacking = sum(bool(missed[best] > 0.0) for missed in self.missing.values())
        return f"the best of these misses {lacking} demands" if lacking else "found"


@dataclass
class Problem:
    """One search: what is wanted of whom, and what it runs on.

    Every claim is a demand, but those ``given_up``, those that are ``fixed`` (everybody gets to the
    end of its way, or ``finish`` is missing) and that on contacts; the proof judges them too. The
    target is none if ``untargeted``. A search that fails tells in ``never`` which claims nothing
    met, and whether the pair stays ``apart`` even in the best, or others are in the way of a target
    that is met. It stays near ``home`` (n,), or near the scenario as it was concretized.
    ``progress`` is told how far it is after every batch.
    """

    concrete: ConcreteScenario
    ways: Mapping[str, Way]
    program: Program
    space: Space
    scene: Tables
    target: Target
    pair: tuple[str, str]
    friction: float
    duration_s: float
    lateral_mps2: Mapping[str, float]
    claims: Sequence[Claim] = ()
    given_up: frozenset[str] = frozenset()
    never: frozenset[str] = frozenset()
    apart: bool = True
    untargeted: bool = False
    room: float = 1.0
    dt_s: float = SEARCH_DT_S
    evaluations: int = 0
    known: list[Floats] = field(default_factory=list)
    home: Floats | None = None
    progress: Callable[[str], None] = lambda _: None

    def view(self, made: Candidates) -> View:
        """The movements of candidates, as claims look at them."""
        traces = simulate_batch(self.program, made, duration_s=self.duration_s, dt_s=self.dt_s)
        return view_of(self.concrete, self.ways, self.scene, traces, self.friction)

    def evaluate(self, x: Floats) -> Outcome:
        """Everything about candidates with these values of the variables (c, n)."""
        made = self.space.candidates(x)
        view = self.view(made)
        self.evaluations += x.shape[0]
        finish, duration = finishing(view, self.pair)
        missing: dict[str, Floats] = {}
        if not self.untargeted:
            room = BAND_ROOM * self.room
            missing["target"] = target_missing(view, self.target, self.pair, room=room)
            late = view.of_pair("closest_s", *self.pair) - (duration - AFTER_S / 2)
            # What comes after everybody has left is cut off.
            missing["target"] += np.where(late > 0.0, 0.2 + late / 4.0, 0.0)
        missing["contacts"] = unwanted(view, self.target, self.pair)
        missing["lateral acceleration"] = self._lateral(view)
        missing["finish"] = finish
        missing["sameness"] = self._sameness(x)
        ending, margins = replace(view, ends_s=duration), dict[str, Floats]()
        for claim in self.claims:
            if not (claim.fixed or claim.kind is ClaimKind.CONTACT or claim.id in self.given_up):
                margins[claim.id] = claim.judge(ending).margin
                missing[claim.id] = self._claim_missing(claim, margins[claim.id])
        strangeness = self.space.strangeness(x, self.home)
        outcome = Outcome(missing, strangeness, made, duration, margins)
        self.progress(f"{self.evaluations:,} candidates tried, {outcome.in_words()}")
        return outcome

    def _claim_missing(self, claim: Claim, margin: Floats) -> Floats:
        """How far a claim is from holding, on a scale that all demands share."""
        if claim.kind is ClaimKind.HAZARD:
            return np.maximum(0.0, HAZARD_ROOM * self.room - margin)
        short = CLAIM_ROOM * claim.tolerance * self.room - margin
        return np.where(short > 0.0, 0.05 + np.log1p(np.maximum(short, 0.0) / claim.scale), 0.0)

    def out_of_reach(self, points: Floats) -> frozenset[str]:
        """Claims that hold at none of these points and by the same margin at all: not of numbers.

        What lies in ways, lanes and sides stays as it is.
        """
        found = self.evaluate(points).margins.items()
        return frozenset(n for n, v in found if v.max() < 0.0 and np.ptp(v) < _SAME)

    def _lateral(self, view: View) -> Floats:
        """How far bends and lane changes are taken too fast, in shares of the limit."""
        worst = np.zeros(view.count)
        for name, limit in self.lateral_mps2.items():
            worst = np.maximum(worst, view.lateral_mps2(name).max(axis=1) / limit - 1.0)
        return np.where(worst > 0.0, 0.1 + worst, 0.0)

    def _sameness(self, x: Floats) -> Floats:
        """Whether a candidate is too much like a solution that is known already."""
        span = np.maximum(self.space.span, 1e-9)
        worst = np.zeros(x.shape[0])
        for other in self.known:
            apart = np.sqrt(np.mean(((x - other) / span) ** 2, axis=1))
            worst = np.maximum(worst, 1.0 - apart / _SPREAD)
        return np.maximum(worst, 0.0)


def band_missing(values: Floats, band: Band, room: float) -> Floats:
    """How far values lie outside a band, in widths of the band (at least 0.5 of its unit)."""
    width = band.high - band.low
    low, high = band.low + room * width, band.high - room * width
    outside = np.maximum(low - values, values - high) / max(width, 0.5)
    # Far away the slope is gentle, so that one far demand does not drown the others.
    outside = np.where(outside > 1.0, 1.0 + np.log1p(np.maximum(outside - 1.0, 0.0)), outside)
    return np.maximum(np.nan_to_num(outside, nan=_NEVER, posinf=_NEVER, neginf=_NEVER), 0.0)


def choice_missing(
    view: View, choice: Sequence[Band], pair: tuple[str, str], room: float
) -> Floats:
    """How far a pair is from bands that must hold together, after the lead-in."""
    missing = early_missing(view, choice, pair, room)
    for band in choice:
        values = view.of_pair(measure_named(band.measure).field, *pair)
        missing = np.maximum(missing, band_missing(values, band, room))
    return missing


def target_missing(view: View, target: Target, pair: tuple[str, str], *, room: float) -> Floats:
    """How far a pair is from the nearest of the target's choices, or from a contact."""
    if target.contact:
        contact = view.of_pair("contact_s", *pair)
        apart = view.of_pair("distance_m", *pair)
        early = early_contact_missing(view, pair, room)
        return np.where(np.isnan(contact), 0.3 + np.log1p(apart), early)
    choices = [choice_missing(view, choice, pair, room) for choice in target.choices]
    return np.min(choices, axis=0) if choices else np.zeros(view.count)


def unwanted(view: View, target: Target, pair: tuple[str, str]) -> Floats:
    """Contacts that are not wanted, and near ones of those who shall not meet at all."""
    wanted = view.pair(*pair)
    missing = np.zeros(view.count)
    for p in range(len(view.scene.pairs)):
        touches = ~np.isnan(view.summary.contact_s[:, p]) & ~follows_from(view, target, pair, p)
        if wanted is not None and p == wanted[0]:
            if target.contact is not False:
                continue
            near = np.zeros(view.count)
        else:
            near = np.maximum(0.0, CLEAR_M - view.summary.distance_m[:, p])
        # One who runs into another in its lane has no PET: the slower, the nearer to none.
        speed = np.minimum(np.nan_to_num(view.summary.impact_mps[:, p]) / _HARD_MPS, 1.0)
        behind = -view.summary.pet_s[:, p]
        depth = np.where(behind > 0.0, np.minimum(behind, 3.0), speed)
        missing += np.where(touches, 1.0 + depth, near)
    return missing


def follows_from(view: View, target: Target, pair: tuple[str, ...], other: int) -> Bools:
    """Whether a pair touches only after the contact that is asked for, and because of it (c,).

    Where bodies go after they have hit each other is not modelled: who runs into the tail of a
    queue is not to be stopped by the one before. ``other`` is the number of another pair.
    """
    wanted = view.pair(*pair) if pair else None
    if wanted is None or target.contact is not True:
        return np.zeros(view.count, dtype=np.bool_)
    shared = bool({*view.scene.pairs[other]} & {*view.scene.pairs[wanted[0]]})
    contact_s = view.summary.contact_s
    later: Bools = contact_s[:, other] > contact_s[:, wanted[0]]
    return later & shared


def finishing(view: View, pair: tuple[str, str] | tuple[()] = ()) -> tuple[Floats, Floats]:
    """What is missing until everybody has left in time, and the duration that takes (c,), s.

    It goes on for a while after the closest approach of the pair.
    """
    last = np.zeros(view.count)
    if pair:
        last = np.nan_to_num(view.of_pair("closest_s", *pair)) + GOES_ON_S + view.dt_s - AFTER_S
    missing = np.zeros(view.count)
    ends: list[Floats] = []
    steps = view.traces.tracks.shape[3]
    for participant in view.concrete.participants:
        way, place = view.ways[participant.id], view.place_m(participant.id)
        if way.halts:
            moves = view.speed_mps(participant.id) >= STANDING_MPS
            missing += np.where(moves[:, -1], 0.5, 0.0)
            stops = np.where(moves.any(axis=1), steps - moves[:, ::-1].argmax(axis=1), 0)
            last = np.maximum(last, stops * view.dt_s)
            continue
        if participant.speed_program:
            last = np.maximum(last, _settled_s(view, participant.id))
        if way.goal_m <= 0.0:
            continue
        left = way.goal_m - place[:, -1]
        missing += np.where(left > 0.0, 0.2 + np.maximum(left, 0.0) / 20.0, 0.0)
        last = np.maximum(last, (place < way.goal_m).sum(axis=1) * view.dt_s)
        if isinstance(participant.motion, DriveMotion):
            # One who waits at the end of its road would stand in the way of the next.
            ends.append((place < way.path.length_m - 1e-3).sum(axis=1) * view.dt_s)
    duration = np.minimum(last + AFTER_S, (steps - 1) * view.dt_s)
    for end in ends:
        missing += np.maximum(0.0, np.minimum(duration, steps * view.dt_s) - end - view.dt_s)
    return missing, duration


def _settled_s(view: View, name: str) -> Floats:
    """When somebody's speed changes for the last time before it is hit, else 0 (c,), s."""
    changes = np.abs(np.diff(view.speed_mps(name), axis=1)) > CHANGES_MPS2 * view.dt_s
    for pair, contact_s in zip(view.scene.pairs, view.summary.contact_s.T, strict=True):
        if view.index[name] in pair:
            changes &= ~(np.arange(1, changes.shape[1] + 1) * view.dt_s >= contact_s[:, None])
    upto = changes.shape[1] - changes[:, ::-1].argmax(axis=1)
    return np.where(changes.any(axis=1), upto, 0) * view.dt_s


def lateral_limits(view: View, friction: float) -> dict[str, float]:
    """How hard each drive may go through bends: as first made, within what the tyres hold."""
    limits = {}
    for participant in view.concrete.participants:
        if isinstance(participant.motion, DriveMotion):
            first = float(view.lateral_mps2(participant.id)[0].max())
            most = 0.9 * friction * GRAVITY_MPS2
            limits[participant.id] = min(max(first, _EVERYDAY_MPS2) * LATERAL_ROOM, most)
    return limits
