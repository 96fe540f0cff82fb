"""Reads weather, light, road surface, speed limit, lanes and their size, driving side."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from scegen.errors import InfeasibleError
from scegen.scenario.junction import MAX_LANES
from scegen.scenario.roadway import AUXILIARY_LENGTHS_M, LANE_WIDTHS_M
from scegen.scenario.vocabulary import DrivingSide
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.road.lengthwise import last_of, role_of, value_of
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at
from scegen.units import speed_mps

_LIMIT_REACH = 4
_FASTEST_MPS = 70
_CONDITIONS = {"sight": ("visual_range_m", 100_000.0), "friction": ("friction", 1.2)}
"""Role of a number -> field of the environment, and the most that it holds."""
_LOWEST_LIMIT, _HIGHEST_LIMIT = 5, 140


@dataclass(slots=True)
class Surroundings:
    """Conditions with the words that they rest on.

    Attributes:
        conditions: field of the environment -> value and words.
        road: field of the junction for how fast, how wide or how long -> number and words.
        measured: the numbers that say so, which are nobody's speed and nobody's distance.
        lanes: lanes per direction, with the words or the reason.
        lanes_in_all: what the text counts, where it seems to count both directions together.
        side: driving side, with its words.
        highway: the words for a road with several lanes each way.
        two_lane: the words "two lanes" without "per direction": those of a roundabout's ring.
    """

    conditions: dict[str, tuple[Any, Basis]] = field(default_factory=dict)
    road: dict[str, tuple[float, Basis]] = field(default_factory=dict)
    measured: list[Term] = field(default_factory=list)
    lanes: int | None = None
    lanes_basis: Basis | None = None
    lanes_in_all: int | None = None
    side: DrivingSide | None = None
    side_basis: Basis | None = None
    highway: Basis | None = None
    two_lane: Basis | None = None


def read_surroundings(terms: list[Term], tokens: list[Token]) -> Surroundings:
    """The conditions that a text names.

    Raises:
        InfeasibleError: it names more lanes than are built.
    """
    found = Surroundings()
    for k, term in enumerate(terms):
        if term.cat == "env":
            found.conditions.setdefault(term.data["field"], (term.value, Basis(term.i, term.j)))
        elif term.cat == "side" and found.side is None:
            found.side, found.side_basis = DrivingSide(term.value), Basis(term.i, term.j)
        elif term.cat in {"quantity", "num"} and _measured(found, terms, k, tokens):
            pass
        elif term.cat == "num":
            _lanes(found, terms, k, tokens)
        elif term.value == "lane" and "count" in term.data:
            found.lanes = found.lanes or term.data["count"]
            found.lanes_basis = Basis(term.i, term.j)
        elif term.cat == "label" and tokens[term.j - 1].forms[-1][0] == "lane":
            found.two_lane = found.two_lane or Basis(term.i, term.j)
        elif term.cat == "place" and term.value == "highway":
            found.highway = found.highway or Basis(term.i, term.j)
    return found


def _measured(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Limits, sight, friction, how large lanes are; whether a term says one."""
    term, basis = terms[k], Basis(terms[k].i, terms[k].j)
    role = role_of(terms, k, tokens)
    if role == "limit":
        _limit(found, terms, k, tokens)
    elif role in _CONDITIONS:
        _conditions(found, terms, k, role)
    elif (size := size_of_lanes(terms, k, tokens)) is not None:
        found.road[size[0]] = size[1], basis
        found.measured.append(term)
    else:
        return False
    return True


def _limit(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> None:
    """``a limit of 70 km/h``; ``a 30 zone`` in the unit of the other speeds, else km/h."""
    number, value = terms[k], value_of(terms, k).high
    if "speed_limit_mps" in found.road:
        return
    around = terms[max(0, k - _LIMIT_REACH) : k + _LIMIT_REACH]
    near = [t for t in around if t.cat == "limit"]
    span = sorted([number, *near[-1:]], key=lambda t: t.i)
    reason = None
    if number.cat == "num":
        if not _LOWEST_LIMIT <= value <= _HIGHEST_LIMIT:
            return
        words = [t.low for t in tokens]
        unit = "mph" if "mph" in words or "miles" in words else "km/h"
        value, reason = speed_mps(value, unit), f"no unit is given; {unit} is taken"
    elif not 0 < value <= _FASTEST_MPS:
        return
    found.road["speed_limit_mps"] = value, Basis(span[0].i, span[-1].j, reason)
    found.measured.append(number)


def _conditions(found: Surroundings, terms: list[Term], k: int, role: str) -> None:
    """How far one sees, how the tyres hold: of a range the middle."""
    value = value_of(terms, k)
    name, most = _CONDITIONS[role]
    if not 0 < value.high <= most:
        return
    reason = "the middle of the range" if value.low < value.high else None
    basis = Basis(terms[k].i, last_of(terms, k).j, reason)
    found.conditions[name] = value.middle, basis
    if role == "sight":
        found.measured.append(terms[k])


def _lanes(found: Surroundings, terms: list[Term], k: int, tokens: list[Token]) -> None:
    """``two lanes per direction``, ``a four-lane road``."""
    number = terms[k]
    noun = next((t for t in terms[k + 1 : k + 3] if t.cat == "place"), None)
    count = int(min(number.data["number"], 99))
    which = terms[max(0, k - 3) : k]
    if [t.cat for t in which] == ["place", "num", "prep"] and which[-1].value == "of":
        if which[0].value == "lane" and 1 < count <= MAX_LANES:
            found.lanes, found.lanes_basis = count, Basis(which[-1].i, number.j)
            found.measured.append(number)
        return  # "in lane 2 of 3"
    if noun is None or (number.i and tokens[number.i - 1].low == "lane"):
        return  # "from lane 1 to lane 2"
    after = {t.low for t in tokens[noun.j : noun.j + 4]}
    each_way = noun.value == "lane" and bool(after & {"direction", "way"})
    if noun.value != "lane" and tokens[noun.i].low != "lane":
        return
    if count == 1 and {t.low for t in tokens[noun.j : noun.j + 3]} & word_list("lanes_aside"):
        return  # "moves one lane to the left"
    likely = count <= MAX_LANES and _one_way(terms[k + 1 : k + 4], count, tokens)
    each_way = each_way or noun.form == "s" or likely
    if count < 1:
        return  # "on no six-lane road"
    lanes = count if each_way else max(1, count // 2)
    if lanes > MAX_LANES:
        msg = f"a road with {lanes} lanes a direction is not built: at most {MAX_LANES}"
        raise InfeasibleError(msg, where="junction.lanes", hint="Say fewer, or no number.")
    found.lanes, found.lanes_basis = lanes, Basis(number.i, noun.j)
    if not each_way:
        found.lanes_in_all = count
        found.lanes_basis = found.lanes_basis.because(f"{count} lanes in both directions together")


def _one_way(after: list[Term], count: int, tokens: list[Token]) -> bool:
    """``a three-lane motorway``: the lanes of one carriageway, as always where they are odd."""
    words = {t.low for term in after for t in tokens[term.i : term.j]}
    odd = count > 1 and count % 2 == 1
    fast = any(term.value == "highway" for term in after)
    return bool(words & word_list("carriageways")) or (fast and odd)


def size_of_lanes(terms: Sequence[Term], k: int, tokens: list[Token]) -> tuple[str, float] | None:
    """``lane_width_m``, or ``auxiliary_length_m`` (of a ramp's lane, or of one that ends).

    None where a term gives neither that can be built.
    """
    plain = [t for t in terms if (t.cat, t.value) == ("place", "lane")]
    plain = [t for t in plain if not {"ranked", "dir"} & {*t.data}]  # as any other of the road
    lanes = [t for t in terms if t in plain or _names_it(t, tokens)]
    ending = [t for t in terms if "auxiliary" in t.data]
    for name, named, limits, how in (
        ("lane_width_m", lanes, LANE_WIDTHS_M, "wide"),
        ("auxiliary_length_m", ending, AUXILIARY_LENGTHS_M, "long"),
    ):
        length = _length_m(terms[k], limits)
        if length is not None and _told_of(named, terms[k], tokens, how):
            return name, length
    return None


def _length_m(term: Term, limits: tuple[float, float]) -> float | None:
    """The length that a term gives exactly, within limits."""
    if (term.cat, term.value) != ("quantity", "length"):
        return None
    value = term.data["quantity"].exact
    return float(value.low) if limits[0] <= value.low == value.high <= limits[1] else None


def _told_of(lanes: list[Term], length: Term, tokens: list[Token], how: str) -> bool:
    """``3 m wide lanes``, ``lanes narrowed to 2.6 m``, ``a merging lane of 180 m``."""
    words = word_list(how)
    if any(lane.i == length.j + (low_at(tokens, length.j) in words) for lane in lanes):
        return True
    lane = next((t for t in reversed(lanes) if t.j <= length.i), None)
    if lane is None:
        return False
    begin = lane.j - (tokens[lane.j - 1].low in words)  # "lane width"
    between = {t.low for t in tokens[begin : length.i]}
    after = {t.low for t in tokens[length.j : length.j + 2]}
    told = not words.isdisjoint(between | after) or between == {"of"}
    return told and between <= word_list("between_widths") | words


def _names_it(term: Term, tokens: list[Token]) -> bool:
    """``lane width``."""
    words = [t.low for t in tokens[term.i : term.j]]
    return words[:1] == ["lane"] and words[-1] in word_list("wide")
