"""Things: where they lie, and whom they hide."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.boxes import box_at, seen, to_side
from scegen.claims.claim import Claim, ClaimKind, Judged, Test, always, best_of
from scegen.claims.hazards.thresholds import IN_SIGHT, OCCLUDED
from scegen.claims.hidden import hidden
from scegen.claims.series import filled
from scegen.claims.told import Told, plain
from scegen.claims.tolerances import SAME_LANE_M
from scegen.claims.view import View
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import Side


def claims(told: Told) -> Iterator[Claim]:
    """Of every thing: in whose way it is, on which side, whom it hides."""
    for thing in told.functional.objects:
        what = thing.called or plain(thing.kind)
        if thing.in_way_of is not None:
            backwards = told.reverses(thing.in_way_of)
            test: Test = partial(_in_way, thing, thing.in_way_of, backwards)
            yield _claim(thing, "in_way_of", f"{what} lies in the way of {thing.in_way_of}", test)
        if thing.side is not None:
            test = partial(_on_side, thing, told.ego, thing.side)
            yield _claim(thing, "side", f"{what} is on the {thing.side} of the road", test)
        for name in thing.hides:
            test = partial(_hides, thing.id, told.ego, name)
            statement = (
                f"{what} hides {name} from {told.ego} until shortly before they come nearest"
            )
            yield _claim(thing, f"hides.{name}", statement, test, unit="s")


def _claim(thing: Thing, part: str, statement: str, test: Test, unit: str = "m") -> Claim:
    name, kind = f"{thing.id}.{part}", ClaimKind.OBJECT
    return Claim(f"object.{name}", kind, statement, f"objects.{name}", unit, test)


def _in_way(thing: Thing, name: str, backwards: bool, view: View) -> Judged:
    """Where it goes on its line at the start, or in what it sweeps where it comes nearest."""
    if thing.id not in view.index:
        return always(view, holds=False)
    found = []
    for time_s in (np.zeros(view.count), filled(view.of_pair("closest_s", name, thing.id), 0.0)):
        step = view.step_of(time_s)
        place = seen(box_at(view, name, step), box_at(view, thing.id, step))
        reach = (place.left - place.right) / 2.0 + SAME_LANE_M
        margin = np.minimum(reach - np.abs(place.y), -place.rear if backwards else place.front)
        found.append(Judged(margin, margin, time_s))
    return best_of(view, found)


def _on_side(thing: Thing, ego: str, side: Side, view: View) -> Judged:
    """To that side of the ego's line where it passes."""
    if thing.id not in view.index:
        return always(view, holds=False)
    nearest = filled(view.of_pair("closest_s", ego, thing.id), 0.0)
    step = view.step_of(nearest)
    aside = seen(box_at(view, ego, step), box_at(view, thing.id, step)).y
    return Judged(to_side(side, aside), aside, nearest)


def _hides(hider: str, ego: str, name: str, view: View) -> Judged:
    """Long enough to be missed, until shortly before the two come nearest."""
    if hider not in view.index or name not in view.index:
        return always(view, holds=False)
    total, last, seen_s = hidden(view, ego, name, hider)
    return Judged(np.minimum(total - OCCLUDED.value, IN_SIGHT.value - seen_s), total, last)
