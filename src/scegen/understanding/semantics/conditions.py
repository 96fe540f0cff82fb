"""Conditions of rows: what must hold of a clause, in a few words each.

* ``path PATTERN``: a phrase of the verb, ``path ^PATTERN`` of who acts; ``at PATTERN``: a place
  named with it; ``noun``: the one that stands without a verb, or who acts; ``object``,
  ``goal`` (the lane it ends in) and ``over PATTERN`` (what is crossed);
* ``some|no|one WHO``: there is somebody; ``any|all|no WHO is WORD``: of whom something holds;
* ``own WORD…``: a word of the verb itself; ``before``, ``lately``, ``next``, ``soon``: around it;
  ``tells PHRASE…``: behind it in its sentence; ``via``: of the verb or a preposition; ``mod``:
  before or after it; ``ends``; ``said``: all its lemmas; ``measured``: what numbers with it
  measure; ``opened``: before who acts; a list of the lexicon is called ``@NAME``;
* ``lemma``, ``event``, ``parent``, ``child``, ``form``, ``link`` of it; ``above``: lemmas of it and
  the verbs above; ``how VALUE…``: manner;
* of a number: ``opens @NAME``, ``closes @NAME``: so begins what stands behind it, ends what stands
  before; ``led WORD…``: one of them leads up to it;
* ``least|below FIELD NUMBER``: a number says that of it, or every one does (SI units);
* ``control``, ``junction``; ``danger KIND…``: there is one, ``facing``: that no driver causes; or
  a word of `FACTS` or of ``facts.yaml``.

``not`` before any of them turns it round; ``A or B`` asks for one of two.
"""

from collections.abc import Callable, Iterable
from enum import StrEnum
from functools import cache
from itertools import takewhile
from typing import TypeAlias

from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind
from scegen.understanding.entity import Entity
from scegen.understanding.frames.loader import read
from scegen.understanding.frames.windows import Window
from scegen.understanding.semantics import lanes, patterns
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.cues import SENTENCE, SOON, needs
from scegen.understanding.semantics.facts import FACTS, Test
from scegen.understanding.semantics.who import entity, who
from scegen.understanding.words.tokens import base_words

Kind: TypeAlias = Callable[[str], Test]
_MARKS = frozenset({".", ";", ":"})


def _among(found: Callable[[Clause, Context], Iterable[str | None]]) -> Kind:
    """Whether one of some words of a clause is named, or in a list of the lexicon ("@gently")."""

    def kind(rest: str) -> Test:
        words = patterns.listed(rest)
        return lambda clause, context: not words.isdisjoint(found(clause, context))

    return kind


def _fits(nouns: Callable[[Clause], Iterable[object]]) -> Kind:
    """Whether one of some nouns of a clause fits a pattern."""

    def kind(rest: str) -> Test:
        test = patterns.noun(rest.split())
        return lambda clause, c: bool([n for n in nouns(clause) if test(n, c)])

    return kind


def _one_of(kinds: type[StrEnum], held: Callable[[Context], Iterable[object]]) -> Kind:
    """Whether the scenario holds one of some words of the vocabulary."""

    def kind(rest: str) -> Test:
        named = frozenset(kinds(word) for word in rest.split())
        return lambda _, context: not named.isdisjoint(held(context))

    return kind


def _each(judge: Callable[[Iterable[bool]], bool]) -> Kind:
    """``WHO is WORD``: of whom something holds."""

    def kind(rest: str) -> Test:
        left, _, word = rest.rpartition(" is ")
        find, test = who(left), entity(word)
        return lambda clause, context: judge([test(e, context) for e in find(clause, context)])

    return kind


def _found(judge: Callable[[list[Entity]], bool]) -> Kind:
    """``WHO``: whether somebody is found, or how many."""

    def kind(rest: str) -> Test:
        find = who(rest)
        return lambda clause, context: judge(find(clause, context))

    return kind


def _path(rest: str) -> Test:
    find = patterns.phrases(rest)
    return lambda clause, context: bool(find(clause, context))


def _next_word(clause: Clause, context: Context) -> list[str]:
    """The word behind a verb, if it is one by itself: not that of "in front of"."""
    opened = next((p.word for p in clause.event.pps if p.word.i == clause.event.j), None)
    if opened is not None and opened.j - opened.i > 1:
        return []
    return context.lows(clause.event.j, clause.event.j + 1)


def _here(words: Iterable[str]) -> Iterable[str]:
    """The words up to the end of a sentence."""
    return takewhile(lambda word: word not in _MARKS, words)


def _opened(clause: Clause, context: Context) -> list[str]:
    who = min((m.i for m in clause.event.subject), default=0)
    return context.lows(who - 1, who)


def _own(clause: Clause, context: Context) -> list[str]:
    return context.lows(clause.event.i, clause.event.j)


def _tells(rest: str) -> Test:
    """``runs along, in the direction of traffic``: one of some phrases after the verb."""
    phrases = patterns.listed(rest)

    def test(clause: Clause, context: Context) -> bool:
        after = context.lows(clause.event.i, clause.event.i + SENTENCE)
        words = f" {' '.join(_here(after))} "
        return any(f" {phrase} " in words for phrase in phrases)

    return test


def _facing(rest: str) -> Test:
    kinds = frozenset(HazardKind(word) for word in rest.split())
    return lambda clause, context: any(
        d.kind in kinds and not any(e in clause.drivers for e in d.by)
        for d in context.draft.dangers
    )


def _least(rest: str) -> Test:
    name, value = rest.split()
    return lambda clause, _: any(
        v is not None and v.low >= float(value) for v in clause.amounts.get(name, ())
    )


def _below(rest: str) -> Test:
    name, value = rest.split()
    return lambda clause, _: (
        name in clause.amounts
        and all(v is not None and v.high < float(value) for v in clause.amounts[name])
    )


def _around(asked: Callable[[Window, str], bool]) -> Kind:
    """Whether something holds of the words around a number."""
    return lambda rest: lambda clause, _: clause.around is not None and asked(clause.around, rest)


_KINDS: dict[str, Kind] = {
    "path": _path,
    "at": _fits(Clause.places),
    "noun": _fits(lambda clause: clause.event.subject),
    "object": _fits(lambda clause: [clause.event.object]),
    "goal": _fits(lambda clause: [lanes.into_lane(clause.event)]),
    "some": _found(bool),
    "one": _found(lambda found: len(found) == 1),
    "any": _each(any),
    "all": _each(all),
    "how": lambda rest: lambda clause, _: clause.event.how(*rest.split()) is not None,
    "own": _among(_own),
    "mod": _among(lambda clause, c: [c.tokens[m.j - 1].low for m in clause.event.mods]),
    "via": _among(
        lambda clause, c: [*_own(clause, c), *(c.tokens[p.word.i].low for p in clause.event.pps)]
    ),
    "ends": _among(lambda clause, c: [c.tokens[clause.event.j - 1].low]),
    "before": _among(lambda clause, c: c.lows(clause.event.i - 1, clause.event.i)),
    "next": _among(_next_word),
    "soon": _among(lambda clause, c: _here(c.lows(clause.event.j, clause.event.j + SOON))),
    "opened": _among(_opened),
    "lately": _among(
        lambda clause, c: _here(reversed(c.lows(clause.event.i - SOON, clause.event.i)))
    ),
    "tells": _tells,
    "measured": _among(lambda c, _: [m.value for m in c.event.mods if m.cat == "quantity"]),
    "said": _among(lambda clause, c: [base_words(c.tokens, clause.event.i, clause.event.j)]),
    "lemma": _among(lambda clause, _: [clause.event.lemma]),
    "above": _among(lambda clause, _: [e.lemma for e in clause.event.upwards()]),
    "event": _among(lambda clause, _: [clause.event.name]),
    "parent": _among(lambda clause, _: [e.name for e in [clause.event.parent] if e is not None]),
    "child": _among(lambda clause, _: [e.name for e in clause.event.children]),
    "form": _among(lambda clause, _: [clause.event.form]),
    "link": _among(lambda clause, _: [clause.event.link]),
    "opens": _around(lambda window, rest: window.opens(rest.removeprefix("@"))),
    "closes": _around(lambda window, rest: window.closes(rest.removeprefix("@"))),
    "led": _around(lambda window, rest: any(map(window.preceded, patterns.listed(rest)))),
    "least": _least,
    "below": _below,
    "control": _one_of(Control, lambda context: [context.junction.control]),
    "junction": _one_of(JunctionKind, lambda context: [context.junction.kind]),
    "danger": _one_of(HazardKind, lambda context: [d.kind for d in context.draft.dangers]),
    "facing": _facing,
}


def ways(text: str) -> list[list[str]]:
    """Rows of conditions that say what one says: each is one way in which it is so."""
    name, _, rest = text.partition(" ")
    if " or " in text:
        return [[part] for part in text.split(" or ")]
    if name == "over":
        return [["own across over", f"object {rest}"], [f"path =across|=over {rest}"]]
    if name == "no":
        return [[f"not any {rest}" if " is " in rest else f"not some {rest}"]]
    told: list[list[str]] = read("facts").get(text, [[text]])
    return told


@cache
def condition(text: str) -> Test:
    """The test that the words of a condition make.

    Raises:
        KeyError: names a word that means nothing here.
    """
    name, _, rest = text.partition(" ")
    if " or " in text:
        one, other = map(condition, text.split(" or ", maxsplit=1))
        return lambda clause, context: one(clause, context) or other(clause, context)
    if (told := ways(text)) != [[text]]:
        return _one_of_rows([[condition(part) for part in row] for row in told])
    if name == "not":
        test = condition(rest)
        return lambda clause, context: not test(clause, context)
    return _KINDS[name](rest) if name in _KINDS else FACTS[text]


def _one_of_rows(rows: list[list[Test]]) -> Test:
    def test(clause: Clause, context: Context) -> bool:
        for tests in rows:
            for test in tests:
                if not test(clause, context):
                    break
            else:
                return True
        return False

    return test


@cache
def needed(text: str) -> frozenset[str]:
    """Cues of which a clause has one wherever a condition holds; none where no cue tells."""
    if (told := ways(text)) == [[text]]:
        return needs(text)
    each = [next(filter(None, map(needed, row)), frozenset[str]()) for row in told]
    return frozenset().union(*each) if all(each) else frozenset()


def holds(name: str, clause: Clause, context: Context) -> bool:
    """Whether a word that has rows of its own is so of a clause."""
    return condition(name)(clause, context)
