"""The story of a scenario along a road: who takes part, what is done, when it begins and ends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from scegen.claims.boxes import Boxes
from scegen.concretization.along.runner import Runner
from scegen.concretization.asked import contact_wanted as said_to_touch
from scegen.concretization.asked import dangers, hazard_of
from scegen.concretization.speed_change import SpeedChange
from scegen.motion.following import Driver, driver_of
from scegen.motion.model import Array
from scegen.scenario.acts import Act, ActKind, AfterAct
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import Spacing
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import Approach, HazardKind

FIRST_ACT_S = 4.0
"""Undisturbed driving before the first act whose moment nobody says."""


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
    seed: int = 0

    @property
    def innermost(self) -> int:
        """The innermost lane to drive in: 0, that of the oncoming, where nothing parts them."""
        undivided = self.functional.junction.carriageway is Carriageway.UNDIVIDED
        return 0 if undivided else 1

    @property
    def hazards(self) -> tuple[Hazard, ...]:
        """The dangers, with everybody named who causes and who suffers them."""
        return dangers(self.functional, self.logical)

    @property
    def ego(self) -> Runner:
        """The vehicle under test."""
        return self.runners[self.functional.ego.id]

    def track(self, name: str, times_s: Array) -> tuple[Boxes, Array]:
        """The boxes of somebody over time, and its speeds."""
        return self.runners[name].track(times_s)

    def hazard_of(self, act: Act) -> HazardKind | None:
        """The danger that an act is, if it is one."""
        return hazard_of(self.hazards, act)

    def words(self, name: str, reference: str) -> frozenset[Approach]:
        """Where somebody is said to be, seen from another; nothing is said of things."""
        found: frozenset[Approach] = frozenset()
        if reference == self.ego.id and not self.runners[name].thing:
            found |= self.functional.participant(name).approaches
        for relation in self.functional.relations:
            if (relation.participant, relation.reference) == (name, reference):
                found |= relation.approaches
        return found

    def driver(self, name: str) -> Driver:
        """Who drives somebody."""
        return driver_of(self.seed, list(self.runners).index(name))

    def concern(self, first: str, second: str) -> bool:
        """Whether what is to happen is between these two: a danger, or how it ends.

        Where the text tells of neither, it is between the ego and everybody.
        """
        pair, ego = {first, second}, self.ego.id
        outcome = self.functional.outcome
        if outcome is not None and outcome.kind is not OutcomeKind.AVOIDED:
            return pair <= {*outcome.between} if len(outcome.between) > 1 else ego in pair
        if not self.hazards:
            return outcome is None and ego in pair
        return any(pair <= {*hazard.by, *hazard.to} for hazard in self.hazards)

    def act(self, name: str) -> Act:
        """An act by its id."""
        return next(act for act in self.acts if act.id == name)

    def is_loose(self, act: Act) -> bool:
        """Whether nothing along the road says when an act begins.

        What follows upon an act of one who crosses is loose, too: it answers that one.
        """
        when = act.when
        if isinstance(when, AfterAct):
            return all(other.id != when.act for other in self.acts)
        return when is None

    def rests_at(self, act: Act) -> Spacing | None:
        """How far from another one is said to be once the act has brought it to rest."""
        said = (s for s in self.functional.spacings if s.at_rest and s.at == act.id)
        return next(said, None)

    def stopped_before(self, act: Act) -> SpeedChange | None:
        """The stopping of another before whom one is said to stop, and so answers it."""
        said = self.rests_at(act)
        names = {said.participant, said.reference} - {act.participant} if said else set()
        steps = [s for n in names & self.runners.keys() for s in self.runners[n].steps]
        return next((s for s in steps if s.target_mps == 0.0), None)

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


def by_rank(logical: LogicalScenario, runners: Mapping[str, Runner]) -> dict[str, int]:
    """The order of those along the road in their direction, 0 = foremost; things before all."""
    ranks = {}
    known = {a.participant: a for a in logical.assignments}
    for name in runners:
        ranks[name] = getattr(known.get(name), "rank", -1)
    return ranks


def contact_wanted(story: Story, first: str, second: str) -> bool:
    """Whether the text says that these two touch."""
    return said_to_touch(story.functional, first, second)
