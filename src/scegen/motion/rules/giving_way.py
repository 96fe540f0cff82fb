"""Right of way: who gives way to whom by itself, and what giving way is.

Who has right of way takes no notice of who gives it: it is through before the other comes, or the
other is gone in time. A driver at the line who is gone ``CLEAR_S`` before has accepted a gap of
that and the 4 to 5 s that it takes from the line across two lanes: the critical headways of 6.2 to
7.1 s of the Highway Capacity Manual (TRB, 2010), exhibit 19-10 (*). A post-encroachment time of
more than 2 s is no conflict. (*) quoted from memory: the text itself could not be consulted.
"""

from dataclasses import dataclass

from scegen.motion.rules.breaches import breaks, endangered, told_hazards
from scegen.scenario.acts import LETS_BY
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import RoadRule
from scegen.scenario.logical import MEETING, Conflict, Drive, LogicalScenario, Rule
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import Control, Maneuver

CLEAR_S = 2.0
"""So long before the other comes must one be gone who goes first without right of way."""
TOGETHER_S = 0.5
"""Two who come to a line within so long arrive at once."""

_RULES = frozenset({Rule.ON_CALL, Rule.SIGN, Rule.PRIORITY_TO_RIGHT, Rule.ONCOMING, Rule.RING,
                    Rule.U_TURN, Rule.CROSSWALK})  # fmt: skip
_WHOEVER_IS_FIRST = frozenset({Rule.CROSSWALK, Rule.ON_CALL})
"""Also at an all-way stop the order of arrival is nothing to these."""


@dataclass(frozen=True, slots=True)
class Duty:
    """``yields`` gives way to ``other`` by ``rule``.

    ``by_arrival``: who is later at its line does; ``yields`` where both come at once. Without a
    rule it does because the text says so.
    """

    yields: str
    other: str
    rule: Rule | None
    by_arrival: bool = False


def must_give_way(functional: FunctionalScenario, logical: LogicalScenario) -> tuple[Duty, ...]:
    """Who gives way to whom, as nobody is said not to.

    What is said of two wins: who is said to give way does, and those whom a danger or the end
    brings together, whose distance is said, or of whom one does something that the text tells,
    meet as is told.
    """
    told = _told_pairs(functional, logical)
    acting = {act.participant for act in (*functional.acts, *logical.acts)}
    walking = {crossing.participant for crossing in logical.crossings}
    # Who steps out before somebody does so in time for that one, not for those behind it.
    stepping = {n for h in told_hazards(functional, logical) for n in h.by if n in walking}
    free = acting | stepping
    breaking = breaks(functional, logical, RoadRule.RIGHT_OF_WAY)
    all_way = functional.junction.control is Control.ALL_WAY_STOP
    said = tuple(
        Duty(act.participant, act.into, None)
        for act in functional.acts
        if act.kind in LETS_BY and act.into is not None
    )
    return said + tuple(
        Duty(yields, other, conflict.rule, all_way and conflict.rule not in _WHOEVER_IS_FIRST)
        for conflict in logical.conflicts
        if conflict.kind in MEETING and conflict.rule in _RULES and conflict.yields is not None
        for yields, other in [_ordered(conflict)]
        if frozenset((yields, other)) not in told
        and not {yields, other} & free
        and yields not in breaking
        and _goes_through(logical, yields)
        and _goes_through(logical, other)
    )


def _ordered(conflict: Conflict) -> tuple[str, str]:
    """(who yields, to whom)."""
    if conflict.yields == conflict.first:
        return conflict.first, conflict.second
    return conflict.second, conflict.first


def _goes_through(logical: LogicalScenario, name: str) -> bool:
    way = logical.assignment(name)
    return not isinstance(way, Drive) or (
        way.maneuver not in {Maneuver.STAY, Maneuver.OVERTAKE, Maneuver.LANE_CHANGE}
        and way.reverses is None
    )


def _told_pairs(
    functional: FunctionalScenario, logical: LogicalScenario
) -> frozenset[frozenset[str]]:
    """Pairs of whom the text says how they come together."""
    everybody = tuple(p.id for p in functional.participants)
    pairs = {frozenset(pair) for pair in endangered(functional, logical)}
    pairs |= {frozenset((s.participant, s.reference)) for s in functional.spacings}
    outcome = functional.outcome
    if outcome is not None and outcome.kind is not OutcomeKind.AVOIDED:
        between = outcome.between or (functional.ego.id,)
        others = between if len(between) > 1 else everybody
        pairs |= {frozenset((one, other)) for one in between for other in others}
    return frozenset(pairs)
