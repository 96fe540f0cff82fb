"""How many texts support every rule of the offline reader, and how many would change without it.

    python benchmarks/support.py FILE.jsonl… [--weak FILE.py…] [--effect] [--below N] [--json OUT]

Each line of a FILE has a description under ``text``; descriptions that occur twice count once.
``--weak`` takes Python files whose sentences count as support of a weaker kind: they were written
for one rule each. A rule is a condition of the reader (what an ``if``, a loop, a comprehension or
a conditional expression asks, and every operand of ``and`` and ``or``), a predicate (a function
that answers yes or no) or a row of its lexicon. Printed are those with the support of fewer than
N texts; with ``--effect`` also how many texts (two at the most are looked for) give another
functional scenario, evidence aside, when the condition is never true. A change of the wording of
a remark counts, and so does a crash.
"""

from __future__ import annotations

import argparse
import ast
import functools
import importlib.machinery
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from scegen.errors import ScegenError
from scegen.scenario.functional import FunctionalScenario

PACKAGE = "scegen.understanding."
NO_RULES = tuple(PACKAGE + part for part in ("agents", "report", "lexicon.loader", "frames.loader"))
"""What compares readings, reports on them or loads data reads nothing itself."""
ENOUGH = 2
"""Texts that a rule needs."""
FEWEST_WORDS = 4
"""What is shorter is no sentence."""
_PROBE = "_asked_"
_SKIP = "_skipped_"
_GIVE = "_given_"


@dataclass(slots=True)
class Rule:
    """A condition, where it stands, and the texts in which it was asked, was true, and mattered."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    kind: str
    function: str
    words: str
    asked: set[int] = field(default_factory=set)
    true: set[int] = field(default_factory=set)
    matters: list[int] = field(default_factory=list)


RULES: list[Rule] = []
_ASKED: set[int] = set()
_TRUE: set[int] = set()
FORCED: dict[int, object] = {}
"""Rules by number whose condition has this value, whatever the text says."""


def _note(number: int, value: object) -> object:
    if number in FORCED:
        return FORCED[number]
    _ASKED.add(number)
    if value:
        _TRUE.add(number)
    return value


def _skip(number: int) -> bool:
    _ASKED.add(number)
    return number in FORCED


def _give(number: int, value: object) -> object:
    if value:
        _TRUE.add(number)
    return value


def _yields(node: ast.FunctionDef) -> bool:
    return any(isinstance(n, ast.Yield | ast.YieldFrom) for n in ast.walk(node))


def nothing(node: ast.FunctionDef) -> ast.expr | None:
    """What a function that finds nothing gives back; None if its type does not tell.

    A function that takes what it gives back, as a pass over chunks does, hands it on as it is.
    """
    if node.returns is None or _yields(node):
        return ast.Constant(None)
    returns = ast.unparse(node.returns)
    for argument in node.args.args:
        if argument.annotation is not None and ast.unparse(argument.annotation) == returns:
            return ast.Name(argument.arg, ast.Load())
    if returns.endswith("None"):
        return ast.Constant(None)
    empty = {"bool": "False", "str": "''", "list": "[]", "tuple": "()", "dict": "{}"}
    empty |= {"set": "set()", "frozenset": "frozenset()", "Iterator": "()"}
    found = empty.get(returns.partition("[")[0])
    return None if found is None else ast.parse(found, mode="eval").body


class _Instrument(ast.NodeTransformer):
    """Wraps every condition of a module into a call that notes its value."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._functions: list[tuple[str, int]] = []

    def _rule(self, node: ast.expr | ast.FunctionDef, kind: str, words: str) -> ast.Constant:
        place = (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0)
        function = self._functions[-1][0] if self._functions else ""
        RULES.append(Rule(self._path, *place, kind, function, " ".join(words.split())))
        return ast.Constant(len(RULES) - 1)

    def _call(self, name: str, *arguments: ast.expr) -> ast.Call:
        return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])

    def _wrap(self, node: ast.expr, kind: str) -> ast.expr:
        number = self._rule(node, kind, ast.unparse(node))
        return ast.copy_location(self._call(_PROBE, number, self.visit(node)), node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        # what is kept from one text to the next would be asked in the first one alone
        node.decorator_list = [
            d
            for d in node.decorator_list
            if "cache" not in (kept := ast.unparse(d)) or "=1)" in kept or "property" in kept
        ]
        empty = nothing(node)
        if empty is None or node.name.startswith("__"):
            return self.generic_visit(node)
        self._functions.append((node.name, len(RULES)))
        number = self._rule(node, "function", ast.unparse(empty))
        self.generic_visit(node)
        self._functions.pop()
        leave = ast.If(self._call(_SKIP, number), [ast.Return(empty)], [])
        node.body.insert(0, ast.copy_location(leave, node.body[0]))
        if ast.unparse(empty) == "None":  # what it does, it does to its arguments
            done = ast.Expr(self._call(_GIVE, number, ast.Constant(True)))
            if _yields(node) or node.returns is None or ast.unparse(node.returns) == "None":
                node.body.insert(1, ast.copy_location(done, node.body[0]))
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        self.generic_visit(node)
        if self._functions and node.value is not None:
            number = ast.Constant(self._functions[-1][1])
            node.value = ast.copy_location(self._call(_GIVE, number, node.value), node.value)
        return node

    def _test(self, node: ast.If | ast.While | ast.IfExp) -> ast.AST:
        node.test = self._wrap(node.test, type(node).__name__.lower())
        for name, value in ast.iter_fields(node):
            if isinstance(value, list):
                setattr(node, name, [self.visit(child) for child in value])
            elif isinstance(value, ast.AST) and name != "test":
                setattr(node, name, self.visit(value))
        return node

    visit_If = visit_While = visit_IfExp = _test  # noqa: N815 - the names that ast calls

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        kind = type(node.op).__name__.lower()
        node.values = [self._wrap(value, kind) for value in node.values]
        return node

    def visit_comprehension(self, node: ast.comprehension) -> ast.AST:
        node.target = self.visit(node.target)
        node.iter = self.visit(node.iter)
        node.ifs = [self._wrap(test, "filter") for test in node.ifs]
        return node


class _Loader(importlib.machinery.SourceFileLoader):
    """Loads a module of the reader with its conditions noted."""

    def get_code(self, fullname: str) -> CodeType:
        path = self.get_filename(fullname)
        tree = ast.parse(self.get_data(path), path)
        name = fullname.removeprefix(PACKAGE).replace(".", "/") + ".py"
        tree = ast.fix_missing_locations(_Instrument(name).visit(tree))
        return compile(tree, path, "exec", dont_inherit=True)

    def exec_module(self, module: ModuleType) -> None:
        vars(module)[_PROBE] = _note
        vars(module)[_SKIP] = _skip
        vars(module)[_GIVE] = _give
        super().exec_module(module)


class _Finder(importlib.machinery.PathFinder):
    """Finds the modules that are rules of the reader."""

    @classmethod
    def find_spec(
        cls, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        if not fullname.startswith(PACKAGE) or fullname.startswith(NO_RULES):
            return None
        spec = super().find_spec(fullname, path, target)
        if spec is not None and spec.origin is not None:
            spec.loader = _Loader(fullname, spec.origin)
        return spec


def instrument() -> Callable[[str], FunctionalScenario]:
    """The reader, every condition noted; must come before anything else imports it."""
    sys.meta_path.insert(0, _Finder())
    found: Callable[[str], FunctionalScenario] = import_module("scegen.understanding.reader").read
    return found


def outcome(read: Callable[[str], FunctionalScenario], text: str) -> str:
    """What a text gives: its functional scenario without evidence, a refusal, or a crash."""
    try:
        return read(text).model_dump_json(exclude={"evidence"})
    except ScegenError as error:
        return f"refused: {type(error).__name__}: {error}"
    except Exception as error:  # noqa: BLE001 - a rule that keeps the reader from it matters
        return f"crash: {type(error).__name__}"


def observe(read: Callable[[str], FunctionalScenario], texts: Sequence[str]) -> list[str]:
    """Reads all texts, notes which rules were asked and true, and returns the outcomes."""
    outcomes = []
    for number, text in enumerate(texts):
        _ASKED.clear()
        _TRUE.clear()
        outcomes.append(outcome(read, text))
        for rule in _ASKED:
            RULES[rule].asked.add(number)
        for rule in _TRUE:
            RULES[rule].true.add(number)
    return outcomes


def effect(
    read: Callable[[str], FunctionalScenario],
    number: int,
    texts: Sequence[str],
    outcomes: Sequence[str],
) -> list[int]:
    """The first texts that give something else when a rule is never true."""
    FORCED[number] = False
    found = []
    for i in sorted(RULES[number].true):
        if outcome(read, texts[i]) != outcomes[i]:
            found.append(i)
        if len(found) >= ENOUGH:
            break
    del FORCED[number]
    return found


def sentences(path: Path) -> Iterator[str]:
    """What reads like a sentence among the strings of a Python file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and len(text.split()) >= FEWEST_WORDS and "{" not in text:
            yield text


def rows(texts: Sequence[str]) -> dict[str, set[int]]:
    """Every row of the lexicon with the texts in which a phrase of it stands."""
    load = import_module("scegen.understanding.lexicon").load
    longest_match = import_module("scegen.understanding.words.terms").longest_match
    tokenize = import_module("scegen.understanding.words.tokens").tokenize

    def entries(node: Any) -> Iterator[Any]:
        yield from node.entries
        for following in node.following.values():
            yield from entries(following)

    def named(entry: Any) -> str:
        return f"{entry.cat} {entry.value} {entry.data or ''}".rstrip()

    found: dict[str, set[int]] = {named(entry): set() for entry in entries(load().root)}
    for number, text in enumerate(texts):
        tokens = tokenize(text)
        for i in range(len(tokens)):
            match = longest_match(tokens, i)
            for entry in match.entries if match else ():
                found[named(entry)].add(number)
    return found


def _texts(paths: Sequence[Path], weak: Sequence[Path]) -> tuple[list[str], int]:
    """All texts, the labelled ones first, and how many of them are labelled."""
    lines = [line for path in paths for line in path.read_text(encoding="utf-8").splitlines()]
    labelled = list(dict.fromkeys(json.loads(line)["text"] for line in lines))
    own = dict.fromkeys(text for path in weak for text in sentences(path))
    return labelled + [text for text in own if text not in set(labelled)], len(labelled)


def main() -> int:
    """Print the rules with too little support; exit code 1 if there are any."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE.jsonl")
    parser.add_argument("--weak", nargs="*", type=Path, default=[], metavar="FILE.py")
    parser.add_argument("--effect", action="store_true")
    parser.add_argument("--below", type=int, default=ENOUGH, metavar="N")
    parser.add_argument("--json", type=Path, metavar="OUT")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    read = instrument()
    texts, labelled = _texts(args.files, args.weak)
    outcomes = observe(read, texts)
    if args.effect:
        work = functools.partial(effect, read, texts=texts, outcomes=outcomes)
        with get_context("fork").Pool(args.jobs) as pool:
            for rule, found in zip(RULES, pool.imap(work, range(len(RULES)), 16), strict=True):
                rule.matters = found
    few = 0
    for rule in sorted(RULES, key=lambda rule: (rule.file, rule.line, rule.column)):
        support = sum(number < labelled for number in rule.true)
        matters = sum(number < labelled for number in rule.matters)
        if support < args.below or (args.effect and matters < args.below):
            few += 1
            shown = f"{support:4d} + {len(rule.true) - support:3d} weak"
            shown += f", matters in {matters} + {len(rule.matters) - matters}" * args.effect
            print(f"{shown}  {rule.file}:{rule.line} {rule.function} {rule.kind}: {rule.words}")
    for name, where in sorted(rows(texts).items()):
        support = sum(number < labelled for number in where)
        if support < args.below:
            few += 1
            print(f"{support:4d} + {len(where) - support:3d} weak  lexicon: {name}")
    print(f"{few} of {len(RULES)} conditions and the lexicon's rows have little support")
    if args.json:
        records = [asdict(rule) for rule in RULES]
        args.json.write_text(json.dumps({"labelled": labelled, "rules": records}, default=sorted))
    return int(few > 0)


if __name__ == "__main__":
    sys.exit(main())
