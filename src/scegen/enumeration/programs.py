"""Running the encodings: facts in, facts out, the same order every time."""

from collections.abc import Iterable, Sequence
from enum import StrEnum
from pathlib import Path

from clorm import FactBase, Predicate, unify
from clorm.clingo import Control, MessageCode, SolveHandle

ENCODINGS = Path(__file__).parent / "encodings"


class Part(StrEnum):
    """The encodings, by file name; each says in its head what it does."""

    ARMS = "arms"
    WORDS = "words"
    CONFLICTS = "conflicts"
    RIGHT_OF_WAY = "right_of_way"
    DEADLOCK = "deadlock"
    DRIVES = "drives"
    PLACES = "places"
    HAZARDS = "hazards"
    ON_FOOT = "on_foot"
    GROUPS = "groups"
    INTERCHANGEABLE = "interchangeable"
    ROTATIONS = "rotations"
    PATTERN = "pattern"
    HOLDS = "holds"
    EXPLAIN = "explain"
    ORDER = "order"
    STATE = "state"
    COVER = "cover"
    RULES = "rules"


SCENARIO_PARTS = (
    Part.ARMS,
    Part.WORDS,
    Part.CONFLICTS,
    Part.DRIVES,
    Part.PLACES,
    Part.HAZARDS,
    Part.ON_FOOT,
    Part.GROUPS,
)
"""What makes an assignment a scenario, without symmetry and without who decides."""
PROBLEM_PARTS = (*SCENARIO_PARTS, Part.HOLDS)
"""The same, where all statements hold."""


def grounded(
    facts: Iterable[Predicate],
    parts: Sequence[Part],
    *options: str,
    rules: str = "",
    said: list[str] | None = None,
) -> Control:
    """A solver that holds the facts and the parts, and a user's rules; clingo's errors go to said.

    Its notes, such as "atom does not occur in any rule head", are dropped: most facts are
    optional. The seed is fixed and there is one thread, so equal input gives equal output in
    equal order.
    """

    def note(code: MessageCode, message: str) -> None:
        if said is not None and code is MessageCode.RuntimeError:
            said.append(message)

    # Bounds on counts are kept as they are: written out as rules, the default for some of them,
    # a model of forty cars costs fifty times as much.
    control = Control(["--seed=1", "--trans-ext=no", *options], logger=note)
    for part in parts:
        control.load(str(ENCODINGS / f"{part}.lp"))
    control.add("base", [], rules)
    control.add_facts(FactBase(facts))
    control.ground([("base", [])])
    return control


def consequences(
    facts: Iterable[Predicate], parts: Sequence[Part], predicates: Sequence[type[Predicate]]
) -> list[Predicate]:
    """The shown facts of these predicates in the one answer set of a program without choices."""
    control = grounded(facts, parts)  # which must live as long as it solves
    handle: SolveHandle
    with control.solve(yield_=True) as handle:
        shown = next(iter(handle)).symbols(shown=True)
    return list(unify(predicates, shown, ordered=True))


def satisfiable(control: Control, assumed: Iterable[Predicate] = ()) -> bool:
    """Whether there is an answer set in which the assumed facts hold."""
    return bool(control.solve(assumptions=[(fact, True) for fact in assumed]).satisfiable)
