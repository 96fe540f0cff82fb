"""The table of hazards: everything that is known about a kind, in one place.

A kind needs its word in :class:`HazardKind`, a row here, a predicate, and a recipe or constraint
where its acts and its arrangement do not make it; ``docs/how-to/add-a-hazard.md`` shows one.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Literal

from scegen.scenario.acts import ActKind
from scegen.scenario.definitions import Definition
from scegen.scenario.vocabulary import HazardKind


class Party(StrEnum):
    """Who is one side of a danger, seen from the other side, where the text does not say.

    ``tailgated``: whom somebody tailgates. ``leader``, ``follower``: next ahead and behind in the
    lane of the other side. ``beside``: in the lane next to it. ``oncoming``: on the other's road,
    towards it. ``crossing``: whose way meets the other's. ``walker``, ``cyclist``: who goes over
    the road on foot, by bicycle; ``animal``: one that does. ``yielding``: who is said to wait for
    the other or to give way to it. ``standing``: who stands or is parked. ``thing``: an object that
    causes nothing else. ``ego``. ``other``: the first other vehicle that drives; ``others``:
    everybody else who moves.
    """

    TAILGATED = "tailgated"
    LEADER = "leader"
    FOLLOWER = "follower"
    BESIDE = "beside"
    ONCOMING = "oncoming"
    CROSSING = "crossing"
    WALKER = "walker"
    CYCLIST = "cyclist"
    ANIMAL = "animal"
    YIELDING = "yielding"
    STANDING = "standing"
    THING = "thing"
    EGO = "ego"
    OTHER = "other"
    OTHERS = "others"


class Case(StrEnum):
    """Where the two are, as far as it changes what a danger needs.

    The first of these that fits and that a row has is the one that counts: ``ring`` at a
    roundabout; ``plain_road`` without a junction, for two of one direction of whom nobody turns
    back; ``one_arm`` where the words let both enter by one arm; ``apart`` where they do not;
    ``anywhere``.
    """

    RING = "ring"
    PLAIN_ROAD = "plain_road"
    ONE_ARM = "one_arm"
    APART = "apart"
    ANYWHERE = "anywhere"


class Arrangement(StrEnum):
    """What a danger needs of the ways of who causes it and who suffers it.

    On one arm: ``ahead``, ``behind`` (who causes it is so, in line), ``together`` (in any order or
    side by side). From different arms: ``one_exit`` (they leave by one), ``facing`` (they come
    from opposite arms), ``oncoming`` (facing, or one leaves where the other comes in). Their ways
    ``clash`` (cross or merge), ``merge``, ``meet`` (in any manner), share a stretch of the ring
    (``one_ring``). ``across``: who causes it turns over the oncoming lane. ``into``: it comes
    backwards into the other's way. ``over``: it goes over an arm that the other uses.
    """

    AHEAD = "ahead"
    BEHIND = "behind"
    TOGETHER = "together"
    ONE_EXIT = "one_exit"
    FACING = "facing"
    ONCOMING = "oncoming"
    CLASH = "clash"
    MERGE = "merge"
    MEET = "meet"
    ONE_RING = "one_ring"
    ACROSS = "across"
    INTO = "into"
    OVER = "over"


class RoadRule(StrEnum):
    """A rule of the road that a danger breaks; whoever causes it breaks this one and no other."""

    SPEED_LIMIT = "speed_limit"
    SIGNAL = "signal"
    RIGHT_OF_WAY = "right_of_way"
    SAFE_DISTANCE = "safe_distance"
    OWN_SIDE = "own_side"


class Motion(StrEnum):
    """In which direction who causes a danger does what makes it; ``still`` if it only is there."""

    ALONG = "along"
    ACROSS = "across"
    STILL = "still"


_EGO_OR_OTHERS = (Party.EGO, Party.OTHERS)


@dataclass(frozen=True, slots=True)
class HazardRow:
    """One kind of danger.

    Attributes:
        meaning: definition, neighbours, example.
        moves: along or across the lane.
        causes: who causes it where nobody is named, seen from who suffers it (from the ego, if
            that is not said either): tried in order, the first that is found and does not suffer.
        suffers: the same for who suffers it, seen from who causes it.
        needs: what it needs of the ways of both; empty: nothing.
        breaks: the rule of the road that it breaks.
        then: how who causes it stands to who suffers it when it does so, of two in one line.
        acts: what who causes it does, where the text gives no act of it.
        speed_share: low, high and usual share of the limit that who causes it drives.
        more_of: the quantity of who causes it that makes more of it, and in which direction.
    """

    meaning: Definition
    moves: Motion
    causes: tuple[Party, ...] = (Party.OTHER, Party.EGO)
    suffers: tuple[Party, ...] = _EGO_OR_OTHERS
    needs: Mapping[Case, tuple[Arrangement, ...]] = field(default_factory=dict)
    breaks: RoadRule | None = None
    then: Literal[Arrangement.AHEAD, Arrangement.BEHIND] | None = None
    acts: tuple[ActKind, ...] = ()
    speed_share: tuple[float, float, float] | None = None
    more_of: tuple[str, Literal[1, -1]] | None = None


HARD_BRAKING_MPS2 = 5.0
"""UN R152: emergency braking demands at least as much."""
CUT_IN_S = 1.0
"""So far ahead, by the speed of who follows, a cut-in is close: near UN R157."""
_BEHIND_ONE = {Case.ONE_ARM: (Arrangement.AHEAD,), Case.APART: (Arrangement.MEET,)}
"""Who brakes, stops or crawls endangers whoever follows, or meets it."""
_FOLLOWED = (Party.TAILGATED, Party.LEADER, Party.EGO, Party.OTHER)


def _goes_over(meaning: Definition, who: Party) -> HazardRow:
    """The row of those who come over the road from its edge."""
    return HazardRow(
        meaning,
        Motion.ACROSS,
        causes=(who,),
        suffers=(Party.YIELDING, *_EGO_OR_OTHERS),
        needs={Case.ANYWHERE: (Arrangement.OVER,)},
        acts=(ActKind.CROSS,),
    )


HAZARDS: dict[HazardKind, HazardRow] = {
    HazardKind.SPEEDING: HazardRow(
        Definition(
            "drives faster than the limit, or than is said to fit the place",
            "a number alone, however high; `sudden_acceleration`, where the speed rises",
            "a van comes from the left at excessive speed",
        ),
        moves=Motion.ALONG,
        breaks=RoadRule.SPEED_LIMIT,
        speed_share=(1.1, 1.5, 1.25),
        more_of=("speed_mps", 1),
    ),
    HazardKind.SUDDEN_ACCELERATION: HazardRow(
        Definition(
            "gains speed harshly or unexpectedly",
            "`speeding`, which is about how fast it is, not how fast it becomes; setting off",
            "the taxi suddenly speeds up and enters first",
        ),
        moves=Motion.ALONG,
        needs={Case.RING: (Arrangement.ONE_RING,)},
        acts=(ActKind.ACCELERATE,),
        more_of=("rate_mps2", 1),
    ),
    HazardKind.HARD_BRAKING: HazardRow(
        Definition(
            "brakes by its own decision, hard or suddenly in words, or with at least "
            f"{HARD_BRAKING_MPS2:g} m/s2",
            "a lower rate alone; `stopping`, where that it stands is the danger; a reaction that "
            "another forces",
            "the lead car brakes sharply in front of the ego",
        ),
        causes=_FOLLOWED,
        suffers=(Party.FOLLOWER, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        then=Arrangement.AHEAD,
        needs=_BEHIND_ONE,
        acts=(ActKind.BRAKE,),
        more_of=("rate_mps2", 1),
    ),
    HazardKind.DELAYED_BRAKING: HazardRow(
        Definition(
            "brakes later than it should or fails to, or is said to notice, react or stop too late",
            "`hard_braking`, whose danger is for those behind; `failure_to_yield`, where it takes "
            "another's way at a junction; a distance alone",
            "distracted, the driver brakes late behind the bus",
        ),
        causes=(Party.EGO, Party.FOLLOWER, Party.OTHER),
        suffers=(Party.LEADER, Party.CROSSING, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        then=Arrangement.BEHIND,
        needs={Case.ONE_ARM: (Arrangement.BEHIND,), Case.APART: (Arrangement.MEET,)},
        acts=(ActKind.BRAKE,),
        more_of=("rate_mps2", 1),
    ),
    HazardKind.STOPPING: HazardRow(
        Definition(
            "stops or stands in the travelled way of others, with its driver or rider",
            "`hard_braking` if only the braking is said; a wait that a rule demands; "
            "`obstacle`, for a thing and a parked or broken-down vehicle; at the edge of the road",
            "a taxi stops in the lane to let somebody out; a stationary car in the ego's lane",
        ),
        causes=_FOLLOWED,
        suffers=(Party.FOLLOWER, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        then=Arrangement.AHEAD,
        needs=_BEHIND_ONE,
        acts=(ActKind.STOP,),
    ),
    HazardKind.SLOW_DRIVING: HazardRow(
        Definition(
            "moves much more slowly than the traffic around it",
            "`hard_braking`, where it slows down; a number alone; the slow ego of a test",
            "a tractor crawls along in front of the ego",
        ),
        causes=(Party.LEADER, Party.OTHER, Party.EGO),
        suffers=(Party.FOLLOWER, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        then=Arrangement.AHEAD,
        needs=_BEHIND_ONE,
        speed_share=(0.2, 0.5, 0.35),
        more_of=("speed_mps", -1),
    ),
    HazardKind.CUT_IN: HazardRow(
        Definition(
            "comes into somebody's lane from the side, close in front of it",
            f"a lane change not called so that endangers nobody, {CUT_IN_S:g} s or more ahead "
            "(headway); `merging_conflict` where ways join; `failure_to_yield` across a junction",
            "the van squeezes in 8 m ahead of the ego",
        ),
        causes=(Party.BESIDE, Party.OTHER, Party.EGO),
        moves=Motion.ACROSS,
        then=Arrangement.AHEAD,
        needs={
            Case.RING: (Arrangement.ONE_RING,),
            Case.ONE_ARM: (Arrangement.TOGETHER,),
            Case.APART: (Arrangement.ONE_EXIT,),
        },
        acts=(ActKind.CHANGE_LANE,),
    ),
    HazardKind.SWERVING: HazardRow(
        Definition(
            "moves sideways off its course, abruptly or drifting, and is still steered",
            "`cut_in`, where it takes a place in front of somebody; `loss_of_control`, where the "
            "driver cannot help it",
            "a motorcycle weaves between the lanes",
        ),
        moves=Motion.ACROSS,
        acts=(ActKind.SWERVE,),
    ),
    HazardKind.TAILGATING: HazardRow(
        Definition(
            "follows too closely",
            "a following distance that is merely said: a spacing",
            "the truck sticks to the ego's bumper",
        ),
        causes=(Party.FOLLOWER, Party.OTHER, Party.EGO),
        suffers=(Party.LEADER, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        then=Arrangement.BEHIND,
        needs={Case.ANYWHERE: (Arrangement.BEHIND,)},
        breaks=RoadRule.SAFE_DISTANCE,
        more_of=("start_m", 1),
    ),
    HazardKind.MERGING_CONFLICT: HazardRow(
        Definition(
            "joins the way of another from a side road, a ramp or an ending lane, and leaves it "
            "no room, so that it has to slow down",
            "a merge that is said to go well (no danger); `cut_in` between lanes of one road",
            "a car merges from the right just as the ego passes",
        ),
        causes=(Party.CROSSING, Party.OTHER, Party.EGO),
        moves=Motion.ACROSS,
        then=Arrangement.AHEAD,
        needs={Case.PLAIN_ROAD: (Arrangement.TOGETHER,), Case.ANYWHERE: (Arrangement.MERGE,)},
    ),
    HazardKind.OVERTAKING: HazardRow(
        Definition(
            "passes another that moves, in a place or manner that is said or shown to be dangerous",
            "passing one that stands (the maneuver alone, or `oncoming_lane`); an overtaking "
            "that nobody is endangered by (the maneuver alone); before oncoming traffic: "
            "`oncoming_lane` alone",
            "a car tries to overtake the ego within the junction",
        ),
        causes=(Party.FOLLOWER, Party.OTHER, Party.EGO),
        suffers=(Party.LEADER, *_EGO_OR_OTHERS),
        moves=Motion.ACROSS,
        needs={Case.ONE_ARM: (Arrangement.BEHIND,)},
        acts=(ActKind.OVERTAKE,),
    ),
    HazardKind.ONCOMING_LANE: HazardRow(
        Definition(
            "drives in the lane of those who come towards it",
            "`overtaking`, if the text speaks neither of the other lane nor of oncoming traffic; a "
            "vehicle that is merely oncoming",
            "the oncoming car drifts over the centre line",
        ),
        causes=(Party.ONCOMING, Party.OTHER, Party.EGO),
        suffers=(Party.ONCOMING, *_EGO_OR_OTHERS),
        moves=Motion.ACROSS,
        needs={Case.ANYWHERE: (Arrangement.ONCOMING,)},
        breaks=RoadRule.OWN_SIDE,
        acts=(ActKind.CHANGE_LANE,),
    ),
    HazardKind.UNPROTECTED_LEFT_TURN: HazardRow(
        Definition(
            "turns left (where traffic keeps left, right) through oncoming traffic without a light "
            "of its own; caused by who turns, whoever is the ego",
            "a left turn that meets nobody who comes towards it; a U-turn; `failure_to_yield`, not "
            "said beside it for the same turn",
            "the ego turns left across an oncoming truck",
        ),
        causes=(Party.ONCOMING, Party.OTHER, Party.EGO),
        suffers=(Party.ONCOMING, *_EGO_OR_OTHERS),
        moves=Motion.ACROSS,
        needs={Case.ANYWHERE: (Arrangement.FACING, Arrangement.CLASH, Arrangement.ACROSS)},
        acts=(ActKind.TURN,),
    ),
    HazardKind.CROSSING_PEDESTRIAN: _goes_over(
        Definition(
            "a pedestrian goes over the road before a vehicle, lawfully or not",
            "one who waits, or walks along the road (no danger)",
            "a child runs out onto the road",
        ),
        Party.WALKER,
    ),
    HazardKind.CROSSING_CYCLIST: _goes_over(
        Definition(
            "a cyclist rides over the road from its edge, a cycle path or a side road",
            "a cyclist in the lanes, who drives as others do; any motorcyclist",
            "a cyclist crosses from the right on the crosswalk",
        ),
        Party.CYCLIST,
    ),
    HazardKind.CROSSING_ANIMAL: _goes_over(
        Definition(
            "an animal runs or goes over the road before a vehicle",
            "one that stands in the lane: `obstacle`; who walks a dog: `crossing_pedestrian`",
            "a deer jumps onto the road",
        ),
        Party.ANIMAL,
    ),
    HazardKind.OCCLUSION: HazardRow(
        Definition(
            "a thing or vehicle keeps somebody from being seen; caused by what hides, suffered by "
            "who cannot see",
            "fog, night, glare (the environment); `obstacle`, which is in the way",
            "a parked van hides the child from the ego; a child runs out between parked cars",
        ),
        causes=(Party.THING, Party.STANDING),
        moves=Motion.STILL,
    ),
    HazardKind.OBSTACLE: HazardRow(
        Definition(
            "a thing, or a parked or broken-down vehicle, blocks a lane",
            "`stopping`, for any other vehicle that stands; what stands beside the lanes",
            "a fallen branch lies in the ego's lane",
        ),
        causes=(Party.THING, Party.STANDING),
        moves=Motion.STILL,
    ),
    HazardKind.RED_LIGHT_RUNNING: HazardRow(
        Definition(
            "enters the junction although its light is red",
            "`failure_to_yield`, which is not said beside it for the same entry; a light that "
            "turns red (no danger)",
            "a crossing truck runs the red light",
        ),
        causes=(Party.CROSSING, Party.OTHER, Party.EGO),
        moves=Motion.ALONG,
        needs={Case.ANYWHERE: (Arrangement.CLASH,)},
        breaks=RoadRule.SIGNAL,
    ),
    HazardKind.FAILURE_TO_YIELD: HazardRow(
        Definition(
            "takes the way of one who has priority, or cuts it off at a junction",
            "`unprotected_left_turn` for a left turn before oncoming traffic, "
            "`red_light_running` at a red light; a conflict of which nobody says who is wrong",
            "a van ignores the stop sign; a bus pulls out of its stop, or a car makes a U-turn, "
            "right before the ego",
        ),
        causes=(Party.CROSSING, Party.OTHER, Party.EGO),
        moves=Motion.ALONG,
        needs={Case.PLAIN_ROAD: (Arrangement.TOGETHER,), Case.ANYWHERE: (Arrangement.CLASH,)},
        breaks=RoadRule.RIGHT_OF_WAY,
    ),
    HazardKind.REVERSING: HazardRow(
        Definition(
            "drives backwards in or into the way of others",
            "`oncoming_lane`, for one who drives forwards on the wrong side; a u-turn",
            "a car backs out of a driveway before the ego",
        ),
        suffers=(Party.FOLLOWER, *_EGO_OR_OTHERS),
        moves=Motion.ALONG,
        needs={Case.ANYWHERE: (Arrangement.INTO,)},
        acts=(ActKind.REVERSE,),
    ),
    HazardKind.SUDDEN_TURN: HazardRow(
        Definition(
            "turns abruptly, at the last moment or without a sign",
            "a normal turn (the maneuver alone); `swerving`, where it goes on in its direction",
            "the car ahead turns right at the last second",
        ),
        moves=Motion.ACROSS,
        acts=(ActKind.TURN,),
    ),
    HazardKind.LOSS_OF_CONTROL: HazardRow(
        Definition(
            "skids, slides or spins: the driver does not steer it any more",
            "`swerving`, where the driver steers; skid marks of one who only brakes",
            "a car skids on the ice into the ego's lane",
        ),
        moves=Motion.ACROSS,
        acts=(ActKind.SWERVE, ActKind.BRAKE),
    ),
}
"""Every kind has its row."""
FROM_BESIDE = frozenset(kind for kind, row in HAZARDS.items() if Case.PLAIN_ROAD in row.needs)
"""On a road without a junction, these come from the lane beside, as a cut-in does."""
