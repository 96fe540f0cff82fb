"""Where in its lane somebody is, or how one reaches into it from the side."""

from scegen.scenario.acts import RESTING, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.amounts.aside import turned
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Place
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Amount, Apart
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.patterns import noun

_BRINK = noun(["side", "+brink", "+of_road", "+kerb"])
_TOWARDS_THE_EDGE_M = (0.3, 0.9)
"""On one side of a lane, and still in it (lanes of 3 to 3.75 m, bodies of up to 2 m)."""
_PARTLY_IN_M = (0.9, 1.3)
"""Across the edge of a lane, and in the way of who drives in its middle."""
_SIDEWAYS = frozenset({Measure.LATERAL_OFFSET_M, Measure.OVERLAP_PERCENT})
_ONE_SIDE = ({Approach.LEFT}, {Approach.RIGHT})


def within(text: Telling) -> None:
    """``on the right-hand side of the lane``: off its middle, how far nobody says.

    So does "along the right edge of the road".
    """
    for clause in text.scenes:
        for place in [p for p in clause.places() if _within(p, text)]:
            basis = Basis(place.i, place.j, "on one side of the lane and still in it")
            for who in [e for e in clause.actors if e.is_vehicle and not (e.parked or e.strip)]:
                _off(who, who, "right" in place.dirs, _TOWARDS_THE_EDGE_M, basis, text)


def reaching_in(text: Telling) -> None:
    """``stands partly in our lane, on the right``: ahead, on that side of its middle.

    How far is what an overlap says, where one is told.
    """
    barring = [e for e in text.draft.causing(HazardKind.OBSTACLE) if e.is_vehicle and e.still]
    barring = [e for e in barring if e.maneuvers <= {Maneuver.STAY}]
    opening = [a.entity for a in text.found.acts if a.kind is ActKind.OPEN_DOOR]
    aside = [p for p in text.draft.placements if p.approaches in _ONE_SIDE]
    for told in [p for p in aside if p.reference is None or p.reference.ego]:
        who = told.entity
        if who not in barring or who in opening or text.context.junction.crossing:
            continue
        right = told.approaches == {Approach.RIGHT}
        told.approaches = {Approach.AHEAD}
        if not any(s.entity is who and s.measure in _SIDEWAYS for s in text.found.spacings):
            basis = told.basis.because("it reaches into the lane from there; how far nobody says")
            _off(who, text.ego, right, _PARTLY_IN_M, basis, text)


def _off(
    who: Entity, of: Entity, right: bool, far: tuple[float, float], basis: Basis, text: Telling
) -> None:
    amount = turned(right, Interval(low=far[0], high=far[1]), basis)
    text.found.spacings.append(Apart(Measure.LATERAL_OFFSET_M, who, of, amount))


def on_the_line(text: Telling) -> None:
    """``stops on the centre line``: who goes across rests in the middle of the road."""
    for clause in text.scenes:
        lines = [p for p in clause.places() if p.kind == "centerline" and p.prep]
        own = text.acts(clause.event.i, clause.event.j, RESTING) if lines else []
        for doing in [a for a in own if Maneuver.CROSS in a.entity.maneuvers]:
            middle = Amount(STILL, Basis(lines[0].i, lines[0].j))
            who, measure = doing.entity, Measure.LATERAL_OFFSET_M
            text.found.spacings.append(Apart(measure, who, who, middle, doing, since="end"))


def _within(place: Place, text: Telling) -> bool:
    at = place.prep and text.tokens[place.prep.i].low in word_list("on_strips")
    return place.kind == "within_lane" or bool(at and _BRINK(place, text.context))
