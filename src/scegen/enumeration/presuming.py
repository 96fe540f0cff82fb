"""Whom a danger concerns where the text does not say, as far as that limits what is listed.

By the table of hazards and the words alone. A presumption gives way where nothing fits it; who
causes and who suffers in the end is resolved in each scenario (resolving.py).
"""

from collections.abc import Sequence
from dataclasses import dataclass

from scegen.scenario.acts import LETS_BY
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS, Arrangement, Party
from scegen.scenario.in_line import unconcerned
from scegen.scenario.outcome import Outcome
from scegen.scenario.vocabulary import ANIMALS, Approach, HazardKind, Maneuver, ParticipantKind

MOST_PAIRS = 6
"""Pairs that may be the two of an outcome of whom the text does not tell."""


@dataclass(frozen=True)
class Parties:
    """Both sides of a danger; ``presumed`` are the names that the text does not give."""

    by: tuple[str, ...]
    to: tuple[str, ...]
    presumed: tuple[str, ...] = ()


def parties(functional: FunctionalScenario, hazard: Hazard, *, left_open: bool) -> Parties:
    """Both sides, as far as they are said or, unless left open, can be presumed."""
    row = HAZARDS[hazard.kind]
    if left_open or (hazard.by and hazard.to):
        return Parties(hazard.by, hazard.to)
    merging = any(Arrangement.MERGE in needs for needs in row.needs.values())
    if merging and len(hazard.by) == 2 and not hazard.to:
        return Parties(hazard.by[:1], hazard.by[1:])
    by, to = hazard.by, hazard.to
    if not by:
        by = _first(functional, row.causes, to or (functional.ego.id,), to)
    if not to and by:
        out = unconcerned(functional, hazard.kind, by)
        to = _ends_with(functional, by) or _first(functional, row.suffers, by, out)
    named = {*hazard.by, *hazard.to}
    return Parties(by, to, tuple(name for name in (*by, *to) if name not in named))


def _ends_with(functional: FunctionalScenario, by: tuple[str, ...]) -> tuple[str, ...]:
    """Whom the one who causes it hits, or nearly, as the text says."""
    between = functional.outcome.between if functional.outcome is not None else ()
    others = tuple(name for name in between if name not in by)
    return others if len(by) == len(others) == 1 and len(between) == 2 else ()


def _first(
    functional: FunctionalScenario,
    wanted: tuple[Party, ...],
    seen_from: tuple[str, ...],
    taken: tuple[str, ...],
) -> tuple[str, ...]:
    """The first party that the words alone tell, if it is one participant."""
    for party in wanted:
        found = [n for n in _by_the_words(functional, party, seen_from) if n not in taken]
        if found:
            ego = functional.ego.id
            return (ego,) if ego in found else tuple(found) if len(found) == 1 else ()
    return ()


def _by_the_words(
    functional: FunctionalScenario, party: Party, seen_from: tuple[str, ...]
) -> list[str]:
    match party:
        case Party.FOLLOWER:
            return _placed(functional, Approach.BEHIND, Approach.AHEAD, seen_from)
        case Party.LEADER:
            return _placed(functional, Approach.AHEAD, Approach.BEHIND, seen_from)
        case Party.YIELDING:
            return yielding(functional, seen_from)
        case _:
            return known_by_itself(functional, party)


def yielding(functional: FunctionalScenario, others: tuple[str, ...]) -> list[str]:
    """Those who are said to wait for one of these, or to give way to it."""
    return [a.participant for a in functional.acts if a.kind in LETS_BY and a.into in others]


def known_by_itself(functional: FunctionalScenario, party: Party) -> list[str]:
    """Those who are this party wherever the others are; none where that decides."""
    ego = functional.ego.id
    match party:
        case Party.EGO:
            return [ego]
        case Party.OTHER | Party.OTHERS:
            others = (v for v in functional.vehicles if v.id != ego)
            return [v.id for v in others if v.maneuvers != {Maneuver.STAY}]
        case Party.TAILGATED:
            tailgating = [h for h in functional.hazards if h.kind is HazardKind.TAILGATING]
            return [name for hazard in tailgating for name in hazard.to]
        case Party.WALKER:
            return _crossers(functional, frozenset({ParticipantKind.PEDESTRIAN}))
        case Party.CYCLIST:
            return _crossers(functional, frozenset({ParticipantKind.BICYCLE}))
        case Party.ANIMAL:
            return _crossers(functional, ANIMALS)
        case Party.STANDING:
            return [p.id for p in functional.participants if p.parked]
        case Party.THING:
            causing = {name for hazard in functional.hazards for name in hazard.by}
            return [thing.id for thing in functional.objects if thing.id not in causing]
        case _:
            return []


def _crossers(functional: FunctionalScenario, kinds: frozenset[ParticipantKind]) -> list[str]:
    crossing = (c for c in functional.crossers if not c.maneuvers or Maneuver.CROSS in c.maneuvers)
    return [c.id for c in crossing if c.kind in kinds]


def _placed(
    functional: FunctionalScenario, word: Approach, inverse: Approach, seen_from: tuple[str, ...]
) -> list[str]:
    """Who is said to be there, seen from one of these, in one word and no other."""
    said = functional.sayings
    found = [who for who, of, words in said if of in seen_from and words == {word}]
    found += [of for who, of, words in said if who in seen_from and words == {inverse}]
    return found


def outcome_pairs(
    functional: FunctionalScenario, outcome: Outcome, dangers: Sequence[Parties]
) -> tuple[tuple[str, str], ...]:
    """Between whom it may come to this: as said, else as the dangers say, else the ego and any.

    None where so many could be meant that nothing follows.
    """
    if len(outcome.between) == 2:
        return ((outcome.between[0], outcome.between[1]),)
    told = {p.id for p in functional.participants if not p.parked}
    one = outcome.between[0] if outcome.between else functional.ego.id
    pairs = [(by, to) for danger in dangers for by in danger.by for to in danger.to]
    pairs = [p for p in pairs if set(p) <= told and (not outcome.between or one in p)]
    if not pairs:
        pairs = [(one, other) for other in sorted(told - {one})]
    return tuple(pairs) if len(pairs) <= MOST_PAIRS else ()
