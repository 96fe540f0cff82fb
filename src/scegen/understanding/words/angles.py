"""Reads the directions of the arms: "arms at 0, 40, 180 and 220 degrees"."""

from __future__ import annotations

from dataclasses import dataclass

from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, low_at

_JOINTS = frozenset({",", "and"})
_REACH = 6
_FEWEST = 3
_SQUARE_DEG = 12.0
"""How far from a right angle, or from a straight line, two arms may be and still count as such."""


@dataclass(frozen=True, slots=True)
class Angles:
    """Directions of the arms, in degrees, rising within [0, 360), and their tokens."""

    degrees: tuple[float, ...]
    i: int
    j: int


def read_angles(tokens: list[Token]) -> Angles | None:
    """The directions of the arms, if the text lists them or says at what angle two roads cross."""
    for i, token in enumerate(tokens):
        if token.kind != "number":
            continue
        values, j, sign = _run(tokens, i)
        if not sign:
            continue
        before = {base for t in tokens[max(0, i - _REACH) : i] for base, _ in t.forms}
        if len(values) >= _FEWEST and before & word_list("arms"):
            return _rising(values, i, j)
        after = {base for t in tokens[j : j + 2] for base, _ in t.forms}
        if len(values) == 1 and "angle" in before | after:
            return _crossing(values[0], i, j)
    return None


def _run(tokens: list[Token], i: int) -> tuple[list[float], int, bool]:
    """Numbers from token ``i`` on, joined by commas and "and", and whether they are degrees."""
    values: list[float] = []
    j = k = i
    sign = False
    while k < len(tokens) and tokens[k].kind == "number" and (k > j or not values):
        values.append(float(tokens[k].text.replace(",", ".")))
        j = k + 1
        if low_at(tokens, j) in word_list("degrees"):
            sign = True
            j += 1
        k = j
        while low_at(tokens, k) in _JOINTS:
            k += 1
    return values, j, sign


def _rising(values: list[float], i: int, j: int) -> Angles | None:
    degrees = tuple(sorted({v % 360 for v in values}))
    return Angles(degrees, i, j) if len(degrees) == len(values) else None


def _crossing(angle: float, i: int, j: int) -> Angles | None:
    """Two roads that cross at an angle."""
    if not 0 < angle < 180 or abs(angle - 90) <= _SQUARE_DEG:
        return None
    return Angles((0.0, angle, 180.0, 180.0 + angle), i, j)


def kind_of(degrees: tuple[float, ...]) -> JunctionKind:
    """The shape that arms in these directions make."""
    gaps = [(b - a) % 360 for a, b in zip(degrees, (*degrees[1:], degrees[0]), strict=True)]
    if len(degrees) == _FEWEST:
        through = any(abs(gap - 180) <= _SQUARE_DEG for gap in gaps)
        return JunctionKind.T if through else JunctionKind.Y
    if len(degrees) == _FEWEST + 1:
        square = all(abs(gap - 90) <= _SQUARE_DEG for gap in gaps)
        return JunctionKind.FOUR_WAY if square else JunctionKind.SKEWED
    return JunctionKind.MULTI_WAY


def set_apart(terms: list[Term], angles: Angles | None) -> list[Term]:
    """The terms with one for all angles, so that nobody counts vehicles by them."""
    if angles is None:
        return terms
    kept = [t for t in terms if t.j <= angles.i or t.i >= angles.j]
    found = Term("angles", "arms", angles.i, angles.j, data={"degrees": angles.degrees})
    return sorted([*kept, found], key=lambda t: t.i)
