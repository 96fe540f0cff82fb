"""The lead-in: what a target asks for has to happen, not to stand at the start.

Everybody drives undisturbed for a second. The measure of the pair must become clearly worse after
it than it was in it, and the second of the pair must enter their conflict area after it. One who
tailgates may be as close from the start: that is the danger.
"""

from collections.abc import Sequence

import numpy as np

from scegen.claims.near_miss import Band
from scegen.claims.view import View
from scegen.criticality.search.variables import LEAD_IN_S
from scegen.measures.evaluation import Summary, measure
from scegen.motion.batch.arrays import BatchTraces, Floats
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.vocabulary import HazardKind

_WORSE_BY = {
    "distance": ("distance_m", -0.5),
    "ttc": ("ttc_s", -0.2),
    "headway": ("headway_s", -0.1),
    "drac": ("drac_mps2", 0.3),
}
"""Field of the summary, and what counts as clearly worse (own choice); the sign is the direction
in which the measure gets worse."""
_LATER_S = 0.1
"""A search aims this much beyond the lead-in: its steps are coarser than those of the proof."""
_NEVER = 1.0


def tailgates(concrete: ConcreteScenario, pair: Sequence[str]) -> bool:
    """Whether the text says that one of the pair tailgates the other."""
    return any(
        hazard.kind is HazardKind.TAILGATING and set(pair) <= {*hazard.by, *hazard.to}
        for hazard in concrete.hazards
    )


def early_missing(view: View, choice: Sequence[Band], pair: tuple[str, str], room: float) -> Floats:
    """How far a choice's decisive moment is from coming after the lead-in, 0 if it does (c,).

    ``room`` above 0 asks for a little more than that.
    """
    if choice[0].measure == "headway" and tailgates(view.concrete, pair):
        return np.zeros(view.count)
    missing = np.zeros(view.count)
    for band in choice:
        if band.measure == "pet":
            late = LEAD_IN_S + (_LATER_S if room else 0.0) - second_enters_s(view, pair)
        else:
            late = _worse_missing(view, band.measure, pair, room)
        missing = np.maximum(missing, late)
    return missing


def early_contact_missing(view: View, pair: tuple[str, str], room: float) -> Floats:
    """How far a contact is from coming after the lead-in, and from a gap in it (c,)."""
    late = LEAD_IN_S + (_LATER_S if room else 0.0) - view.of_pair("contact_s", *pair)
    apart = _worse_missing(view, "distance", pair, room)
    missing: Floats = np.maximum(np.nan_to_num(np.maximum(late, 0.0)), apart)
    return missing


def second_enters_s(view: View, pair: tuple[str, str]) -> Floats:
    """When the second of a pair enters, in the first conflict area that both enter; inf: none."""
    first = np.full(view.count, np.inf)
    own, other = (view.place_m(name) for name in pair)
    for area in view.areas(*pair):
        enters = (own < area.enter_m).sum(axis=1), (other < area.other_enters_m).sum(axis=1)
        beyond = (own[:, 0] >= area.leave_m) | (other[:, 0] >= area.other_leaves_m)
        first = np.where(beyond, first, np.minimum(first, np.maximum(*enters) * view.dt_s))
    return first


def _worse_missing(view: View, name: str, pair: tuple[str, str], room: float) -> Floats:
    """How far a measure is from getting clearly worse after the lead-in, in what counts as that."""
    field, worse = _WORSE_BY[name]
    early = view.once(("lead-in", pair), lambda: _summary_of_lead_in(view, pair))
    before, after = getattr(early, field)[:, 0], view.of_pair(field, *pair)
    # Undefined in the lead-in: nobody was near. Undefined at all: no candidate for the band.
    undisturbed = np.isnan(before) & ~np.isnan(after)
    with np.errstate(invalid="ignore"):
        gained = (after - before) / worse
    missing = np.maximum(0.0, 1.0 + room - np.nan_to_num(gained, nan=-_NEVER))
    return np.where(undisturbed, 0.0, np.minimum(missing, 1.0 + room + _NEVER))


def _summary_of_lead_in(view: View, pair: tuple[str, str]) -> Summary:
    """The measures of the pair alone over the lead-in (c, 1)."""
    found = view.pair(*pair)
    p = found[0] if found is not None else 0
    scene = view.scene._replace(
        pairs=view.scene.pairs[p : p + 1],
        following=view.scene.following._replace(first=view.scene.following.first[p : p + 1]),
        areas=view.scene.areas._replace(first=view.scene.areas.first[p : p + 2]),
        occlusions=view.scene.occlusions[:0],
    )
    steps = round(LEAD_IN_S / view.dt_s) + 1
    # A copy: kernels are compiled for contiguous tracks.
    tracks = view.traces.tracks[:, :, :, :steps].copy()
    return measure(BatchTraces(view.dt_s, tracks, view.traces.fired_step), scene)
