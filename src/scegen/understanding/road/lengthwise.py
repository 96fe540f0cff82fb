"""What a road is like along its length: a median, strips beside its lanes, bends, its numbers."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from pydantic import ValidationError

from scegen.errors import InfeasibleError
from scegen.scenario.bends import RADII_M, Bend
from scegen.scenario.model import Interval
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import JunctionKind, Side
from scegen.understanding.entity import Basis
from scegen.understanding.frames.loader import cues
from scegen.understanding.frames.windows import frame_of, window
from scegen.understanding.lexicon import word_list
from scegen.understanding.road import absent
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_ROLES = ("limit", "sight", "friction", "radius")
_NUMBERS = {"quantity": "quantity", "num": "number"}
"""Class of a term -> where its number stands."""


def role_of(terms: Sequence[Term], k: int, tokens: list[Token]) -> str:
    """What of the road a number measures, by the words around it alone; empty if nothing."""
    term = terms[k]
    if term.cat not in _NUMBERS or term.data.get(_NUMBERS[term.cat]) is None:
        return ""
    dimension = term.value if term.cat == "quantity" else "number"
    if cues(dimension, *_ROLES).isdisjoint(t.low for t in tokens):
        return ""
    ends = {t.j: t.i for t in terms if t.cat == "quantity"}
    around = window(tokens, term.i, last_of(terms, k).j, ends)
    return frame_of(dimension, value_of(terms, k).low, around, frozenset()).role


def value_of(terms: Sequence[Term], k: int) -> Interval:
    """The number as it is written: a range, or a range of one value."""
    if terms[k].cat == "quantity":
        exact: Interval = terms[k].data["quantity"].exact
        return exact
    ends = [float(t.data["number"]) for t in (terms[k], last_of(terms, k))]
    return Interval(low=min(ends), high=max(ends))


def last_of(terms: Sequence[Term], k: int) -> Term:
    """The last term of a number: ``0.3-0.4``, ``0.3 to 0.4``, ``between 0.3 and 0.4``."""
    between = k > 0 and terms[k - 1].value == "between"
    joined = terms[k + 1 : k + 2]
    steps = (
        2 if joined and (joined[0].value == "to" or (between and joined[0].value == "and")) else 1
    )
    upper = terms[k + steps] if k + steps < len(terms) and terms[k].cat == "num" else None
    return upper if upper is not None and "number" in upper.data else terms[k]


_SIDES = frozenset({"left", "right"})
_RADIUS = frozenset({"radius", "r"})
_REACH = 5


def whole_bends(terms: Sequence[Term], tokens: list[Token]) -> list[Term]:
    """The terms, those of a bend's side and radius joined to it.

    A bend behind which something happens is a feature of the road elsewhere.
    """
    found = list(terms)
    for k in reversed(range(len(terms))):
        bend = found[k] if k < len(found) else None
        if bend is None or (bend.cat, bend.value) != ("place", "bend") or "side" in bend.data:
            continue
        i, j = _with_side(found, k, tokens)
        i, j, radius = _with_radius(found, i, j, tokens)
        side = next((t.value for t in found[i : j + 1] if t.value in _SIDES), None)
        if side is None and i > 1 and found[i - 1].cat == "place" and found[i - 2].value in _SIDES:
            side = found[i - 2].value  # "a right-hand motorway bend"
            found[i - 2 : i] = [replace(found[i - 1], i=found[i - 2].i)]
            i, j = i - 1, j - 1
        data = {"side": side, "radius_m": radius and radius.data["quantity"].exact.middle}
        first, last = found[i].i, found[j].j
        whole = replace(bend, i=first, j=last, data={**bend.data, **data})
        if _elsewhere(tokens, first):
            whole = replace(whole, value="feature")
        found[i : j + 1] = [whole]
    return _with_radius_alone(found, tokens)


def _with_side(terms: list[Term], k: int, tokens: list[Token]) -> tuple[int, int]:
    """From the side before it ("left-hand bend") or after it ("bend to the left")."""
    if k and terms[k - 1].value in _SIDES and terms[k - 1].j == terms[k].i:
        return k - 1, k
    after = [t.low for t in tokens[terms[k].j : terms[k].j + 2]]
    for m in range(k + 1, min(k + 4, len(terms))):
        if after == ["to", "the"] and terms[m].value in _SIDES and terms[m].i == terms[k].j + 2:
            return k, m
    return k, k


def _with_radius(
    terms: list[Term], i: int, j: int, tokens: list[Token]
) -> tuple[int, int, Term | None]:
    """From or to a length that is called its radius, with nothing but small words between."""
    for m, term in enumerate(terms):
        if not i - _REACH <= m <= j + _REACH or not _is_radius(terms, m, tokens):
            continue
        first, last = min(i, m), max(j, m)
        between = {t.low for t in tokens[terms[first].i : terms[last].j]}
        own = {t.low for n in (*range(i, j + 1), m) for t in tokens[terms[n].i : terms[n].j]}
        if between - own - word_list("within_bends") - _RADIUS:
            return i, j, term
        last += last == m and tokens[term.j : term.j + 1] != [] and tokens[term.j].low in _RADIUS
        return first, min(last, len(terms) - 1), term
    return i, j, None


def _is_radius(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    return terms[k].value == "length" and role_of(terms, k, tokens) == "radius"


def _with_radius_alone(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """``at R = 750 m``: a bend that only its radius tells of, or one that is told of elsewhere.

    Where a roundabout is told of, the radius is that one's.
    """
    m = next((m for m in range(len(terms)) if _is_radius(terms, m, tokens)), None)
    if m is None or any(term.data.get("kind") == JunctionKind.ROUNDABOUT for term in terms):
        return terms
    bends = [k for k, t in enumerate(terms) if t.cat == "place" and t.value == "bend"]
    if any(terms[k].data.get("radius_m") for k in bends):
        return terms
    radius = value_of(terms, m).middle
    if bends:
        whole = terms[bends[0]]
        terms[bends[0]] = replace(whole, data={**whole.data, "radius_m": radius})
    data = {"side": None, "radius_m": radius}
    terms[m] = Term("place", "bend", terms[m].i, terms[m].j, data=data)
    return terms


def _elsewhere(tokens: list[Token], i: int) -> bool:
    """``behind a bend``."""
    before = [t.low for t in tokens[max(0, i - 3) : i] if t.low not in word_list("within_bends")]
    return before[-1:] != [] and before[-1] in word_list("elsewhere")


@dataclass(slots=True)
class Lengthwise:
    """What the text says of the road itself; None where it says nothing.

    Attributes:
        carriageway: how its directions lie to each other, with the words for it.
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


def read_lengthwise(terms: list[Term], inner: str) -> Lengthwise:
    """What the words for roads say of their length; of lanes, none on the inner side ends."""
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
        ends = term.data.get("auxiliary") == AuxiliaryLane.LANE_DROP
        built = not (ends and k and terms[k - 1].value == inner)
        if "auxiliary" in term.data and found.auxiliary is None and built:
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
