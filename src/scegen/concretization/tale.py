"""What both levels above tell, for those who choose the numbers."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

from scegen.concretization.profile import SpeedChange
from scegen.enumeration.ranges import speed_range
from scegen.motion.friction import GRAVITY_MPS2, friction_of
from scegen.scenario.acts import GAINING, LEAVING, SLOWING, Act, ActKind, AfterAct, WhenMeasure
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import Change
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import FROM_BESIDE, HAZARDS
from scegen.scenario.in_line import words_between
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.parameters import ParameterRange
from scegen.scenario.spacings import START, Measure, Spacing
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, Side

SIDEWAYS = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
"""What leads out of the lane beside the way through a junction."""
SWERVING = frozenset({HazardKind.SWERVING, HazardKind.LOSS_OF_CONTROL})
"""The dangers of those who leave their lane and come back."""
_ROUNDING_MPS = 1e-3
_ALIKE = (SLOWING, GAINING, LEAVING | {ActKind.TURN})
"""What is told by one of these may be a danger that consists of another."""


def changes_before_turning(functional: FunctionalScenario, drive: Drive) -> bool:
    """``changes lanes just before it turns``: beside the way through the junction, too."""
    own = (act.kind for act in functional.acts if act.participant == drive.participant)
    return drive.turn in {Maneuver.LEFT, Maneuver.RIGHT} and ActKind.CHANGE_LANE in own


def as_meant(functional: FunctionalScenario, logical: LogicalScenario) -> FunctionalScenario:
    """What is described, with dangers and acts as the logical scenario has them.

    One made by hand may have none: there they are as described.
    """
    hazards, acts = logical.hazards or functional.hazards, logical.acts or functional.acts
    return functional.but(hazards=hazards, acts=acts)


def outward(functional: FunctionalScenario, side: Side) -> int:
    """1 if that side of one who drives is towards the kerb, -1 if towards the centre line."""
    return 1 if side.value == functional.junction.driving_side.value else -1


def side_of(functional: FunctionalScenario, name: str, reference: str) -> Side | None:
    """On which side of another somebody is said to be, None if on neither or on both."""
    sides = words_between(functional, name, reference) & {Approach.LEFT, Approach.RIGHT}
    return Side(next(iter(sides)).value) if len(sides) == 1 else None


def told_at(functional: FunctionalScenario, act: Act | None) -> list[Spacing | WhenMeasure]:
    """How far apart two are said to be as an act begins, what sets it off last; else at first."""
    at = START if act is None else act.id
    told: list[Spacing | WhenMeasure] = [s for s in functional.spacings if s.at == at]
    return told + ([act.when] if act and isinstance(act.when, WhenMeasure) else [])


def pace_of(functional: FunctionalScenario, logical: LogicalScenario, name: str) -> ParameterRange:
    """How fast somebody may be who moves; of a logical scenario made by hand, as of one listed."""
    listed = (p for p in logical.parameters if p.name == f"{name}.speed_mps")
    pace = next(listed, None) or speed_range(functional, logical.assignment(name))
    said = functional.participant(name).speed_mps
    if said is None or abs(said.middle - pace.default) > _ROUNDING_MPS:
        return pace
    return pace.but(low=said.low, high=said.high, default=said.middle)


def at_odds(functional: FunctionalScenario, first: str, second: str) -> bool:
    """Whether what is to happen is between these two: a danger, or how it ends.

    Where the text tells of neither, it is between the ego and everybody.
    """
    pair, ego = {first, second}, functional.ego.id
    outcome = functional.outcome
    if outcome is not None and outcome.kind is not OutcomeKind.AVOIDED:
        return pair <= {*outcome.between} if len(outcome.between) > 1 else ego in pair
    if not functional.hazards:
        return outcome is None and ego in pair
    return any(pair <= {*hazard.by, *hazard.to} for hazard in functional.hazards)


@dataclass
class Tale:
    """Both levels (see ``as_meant``), and the acts spelled out in their order."""

    functional: FunctionalScenario
    logical: LogicalScenario
    acts: Sequence[Act]
    changes: list[Change] = field(default_factory=list, init=False)
    caused: dict[Hazard, Hazard] = field(default_factory=dict, init=False)

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
    def hazards(self) -> tuple[Hazard, ...]:
        """The dangers, with the things that cause them."""
        return tuple(self.caused.get(hazard, hazard) for hazard in self.functional.hazards)

    def blame(self, thing: Thing, hazard: Hazard) -> None:
        """Let a thing cause a danger, to whoever it lies in the way of if nobody is said to."""
        to = hazard.to or (thing.in_way_of or self.functional.ego.id,)
        self.caused[hazard] = hazard.but(by=(thing.id,), to=to)

    @property
    def grip_mps2(self) -> float:
        """What the tyres hold on this road."""
        return friction_of(self.functional.environment) * GRAVITY_MPS2

    @property
    def limit_mps(self) -> float:
        """The speed limit of the road."""
        return implied_limit_mps(self.functional)

    def act(self, name: str) -> Act:
        """An act by its id: one that is done, or one that the rules of the road see to."""
        return next(act for act in (*self.acts, *self.functional.acts) if act.id == name)

    def has_said_speed(self, name: str) -> bool:
        """Whether the text says how fast somebody is."""
        return self.functional.participant(name).speed_mps is not None

    def driven_mps(self, name: str, usual_mps: float) -> float:
        """How fast somebody drives who does: as is said, else as is usual."""
        said = self.functional.participant(name).speed_mps
        return said.middle if said is not None and said.high > 0 else usual_mps

    def kinds_by(self, name: str) -> set[HazardKind]:
        """The dangers that somebody causes."""
        return {hazard.kind for hazard in self.functional.hazards if name in hazard.by}

    def of_kind(self, kind: HazardKind) -> Iterator[Hazard]:
        """The dangers of a kind."""
        return (hazard for hazard in self.functional.hazards if hazard.kind is kind)

    def endangered_by(self, name: str, *kinds: HazardKind) -> list[str]:
        """Who suffers the dangers that somebody causes, of some kinds or of any."""
        caused = (hazard for hazard in self.functional.hazards if name in hazard.by)
        return [to for hazard in caused if not kinds or hazard.kind in kinds for to in hazard.to]

    @property
    def impact_share(self) -> float:
        """Where on one's width, from the left, another touches it; in the middle if not said."""
        outcome = self.functional.outcome
        percent = outcome.impact_percent if outcome is not None else None
        return 0.5 if percent is None else percent.middle / 100

    def struck_left_m(self, body: Body) -> float:
        """How far to the left of the middle of a body that is."""
        return (0.5 - self.impact_share) * body.width_m

    def hazard_of(self, act: Act) -> HazardKind | None:
        """The danger that an act is, if it is one; rather one of just such moves aside."""
        alike = next((kinds for kinds in _ALIKE if act.kind in kinds), frozenset())
        beside = FROM_BESIDE if act.kind is ActKind.CHANGE_LANE else frozenset()
        own = self.kinds_by(act.participant)
        found = [k for k in HAZARDS if k in own and (k in beside or alike & {*HAZARDS[k].acts})]
        aside = act.kind in LEAVING
        return min(found, key=lambda k: aside and act.kind not in HAZARDS[k].acts, default=None)

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

    def acts_of(self, name: str, kinds: Collection[ActKind] = frozenset(ActKind)) -> list[Act]:
        """What somebody does, in order: all, or what is of some kinds."""
        return [act for act in self.acts if act.participant == name and act.kind in kinds]

    def speed_acts(self, name: str) -> list[Act]:
        """The changes of speed that the text tells of somebody, in order."""
        return self.acts_of(name, SLOWING | GAINING)

    def first_act(self, name: str, *kinds: ActKind) -> Act | None:
        """The first act that the text tells of somebody that is of some kinds."""
        own = (act for act in self.functional.acts if act.participant == name)
        return next((act for act in own if act.kind in kinds), None)

    def rests_at(self, act: str | None) -> Spacing | None:
        """How far from another one is said to be once an act has brought it to rest."""
        return next((s for s in self.functional.spacings if s.since == "end" and s.at == act), None)

    def between(self, one: str, other: str, *measures: Measure) -> Spacing | None:
        """How far apart two are said to be, by one of these measures."""
        pair = {one, other}
        said = (s for s in self.functional.spacings if {s.participant, s.reference} == pair)
        return next((s for s in said if s.measure in measures and s.since == "begin"), None)

    def loose(self, changes: Sequence[SpeedChange], before_mps: float) -> SpeedChange | None:
        """The braking of which nothing says when it begins: the answer to who is ahead."""
        for change in changes:
            slows = change.target_mps < before_mps and change.then_s is None
            if slows and self.is_loose(change.act):
                named = {s.at for s in self.functional.spacings if s.since == "begin"}
                return None if change.act in named else change
        return None
