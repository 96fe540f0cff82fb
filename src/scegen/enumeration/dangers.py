"""What dangers, acts and the outcome say of the ways of those concerned, as statements."""

from collections.abc import Sequence

from scegen.enumeration import predicates as p
from scegen.enumeration.presuming import Parties, outcome_pairs
from scegen.enumeration.right_of_way import road_rules
from scegen.enumeration.statements import Stated
from scegen.scenario.acts import LEAVING, ActKind
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import HAZARDS, Case, RoadRule
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind, Maneuver, Role

_RANKED = frozenset({Control.YIELD, Control.STOP, Control.PRIORITY_TO_RIGHT})
"""Where the ways alone tell who has right of way, and the text tells that they do."""


def say_dangers(
    out: Stated,
    functional: FunctionalScenario,
    sides: Sequence[Parties],
    left_open: frozenset[int],
    *,
    ranked: bool = True,
) -> dict[int, int]:
    """State what dangers, acts and the outcome demand.

    ``sides`` are those of each danger as far as they are known; of those ``left_open``, by their
    place, nothing is presumed. ``ranked``: arms are told apart by their signs. Gives back the
    dangers, by their place, of which something is presumed, by statement.
    """
    for row_kind, row in HAZARDS.items():
        out.facts += [
            p.Row(row_kind.value, list(Case).index(case), what.value)
            for case, needs in row.needs.items()
            for what in needs
        ]
        if LEAVING & set(row.acts):
            out.facts.append(p.LeavesLane(row_kind.value))
    presumed: dict[int, int] = {}
    for index, (hazard, both) in enumerate(zip(functional.hazards, sides, strict=True)):
        number = out.number(f"hazard {hazard.kind} (by {_told(hazard.by, both.by)}; "
                            f"to {_told(hazard.to, both.to)})")  # fmt: skip
        _say(out, number, hazard.kind, both)
        if index in left_open:
            continue
        meet = bool(hazard.by and hazard.to) and not HAZARDS[hazard.kind].needs
        if meet:
            out.facts.append(p.MustMeet(number))
        owes = _owes_way(functional, hazard.kind, both, ranked=ranked)
        if owes:
            out.facts.append(p.OwesWay(number))
        if both.presumed or owes or meet:
            presumed[number] = index
    if any(isinstance(fact, p.OwesWay) for fact in out.facts):
        turns_back = any(Maneuver.U_TURN in v.maneuvers for v in functional.vehicles)
        rules = road_rules(functional.junction, u_turns=turns_back)
        out.facts += [p.GoesFirst(f, y, e, x) for e, x, f, y in sorted(rules.gives_way)]
    _say_acts(out, functional)
    _say_outcome(out, functional, sides)
    return presumed


def _owes_way(
    functional: FunctionalScenario, kind: HazardKind, both: Parties, *, ranked: bool
) -> bool:
    """Whether who causes a danger breaks the right of way of one that is known.

    On a ring that does not depend on what stands at which arm.
    """
    breach = HAZARDS[kind].breaks is RoadRule.RIGHT_OF_WAY
    junction = functional.junction
    ring = junction.kind is JunctionKind.ROUNDABOUT
    known = ring or (ranked and junction.control in _RANKED)
    known = known and not functional.on_call & {*both.to}  # everybody owes them way
    return breach and bool(both.by and both.to) and known


def _say(out: Stated, number: int, kind: HazardKind, both: Parties) -> None:
    out.facts.append(p.Hazard(number, kind.value))
    out.facts += [p.By(number, name) for name in both.by]
    out.facts += [p.To(number, name) for name in both.to]


def _say_acts(out: Stated, functional: FunctionalScenario) -> None:
    """Who changes into another's lane does so as one who cuts in; who overtakes, from behind."""
    changing = set[str]()
    astray = {
        name for h in functional.hazards if h.kind is HazardKind.ONCOMING_LANE for name in h.by
    }
    for act in functional.acts:
        if act.kind is ActKind.CHANGE_LANE and act.participant not in changing:
            changing.add(act.participant)  # the first change decides where it begins
            out.facts.append(p.Changes(act.participant))
            if act.side is not None:
                out.facts.append(p.Goes(act.participant, act.side.value))
        if act.kind is ActKind.CHANGE_LANE and act.into not in {None, act.participant}:
            kind = HazardKind.ONCOMING_LANE if act.participant in astray else HazardKind.CUT_IN
        elif act.kind is ActKind.OVERTAKE and act.into is not None:
            kind = HazardKind.OVERTAKING
        else:
            continue
        number = out.number(f"act {act.id}: {act.participant} comes into the lane of {act.into}")
        _say(out, number, kind, Parties((act.participant,), (str(act.into),)))


def _say_outcome(out: Stated, functional: FunctionalScenario, sides: Sequence[Parties]) -> None:
    outcome = functional.outcome
    if outcome is None:
        return
    pairs = outcome_pairs(functional, outcome, sides)
    drivers = {v.id for v in functional.vehicles}
    listed = drivers | {c.id for c in functional.crossers}
    if not pairs or any(not listed.issuperset(pair) for pair in pairs):
        return  # what stands beside the lanes or lies in them is met by whoever comes along
    held = {v.id for v in functional.vehicles if v.maneuvers == {Maneuver.STAY}}
    placed = [v for v in functional.vehicles if len(v.approaches) == 1 or v.role is Role.EGO]
    told = {v.id for v in placed if len(v.maneuvers) == 1}
    lets_by = all(held & {*pair} or told.issuperset(pair) for pair in pairs)
    crossing = functional.junction.kind is not JunctionKind.STRAIGHT
    if outcome.kind is OutcomeKind.AVOIDED and crossing and lets_by:
        return  # who waits at its line lets everybody by; ways that are told may not meet
    either = " or ".join(f"{one} and {other}" for one, other in pairs)
    number = out.number(f"outcome {outcome.kind} (between {either})")
    out.facts.append(p.Outcome(number))
    out.facts += [
        p.MayMeet(number, *sorted(pair, key=lambda name: name not in drivers)) for pair in pairs
    ]


def _told(said: tuple[str, ...], taken: tuple[str, ...]) -> str:
    if said:
        return ", ".join(said)
    return f"{', '.join(taken)}, not said" if taken else "not said"
