"""Reads what a road is like along its length: a median, one way only, strips beside its lanes."""

from __future__ import annotations

from dataclasses import dataclass, field

from pydantic import ValidationError

from scegen.errors import InfeasibleError
from scegen.scenario.bends import RADII_M, Bend
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import Side
from scegen.understanding.entity import Basis
from scegen.understanding.words import absent
from scegen.understanding.words.terms import Term


@dataclass(slots=True)
class Lengthwise:
    """What the text says of the road itself; None where it says nothing.

    Attributes:
        carriageway: how its directions lie to each other.
        carriageway_basis: the words for it.
        presumed: those words only make it likely ("a highway").
        median: those words name a median.
        strips: what lies beside its lanes, with the words for it.
        without: strips that the text says are not there, with the words for it.
        bend: the bend that is driven, with the words for it.
        auxiliary: a ramp, or a lane that ends, with the words for it.
        alongside: those words name the lane into which a ramp leads, beside the others.
        crosswalk_basis: the words for a marked crosswalk.
    """

    carriageway: Carriageway | None = None
    carriageway_basis: Basis | None = None
    presumed: bool = False
    median: bool = False
    strips: dict[Strip, Basis] = field(default_factory=dict)
    without: dict[Strip, Basis] = field(default_factory=dict)
    bend: tuple[Bend, Basis] | None = None
    auxiliary: tuple[AuxiliaryLane, Basis] | None = None
    alongside: bool = False
    crosswalk_basis: Basis | None = None


def read_lengthwise(terms: list[Term]) -> Lengthwise:
    """What the words for roads say of their length."""
    found = Lengthwise()
    for k, term in enumerate(terms):
        if term.cat != "place":
            continue
        basis = Basis(term.i, term.j)
        if absent.negated(terms, k):
            denied = term.data.get("strip", term.data.get("stands_on"))
            if denied is not None:
                found.without.setdefault(Strip(denied), basis)
            continue
        presumed = bool(term.data.get("presumed"))
        known = found.carriageway is not None and (presumed or not found.presumed)
        if "carriageway" in term.data and not known:
            found.carriageway = Carriageway(term.data["carriageway"])
            found.carriageway_basis, found.presumed = basis, presumed
            found.median = "median" in term.data
        if "auxiliary" in term.data and found.auxiliary is None:
            found.auxiliary = AuxiliaryLane(term.data["auxiliary"]), basis
            found.alongside = "alongside" in term.data
        if term.value == "bend" and found.bend is None:
            found.bend = _bend(term), basis
        if "marked" in term.data and not absent.away_from(terms, k):
            found.crosswalk_basis = found.crosswalk_basis or basis
        if "strip" in term.data:
            found.strips.setdefault(Strip(term.data["strip"]), basis)
    return found


def _bend(term: Term) -> Bend:
    """A bend with its side and radius.

    Raises:
        InfeasibleError: no road is built with such a radius.
    """
    side, radius = term.data.get("side"), term.data.get("radius_m")
    try:
        return Bend(side=None if side is None else Side(side), radius_m=radius)
    except ValidationError:
        low, high = RADII_M
        msg = f"a bend of {radius:g} m radius is not built: {low:g} to {high:g} m"
        raise InfeasibleError(msg, where="junction.bend.radius_m") from None
