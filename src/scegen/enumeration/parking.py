"""Where parked vehicles stand: not enumerated, but following from where the others enter."""

from collections.abc import Collection, Iterable, Mapping

from scegen.scenario.acts import LEAVING, ActKind
from scegen.scenario.arms import arm_angles_deg, turn_name
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.logical import Standing
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver, Side

BLOCKING = frozenset({HazardKind.OBSTACLE, HazardKind.STOPPING})
"""Hazards by which a parked vehicle stands in the travelled lane."""
HIDING = BLOCKING | {HazardKind.OCCLUSION}


def standing(
    functional: FunctionalScenario,
    parked: Participant,
    entry_of: Mapping[str, int],
    crossed: Collection[tuple[int, Side]] = (),
) -> Standing:
    """A parked vehicle stands on the arm where the one whom it hinders enters.

    Where its side is not said, one that hides somebody is on the side that one comes from.
    ``entry_of`` are the arms at which the others enter, ``crossed`` those that are crossed, and
    from which side.
    """
    hindered = (*_hindered_by(functional, parked.id), functional.ego.id)
    arm = next(entry_of[name] for name in hindered if name in entry_of)
    if parked.entries and arm not in parked.entries:
        arm = min(parked.entries)
    said = parked.approaches & {Approach.LEFT, Approach.RIGHT}
    hides = any(h.kind is HazardKind.OCCLUSION and parked.id in h.by for h in functional.hazards)
    if len(said) == 1:
        side = Side(next(iter(said)).value)
    else:
        hidden = _sides(functional, arm, crossed, entry_of.values()) if hides else set()
        side = hidden.pop() if len(hidden) == 1 else functional.junction.kerb
    opens = any(a.kind is ActKind.OPEN_DOOR for a in functional.acts if a.participant == parked.id)
    blocks = any(h.kind in BLOCKING and parked.id in h.by for h in functional.hazards)
    backing = {n for h in functional.hazards if h.kind is HazardKind.REVERSING for n in h.by}
    behind = parked.approaches == {Approach.BEHIND} and parked.strip is None
    blocks |= behind and functional.ego.id in backing  # what the ego gets to
    blocks = (blocks or _is_run_into(functional, parked)) and not (parked.pulls_out or opens)
    return Standing(participant=parked.id, arm=arm, side=side, in_lane=blocks)


def _is_run_into(functional: FunctionalScenario, parked: Participant) -> bool:
    """Whether somebody hits it who leaves no lane for that, so that it stands in the lane."""
    outcome = functional.outcome
    if outcome is None or outcome.kind is not OutcomeKind.COLLISION or parked.strip is not None:
        return False
    others = {*outcome.between} - {parked.id}
    aside = {n for h in functional.hazards if LEAVING & {*HAZARDS[h.kind].acts} for n in h.by}
    aside |= {act.participant for act in functional.acts if act.kind in LEAVING}
    aside |= {p.id for p in functional.participants if p.strip is not None}
    return parked.id in outcome.between and len(others) == 1 and not others & aside


def _sides(
    functional: FunctionalScenario,
    arm: int,
    crossed: Collection[tuple[int, Side]],
    entries: Iterable[int],
) -> set[Side]:
    """From where they come who cross the road of an arm, seen by who enters there; else others."""
    plain_road = functional.junction.kind is JunctionKind.STRAIGHT
    found = {side for there, side in crossed if there == arm}
    found |= {side.opposite for there, side in crossed if plain_road and there != arm}
    angles_deg = arm_angles_deg(functional.junction)
    turns = {turn_name(angles_deg, arm, (entry - arm) % len(angles_deg)) for entry in entries}
    return found or {Side(turn) for turn in turns & {Maneuver.LEFT, Maneuver.RIGHT}}


def _hindered_by(functional: FunctionalScenario, name: str) -> list[str]:
    hindered = [
        sufferer
        for hazard in functional.hazards
        if hazard.kind in HIDING and name in hazard.by
        for sufferer in hazard.to
    ]
    return hindered + [r.reference for r in functional.relations if r.participant == name]
