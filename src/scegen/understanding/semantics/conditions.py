"""Conditions of rows: what must hold of a clause, in a few words each.

* ``path PATTERN``: a phrase of the verb, ``path ^PATTERN`` of who acts; ``at PATTERN``: a place
  named with it; ``noun``: the one that stands without a verb, or who acts; ``object``,
  ``goal`` (the lane it ends in) and ``over PATTERN`` (what is crossed);
* ``some|no|one WHO``: there is somebody; ``any|all|no WHO is WORD``: of whom something holds;
* ``own WORD…``: a word of the verb itself; ``before``, ``next``, ``soon``: around it; ``via``: of
  the verb or a preposition; ``mod``: before or after it; ``ends``; ``said``: all its lemmas;
  where a list of the lexicon stands for words, it is called ``@NAME``;
* ``lemma``, ``event``, ``parent``, ``child``, ``form``, ``link`` of it; ``how VALUE…``: manner;
* of a number: ``opens LIST``, ``closes LIST``: so begins what stands behind it, ends what stands
  before; ``led WORD…``: one of them leads up to it; ``opened WORD…``: its part of the sentence;
* ``least|below FIELD NUMBER``: a number says that of it, or every one does (SI units);
* ``control``, ``junction``; ``danger KIND…``: there is one; or a word of `FACTS`.

``not`` before any of them turns it round; ``A or B`` asks for one of two.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from scegen.scenario.vocabulary import Control, HazardKind, JunctionKind
from scegen.understanding.semantics import (
    along,
    doing,
    lanes,
    met,
    of_numbers,
    owed,
    patterns,
    seen,
    ways,
)
from scegen.understanding.semantics.contact import goal_of_contact
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.rewriting import passes_round
from scegen.understanding.semantics.values import alike
from scegen.understanding.semantics.who import entity, who

Test: TypeAlias = Callable[[Clause, Context], bool]
_SOON = 5

FACTS: dict[str, Test] = {
    "reaction": lambda clause, _: clause.reaction,
    "modal": lambda clause, _: clause.event.modal,
    "nominal": lambda clause, _: clause.event.nominal,
    "passive": lambda clause, _: clause.event.passive,
    "perfect": lambda clause, _: clause.event.perfect,
    "negated": lambda clause, _: clause.event.negated,
    "late": lambda clause, _: clause.event.late,
    "unable": lambda clause, _: clause.event.unable,
    "sudden": lambda clause, _: clause.sudden is not None,
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
    "meeting": lambda _, c: c.junction.crossing or c.draft.crossing_implied is not None,
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


def _path(rest: str) -> Test:
    find = patterns.phrases(rest)
    return lambda clause, c: bool(find(clause, c))


def _at(rest: str) -> Test:
    test = patterns.noun(rest.split())
    return lambda clause, c: any(test(p, c) for p in clause.places())


def _noun(rest: str) -> Test:
    test = patterns.noun(rest.split())
    return lambda clause, c: any(test(m, c) for m in clause.event.subject)


def _object(rest: str) -> Test:
    test = patterns.noun(rest.split())
    return lambda clause, c: test(clause.event.object, c)


def _goal(rest: str) -> Test:
    test = patterns.noun(rest.split())
    return lambda clause, c: test(lanes.into_lane(clause.event), c)


def _ends(rest: str) -> Test:
    return lambda clause, c: c.tokens[clause.event.j - 1].low == rest


def _before(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, c: clause.event.i > 0 and c.tokens[clause.event.i - 1].low in words


def _next(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, c: (
        not words.isdisjoint([t.low for t in c.tokens[clause.event.j : clause.event.j + 1]])
    )


def _soon(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, c: (
        not words.isdisjoint([t.low for t in c.tokens[clause.event.j : clause.event.j + _SOON]])
    )


def _said(rest: str) -> Test:
    forms = rest.split()
    return lambda clause, c: (
        [t.forms[-1][0] for t in c.tokens[clause.event.i : clause.event.j]] == forms
    )


def _via(rest: str) -> Test:
    words, own = patterns.listed(rest), _own(rest)
    return lambda clause, c: (
        own(clause, c) or any(c.tokens[p.word.i].low in words for p in clause.event.pps)
    )


def _over(rest: str) -> Test:
    own, direct, phrase = _own("across over"), _object(rest), _path(f"=across|=over {rest}")
    return lambda clause, c: (own(clause, c) and direct(clause, c)) or phrase(clause, c)


def _how(rest: str) -> Test:
    values = rest.split()
    return lambda clause, _: clause.event.how(*values) is not None


def _own(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, c: (
        not words.isdisjoint([t.low for t in c.tokens[clause.event.i : clause.event.j]])
    )


def _mod(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, c: (
        not words.isdisjoint([c.tokens[m.j - 1].low for m in clause.event.mods])
    )


def _lemma(rest: str) -> Test:
    words = patterns.listed(rest)
    return lambda clause, _: clause.event.lemma in words


def events(rest: str) -> frozenset[str]:
    """Events by name, and those of a list of the lexicon ("@steady")."""
    return frozenset().union(*map(patterns.listed, rest.split()))


def _event(rest: str) -> Test:
    names = events(rest)
    return lambda clause, _: clause.event.name in names


def _parent(rest: str) -> Test:
    names = frozenset(rest.split())
    return lambda clause, _: clause.event.parent is not None and clause.event.parent.name in names


def _child(rest: str) -> Test:
    names = frozenset(rest.split())
    return lambda clause, _: any(c.name in names for c in clause.event.children)


def _form(rest: str) -> Test:
    return lambda clause, _: clause.event.form == rest


def _link(rest: str) -> Test:
    return lambda clause, _: clause.event.link == rest


def _control(rest: str) -> Test:
    kinds = frozenset(Control(word) for word in rest.split())
    return lambda _, context: context.junction.control in kinds


def _junction(rest: str) -> Test:
    kinds = frozenset(JunctionKind(word) for word in rest.split())
    return lambda _, context: context.junction.kind in kinds


def _danger(rest: str) -> Test:
    kinds = frozenset(HazardKind(word) for word in rest.split())
    return lambda _, context: any(d.kind in kinds for d in context.draft.dangers)


def _some(rest: str) -> Test:
    find = who(rest)
    return lambda clause, context: bool(find(clause, context))


def _one(rest: str) -> Test:
    find = who(rest)
    return lambda clause, context: len(find(clause, context)) == 1


def _any(rest: str) -> Test:
    left, _, word = rest.rpartition(" is ")
    find, test = who(left), entity(word)
    return lambda clause, context: any(test(e, context) for e in find(clause, context))


def _all(rest: str) -> Test:
    left, _, word = rest.rpartition(" is ")
    find, test = who(left), entity(word)
    return lambda clause, context: all(test(e, context) for e in find(clause, context))


def _no(rest: str) -> Test:
    found = _any(rest) if " is " in rest else _some(rest)
    return lambda clause, context: not found(clause, context)


_KINDS: dict[str, Callable[[str], Test]] = {
    "path": _path, "at": _at, "noun": _noun, "object": _object, "goal": _goal, "how": _how,
    "own": _own,
    "mod": _mod, "lemma": _lemma, "event": _event, "parent": _parent, "child": _child,
    "form": _form, "ends": _ends, "link": _link, "control": _control, "junction": _junction,
    "danger": _danger, "before": _before, "next": _next, "soon": _soon, "said": _said,
    "via": _via, "over": _over, **of_numbers.KINDS,
    "some": _some, "one": _one, "any": _any, "all": _all, "no": _no,
}  # fmt: skip


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
