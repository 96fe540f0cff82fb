"""Conditions of rows: what must hold of a clause, in a few words each.

* ``path PATTERN``: a phrase of the verb, ``path ^PATTERN`` of who acts; ``at PATTERN``: a place
  named with it; ``noun``: the one that stands without a verb, or who acts; ``object``,
  ``goal`` (the lane it ends in) and ``over PATTERN`` (what is crossed);
* ``some|no|one WHO``: there is somebody; ``any|all|no WHO is WORD``: of whom something holds;
* ``own WORD…``: a word of the verb itself; ``before``, ``next``, ``soon``: around it; ``via``: of
  the verb or a preposition; ``mod``: before or after it; ``ends``; ``said``: all its lemmas;
  where a list of the lexicon stands for words, it is called ``@NAME``;
* ``lemma``, ``event``, ``parent``, ``child``, ``form``, ``link`` of it; ``how VALUE…``: manner;
* of a number: ``opens @NAME``, ``closes @NAME``: so begins what stands behind it, ends what stands
  before; ``led WORD…``: one of them leads up to it;
* ``least|below FIELD NUMBER``: a number says that of it, or every one does (SI units);
* ``control``, ``junction``; ``danger KIND…``: there is one; or a word of `FACTS`.

``not`` before any of them turns it round; ``A or B`` asks for one of two.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import StrEnum
from typing import TypeAlias

from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind
from scegen.understanding.frames.windows import Window
from scegen.understanding.semantics import along, doing, lanes, met, owed, patterns, seen, ways
from scegen.understanding.semantics.contact import goal_of_contact
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rewriting import passes_round
from scegen.understanding.semantics.values import alike
from scegen.understanding.semantics.who import entity, who
from scegen.understanding.words.tokens import base_words

Test: TypeAlias = Callable[[Clause, Context], bool]
Kind: TypeAlias = Callable[[str], Test]
_SOON = 5

_OF_THE_VERB = ("modal", "nominal", "passive", "perfect", "negated", "late", "unable")


def _is(name: str) -> Test:
    return lambda clause, _: bool(getattr(clause.event, name))


FACTS: dict[str, Test] = {
    **{name: _is(name) for name in _OF_THE_VERB},
    "reaction": lambda clause, _: clause.reaction,
    "sudden": lambda clause, _: clause.sudden is not None,
    "supposed": lambda clause, c: any(c.lows(m.i - 1, m.i) == ["if"] for m in clause.event.subject),
    "premodifier": lambda clause, _: clause.event.premod_of is not None,
    "subject": lambda clause, _: bool(clause.event.subject),
    "sided": lambda clause, _: any(t.value in {"left", "right"} for t in clause.event.dirs),
    "directed": lambda clause, _: bool(clause.event.dirs),
    "at_a_speed": lambda clause, _: any(
        (m.cat, m.value) == ("quantity", "speed") for m in clause.event.mods
    ),
    "right_after": lambda clause, _: (
        clause.event.parent is not None and clause.event.parent.j == clause.event.i
    ),
    "verbless": lambda clause, _: not clause.event.name,
    "crossing": lambda _, context: context.junction.crossing,
    "on_a_road": lambda _, context: context.junction.road is not None,
    "highway": lambda _, context: context.junction.highway,
    "meeting": lambda _, context: context.meeting,
    "kerbwards": lambda clause, c: any(
        [
            c.draft.kerb in [d for place in clause.places() for d in place.dirs],
            c.draft.kerb in [term.value for term in clause.event.dirs],
        ]
    ),
    "ramp": lambda _, context: context.draft.ramp is not None,
    "access": lambda _, context: context.draft.access is not None,
    "from_kerb": lambda _, context: context.draft.from_kerb,
    "controlled": lambda _, context: context.junction.control is not None,
    "dangerous": lambda _, context: bool(context.draft.dangers),
    "endangered": lambda _, c: any(d.by and not any(e.ego for e in d.by) for d in c.draft.dangers),
    "prevents": lambda clause, _: any(c.link == "ing" or c.nominal for c in clause.event.children),
    "people_act": lambda clause, _: any(
        h.value == "pedestrian" for m in clause.event.subject for h in m.heads
    ),
    "as_others_do": lambda clause, c: bool(alike(clause, c)),
    **lanes.FACTS,
    **ways.FACTS,
    **along.FACTS,
    **owed.FACTS,
    **met.FACTS,
    **doing.FACTS,
    **seen.FACTS,
    "passes_round": passes_round,
    "into_somebody": lambda clause, c: goal_of_contact(clause, c) is not None,
}


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
        return lambda clause, context: any(test(noun, context) for noun in nouns(clause))

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
        return lambda clause, context: judge(test(e, context) for e in find(clause, context))

    return kind


def _some(rest: str) -> Test:
    find = who(rest)
    return lambda clause, context: bool(find(clause, context))


def _one(rest: str) -> Test:
    find = who(rest)
    return lambda clause, context: len(find(clause, context)) == 1


def _no(rest: str) -> Test:
    found = _each(any)(rest) if " is " in rest else _some(rest)
    return lambda clause, context: not found(clause, context)


def _path(rest: str) -> Test:
    find = patterns.phrases(rest)
    return lambda clause, context: bool(find(clause, context))


def _over(rest: str) -> Test:
    own, direct = _KINDS["own"]("across over"), _KINDS["object"](rest)
    phrase = _path(f"=across|=over {rest}")
    return lambda clause, c: (own(clause, c) and direct(clause, c)) or phrase(clause, c)


def _how(rest: str) -> Test:
    values = rest.split()
    return lambda clause, _: clause.event.how(*values) is not None


def _next_word(clause: Clause, context: Context) -> list[str]:
    """The word behind a verb, if it is one by itself: not that of "in front of"."""
    opened = next((p.word for p in clause.event.pps if p.word.i == clause.event.j), None)
    if opened is not None and opened.j - opened.i > 1:
        return []
    return context.lows(clause.event.j, clause.event.j + 1)


def _said(rest: str) -> Test:
    return lambda clause, c: base_words(c.tokens, clause.event.i, clause.event.j) == rest


def _own(clause: Clause, context: Context) -> list[str]:
    return context.lows(clause.event.i, clause.event.j)


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
    "over": _over,
    "some": _some,
    "one": _one,
    "any": _each(any),
    "all": _each(all),
    "no": _no,
    "how": _how,
    "own": _among(_own),
    "mod": _among(lambda clause, c: [c.tokens[m.j - 1].low for m in clause.event.mods]),
    "via": _among(
        lambda clause, c: [*_own(clause, c), *(c.tokens[p.word.i].low for p in clause.event.pps)]
    ),
    "ends": _among(lambda clause, c: [c.tokens[clause.event.j - 1].low]),
    "before": _among(lambda clause, c: c.lows(clause.event.i - 1, clause.event.i)),
    "next": _among(_next_word),
    "soon": _among(lambda clause, c: c.lows(clause.event.j, clause.event.j + _SOON)),
    "said": _said,
    "lemma": _among(lambda clause, _: [clause.event.lemma]),
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
}


def condition(text: str) -> Test:
    """The test that the words of a condition make.

    Raises:
        KeyError: names a word that means nothing here.
    """
    if " or " in text:
        one, other = map(condition, text.split(" or ", maxsplit=1))
        return lambda clause, context: one(clause, context) or other(clause, context)
    name, _, rest = text.partition(" ")
    if name == "not":
        test = condition(rest)
        return lambda clause, context: not test(clause, context)
    return _KINDS[name](rest) if name in _KINDS else FACTS[text]
