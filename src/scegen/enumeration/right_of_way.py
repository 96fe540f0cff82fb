"""Who gives way: the table of right_of_way.lp, looked up for two participants.

The rules are those of the Vienna Convention on Road Traffic of 1968 (VC); the encoding names the
article of each. Where it leaves a choice:

* Without signs, ``uncontrolled`` and ``priority_to_right`` mean the same at a crossing: who comes
  from the right goes first (VC 18.4a). VC 18.4b leaves countries that keep left free; there too
  it is the right, as in Australia (Australian Road Rules, rule 72) and New Zealand. Great Britain
  has no such rule (Highway Code, rule 146: nobody has priority), Japan gives it to the left.
* Lights that do not work regulate nothing, as if they were not there (VC 5, 18; some states of the
  USA take them for an all-way stop, which a text has to say).
* A T has no rule of its own (Australian Road Rules, rule 73, puts the stem last; VC does not).
* On a roundabout the ring goes first, also without signs (Highway Code, rule 185); only where
  ``priority_to_right`` is said do those who come in from the right of the ring go first.
* An all-way stop goes by order of arrival, which a logical scenario does not have: all count as
  arriving at once, and then the one to the right goes first (US Uniform Vehicle Code 11-401).
* Two on one arm: who is behind keeps its distance (VC 13), who changes lane lets the other pass
  (VC 14).
* An emergency vehicle counts as any other, unless it is on call (VC 34.1; see `conflicts`).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from clorm import Predicate

from scegen.enumeration import answers as a
from scegen.enumeration import predicates as p
from scegen.enumeration.programs import Part, consequences
from scegen.enumeration.statements import junction_facts
from scegen.enumeration.wide_curves import Ways, curves_that_meet
from scegen.scenario.arms import arm_angles_deg, turn_deg
from scegen.scenario.control import controlled_arms, has_crosswalk, oncoming_arms, signal_phases
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Assignment, ConflictKind, Crossing, Drive, Rule
from scegen.scenario.vocabulary import Control, JunctionKind, Maneuver, Side

Footing = tuple[int, int, int]
"""Entry and exit of a vehicle, arm that somebody crosses."""


@dataclass(frozen=True)
class RoadRules:
    """Conflicts and right of way of all ways through one junction.

    ``gives_way[e, x, f, y]`` is the rule by which the driver on e -> x gives way to the one on
    f -> y, ``open`` the reason why nobody can say; for those who cross an arm likewise.
    ``stuck`` are the ways that a deadlock may hold up. Who enters keeps to the side ``kerb``.
    """

    kinds: dict[Ways, ConflictKind]
    gives_way: dict[Ways, Rule]
    open: dict[Ways, Rule]
    lets_cross: dict[Footing, Rule]
    waits_to_cross: dict[Footing, Rule]
    open_to_cross: dict[Footing, Rule]
    stuck: frozenset[tuple[int, int]]
    kerb: Side


@lru_cache(maxsize=64)
def road_rules(junction: Junction, *, u_turns: bool = False) -> RoadRules:
    """The table of a junction, by one run of the solver; ``u_turns`` draws these roads too."""
    parts = (Part.ARMS, Part.CONFLICTS, Part.RIGHT_OF_WAY, Part.DEADLOCK)
    wanted = (
        a.Meets, a.GivesWay, a.Open, a.LetsCross, a.WaitsToCross, a.OpenToCross, a.Stuck
    )  # fmt: skip
    found = consequences(rule_facts(junction, u_turns=u_turns), parts, wanted)
    return RoadRules(
        kinds={
            tuple(fact)[:-1]: ConflictKind(fact.kind) for fact in found if isinstance(fact, a.Meets)
        },
        gives_way=_rules(found, a.GivesWay),
        open=_rules(found, a.Open),
        lets_cross=_rules(found, a.LetsCross),
        waits_to_cross=_rules(found, a.WaitsToCross),
        open_to_cross=_rules(found, a.OpenToCross),
        stuck=frozenset((fact.way[0], fact.way[1]) for fact in found if isinstance(fact, a.Stuck)),
        kerb=junction.kerb,
    )


def rule_facts(junction: Junction, *, u_turns: bool = False) -> list[Predicate]:
    """What the encodings are told of a junction: its ways, signs, lights and views."""
    arms, control = range(junction.arms), junction.control
    facts: list[Predicate] = [
        fact
        for fact in junction_facts(junction)
        if isinstance(fact, p.Arms | p.Turn | p.Ring | p.LeftHand)
    ]
    angles = arm_angles_deg(junction)
    facts += [
        p.RightOf(arm, other)
        for arm in arms
        for other in arms
        if arm != other and turn_deg(angles, arm, (other - arm) % junction.arms) < 0
    ]
    facts += [p.Oncoming(*pair) for pair in sorted(oncoming_arms(junction))]
    facts += [p.CurvesMeet(*pair) for pair in sorted(curves_that_meet(junction, u_turns=u_turns))]
    facts += [p.Crosswalk(arm) for arm in arms if has_crosswalk(junction, arm)]
    if control in {Control.YIELD, Control.STOP}:
        facts += [p.Minor(arm) for arm in sorted(controlled_arms(junction))]
    if control is Control.SIGNALS:
        facts += [p.Phase(arm, phase) for arm, phase in enumerate(signal_phases(junction))]
    right = p.LeftHand() not in facts
    if junction.kind is JunctionKind.ROUNDABOUT and control is Control.PRIORITY_TO_RIGHT and right:
        facts.append(p.EntryFirst())
    return facts


def right_of_way(
    rules: RoadRules, first: Assignment, second: Assignment
) -> tuple[str | None, Rule | None]:
    """Who of two whose paths meet gives way, and by which rule; None if nobody need or can say."""
    if isinstance(first, Drive) and isinstance(second, Drive):
        if first.entry == second.entry:
            return _on_one_arm(first, second)
        return _from_two_arms(rules, first, second)
    drive, other = (first, second) if isinstance(first, Drive) else (second, first)
    if not isinstance(drive, Drive):
        return None, None
    if isinstance(other, Crossing):
        return _with_crosser(rules, drive, other)
    return drive.participant, Rule.AHEAD


def _from_two_arms(rules: RoadRules, first: Drive, second: Drive) -> tuple[str | None, Rule | None]:
    for one, other in ((first, second), (second, first)):
        rule = rules.gives_way.get((one.entry, one.exit, other.entry, other.exit))
        if rule is not None:
            return one.participant, rule
    return None, rules.open.get((first.entry, first.exit, second.entry, second.exit))


def _on_one_arm(first: Drive, second: Drive) -> tuple[str | None, Rule | None]:
    changing = [d for d in (first, second) if d.maneuver is Maneuver.LANE_CHANGE]
    if len(changing) == 1:
        return changing[0].participant, Rule.LANE_CHANGE
    if first.rank == second.rank:
        return None, None
    return max(first, second, key=lambda drive: drive.rank).participant, Rule.AHEAD


def _with_crosser(
    rules: RoadRules, drive: Drive, crossing: Crossing
) -> tuple[str | None, Rule | None]:
    footing = (drive.entry, drive.exit, crossing.arm)
    if footing in rules.lets_cross:
        return drive.participant, rules.lets_cross[footing]
    if footing in rules.waits_to_cross:
        return crossing.participant, rules.waits_to_cross[footing]
    return None, rules.open_to_cross.get(footing)


def _rules(found: Iterable[Predicate], kind: type[Predicate]) -> dict[Any, Rule]:
    """The rules that facts of a kind tell, by the ways of whom."""
    return {tuple(fact)[:-1]: Rule(fact.rule) for fact in found if isinstance(fact, kind)}
