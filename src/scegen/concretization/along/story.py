"""When everything happens: acts become steps of speed and moves to the side, in time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import pi

from scegen.concretization.along.asked import dangers, outward
from scegen.concretization.along.runner import NEVER_S, Move, Runner, Step
from scegen.concretization.along.spacing import LENGTHWISE, measured
from scegen.concretization.limits import (
    ABRUPT_LANE_CHANGE_S,
    COMFORTABLE_ACCELERATION_MPS2,
    HARD_BRAKING_MPS2,
    LANE_CHANGE_S,
    STOPPING_MPS2,
    SUDDEN_ACCELERATION_MPS2,
)
from scegen.road.defaults import LANE_WIDTH_M
from scegen.scenario.acts import Act, ActKind, AfterAct, AfterStart, WhenMeasure
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import CONTACT
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import Approach, HazardKind, Side

FIRST_ACT_S = 4.0
"""Undisturbed driving before the first act whose moment nobody says."""
_HOLDS_S = 1.5
"""Between two acts of one participant, where nothing is said: long enough to see the speed held."""
_GAINS_MPS = 8.0
_ABRUPT = frozenset({HazardKind.CUT_IN, HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL})
_HAZARDS_OF = {
    ActKind.BRAKE: (HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.LOSS_OF_CONTROL),
    ActKind.STOP: (HazardKind.STOPPING, HazardKind.HARD_BRAKING),
    ActKind.ACCELERATE: (HazardKind.SUDDEN_ACCELERATION,),
    ActKind.CHANGE_LANE: (
        HazardKind.CUT_IN,
        HazardKind.MERGING_CONFLICT,
        HazardKind.FAILURE_TO_YIELD,
        HazardKind.ONCOMING_LANE,
        HazardKind.SUDDEN_TURN,
    ),
    ActKind.SWERVE: (
        HazardKind.SWERVING,
        HazardKind.LOSS_OF_CONTROL,
        HazardKind.ONCOMING_LANE,
        HazardKind.SUDDEN_TURN,
    ),
    ActKind.OVERTAKE: (HazardKind.OVERTAKING, HazardKind.ONCOMING_LANE),
}
"""The dangers that an act may be."""
_LATE_S, _LOOK_S = 60.0, 0.02


@dataclass
class Story:
    """Who does what when; ``begins_s`` and ``ends_s`` by act, ``things`` lie in somebody's way."""

    functional: FunctionalScenario
    logical: LogicalScenario
    runners: dict[str, Runner]
    acts: Sequence[Act]
    lane_count: int
    limit_mps: float
    grip_mps2: float
    things: tuple[Thing, ...] = ()
    begins_s: dict[str, float] = field(default_factory=dict)
    ends_s: dict[str, float] = field(default_factory=dict)

    @property
    def hazards(self) -> tuple[Hazard, ...]:
        """The dangers, with everybody named who causes and who suffers them."""
        return dangers(self.functional, self.logical)

    @property
    def ego(self) -> Runner:
        """The vehicle under test."""
        return self.runners[self.functional.ego.id]

    def hazard_of(self, act: Act) -> HazardKind | None:
        """The danger that an act is, if it is one."""
        asked = [h.kind for h in self.hazards if act.participant in h.by]
        return next((kind for kind in _HAZARDS_OF.get(act.kind, ()) if kind in asked), None)

    def words(self, name: str, reference: str) -> frozenset[Approach]:
        """Where somebody is said to be, seen from another; nothing is said of things."""
        found: frozenset[Approach] = frozenset()
        if reference == self.ego.id and self.runners[name].box is None:
            found |= self.functional.participant(name).approaches
        for relation in self.functional.relations:
            if (relation.participant, relation.reference) == (name, reference):
                found |= relation.approaches
        return found

    def act(self, name: str) -> Act:
        """An act by its id."""
        return next(act for act in self.acts if act.id == name)

    # ---- moments

    def time_what_is_known(self) -> list[Act]:
        """Give every act its moment that needs nobody's place; returns those that need one."""
        waiting: list[Act] = []
        for act in self.acts:
            when = act.when
            placed = isinstance(when, WhenMeasure) and self._is_placed_otherwise(act, when)
            follows = isinstance(when, AfterAct) and when.act not in self.begins_s
            if placed or (follows and not self.is_loose(act)):
                waiting.append(act)
            else:
                self.perform(act, self._moment_s(act))
        return waiting

    def is_loose(self, act: Act) -> bool:
        """Whether nothing along the road says when an act begins.

        What follows upon an act of one who crosses is loose, too: it answers that one.
        """
        when = act.when
        if isinstance(when, AfterAct):
            return all(other.id != when.act for other in self.acts)
        return when is None

    def _is_placed_otherwise(self, act: Act, when: WhenMeasure) -> bool:
        """Whether other statements fix how far apart the two of a trigger are, step by step."""
        pairs = [
            {s.participant, s.reference}
            for s in self.functional.spacings
            if s.measure in LENGTHWISE and s.at != CONTACT
        ]
        for earlier in self.acts[: self.acts.index(act)]:
            if isinstance(earlier.when, WhenMeasure):
                pairs.append({earlier.when.participant, earlier.when.reference})
        reached = {when.participant}
        for _ in pairs:
            reached |= {name for pair in pairs if pair & reached for name in pair}
        return when.reference in reached

    def _moment_s(self, act: Act) -> float:
        when = act.when
        if isinstance(when, AfterStart):
            return when.delay_s.middle
        if isinstance(when, AfterAct) and not self.is_loose(act):
            known = self.ends_s if when.since == "end" else self.begins_s
            delay = when.delay_s.middle
            alone = self.act(when.act).participant == act.participant
            if alone and delay == 0.0 and when.since == "end":
                delay = _HOLDS_S  # "and then": what it has reached is held for a moment
            return known[when.act] + delay
        own = [self.ends_s[a.id] for a in self.acts if a.participant == act.participant
               and a.id in self.ends_s]  # fmt: skip
        if own:
            return max(own) + _HOLDS_S
        return FIRST_ACT_S

    def perform_waiting(self, waiting: Sequence[Act]) -> list[Act]:
        """Acts that wait for a measure, now that places are known; those that never come."""
        never: list[Act] = []
        for act in waiting:
            when = act.when
            if isinstance(when, WhenMeasure):
                moment = self._when_measured_s(when)
            elif isinstance(when, AfterAct) and when.act not in self.begins_s:
                moment = NEVER_S
            else:
                moment = self._moment_s(act)
            if moment < NEVER_S:
                self.perform(act, moment)
            else:
                never.append(act)
        return never

    def _when_measured_s(self, when: WhenMeasure) -> float:
        """The first moment at which the measure has come down to its value."""
        if not {when.participant, when.reference} <= self.runners.keys():
            return NEVER_S
        first, second = self.runners[when.participant], self.runners[when.reference]
        steps = int(_LATE_S / _LOOK_S)
        for n in range(steps):
            time_s = n * _LOOK_S
            if measured(when.measure, first, second, time_s) <= when.value.middle:
                return time_s
        return NEVER_S

    # ---- what acts do

    def perform(self, act: Act, begins_s: float) -> None:
        """Add an act's steps and moves to who does it."""
        runner = self.runners[act.participant]
        self.begins_s[act.id] = begins_s
        if self.goes_round(act) or self.comes_back(act):
            self.ends_s[act.id] = begins_s  # its moves follow from the places
            return
        if act.kind in {ActKind.CHANGE_LANE, ActKind.SWERVE}:
            moves = self._sideways(act, runner, begins_s)
            runner.moves += moves
            self.ends_s[act.id] = moves[-1].ends_s
            return
        step = self._step(act, runner, begins_s)
        runner.steps.append(step)
        self.ends_s[act.id] = runner.profile.settles_s(begins_s)

    def comes_back(self, act: Act) -> bool:
        """Whether a change of lane is how one who overtakes comes back."""
        earlier = self.acts[: self.acts.index(act)]
        overtakes = any(
            a.participant == act.participant and a.kind is ActKind.OVERTAKE for a in earlier
        )
        return act.kind is ActKind.CHANGE_LANE and overtakes

    def goes_round(self, act: Act) -> bool:
        """Whether an act leads out of the lane, past somebody, and back.

        One that changes lanes where there is no other of its direction does so round somebody.
        """
        if act.kind is ActKind.OVERTAKE:
            return True
        if self.comes_back(act):
            return False
        passing = {n for h in self.hazards if h.kind is HazardKind.OVERTAKING for n in h.by}
        if act.kind is ActKind.CHANGE_LANE and act.participant in passing:
            return True
        said = (act.side, act.into, act.lateral_m)
        alone = self.lane_count == 1 and self.hazard_of(act) is None
        return act.kind is ActKind.CHANGE_LANE and alone and not any(said)

    def _step(self, act: Act, runner: Runner, begins_s: float) -> Step:
        before = runner.speed_at_mps(begins_s)
        hazard = self.hazard_of(act)
        gains = act.kind in {ActKind.ACCELERATE, ActKind.SET_OFF}
        rate = act.rate_mps2.middle if act.rate_mps2 else None
        target = self._target_mps(act, runner, before, rate)
        if rate is None and act.duration_s is not None and abs(target - before) > 0.1:
            rate = abs(target - before) / max(act.duration_s.middle, 0.1)
        if rate is None and act.distance_m is not None and abs(target - before) > 0.1:
            rate = abs(target**2 - before**2) / (2 * max(act.distance_m.middle, 0.1))
        if rate is None:
            usual = _usual_rate_mps2(act.kind, hazard)
            body = runner.body.max_acceleration_mps2 if gains else runner.body.max_deceleration_mps2
            rate = min(usual, body, 0.95 * self.grip_mps2)
        timed = isinstance(act.when, AfterStart)
        return Step(begins_s, target, rate, act.id, hazard, timed=timed)

    def _target_mps(self, act: Act, runner: Runner, before: float, rate: float | None) -> float:
        if act.target_speed_mps is not None:
            return act.target_speed_mps.middle
        if act.duration_s is not None and rate is not None:
            change = rate * act.duration_s.middle
            gains = act.kind is ActKind.ACCELERATE
            return max(0.0, before + (change if gains else -change))
        if act.kind is ActKind.ACCELERATE:
            return min(before + _GAINS_MPS, runner.body.top_speed_mps)
        if act.kind is ActKind.SET_OFF:
            said = self.functional.participant(runner.id).speed_mps
            if said is not None and said.high > 0:
                return said.middle
            return min(self.limit_mps, self.ego.speed_mps or self.limit_mps)
        return 0.0

    def _sideways(self, act: Act, runner: Runner, begins_s: float) -> list[Move]:
        """A change of lane, or out and back within it."""
        hazard = self.hazard_of(act)
        now = runner.lane_at(begins_s)
        if act.kind is ActKind.SWERVE or act.lateral_m is not None:
            return self._swerve(act, runner, begins_s, hazard)
        lane = self._lane_after(act, runner, now)
        width = abs(lane - now) * LANE_WIDTH_M or LANE_WIDTH_M
        usual = ABRUPT_LANE_CHANGE_S if hazard in _ABRUPT else LANE_CHANGE_S
        lasts = _lasting_s(act, width, usual)
        return [Move(begins_s, lasts, lane, 0.0, act.id, hazard)]

    def _swerve(
        self, act: Act, runner: Runner, begins_s: float, hazard: HazardKind | None
    ) -> list[Move]:
        lane = runner.lane_at(begins_s)
        side = act.side or self._free_side(runner, lane)
        if act.lateral_m is None:
            aside = max(0, lane + outward(self.functional, side))
            if aside > self.lane_count:
                side = Side.LEFT if side is Side.RIGHT else Side.RIGHT
                aside = max(0, lane + outward(self.functional, side))
            lasts = _lasting_s(act, LANE_WIDTH_M, ABRUPT_LANE_CHANGE_S)
            out = Move(begins_s, lasts, aside, 0.0, act.id, hazard)
            return [out, Move(out.ends_s + 0.1, lasts, lane, 0.0, act.id, hazard)]
        width = act.lateral_m.middle
        offset = width if side is Side.LEFT else -width
        lasts = _lasting_s(act, width, LANE_CHANGE_S)
        start = runner.moves[-1].offset_m if runner.moves else runner.offset_m
        out = Move(begins_s, lasts, lane, start + offset, act.id, hazard)
        if act.kind is not ActKind.SWERVE:
            return [self._in_lane(out)]
        return [out, Move(out.ends_s + 0.1, lasts, lane, start, act.id, hazard)]

    def _in_lane(self, move: Move) -> Move:
        """The same place across the road, told from the lane that it lies in."""
        right = -round(move.offset_m / LANE_WIDTH_M)
        step = right * outward(self.functional, Side.RIGHT)
        lane = move.lane + step
        if not step or not 0 <= lane <= self.lane_count:
            return move
        offset = move.offset_m + right * LANE_WIDTH_M
        return Move(move.begins_s, move.lasts_s, lane, offset, move.act, move.hazard)

    def _lane_after(self, act: Act, runner: Runner, now: int) -> int:
        into = self.runners.get(act.into or "")
        if into is not None:
            if into.forward != runner.forward:
                return 0
            if abs(into.lane - now) == 1:
                return into.lane
        side = act.side or self._free_side(runner, now)
        lane = now + outward(self.functional, side)
        return max(0, min(lane, self.lane_count))

    def _free_side(self, runner: Runner, now: int) -> Side:
        """Towards whom it endangers; else towards the centre line, if there is a lane."""
        kerb = Side(self.functional.junction.driving_side.value)
        centre = Side.LEFT if kerb is Side.RIGHT else Side.RIGHT
        for hazard in self.hazards:
            for name in hazard.to if runner.id in hazard.by else ():
                other = self.runners.get(name)
                if other is not None and other.forward == runner.forward and other.lane != now:
                    return kerb if other.lane > now else centre
                if other is not None and other.forward != runner.forward:
                    return centre
        return centre if now > 1 or now == self.lane_count else kerb


def _lasting_s(act: Act, width_m: float, usual_s: float) -> float:
    """How long a move to the side takes: a cosine's greatest speed is pi/2 of its mean."""
    if act.duration_s is not None:
        return max(act.duration_s.middle, 0.2)
    if act.lateral_mps is not None:
        return width_m * pi / 2 / max(act.lateral_mps.middle, 0.1)
    return usual_s


def _usual_rate_mps2(kind: ActKind, hazard: HazardKind | None) -> float:
    if hazard is HazardKind.HARD_BRAKING:
        return HARD_BRAKING_MPS2[0]
    if hazard is HazardKind.SUDDEN_ACCELERATION:
        return SUDDEN_ACCELERATION_MPS2[0]
    if kind in {ActKind.BRAKE, ActKind.STOP}:
        return STOPPING_MPS2
    return COMFORTABLE_ACCELERATION_MPS2


def by_rank(logical: LogicalScenario, runners: Mapping[str, Runner]) -> dict[str, int]:
    """The order of those along the road in their direction, 0 = foremost; things before all."""
    ranks = {}
    known = {a.participant: a for a in logical.assignments}
    for name in runners:
        ranks[name] = getattr(known.get(name), "rank", -1)
    return ranks


def contact_wanted(story: Story, first: str, second: str) -> bool:
    """Whether the text says that these two touch."""
    outcome = story.functional.outcome
    if outcome is None or outcome.kind is not OutcomeKind.COLLISION:
        return False
    if outcome.between:
        return {first, second} == {*outcome.between}
    return story.functional.ego.id in {first, second}
