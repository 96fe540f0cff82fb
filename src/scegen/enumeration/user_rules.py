"""A user's own rules in ASP: what they may say, and errors that name the line.

Rules forbid scenarios; they do not make any. So a rule has an atom of the user's own as its head,
or none at all (a constraint); choices, scripts, and heads that redefine the vocabulary are refused.
"""

# mypy does not follow clorm and clingo.
# mypy: allow-subclassing-any

import difflib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from clingo import ast
from clorm import Predicate

from scegen.enumeration import predicates as p
from scegen.enumeration.problem import Problem
from scegen.enumeration.programs import ENCODINGS, PROBLEM_PARTS, Part, grounded
from scegen.enumeration.reading import Solution, read_solutions
from scegen.errors import InputError
from scegen.scenario.rule_file import RuleFile


@dataclass(frozen=True, slots=True)
class Word:
    """A predicate that rules may use: how it is written, and what it says."""

    form: str
    means: str

    @property
    def arity(self) -> int:
        """The number of its arguments."""
        return self.form.count(",") + 1


_WORDS = (
    Word("arms(N)", "the junction has so many arms, counter-clockwise from 0 to N-1"),
    Word("arm(A)", "an arm of the junction"),
    Word("vehicle(V)", "who drives through"),
    Word("crosser(P)", "who crosses an arm"),
    Word("ego(V)", "the vehicle under test"),
    Word("kind(V,K)", "what somebody is: car, truck, pedestrian, …"),
    Word("enters(V,A)", "the arm by which a vehicle comes"),
    Word("leaves(V,A)", "the arm by which it leaves"),
    Word("turns(V,T)", "straight, left, right or u_turn, by geometry"),
    Word("does(V,M)", "the same, or lane_change, overtake, stay; cross for one who crosses"),
    Word("crosses(P,A,Side)", "the arm that somebody crosses, starting on the right or left"),
    Word("comes_from(V,R,W)", "V comes from left, right or opposite, seen from R"),
    Word(
        "conflict(V,W,K)",
        "the ways of two vehicles meet: crossing, merging, diverging, following; in both orders",
    ),
)
VOCABULARY: dict[str, Word] = {word.form.partition("(")[0]: word for word in _WORDS}
"""Predicates that rules may use, by name; docs/how-to/rules.md explains them."""

_HARMLESS = {ast.ASTType.Program, ast.ASTType.Comment, ast.ASTType.Definition}


def ruled_solutions(problem: Problem, rules: RuleFile) -> Iterator[Solution]:
    """Every assignment that the rules allow, once, in the usual order.

    Raises:
        InputError: they are no rules over the vocabulary; names the line.
    """
    _check(rules)
    said: list[str] = []
    facts: list[Predicate] = [*problem.facts, *(p.Decides(v.id) for v in problem.vehicles)]
    facts += [p.Kind(m.id, m.kind.value) for m in problem.functional.participants]
    parts = (*PROBLEM_PARTS, Part.ORDER, Part.RULES)
    try:
        control = grounded(facts, parts, "--heuristic=Domain", rules=rules.text, said=said)
    except RuntimeError as error:
        raise _unread(rules, said, error) from error
    seen: set[Solution] = set()  # rules of the user's may have several answers of their own
    for solution in read_solutions(problem, control):
        if solution not in seen:
            seen.add(solution)
            yield solution


def _unread(rules: RuleFile, said: list[str], error: RuntimeError) -> InputError:
    """What clingo says of rules that it cannot read, with their own name for the place."""
    message = "; ".join(" ".join(text.split()) for text in said) or str(error)
    for nameless in ("<string>", "<block>"):
        message = message.replace(nameless, rules.name)
    return InputError(message, where="--rules")


def _check(rules: RuleFile) -> None:
    """Refuse what is not a rule over the vocabulary."""
    for number, line in enumerate(rules.text.splitlines(), start=1):
        if "#include" in line:  # clingo would read the other file while it parses this one
            raise InputError(
                "rules stand in one file: #include is not read",
                where=f"{rules.name}, line {number}",
            )
    statements: list[ast.AST] = []
    said: list[str] = []
    try:
        ast.parse_string(
            rules.text, statements.append, logger=lambda _, message: said.append(message)
        )
    except RuntimeError as error:
        raise _unread(rules, said, error) from error
    own = set[str]()
    for statement in statements:
        own |= _head(statement, rules)
    for statement in statements:
        if statement.ast_type is ast.ASTType.Rule:
            _Bodies(rules, own).visit_sequence(statement.body)


def _head(statement: ast.AST, rules: RuleFile) -> set[str]:
    """The predicate that a rule defines, none for a constraint."""
    if statement.ast_type in _HARMLESS:
        return set()
    if statement.ast_type is not ast.ASTType.Rule:
        raise _refused(rules, statement, "only rules and constraints may stand here")
    head = statement.head
    if head.ast_type is not ast.ASTType.Literal:
        raise _refused(rules, head, "a rule's head is one atom, or nothing; choices are not rules")
    if head.atom.ast_type is not ast.ASTType.SymbolicAtom:
        return set()
    name, _ = _signature(head.atom)
    if name in VOCABULARY:
        raise _refused(rules, head, f"{name} is given; a rule may ask for it, not define it")
    if name in _names_taken():
        raise _refused(rules, head, f"{name} is taken by the program", "Choose another name.")
    return {name}


@lru_cache(maxsize=1)
def _names_taken() -> frozenset[str]:
    """The predicates of all encodings: a rule of the user's must not add to them by accident."""
    names = set[str]()

    class Names(ast.Transformer):
        def visit_SymbolicAtom(self, atom: ast.AST) -> ast.AST:  # noqa: N802 - named by clingo
            names.add(_signature(atom)[0])
            return atom

    ast.parse_files([str(ENCODINGS / f"{part}.lp") for part in Part], Names().visit)
    return frozenset(names)


class _Bodies(ast.Transformer):
    """Visits the atoms of rule bodies."""

    def __init__(self, rules: RuleFile, own: set[str]) -> None:
        self._rules = rules
        self._own = own

    def visit_SymbolicAtom(self, atom: ast.AST) -> ast.AST:  # noqa: N802 - named by clingo
        """Check that the predicate is known."""
        name, arity = _signature(atom)
        if name in self._own:
            return atom
        if name not in VOCABULARY:
            close = difflib.get_close_matches(name, [*VOCABULARY, *self._own], n=2)
            hint = f"Did you mean {' or '.join(close)}?" if close else "See docs/how-to/rules.md."
            raise _refused(self._rules, atom, f"unknown predicate {name}/{arity}", hint)
        if arity != VOCABULARY[name].arity:
            raise _refused(
                self._rules, atom, f"{name} takes {VOCABULARY[name].arity} arguments, not {arity}"
            )
        return atom


def _signature(atom: ast.AST) -> tuple[str, int]:
    term = atom.symbol
    if term.ast_type is ast.ASTType.UnaryOperation:
        term = term.argument
    if term.ast_type is ast.ASTType.Pool:
        term = term.arguments[0]
    return term.name, len(term.arguments)


def _refused(rules: RuleFile, node: ast.AST, message: str, hint: str | None = None) -> InputError:
    place = node.location.begin if "location" in node.keys() else node.symbol.location.begin  # noqa: SIM118
    return InputError(
        message, where=f"{rules.name}, line {place.line}, column {place.column}", hint=hint
    )
