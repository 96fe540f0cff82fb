"""Reads weather, light, road surface, speed limit, lanes and driving side."""

from __future__ import annotations

from dataclasses import dataclass, field

from scegen.errors import InfeasibleError
from scegen.scenario.functional import MAX_LANES, Environment
from scegen.scenario.vocabulary import DrivingSide, RoadSurface, TimeOfDay, Visibility, Weather
from scegen.understanding.draft import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.lane_widths import auxiliary_length_m, lane_width_m
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token
from scegen.units import speed_mps

_LIMIT_REACH = 6
_SIGHT_REACH = 5
_FRICTION_REACH = 3
_LIMIT_BEFORE = 3
_LOWEST_LIMIT, _HIGHEST_LIMIT = 5, 140


@dataclass(slots=True)
class Surroundings:
    """Conditions with the words that they rest on.

    Attributes:
        values: field of the environment -> value.
        amounts: field of the environment -> number (friction, visual range in m).
        bases: field -> words.
        speed_limit_mps: the limit, if one is given.
        limit_basis: its words.
        limit_term: the quantity used, so that it is not read as somebody's speed.
        sight_term: the quantity that says how far one sees, likewise nobody's distance.
        lanes: lanes per direction.
        lanes_basis: the words or the reason.
        lanes_in_all: what the text counts, where it seems to count both directions together.
        lane_width_m: how wide its lanes are.
        lane_width_basis: the words for it.
        auxiliary_length_m: how long a ramp's lane is, or one that ends.
        auxiliary_length_basis: the words for it.
        width_terms: the quantities that say so.
        side: driving side.
        side_basis: its words.
        two_lane: the words "two lanes" without "per direction": those of a roundabout's ring.
    """

    values: dict[str, str] = field(default_factory=dict)
    amounts: dict[str, float] = field(default_factory=dict)
    bases: dict[str, Basis] = field(default_factory=dict)
    speed_limit_mps: float | None = None
    limit_basis: Basis | None = None
    limit_term: Term | None = None
    sight_term: Term | None = None
    lanes: int | None = None
    lanes_basis: Basis | None = None
    lanes_in_all: int | None = None
    lane_width_m: float | None = None
    lane_width_basis: Basis | None = None
    auxiliary_length_m: float | None = None
    auxiliary_length_basis: Basis | None = None
    width_terms: list[Term] = field(default_factory=list)
    side: DrivingSide | None = None
    side_basis: Basis | None = None
    highway: Basis | None = None
    two_lane: Basis | None = None

    @property
    def measured(self) -> list[Term]:
        """Quantities of the road, and of nobody on it."""
        found = (self.limit_term, self.sight_term)
        return [*(t for t in found if t is not None), *self.width_terms]

    def environment(self) -> Environment:
        """The environment of the scenario."""
        values = self.values
        return Environment(
            weather=Weather(values["weather"]) if "weather" in values else None,
            time_of_day=TimeOfDay(values["time_of_day"]) if "time_of_day" in values else None,
            road_surface=RoadSurface(values["road_surface"]) if "road_surface" in values else None,
            visibility=Visibility(values["visibility"]) if "visibility" in values else None,
            **self.amounts,
        )


def read_surroundings(terms: list[Term], tokens: list[Token]) -> Surroundings:
    """The conditions that a text names.

    Raises:
        InfeasibleError: it names more lanes than are built.
    """
    found = Surroundings()
    for k, term in enumerate(terms):
        basis = Basis(term.i, term.j)
        if term.cat == "env":
            found.values.setdefault(term.data["field"], term.value)
            found.bases.setdefault(term.data["field"], basis)
        elif term.cat == "side" and found.side is None:
            found.side, found.side_basis = DrivingSide(term.value), basis
        elif term.cat == "limit" or ("pace" in term.data and tokens[term.j - 1].low == "limit"):
            _limit(found, terms, k)
        elif _measured(found, terms, k, tokens):
            pass
        elif term.cat == "quantity" and _zone(tokens, term):
            _limit(found, [*terms[: k + 1], term], k)
        elif term.cat == "num":
            _lanes(found, terms, k, tokens)
            _bare_limit(found, terms, k, tokens)
        elif term.value == "lane" and "count" in term.data:
            found.lanes, found.lanes_basis = found.lanes or term.data["count"], basis
        elif term.cat == "label" and tokens[term.j - 1].forms[-1][0] == "lane":
            _two_lanes(found, term, tokens)
        elif term.cat == "place" and term.value == "highway":
            found.highway = found.highway or basis
    return found


def _measured(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """How far one sees, how large lanes are, how the tyres hold; whether a term says that."""
    term, basis = terms[k], Basis(terms[k].i, terms[k].j)
    if (sight := _sight_m(tokens, term)) is not None:
        found.amounts["visual_range_m"], found.bases["visual_range_m"] = sight, basis
        found.sight_term = term
    elif (width := lane_width_m(terms, k, tokens)) is not None:
        found.lane_width_m, found.lane_width_basis = width, basis
        found.width_terms.append(term)
    elif (length := auxiliary_length_m(terms, k, tokens)) is not None:
        found.auxiliary_length_m, found.auxiliary_length_basis = length, basis
        found.width_terms.append(term)
    elif term.cat == "num" and (held := _friction(tokens, term)) is not None:
        found.amounts["friction"], found.bases["friction"] = held, basis
    else:
        return False
    return True


def _sight_m(tokens: list[Token], term: Term) -> float | None:
    """``visibility of 150 m``, ``one sees 80 m far``."""
    if (term.cat, term.value) != ("quantity", "length"):
        return None
    near = {t.low for t in tokens[max(0, term.i - _SIGHT_REACH) : term.j + 2]}
    sees = {"can", "one", "you", "anybody"} & near and {"see", "sees"} & near
    sight = bool(sees) or (
        bool(near & {"visibility", "visual", "sight"}) and "distance" not in near
    )
    value = term.data["quantity"].exact
    return float(value.low) if sight and value.low == value.high else None


def _friction(tokens: list[Token], term: Term) -> float | None:
    """``friction 0.4``, ``a surface with μ = 0.6``."""
    before = {t.low for t in tokens[max(0, term.i - _FRICTION_REACH) : term.i]}
    value = float(term.data["number"])
    return value if before & {"friction", "μ", "mu", "µ"} and 0 < value <= 1 else None


def _zone(tokens: list[Token], term: Term) -> bool:
    """``a 30 km/h zone``, ``zone 30``."""
    before = tokens[term.i - 1].low if term.i else ""
    after = tokens[term.j].low if term.j < len(tokens) else ""
    return "zone" in {before, after}


def _limit(found: Surroundings, terms: list[Term], k: int) -> None:
    """The speed that goes with "limit": right before it, or after it before anybody is named."""
    after = []
    for term in terms[k + 1 : k + 1 + _LIMIT_REACH]:
        if term.cat in {"actor", "pronoun", "verb"} or term.value in {".", ";", ","}:
            break
        after.append(term)
    for term in (*terms[max(0, k - 1) : k], *after, *terms[max(0, k - 2) : k]):
        if term.cat == "quantity" and term.value == "speed" and found.limit_term is None:
            limit = term.data["quantity"].value.high
            if not 0 < limit <= 70:
                return
            found.speed_limit_mps = limit
            span = sorted((terms[k], term), key=lambda t: t.i)
            found.limit_basis = Basis(span[0].i, span[1].j)
            found.limit_term = term
            return


def _bare_limit(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> None:
    """``a 30 zone``, ``limit 50``: in the unit of the other speeds, else km/h."""
    number = terms[k]
    value = float(number.data["number"])
    zone = _zone(tokens, number)
    named = any(t.cat == "limit" for t in terms[max(0, k - _LIMIT_BEFORE) : k])
    if not (zone or named) or found.limit_term is not None or found.speed_limit_mps is not None:
        return
    if not _LOWEST_LIMIT <= value <= _HIGHEST_LIMIT:
        return
    words = [t.low for t in tokens]
    unit = "mph" if "mph" in words or "miles" in words else "km/h"
    found.speed_limit_mps = speed_mps(value, unit)
    reason = f"no unit is given; {unit} is taken"
    found.limit_basis = Basis(number.i, number.j, reason)


def _two_lanes(found: Surroundings, term: Term, tokens: list[Token]) -> None:
    """``two lanes per direction``; on a plain road "two lanes" are one for each direction."""
    basis = Basis(term.i, term.j)
    after = [t.low for t in tokens[term.j : term.j + 4]]
    if "direction" in after or "way" in after or "approach" in after:
        found.lanes, found.lanes_basis = 2, basis
    found.two_lane = found.two_lane or basis


def _lanes(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> None:
    """``two lanes per direction``, ``a four-lane road``."""
    number = terms[k]
    noun = next((t for t in terms[k + 1 : k + 3] if t.cat == "place"), None)
    if noun is None:
        return
    words = [t.low for t in tokens[noun.i : noun.j]]
    if noun.value == "lane":
        after = [t.low for t in tokens[noun.j : noun.j + 4]]
        each_way = "direction" in after or "way" in after
    elif words[0] == "lane":
        each_way = False
    else:
        return
    count = int(min(number.data["number"], 99))
    if count == 1 and {t.low for t in tokens[noun.j : noun.j + 3]} & word_list("lanes_aside"):
        return  # "moves one lane to the left"
    likely = count <= MAX_LANES and _one_way(terms[k + 1 : k + 4], count, tokens)
    each_way = each_way or noun.form == "s" or likely
    lanes = count if each_way else max(1, count // 2)
    if lanes < 1:
        return
    if lanes > MAX_LANES:
        msg = f"a road with {lanes} lanes a direction is not built: at most {MAX_LANES}"
        raise InfeasibleError(msg, where="junction.lanes", hint="Say fewer, or no number.")
    basis = Basis(number.i, noun.j)
    if not each_way:
        basis = Basis(basis.i, basis.j, f"{count} lanes in both directions together")
        found.lanes_in_all = count
    found.lanes, found.lanes_basis = lanes, basis


def _one_way(after: list[Term], count: int, tokens: list[Token]) -> bool:
    """``a three-lane motorway``: the lanes of one carriageway, as always where they are odd."""
    words = {t.low for term in after for t in tokens[term.i : term.j]}
    odd = count > 1 and count % 2 == 1
    fast = any(term.value == "highway" for term in after)
    return bool(words & word_list("carriageways")) or (fast and odd)
