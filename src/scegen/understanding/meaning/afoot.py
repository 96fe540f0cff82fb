"""People where they stand or come from, of whom no verb says that they cross; who runs."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import HazardKind, ParticipantKind
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_RUNNING = Interval(low=2.2, high=3.8)
"""From Euro NCAP's running adult (8 km/h, AEB VRU protocol) up; the upper end is our own."""
_WAY = frozenset({"crosswalk", "road", "lane", "path", "highway"})


def on_the_road(mention: Mention, context: Context) -> None:
    """``a pedestrian on the crosswalk``, ``brakes for a child``: they cross.

    Args:
        mention: who is spoken of.
        context: the scenario in the making.
    """
    walkers = [e for e in mention.entities if not e.is_vehicle]
    cyclists = [e for e in mention.entities if context.is_cyclist(e) and not e.ego]
    for prep in mention.pps:
        place = prep.target
        on = prep.value == "in" and isinstance(place, Place) and place.kind in _WAY
        if on and isinstance(place, Place) and context.tokens[prep.word.i].low in word_list("upon"):
            basis = Basis(mention.i, place.j)
            if walkers:
                context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, walkers)
            if cyclists and place.kind == "crosswalk":
                context.draft.hazard(HazardKind.CROSSING_CYCLIST, basis, cyclists)


def note_runners(clauses: list[Clause]) -> None:
    """``a child runs into the road``: faster than who walks, if nothing says how fast.

    Args:
        clauses: what happens, amounts read.
    """
    for clause in clauses:
        event = clause.event
        if event.lemma not in word_list("running") or event.negated or event.modal:
            continue
        for entity in clause.actors:
            if entity.kind is ParticipantKind.PEDESTRIAN and entity.speed is None:
                entity.speed = _RUNNING
                entity.speed_basis = Basis(event.i, event.j, "as fast as people run")


def comes_from_the_side(mention: Mention, context: Context) -> None:
    """``pedestrian from the right, hidden by a van``: nothing else is said, so they cross.

    Args:
        mention: who is spoken of, and does nothing.
        context: the scenario in the making.
    """
    walkers = [e for e in mention.entities if not e.is_vehicle]
    for prep in mention.pps:
        place = prep.target
        sided = isinstance(place, Place) and place.kind in {"side", "direction", "sidewalk"}
        if prep.value != "from" or not sided:
            continue
        basis = Basis(mention.i, place.j if place is not None else mention.j)
        if walkers:
            context.draft.hazard(HazardKind.CROSSING_PEDESTRIAN, basis, walkers)
