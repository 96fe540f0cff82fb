"""Expressions over a scenario, such as ``conflicts(crossing) >= 2 and ego.maneuver == left``.

The grammar is documented in docs/how-to/where.md. It is a small part of Python's, so Python parses
it; everything outside the part is refused, and nothing is executed but the closures made here.
"""

import ast
import difflib
import operator
from collections.abc import Callable, Iterable

from scegen.enumeration.choosing import terms
from scegen.enumeration.choosing.terms import NONE, NUMBER, TRUTH, Evaluate, Type
from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario

LONGEST = 2_000
"""Characters; longer expressions nobody reads."""

_GRAMMAR = "see docs/how-to/where.md"
_ORDER: dict[type[ast.cmpop], Callable[[int, int], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_SCENARIO: dict[str, tuple[Type, Callable[[LogicalScenario], int | bool]]] = {
    "class_size": (NUMBER, lambda s: s.class_size),
    "index": (NUMBER, lambda s: s.index),
    "deadlock": (TRUTH, lambda s: bool(s.deadlock)),
}
_FUNCTIONS = ("conflicts", "conflict", "yields", "count")
Term = tuple[Type, Evaluate]


def where(functional: FunctionalScenario, expression: str) -> Callable[[LogicalScenario], bool]:
    """The test that an expression stands for.

    Raises:
        InputError: the expression is not one; names the column, and what may be meant.
    """
    if len(expression) > LONGEST:
        raise InputError(f"is longer than {LONGEST} characters", where="--where")
    reader = _Reader(functional, expression)
    try:
        tree = ast.parse(expression.strip() or " ", mode="eval")
        test = reader.truth(tree.body)
    except SyntaxError as error:
        single = expression.strip()[(error.offset or 1) - 1 :].startswith("=")
        hint = "equality is written ==" if single else _GRAMMAR
        raise reader.error(error.offset or 1, "this is not an expression", hint) from error
    except (RecursionError, MemoryError, ValueError) as error:
        raise reader.error(1, "this is not an expression that can be read", None) from error
    return lambda scenario: bool(test((scenario, "")))


class _Reader:
    """Reads the syntax tree of one expression."""

    def __init__(self, functional: FunctionalScenario, text: str) -> None:
        self._text = text.strip()
        self._names = {p.id: p.id for p in functional.participants}
        self._names.setdefault("ego", functional.ego.id)
        kinds = {p.id: str(p.kind) for p in functional.participants}
        roles = {p.id: str(p.role) for p in functional.participants}
        self._attributes = terms.attributes(kinds, roles)
        self._inside = False

    def truth(self, node: ast.expr) -> Evaluate:
        """A condition."""
        type_, evaluate = self._term(node)
        if type_ is not TRUTH:
            raise self._wrong(node, "this is not a condition", "compare it: ==, !=, <, <=, >, >=")
        return evaluate

    def _term(self, node: ast.expr) -> Term:
        match node:
            case ast.BoolOp(op=op, values=values):
                parts = [self.truth(value) for value in values]
                every = isinstance(op, ast.And)
                return TRUTH, lambda row: (all if every else any)(part(row) for part in parts)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                inner = self.truth(operand)
                return TRUTH, lambda row: not inner(row)
            case ast.Compare():
                return self._comparison(node)
            case ast.Constant(value=int() as value) if not isinstance(value, bool):
                return NUMBER, lambda _: value
            case ast.Attribute():
                return self._attribute(node)
            case ast.Name():
                return self._name(node)
            case ast.Call(func=ast.Name(id=name), keywords=[]):
                return self._call(name, node)
        raise self._wrong(node, "this is not part of the language", _GRAMMAR)

    def _name(self, node: ast.Name) -> Term:
        if node.id in _SCENARIO:
            type_, of_scenario = _SCENARIO[node.id]
            return type_, lambda row: of_scenario(row[0])
        if self._inside and node.id in self._attributes:
            attribute = self._attributes[node.id]
            return attribute.type, lambda row: attribute.read(row[0].assignment(row[1]))
        raise self._unknown(node, node.id, [*_SCENARIO, *self._scope(), *self._names])

    def _scope(self) -> Iterable[str]:
        return self._attributes if self._inside else ()

    def _attribute(self, node: ast.Attribute) -> Term:
        name = self._participant(node.value)
        attribute = self._attributes.get(node.attr)
        if attribute is None:
            raise self._unknown(node, node.attr, self._attributes, at=node.end_col_offset)
        read = attribute.read
        return attribute.type, lambda row: read(row[0].assignment(name))

    def _participant(self, node: ast.expr) -> str:
        if not isinstance(node, ast.Name):
            raise self._wrong(node, "a participant's name is expected here", None)
        if node.id not in self._names:
            raise self._unknown(node, node.id, self._names, "participant")
        return self._names[node.id]

    def _comparison(self, node: ast.Compare) -> Term:
        if len(node.ops) != 1:
            raise self._wrong(node, "two comparisons are joined by and", "1 < x and x < 3")
        left, op, right = node.left, node.ops[0], node.comparators[0]
        if isinstance(op, ast.In | ast.NotIn):
            return self._membership(left, right, negated=isinstance(op, ast.NotIn))
        if type(op) in _ORDER:
            compare = _ORDER[type(op)]
            low, high = self._number(left), self._number(right)
            return TRUTH, lambda row: _ordered(compare, low(row), high(row))
        if not isinstance(op, ast.Eq | ast.NotEq):
            raise self._wrong(node, "this is not a comparison of the language", _GRAMMAR)
        if self._is_word(left) and not self._is_word(right):
            left, right = right, left
        type_, first = self._term(left)
        second = self._operand(right, type_)
        same = isinstance(op, ast.Eq)
        return TRUTH, lambda row: (first(row) == second(row)) is same

    def _membership(self, left: ast.expr, right: ast.expr, *, negated: bool) -> Term:
        if not isinstance(right, ast.Tuple | ast.List | ast.Set):
            raise self._wrong(right, "in wants a list, such as (left, right)", None)
        type_, first = self._term(left)
        options = [self._operand(option, type_) for option in right.elts]
        return TRUTH, lambda row: (first(row) in [o(row) for o in options]) is not negated

    def _number(self, node: ast.expr) -> Evaluate:
        type_, evaluate = self._term(node)
        if type_ is not NUMBER:
            raise self._wrong(node, "only numbers have an order", "use == or !=")
        return evaluate

    def _is_word(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and node.id not in {*_SCENARIO, *self._scope()}

    def _operand(self, node: ast.expr, type_: Type) -> Evaluate:
        """The right side of a comparison: for a word, one of the vocabulary of the left."""
        if isinstance(node, ast.Name) and node.id == NONE:
            return lambda _: NONE if type_ is terms.KINDS else None
        if isinstance(node, ast.Name) and self._is_word(node) and type_.words:
            word = self._names.get(node.id, node.id)
            if word not in type_.words:
                raise self._unknown(node, node.id, type_.words)
            return lambda _: word
        other, evaluate = self._term(node)
        if other.name != type_.name:
            raise self._wrong(node, f"a {other.name} never equals a {type_.name}", None)
        return evaluate

    def _call(self, name: str, node: ast.Call) -> Term:
        given = node.args
        if name == "count" and len(given) == 1:
            outer, self._inside = self._inside, True
            test = self.truth(given[0])
            self._inside = outer
            return NUMBER, lambda row: sum(
                bool(test((row[0], a.participant))) for a in row[0].assignments
            )
        if name == "conflicts" and len(given) <= 2:
            kind = self._kind(given[0]) if given else None
            whose = self._participant(given[1]) if len(given) == 2 else None
            return NUMBER, lambda row: terms.conflicts(row[0], kind, whose)
        if name == "conflict" and len(given) == 2:
            one, two = (self._participant(part) for part in given)
            return terms.KINDS, lambda row: terms.conflict(row[0], one, two)
        if name == "yields" and 1 <= len(given) <= 2:
            who, to = self._participant(given[0]), [self._participant(p) for p in given[1:]]
            return TRUTH, lambda row: terms.yields(row[0], who, to[0] if to else None)
        if name in _FUNCTIONS:
            raise self._wrong(node, f"{name} does not take {len(given)} arguments", None)
        raise self._unknown(node, name, _FUNCTIONS, "function")

    def _kind(self, node: ast.expr) -> str:
        if isinstance(node, ast.Name) and node.id in terms.KINDS.words - {NONE}:
            return node.id
        if isinstance(node, ast.Name):
            raise self._unknown(node, node.id, terms.KINDS.words - {NONE}, "kind of conflict")
        raise self._wrong(node, "a kind of conflict is expected here", "such as crossing")

    def _unknown(
        self,
        node: ast.expr,
        name: str,
        known: Iterable[str],
        what: str = "name",
        *,
        at: int | None = None,
    ) -> InputError:
        close = difflib.get_close_matches(name, known, n=3, cutoff=0.6)
        hint = (
            f"Did you mean {' or '.join(close)}?" if close else f"Known: {', '.join(sorted(known))}"
        )
        column = node.col_offset + 1 if at is None else at - len(name) + 1
        return self.error(column, f"unknown {what} {name!r}", hint)

    def _wrong(self, node: ast.expr, message: str, hint: str | None) -> InputError:
        return self.error(node.col_offset + 1, message, hint)

    def error(self, column: int, message: str, hint: str | None) -> InputError:
        """An error at a column of the expression, from 1."""
        shown = self._text if len(self._text) <= 120 else self._text[:119] + "…"
        return InputError(message, where=f"--where, column {column} of {shown!r}", hint=hint)


def _ordered(compare: Callable[[int, int], bool], low: terms.Value, high: terms.Value) -> bool:
    """What is missing is neither more nor less than anything."""
    return isinstance(low, int) and isinstance(high, int) and compare(low, high)
