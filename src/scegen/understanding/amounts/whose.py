"""Whose a speed is: by the words right before it, by the noun, else by who acts in its clause."""

from __future__ import annotations

from scegen.understanding.amounts.figures import Figure
from scegen.understanding.chunks import Mention, Word
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import Quantity
from scegen.understanding.words.terms import Term

_WAITS = frozenset({"wait", "yield", "cause"})
_FROM_REST = frozenset({"pull_out", "unpark", "reverse", "door", "leave"})
_BESIDES = frozenset({"prep", "locus", "manner", "aux"})


def whose(figure: Figure) -> list[tuple[Entity, Quantity]]:
    """Those whose speed it is, with what it is of each of them; none where nothing tells."""
    near = _for_whom(figure) or figure.named_before(_outside(figure))
    near = near or _of_the_noun(figure) or _opens_with(figure)
    return [(entity, figure.quantity) for entity in near] or _by_clause(figure)


def _for_whom(figure: Figure) -> list[Entity]:
    """``60 km/h for the ego and 20 km/h for the van``."""
    text = figure.text
    who = next((m for m in text.mentions if m.i >= figure.j), None)
    given = who is not None and text.low(figure.j, who.i) == " for "
    acts = text.within(figure.start, figure.i)
    return list(who.entities) if who is not None and given and not acts else []


def _outside(figure: Figure) -> int:
    """``a tractor (width 2.5 m, speed 30 km/h)``: where the brackets open around a number."""
    tokens = figure.text.tokens
    marks = [k for k in range(figure.start, figure.i) if tokens[k].low in {"(", ")"}]
    return marks[-1] if marks and tokens[marks[-1]].low == "(" else figure.i


def _of_the_noun(figure: Figure) -> list[Entity]:
    """``a car from the left at 50 km/h``, ``waits for a van at 50 km/h``, ``both at 50 km/h``.

    Who waits has no speed, and who sets off has none yet.
    """
    text, verb, end = figure.text, figure.verb, figure.i - 1
    who = next((m for m in reversed(text.mentions) if m.j < figure.i), None)
    if who is None or who.possessor or who.i < figure.start:
        return []
    if _before_any_verb(figure, who):
        return list(figure.placed_by(who).entities)
    told = who.pronoun in {"both", "all"} and not text.within(who.j, figure.i)
    sides = [p for p in who.pps if p.value == "from" and p.names("side", "direction")]
    if any(p.place is not None and p.place.j == end for p in sides):
        told |= who.pronoun is None and not who.stands_after("of")
    elif verb is not None and who.j == end:
        ahead = any(p.value == "ahead" and p.target is who for p in verb.pps)
        awaited = verb.name in _WAITS and (who.prep is not None or verb.object is who)
        out = verb.name == "cut_in" and any(e.pulls_out for e in figure.actors)
        rests = (out or verb.name in _FROM_REST) and ahead
        told |= awaited or (rests and not _has_another(figure, who))
    return list(who.entities) if told else []


def _before_any_verb(figure: Figure, who: Mention) -> bool:
    """``a coach at 60 km/h is overtaken by a taxi``, ``between me, at 50 km/h, and the van``."""
    if who.stands_after("of") or figure.text.within(figure.start, figure.i):
        return False
    between = [c for c in figure.text.chunks if who.j <= c.i < figure.i]
    return all(isinstance(c, Word) and (c.cat in _BESIDES or c.value == ",") for c in between)


def _opens_with(figure: Figure) -> list[Entity]:
    """``At about 100 km/h, the ego is overtaken by a van``: of whom the sentence is about.

    So it is in "60 km/h is the speed of both".
    """
    text, start = figure.text, figure.start
    before = [c for c in text.chunks if start <= c.i < figure.i]
    who = next((m for m in text.mentions if start <= m.i < figure.end), None)
    if who is None or not all(isinstance(c, Word) for c in before):
        return []
    named = text.low(figure.j, who.i).split()
    if named[:1] == ["is"] and named[-1:] == ["of"] and set(named) & word_list("rates"):
        return list(who.entities)
    told = before and who.prep is None and not who.possessor and not text.within(start, who.i)
    return list(who.entities) if told else []


def _by_clause(figure: Figure) -> list[tuple[Entity, Quantity]]:
    """The noun's, or of who acts.

    In "a van drives at 80 km/h, a bus in the right lane at 60 km/h" the bus does as the van, but
    at a speed of its own.
    """
    nouns = [(m.mods, m.entities) for m in figure.text.mentions]
    own = {e for mods, who in nouns for m in mods if _is_speed(m) and m.i > figure.i for e in who}
    verbs = [(s.event.mods, [e for e in s.actors if e not in own]) for s in figure.text.scenes]
    return [
        (entity, term.data["quantity"])
        for mods, who in (*nouns, *verbs)
        for term in mods
        if (term.i, term.j) == (figure.i, figure.j) and "quantity" in term.data
        for entity in who
    ]


def _has_another(figure: Figure, who: Mention) -> bool:
    """Whether a speed is told of somebody elsewhere ("… in front of us at 30; we do 70")."""
    nouns = [(m.mods, m.entities) for m in figure.text.mentions]
    verbs = [(s.event.mods, s.actors) for s in figure.text.scenes]
    told = ((m, of) for mods, of in (*nouns, *verbs) for m in mods if _is_speed(m))
    return any(e in of for m, of in told if m.i != figure.i for e in who.entities)


def _is_speed(term: Term) -> bool:
    return (term.cat, term.value) == ("quantity", "speed")
