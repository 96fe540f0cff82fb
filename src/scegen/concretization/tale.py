"""What both levels tell that happens, for those who choose its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from scegen.concretization.profile import SpeedChange
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.scenario.acts import Act, ActKind, AfterAct
from scegen.scenario.concrete import Change
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import Spacing
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.vocabulary import HazardKind

_HAZARDS_OF = {
    ActKind.BRAKE: (HazardKind.HARD_BRAKING, HazardKind.STOPPING, HazardKind.LOSS_OF_CONTROL),
    ActKind.STOP: (HazardKind.HARD_BRAKING, HazardKind.STOPPING),
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


@dataclass
class Tale:
    """Both levels (see ``asked.as_meant``), and the acts spelled out in their order."""

    functional: FunctionalScenario
    logical: LogicalScenario
    acts: Sequence[Act]
    changes: list[Change] = field(default_factory=list, init=False)

    def note(self, parameter: str, after: float, reason: str, before: float | None = None) -> None:
        """Record who set a parameter and why."""
        self.changes.append(
            Change(
                parameter=parameter,
                by="concretization",
                before=before,
                after=round(after, 3),
                reason=reason,
            )
        )

    @property
    def grip_mps2(self) -> float:
        """What the tyres hold on this road."""
        return friction_of(self.functional.environment) * GRAVITY_MPS2

    @property
    def limit_mps(self) -> float:
        """The speed limit of the road."""
        return implied_limit_mps(self.functional)

    def act(self, name: str) -> Act:
        """An act by its id."""
        return next(act for act in self.acts if act.id == name)

    def has_said_speed(self, name: str) -> bool:
        """Whether the text says how fast somebody is."""
        return self.functional.participant(name).speed_mps is not None

    def kinds_by(self, name: str) -> set[HazardKind]:
        """The dangers that somebody causes."""
        return {hazard.kind for hazard in self.functional.hazards if name in hazard.by}

    def hazard_of(self, act: Act) -> HazardKind | None:
        """The danger that an act is, if it is one."""
        kinds = self.kinds_by(act.participant)
        return next((kind for kind in _HAZARDS_OF.get(act.kind, ()) if kind in kinds), None)

    def contact_wanted(self, first: str, second: str) -> bool:
        """Whether the text says that these two touch."""
        outcome = self.functional.outcome
        if outcome is None or outcome.kind is not OutcomeKind.COLLISION:
            return False
        if outcome.between:
            return {first, second} == {*outcome.between}
        return self.functional.ego.id in {first, second}

    def is_loose(self, name: str | None) -> bool:
        """Whether something is an act of which nothing says when it begins.

        What follows upon an act that is none of these is loose, too: it answers whoever does that.
        """
        if name is None:
            return False
        when = self.act(name).when
        if isinstance(when, AfterAct):
            return all(other.id != when.act for other in self.acts)
        return when is None

    def first_act(self, name: str, kind: ActKind) -> Act | None:
        """The first act of somebody that is of a kind."""
        own = (act for act in self.functional.acts if act.participant == name)
        return next((act for act in own if act.kind is kind), None)

    def rests_at(self, act: str | None) -> Spacing | None:
        """How far from another one is said to be once an act has brought it to rest."""
        return next((s for s in self.functional.spacings if s.since == "end" and s.at == act), None)

    def loose(self, changes: Sequence[SpeedChange], before_mps: float) -> SpeedChange | None:
        """The braking of which nothing says when it begins: the answer to who is ahead."""
        for change in changes:
            slows = change.target_mps < before_mps and change.then_s is None
            if slows and self.is_loose(change.act):
                named = {spacing.at for spacing in self.functional.spacings}
                return None if change.act in named else change
        return None
