"""Phrases of place that do not say where a noun is, although they stand beside it."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Prep

_LEAVING = frozenset({"turn", "sharp_turn", "u_turn", "leave", "cross", "cut_in", "dash"})


def own_lane(event: Event, prep: Prep) -> bool:
    """``the ego follows a van in the right lane``: that is the ego's lane, too.

    Args:
        event: what happens.
        prep: a phrase after its object.
    """
    lane = prep.place is not None and prep.place.kind == "lane" and prep.value == "in"
    ego = any(e.ego for e in event.doers)
    return lane and ego and event.name in {"follow", "tailgate"} and not event.passive


def is_side(prep: Prep) -> bool:
    """Whether a phrase names a side.

    Args:
        prep: a phrase of place.
    """
    return prep.place is not None and prep.place.kind == "side"


def from_the_wrong_lane(prep: Prep, event: Event | None) -> bool:
    """``turns right from the wrong lane``: from one that is not for turning, not an oncoming one.

    Args:
        prep: a phrase of place.
        event: the event that it belongs to, if any.
    """
    place = prep.place
    wrong = place is not None and place.head is not None and "dir" in place.head.data
    return wrong and prep.value == "from" and event is not None and event.name in _LEAVING
