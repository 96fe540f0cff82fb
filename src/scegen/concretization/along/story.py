"""The story of a scenario along a road: who takes part, what is done, when it begins and ends."""

from dataclasses import dataclass, field

import numpy as np

from scegen.claims.boxes import Boxes, free
from scegen.concretization.along.runner import Runner
from scegen.concretization.others import Walk
from scegen.concretization.profile import SpeedChange
from scegen.concretization.tale import Tale
from scegen.motion.following import Driver, driver_of
from scegen.motion.model import Array
from scegen.road.cross_section import median_half_m
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.bodies import Body
from scegen.scenario.logical import Drive, Rule, Standing
from scegen.scenario.roadway import BAYS, Carriageway
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import (
    Approach,
    DrivingSide,
    HazardKind,
    Maneuver,
    ParticipantKind,
    Side,
)

FIRST_ACT_S = 4.0
"""Undisturbed driving before the first act whose moment nobody says."""


@dataclass
class Story(Tale):
    """Who does what when; ``begins_s`` and ``ends_s`` by act, ``things`` lie in somebody's way.

    ``parked`` stand beside the lanes; the door that one of them opens is among the ``runners``.
    """

    runners: dict[str, Runner] = field(default_factory=dict)
    parked: dict[str, Runner] = field(default_factory=dict)
    walks: dict[str, Walk] = field(default_factory=dict)
    lane_count: int = 1
    things: dict[str, Thing] = field(default_factory=dict)
    begins_s: dict[str, float] = field(default_factory=dict)
    ends_s: dict[str, float] = field(default_factory=dict)
    first_act_s: float = FIRST_ACT_S
    seed: int = 0

    def made(
        self, name: str, kind: ParticipantKind, body: Body, lane: int = -1, *,
        forward: bool, thing: bool = False,
    ) -> Runner:  # fmt: skip
        """Somebody or something on this road, at rest; lanes may come later."""
        junction = self.functional.junction
        return Runner(
            name, kind, body, forward, lane, 0.0, thing=thing,
            keeps_left=junction.driving_side is DrivingSide.LEFT,
            inner_m=median_half_m(junction.carriageway),
            lane_width_m=junction.lanes_wide_m,
        )  # fmt: skip

    @property
    def ego_arm(self) -> int:
        """The arm by which the ego comes."""
        ego = self.logical.assignment(self.functional.ego.id)
        return ego.entry if isinstance(ego, Drive) else 0

    def standing(self, name: str) -> Standing:
        """How one who is parked stands."""
        return next(s for s in self.logical.standings if s.participant == name)

    def stands_left(self, name: str) -> bool:
        """Whether that is on the ego's left."""
        standing = self.standing(name)
        return (standing.side is Side.LEFT) == (standing.arm == self.ego_arm)

    @property
    def people(self) -> dict[str, Runner]:
        """Those along the road who are no things."""
        return {name: runner for name, runner in self.runners.items() if not runner.thing}

    @property
    def in_bays(self) -> list[str]:
        """Those who drive, and stand in a bay beside the lanes at first."""
        off = (d for d in self.logical.drives if d.maneuver is not Maneuver.STAY)
        driven = (self.functional.participant(d.participant) for d in off)
        return [p.id for p in driven if p.strip in BAYS and p.id in self.runners]

    @property
    def inwards(self) -> Side:
        """The side away from the kerb."""
        return self.functional.junction.kerb.opposite

    @property
    def merging(self) -> frozenset[str]:
        """Those who are in the lane that ends."""
        return self._who_only(Maneuver.MERGE)

    @property
    def joined(self) -> frozenset[str]:
        """Those of them who are said to be in that lane from the start, no more on the ramp."""
        return frozenset(n for n in self.merging if self.functional.participant(n).lanes)

    @property
    def exiting(self) -> frozenset[str]:
        """Those who leave by the ramp."""
        return self._who_only(Maneuver.EXIT)

    def _who_only(self, maneuver: Maneuver) -> frozenset[str]:
        return frozenset(p.id for p in self.functional.participants if p.maneuvers == {maneuver})

    @property
    def innermost(self) -> int:
        """The innermost lane to drive in: 0, that of the oncoming, where nothing parts them."""
        undivided = self.functional.junction.carriageway is Carriageway.UNDIVIDED
        return 0 if undivided else 1

    @property
    def ego(self) -> Runner:
        """The vehicle under test."""
        return self.runners[self.functional.ego.id]

    def track(self, name: str, times_s: Array) -> tuple[Boxes, Array]:
        """The boxes of somebody over time, and its speeds."""
        return (self.runners.get(name) or self.walks[name]).track(times_s)

    def seen_s(self, who: str, name: str) -> float:
        """When another becomes a danger: it slows down, comes into the lane or steps out."""
        if name not in self.runners:
            return self.walks[name].sets_off_s
        one, other = self.runners[who], self.runners[name]
        slows = [s.begins_s for s in other.steps if s.target_mps < other.speed_mps]
        comes = [m for m in other.moves if m.lane == one.lane and other.forward == one.forward]
        moments = [*slows, *(move.begins_s for move in comes or other.moves)]
        return min(moments, default=other.appears_s)

    def does(self, name: str, maneuver: Maneuver) -> bool:
        """Whether somebody drives along by that maneuver."""
        return any((d.participant, d.maneuver) == (name, maneuver) for d in self.logical.drives)

    def ranks(self) -> dict[str, int]:
        """The order along the road, foremost first; things, and who stands before the ego, lead."""
        known, far = {a.participant: a for a in self.logical.assignments}, len(self.runners)
        ranks = {name: getattr(known.get(name), "rank", -1) for name in self.runners}
        ranks |= {name: far for name in self.things if self.lies_behind(name)}
        met = {n for n, r in self.runners.items() if r.stands and ranks[n] < ranks[self.ego.id]}
        return {name: rank - far * (name in met) for name, rank in ranks.items()}

    def in_order(self) -> bool:
        """Whether those who are said to be ahead of, or behind, others are so at the start."""
        start = np.zeros(1)
        for who, of, words in self.functional.sayings:
            one, other = self.runners.get(who), self.runners.get(of)
            if one is None or other is None or one.forward != other.forward:
                continue
            clear = free(other.track(start)[0], one.track(start)[0])
            clear_m = {Approach.AHEAD: clear.front, Approach.BEHIND: clear.rear}
            along = [clear_m[word] for word in words if word in clear_m]
            if len(along) == 1 and along[0] < 0.0:
                return False
        return True

    def lies_behind(self, name: str) -> bool:
        """Whether it is a thing in the way of one who reverses."""
        thing = self.things.get(name)
        return thing is not None and self.runners[thing.in_way_of or self.ego.id].backs

    def driver(self, name: str) -> Driver:
        """Who drives somebody."""
        return driver_of(self.seed, list(self.runners).index(name))

    def lets_by(self, who: str, other: str) -> bool:
        """Whether one gives way to another, and so comes into its lane behind it.

        By an act, or as the rules say to a faster one, where no danger or number says otherwise.
        """
        functional, pair = self.functional, {who, other}
        acts = [(a.participant, a.kind, a.into) for a in functional.acts]
        if (who, ActKind.GIVE_WAY, other) in acts:
            return True
        owed = any(c.yields == who and c.rule is Rule.LANE_CHANGE and pair == {c.first, c.second}
                   for c in self.logical.conflicts)  # fmt: skip
        told = any(pair == {s.participant, s.reference} for s in functional.spacings)
        told |= bool(self.kinds_by(who) or functional.outcome) or other in {a[0] for a in acts}
        return owed and not told and self.runners[other].speed_mps > self.runners[who].speed_mps

    def stopped_before(self, act: Act) -> SpeedChange | None:
        """The stopping of another before whom one is said to stop, and so answers it."""
        said = self.rests_at(act.id)
        names = {said.participant, said.reference} - {act.participant} if said else set()
        steps = [s for n in names & self.runners.keys() for s in self.runners[n].steps]
        return next((s for s in steps if s.target_mps == 0.0), None)

    def comes_back(self, act: Act) -> bool:
        """Whether a change of lane is how one who overtakes comes back."""
        earlier = [(a.participant, a.kind) for a in self.acts[: self.acts.index(act)]]
        return act.kind is ActKind.CHANGE_LANE and (act.participant, ActKind.OVERTAKE) in earlier

    def goes_round(self, act: Act) -> bool:
        """Whether an act leads out of the lane, past somebody, and back.

        One that changes lanes where there is no other of its direction does so round somebody, and
        one that swerves round who stands in its lane.
        """
        if act.kind is ActKind.OVERTAKE:
            return True
        if act.kind is ActKind.SWERVE and act.when is None and act.lateral_m is None:
            own = self.runners[act.participant]
            return any(
                r.stands and not r.opens and (r.lane, r.forward) == (own.lane, own.forward)
                for r in self.runners.values()
            )
        if act.kind is not ActKind.CHANGE_LANE or self.comes_back(act):
            return False
        passing = self.does(act.participant, Maneuver.OVERTAKE)
        passing |= HazardKind.OVERTAKING in self.kinds_by(act.participant)
        alone = self.lane_count == 1 and self.hazard_of(act) is None
        return passing or (alone and not any((act.side, act.into, act.lateral_m)))
