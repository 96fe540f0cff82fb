"""Patterns of phrases and nouns: ``into lane -opposite``, ``=across road``, ``from<behind who``.

A phrase is one or more prepositions by their value, with ``=`` by the word itself (``=@NAME``: a
list of the lexicon), with ``!`` by any other value and ``~`` any other word, after ``<`` the one
inside ("from behind"), after ``&`` right after somebody; then a noun. A noun is a kind of place,
``who`` (participants), ``who.it`` (that pronoun), ``thing`` or ``thing.view``, ``place`` (any),
``none``, ``named`` (any but none); ``any`` is whatever stands there. ``+x`` and ``-x`` ask for,
and rule out, a direction, one of `FILTERS`, a word of a list (``@NAME``), one before its
preposition (``led@NAME``), or what the lexicon says of its head (``does.overtaking``).
"""

from collections.abc import Callable, Collection
from functools import cache
from typing import Any, TypeAlias

from scegen.scenario.roadway import BAYS
from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.lanes import lane_number
from scegen.understanding.semantics.met import lies_there

NounTest: TypeAlias = Callable[[Any, Context], bool]
PrepTest: TypeAlias = Callable[[Prep, Context], bool]
ANY = "any"
FRONT = "in_front"
"""In somebody's way; "ahead of" somebody one only leads."""


def _lit(colour: str, noun: NounPhrase, context: Context) -> bool:
    return any(t.low == colour for t in context.tokens[noun.i : noun.j])


def _opaque(n: NounPhrase | Event, _: Context) -> bool:
    """One cannot see through it."""
    if isinstance(n, Place):
        return n.kind in _OPAQUE
    if isinstance(n, Mention):
        return not any(e.ego or not e.is_vehicle for e in n.entities)
    return isinstance(n, Thing)


def _stopped(n: Mention, context: Context) -> bool:
    stopping = context.draft.causing(HazardKind.STOPPING)
    return bool(n.entities) and all(e.parked or e.stands or e in stopping for e in n.entities)


def _other_half(n: Place, _: Context) -> bool:
    """The oncoming lane, the wrong side, what divides them."""
    theirs = n.owner is not None and any(m.value == "opposite" for m in n.owner.mods)
    other = n.kind in {"side", "lane"} and any(m.value == "other" for m in n.mods)
    lane = n.kind == "lane" and "opposite" in n.dirs
    return n.kind == "centerline" or lane or theirs or other


def _of_road(n: NounPhrase, context: Context) -> bool:
    """``the edge of the road``."""
    of, *after = [t.low for t in context.tokens[n.j : n.j + _OF_REACH]] or [""]
    return of == "of" and not word_list("roads").isdisjoint(after)


def _said(*values: str) -> NounTest:
    return lambda n, _: any(m.value in values for m in n.mods)


def _head(key: str, values: Collection[str] = ()) -> NounTest:
    """What the lexicon says of the head: any value, or one of these."""
    return lambda n, _: (
        n.head is not None and key in n.head.data and (not values or n.head.data[key] in values)
    )


_OF_REACH = 4
_OPAQUE = frozenset({"bus_stop", "feature", "parking"})
FILTERS: dict[str, NounTest] = {
    "opaque": _opaque,
    "stopped": _stopped,
    "other_half": _other_half,
    "another": lambda n, _: any(e.is_vehicle and not e.ego for e in n.entities),
    "owned": lambda n, _: n.owner is not None,
    "its": lambda n, _: n.has("possessive"),
    "egos": lambda n, _: n.has("possessive", "first_person") or any(e.ego for e in n.owned_by),
    "other": _said("other"),
    "strip": _head("stands_on"),
    "bay": _head("stands_on", BAYS),
    "numbered": lambda n, c: lane_number(n, c.tokens) is not None,
    "armed": lambda n, _: n.arm is not None,
    "of_road": _of_road,
    "brink": lambda n, c: c.tokens[n.j - 1].low == "edge",
    "kerb": lambda n, c: c.draft.kerb in n.dirs,
    "both": lambda n, _: n.has("quant"),
    "compass": lambda n, _: n.mod("compass") is not None,
    "different": _said("different", "another"),
    "same": _said("same"),
    "edge": lambda n, c: n.kind == "sidewalk" or (n.kind == "side" and _of_road(n, c)),
    "unprotected": _said("unprotected"),
    "gap": _head("gap"),
    "ranked": _head("ranked"),
    "lying": lies_there,
    "leads_off": _head("auxiliary", ["off_ramp"]),
    "plural": lambda n, _: n.head is not None and n.head.form == "s",
    "headed": lambda n, _: n.head is not None,
    "roundabout": _head("kind", ["roundabout"]),
    "undirected": lambda n, _: not n.dirs,
    "vehicle": lambda n, _: any(e.is_vehicle for e in n.entities),
    "afoot": lambda n, _: any(not e.is_vehicle for e in n.entities),
    "nobody_drives": lambda n, _: not any(e.is_vehicle for e in n.entities),
    "moving": lambda n, _: any(e.moving_vehicle for e in n.entities),
    "ego": lambda n, _: any(e.ego for e in n.entities),
    "somebody": lambda n, _: bool(n.entities),
    "pronoun": lambda n, _: n.pronoun is not None,
    "red": lambda n, c: _lit("red", n, c),
    "amber": lambda n, c: _lit("amber", n, c) or _lit("yellow", n, c),
    "green": lambda n, c: _lit("green", n, c),
}


_NOUNS: dict[str, NounTest] = {
    ANY: lambda _n, _c: True,
    "none": lambda n, _: n is None,
    "named": lambda n, _: n is not None,
    "place": lambda n, _: isinstance(n, Place),
}


def _alternative(word: str) -> NounTest:
    kind, _, detail = word.partition(".")
    if kind == "who":
        return lambda n, _: isinstance(n, Mention) and detail in {"", n.pronoun}
    if kind == "thing":
        return lambda n, _: isinstance(n, Thing) and (not detail or n.kind == detail)
    return _NOUNS.get(word) or (lambda n, _: isinstance(n, Place) and n.kind == kind)


def _filter(word: str) -> NounTest:
    wanted, names = word[0] == "+", word[1:].split("|")
    tests = [test for name in names if (test := FILTERS.get(name) or _of_words(name))]
    dirs = {name for name in names if name.isidentifier() and name not in FILTERS}
    if len(tests) == 1 and not dirs:
        return tests[0] if wanted else lambda n, c: not tests[0](n, c)
    return lambda n, c: (any(t(n, c) for t in tests) or bool(dirs and dirs & set(n.dirs))) == wanted


def _of_words(name: str) -> NounTest | None:
    """What ``@NAME``, ``led@NAME`` and ``key.value`` ask of the words of a noun."""
    if name[0] == "@":
        listed = word_list(name[1:])
        return lambda n, c: any(t.low in listed for t in c.tokens[n.i : n.j])
    if name.startswith("led@"):
        before = word_list(name[4:])
        return lambda n, c: n.prep is not None and c.tokens[n.prep.i - 1].low in before
    key, _, value = name.partition(".")
    return (lambda n, _: any(h.data.get(key) == value for h in n.heads)) if value else None


def noun(words: list[str]) -> NounTest:
    """The test that a pattern of a noun makes; True for any where there is none."""
    kind = _kind((words[0] if words else ANY).split("|"))
    filters = [_filter(word) for word in words[1:]]
    if not filters:
        return kind
    return lambda n, c: kind(n, c) and all(f(n, c) for f in filters)


def _kind(names: list[str]) -> NounTest:
    """The test for one of some kinds of nouns; most patterns name kinds of places."""
    special = {*_NOUNS, "who", "thing"}
    if special.isdisjoint(name.partition(".")[0] for name in names):
        kinds = frozenset(names)
        return lambda n, _: isinstance(n, Place) and n.kind in kinds
    tests = [_alternative(name) for name in names]
    return tests[0] if len(tests) == 1 else lambda n, c: any(test(n, c) for test in tests)


def _in_front(p: Prep, context: Context) -> bool:
    words = context.tokens[p.word.i : p.word.j]
    ahead = p.word.cat == "locus" and p.value == "ahead" and p.outer != "from"
    return ahead and all(t.low != "ahead" for t in words)


def prep(words: list[str]) -> PrepTest:
    """The test that a pattern of a phrase makes."""
    values: set[str] = set()
    spelled: set[str] = set()
    other: set[str] = set()
    apart: set[str] = set()
    outer: set[tuple[str, str]] = set()
    named_after = words[0].startswith("&")
    for word in words[0].removeprefix("&").split("|"):
        before, inside, value = word.rpartition("<")
        if inside:
            outer.add((before, value))
        elif word[0] == "!":
            apart.add(word[1:])
        elif word[0] in "=~":
            named_words = word_list(word[2:]) if word[1] == "@" else {word[1:]}
            (spelled if word[0] == "=" else other).update(named_words)
        else:
            values.add(value)
    target = noun(words[1:])
    free = ANY in values

    def fits(p: Prep, context: Context) -> bool:
        word, value = context.tokens[p.word.i].low, p.word.value
        named = free or value in values or word in spelled or (bool(other) and word not in other)
        named = named or (bool(apart) and value not in apart)
        for o, v in outer if not named else ():
            named = named or (p.outer == o and v in {ANY, value}) or (word == o and value == v)
        named = named or (FRONT in values and _in_front(p, context))
        return named and target(p.target, context) and (p.on_mention is not None or not named_after)

    return fits


def phrases(pattern: str) -> Callable[[Clause, Context], list[Prep]]:
    """What finds the phrases of a clause that fit a pattern, after ``^`` those of who acts."""
    test = prep(pattern.removeprefix("^").split())
    if pattern.startswith("^"):
        return lambda clause, c: [p for m in clause.event.subject for p in m.pps if test(p, c)]
    return lambda clause, context: [p for p in clause.event.pps if test(p, context)]


def people(found: list[Prep]) -> list[Entity]:
    """Whom phrases name."""
    return [e for p in found if isinstance(p.target, Mention) for e in p.target.entities]


def end(found: Prep) -> int:
    """The index after the last token of a phrase."""
    return found.target.j if isinstance(found.target, NounPhrase | Event) else found.word.j


@cache
def listed(rest: str) -> frozenset[str]:
    """Words, and those of lists of the lexicon ("@gently")."""
    named = (word_list(word[1:]) if word[0] == "@" else {word} for word in rest.split())
    return frozenset().union(*named)
