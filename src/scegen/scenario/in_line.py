"""Who is ahead of whom when something is done, where a danger, an act or words tell."""

from collections.abc import Collection, Iterable
from typing import Literal

from scegen.scenario.acts import LEAVING, LETS_BY, SLOWING, Act, ActKind
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS, Arrangement, Motion
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver

_IN_LINE = frozenset({Maneuver.STRAIGHT, Maneuver.STAY})


def is_said_ahead(
    functional: FunctionalScenario,
    hazards: Iterable[Hazard],
    who: str,
    other: str,
    at: str,
    since: Literal["begin", "end"] = "begin",
) -> bool | None:
    """Whether one is ahead of another when an act begins or ends; None where nothing tells.

    Who cuts in comes in ahead and who overtakes ends ahead, wherever they came from; who brakes
    is ahead of whom that endangers, who crosses is behind whom it lets go first. Else words of the
    start count, until one goes aside.
    """
    act = next((a for a in functional.acts if a.id == at), None)
    if act is None:
        return None
    if act.participant in {who, other}:
        passive = other if act.participant == who else who
        ahead = _by_act(functional, hazards, act, passive, since)
        if ahead is not None:
            return ahead == (act.participant == who)
    before = _are_still_in_line(functional, act, since, {who, other})
    return is_ahead_at_first(functional, who, other) if before else None


def is_ahead_at_first(functional: FunctionalScenario, who: str, other: str) -> bool | None:
    """Whether one is said to be ahead of another at the start."""
    for name, reference, ahead in ((who, other, True), (other, who, False)):
        words = words_between(functional, name, reference) & {Approach.AHEAD, Approach.BEHIND}
        if len(words) == 1:
            return (Approach.AHEAD in words) is ahead
    return None


def unconcerned(
    functional: FunctionalScenario, kind: HazardKind, by: tuple[str, ...]
) -> tuple[str, ...]:
    """Whom it cannot endanger that some slow down: themselves, and who is in front of them.

    That is who is said to be ahead, or to come there out of the next lane.
    """
    row = HAZARDS[kind]
    if row.then is not Arrangement.AHEAD or row.moves is not Motion.ALONG:
        return by
    comes = [
        a.participant for a in functional.acts if a.kind is ActKind.CHANGE_LANE and a.into in by
    ]
    found, others = [*by, *comes], [p.id for p in functional.participants]
    while True:  # and whoever is ahead of those
        left = [o for o in others if o not in found]
        ahead = [o for o in left if any(is_ahead_at_first(functional, o, n) for n in found)]
        if not ahead:
            return tuple(dict.fromkeys(found))
        found += ahead


def words_between(functional: FunctionalScenario, name: str, reference: str) -> frozenset[Approach]:
    """Where somebody is said to be, seen from another; nothing is said of things."""
    told = (words for *two, words in functional.sayings if two == [name, reference])
    return frozenset[Approach]().union(*told)


def in_next_lane(words: Collection[Approach]) -> Approach | None:
    """Where along the road one is that is beside another; None where that is not said.

    ``adjacent`` with one of ``ahead`` and ``behind`` says so; with both, any of the three is meant.
    """
    along = {Approach.AHEAD, Approach.BEHIND} & set(words)
    return along.pop() if Approach.ADJACENT in words and len(along) == 1 else None


def goes_first(functional: FunctionalScenario, other: str, name: str) -> bool:
    """Whether somebody is said to let another go first."""
    acts = (act for act in functional.acts if act.kind in LETS_BY)
    return any((act.participant, act.into) == (name, other) for act in acts)


def _by_act(
    functional: FunctionalScenario, hazards: Iterable[Hazard], act: Act, other: str, since: str
) -> bool | None:
    """Whether who acts is ahead of another: as the danger that it makes has it."""
    if act.kind is ActKind.CROSS and goes_first(functional, other, act.participant):
        return False
    if act.kind is ActKind.OVERTAKE and other in functional.overtaken(act.participant):
        return since == "end"
    if act.kind is ActKind.CHANGE_LANE and act.into == other and _passes(functional, act, other):
        return True
    found = {
        HAZARDS[hazard.kind].then is Arrangement.AHEAD
        for hazard in hazards
        if HAZARDS[hazard.kind].then and act.participant in hazard.by and other in hazard.to
        and _makes(functional, act, hazard, other)
    }  # fmt: skip
    return found.pop() if len(found) == 1 else None


def _passes(functional: FunctionalScenario, act: Act, other: str) -> bool:
    """Whether it is how one who has passed another comes back in front of it."""
    ways = functional.participant(act.participant).maneuvers
    return Maneuver.OVERTAKE in ways or other in functional.overtaken(act.participant)


def _makes(functional: FunctionalScenario, act: Act, hazard: Hazard, other: str) -> bool:
    """Whether it is by this act that somebody endangers another; one comes in by its last one."""
    if HAZARDS[hazard.kind].moves is not Motion.ACROSS:
        return act.kind in SLOWING
    own = [a for a in functional.acts if a.participant == act.participant and a.kind in LEAVING]
    into = [a for a in own if a.into == other and a.kind is not ActKind.OVERTAKE]
    return act in own and act == (into or own)[-1]


def _are_still_in_line(functional: FunctionalScenario, act: Act, since: str, two: set[str]) -> bool:
    """Whether neither of two has gone aside or turned by an act: who is to do so, does it later."""
    number = functional.acts.index(act) + (since == "end")
    aside = [{a.participant for a in acts if a.kind in LEAVING}
             for acts in (functional.acts[:number], functional.acts[number:])]  # fmt: skip
    strays = {p.id for p in functional.participants if p.id in two and p.maneuvers - _IN_LINE}
    return not two & aside[0] and strays <= aside[1]
