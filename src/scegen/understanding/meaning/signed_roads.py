"""Who is on the road that has the sign, and who on the one that has priority."""

from __future__ import annotations

from scegen.scenario.control import controlled_arms
from scegen.scenario.functional import Junction
from scegen.scenario.vocabulary import Control, JunctionKind, Maneuver
from scegen.understanding.draft import Draft

_ALL_ALIKE = frozenset({Control.SIGNALS, Control.ALL_WAY_STOP})


def settle_roads(draft: Draft, junction: Junction) -> None:
    """Lets who has the sign enter where it stands, and who has priority elsewhere.

    Args:
        draft: the scenario in the making.
        junction: the junction as it is built; a T without signs has a side road, too.
    """
    signed = junction.control in {Control.YIELD, Control.STOP}
    stem = junction.kind is JunctionKind.T and junction.control not in _ALL_ALIKE
    if not (signed or stem):
        return
    minor = controlled_arms(
        junction if signed else junction.model_copy(update={"control": Control.YIELD})
    )
    for entity in draft.entities:
        if entity.on_minor is None or entity.entries or not entity.moving_vehicle:
            continue
        if Maneuver.CROSS in entity.maneuvers:
            continue  # a cyclist who crosses a road has none of its arms to come in by
        on_minor, basis = entity.on_minor
        arms = minor if on_minor else frozenset(range(junction.arms)) - minor
        entity.entries, entity.entry_basis = set(arms), basis
