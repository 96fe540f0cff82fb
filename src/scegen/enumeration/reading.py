"""From answer sets to solutions: every atom is understood once, however often it comes back."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from clorm import Predicate, unify
from clorm.clingo import Control, Symbol

from scegen.enumeration import answers as a
from scegen.enumeration.problem import Problem

COUNTED = -1
"""Stands for the move of a vehicle whose moves are counted instead of chosen."""

Way = tuple[int, int, str]
"""Entry, move and manner of a vehicle."""

_SHOWN = (a.Drive, a.Enters, a.GoesOnFoot, a.Place)
_UNSET: Way = (-1, COUNTED, "")


class Solution(NamedTuple):
    """One assignment, in listing order of the participants.

    ``drives`` holds (entry, move, manner); in a state, of which only the entries are chosen,
    the move of an independent vehicle is COUNTED. ``on_foot`` holds (arm, way), ``places``
    (vehicle, reference, word).
    """

    drives: tuple[Way, ...]
    on_foot: tuple[tuple[int, str], ...]
    places: tuple[tuple[str, str, str], ...]

    @property
    def pattern(self) -> tuple[int, ...]:
        """The multiset of symbolic moves, sorted."""
        return tuple(sorted([way[1] for way in self.drives]))


class Reader:
    """Reads the answer sets of one program.

    Atoms are few and answer sets many: an atom is taken apart once and looked up afterwards.
    """

    def __init__(self, problem: Problem) -> None:
        self._slots = {vehicle.id: slot for slot, vehicle in enumerate(problem.vehicles)}
        self._walkers = {crosser.id: slot for slot, crosser in enumerate(problem.crossers)}
        self._ways: dict[Symbol, tuple[int, Way]] = {}
        self._facts: dict[Symbol, Predicate] = {}
        self._equal: dict[Way, Way] = {}  # equal ways are one object, so they compare at once

    def solution(self, shown: Iterable[Symbol]) -> Solution:
        """The solution that the shown atoms of one answer set say."""
        drives: list[Way] = [_UNSET] * len(self._slots)
        others: list[Predicate] = []
        find = self._ways.get
        for symbol in shown:
            found = find(symbol)
            if found is not None:
                drives[found[0]] = found[1]
                continue
            fact = self._fact(symbol)
            if isinstance(fact, a.Drive):
                slot, way = self._slots[fact.id], (fact.entry, fact.move, fact.manner)
                self._ways[symbol] = slot, self._equal.setdefault(way, way)
                drives[slot] = self._ways[symbol][1]
            else:
                others.append(fact)
        on_foot: list[tuple[int, str]] = [(0, "")] * len(self._walkers)
        places: list[tuple[str, str, str]] = []
        for fact in others:
            if isinstance(fact, a.GoesOnFoot):
                on_foot[self._walkers[fact.id]] = (fact.arm, fact.way)
            elif isinstance(fact, a.Place):
                places.append((fact.id, fact.reference, fact.word))
            elif isinstance(fact, a.Enters) and drives[self._slots[fact.id]] is _UNSET:
                drives[self._slots[fact.id]] = (fact.arm, COUNTED, "none")
        return Solution(tuple(drives), tuple(on_foot), tuple(sorted(places)))

    def _fact(self, symbol: Symbol) -> Predicate:
        if symbol not in self._facts:
            (self._facts[symbol],) = unify(_SHOWN, [symbol], ordered=True)
        return self._facts[symbol]


def read_solutions(
    problem: Problem, control: Control, *, limit: int = 0, assumed: Iterable[Predicate] = ()
) -> Iterator[Solution]:
    """The answer sets of a program as solutions, in its order; ``limit`` 0 means all.

    Only those in which the assumed facts hold.
    """
    reader = Reader(problem)
    control.configuration.solve.models = limit
    assumptions = [(fact.symbol, True) for fact in assumed]
    # The plain handle: clorm's would wrap every model anew, and the reader does its work.
    with control.control_.solve(assumptions, yield_=True) as handle:
        for model in handle:
            yield reader.solution(model.symbols(shown=True))
