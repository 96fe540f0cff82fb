"""When acts happen without a number: "then", "as soon as", and what one does in turn."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.amounts.timing import endless, since_green, told_in
from scegen.understanding.entity import Basis
from scegen.understanding.happenings import STILL, Amount, Doing, Since, Trigger
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import ends_a_quantity, quantity_at
from scegen.understanding.words.terms import Term

_PARTS = frozenset({",", "and", "but", "while", ";"})
_SOON_SAID = 6
"""So many words after an act may still say that it comes at once."""


def order(text: Telling) -> None:
    """Says what sets acts off that no number delays."""
    acts = text.found.acts
    _clauses(text)
    for doing in acts:
        since_green(doing, text)
    for doing in acts:  # "both brake when they are 80 m apart"
        alike = [a for a in acts if a.i == doing.i and a.kind is doing.kind and a.when]
        doing.when = doing.when or (alike[0].when if alike else None)
    acts = sorted(acts, key=lambda a: _moment(a, text))
    for n, (doing, before) in enumerate(zip(acts[1:], acts, strict=False), start=1):
        awaited = before.when is not None and before.when.act is doing
        if doing.when is not None or awaited:
            continue
        together = doing.i == before.i  # "both return"
        phrase = _then(before, doing, text) if not together else None
        basis = Basis(*phrase) if phrase is not None else doing.basis
        own = before.entity is doing.entity
        mine = [a for a in acts[:n] if a.entity is doing.entity and a.i != doing.i]
        told = before.always or bool(before.amounts) or doing.always
        if phrase is not None and (told or not own):
            doing.when = Trigger("after", basis, _at_once(before, doing, text), before)
        elif doing.forced and before.always and not own and not together:
            basis = basis.because("what one has to do answers what the other does")
            doing.when = Trigger("after", basis, act=before, since="begin")
        elif mine and mine[-1].always and doing.always:
            reason = "what one does in turn happens in the order of the text"
            at_once = _at_once(mine[-1], doing, text)
            basis = at_once.basis if at_once is not None else basis.because(reason)
            doing.when = Trigger("after", basis, at_once, mine[-1])


def _moment(doing: Doing, text: Telling) -> float:
    """``before it brakes, it swerves``: the first clause comes last; ``before that it brakes``."""
    start, stop = text.bounds(doing.i)
    told = [a.i for a in text.found.acts if a.i < doing.i]
    since = max([start, *told[-1:]])
    if told and text.find("earlier", since, doing.i + 1) is not None:
        return told[-1] - 0.5
    opens = next((c for c in text.chunks if c.i == start), None)
    if not isinstance(opens, Term) or text.tokens[start].low != "before":
        return doing.i
    return stop if doing.i < _end(opens, start, stop, text) else doing.i


def _then(before: Doing, doing: Doing, text: Telling) -> tuple[int, int] | None:
    start = max(before.basis.j or before.i, text.bounds(doing.i)[0])
    span = text.find("then", start, doing.i)
    return span if span is not None and text.tokens[span[0]].low != "before" else None


def _at_once(before: Doing, doing: Doing, text: Telling) -> Amount | None:
    """``immediately brakes``, ``brakes at once``: no time between; a place is no moment."""
    tokens = text.tokens
    start, stop = text.bounds(doing.i)
    start = max(before.basis.j or before.i + 1, start)
    parts = (k for k in range(doing.i + 1, stop) if tokens[k].low in _PARTS)
    stop = min(next(parts, stop), doing.i + _SOON_SAID)
    span = text.find("at_once", start, stop)
    if span is None or tokens[span[1]].low in word_list("no_moment"):
        return None
    return Amount(STILL, Basis(*span))


def _end(opens: Term, start: int, stop: int, text: Telling) -> int:
    """At the comma, or where the sentence goes on without one: "once it stands the ego …"."""
    comma = next((k for k in range(opens.j, stop) if text.tokens[k].low == ","), None)
    if comma is not None or text.within(start, opens.i):
        return stop if comma is None else comma
    told = [i for i, _ in told_in(text, opens.j, stop)]
    return told[1] if len(told) > 1 else stop


def _clauses(text: Telling) -> None:
    """``as soon as the lead brakes, the ego changes lanes``."""
    for chunk in text.subs:
        opening = text.low(chunk.i, chunk.j).strip()
        because = opening in {"because", "since"}
        if not because and (opening not in word_list("triggers") or opening in {"if", "until"}):
            continue
        start, stop = text.bounds(chunk.i)
        if chunk.j >= stop or quantity_at(text.tokens, chunk.j) is not None:
            continue  # "after 2 s"
        end = _end(chunk, start, stop, text)
        inside = [a for a in text.found.acts if any(chunk.j <= i < end for i in a.places)]
        outside = [(i, a) for i, a in told_in(text, start, stop) if a not in inside]
        main = _main(chunk, start, end, outside, text)
        if not inside or main is None or main.when is not None:
            continue
        if opening == "when" and not main.always:
            continue  # "passes a bus when a child runs out": what goes on meanwhile
        first = inside[0]
        over = any(c.event.perfect for c in text.within(chunk.j, end))
        over = over or any(r.i in first.told for r in first.entity.rests)  # "when it has stopped"
        begun = (because or opening in word_list("while_begun")) and not over
        steps = first.kind is ActKind.CROSS and endless(first, text)
        since: Since = "begin" if steps or begun else "end"
        basis = Basis(chunk.i, chunk.j)
        soon = text.find("at_once", max(chunk.i - 1, start), chunk.j)  # "right after"
        at_once = Amount(STILL, Basis(*soon)) if soon else None
        main.when = Trigger("after", basis, at_once, first, since)


def _main(
    chunk: Term, start: int, end: int, outside: list[tuple[int, Doing]], text: Telling
) -> Doing | None:
    """What a clause sets off: the act before it, else the one that follows."""
    opens = chunk.i - (2 if ends_a_quantity(text.tokens, chunk.i) else 0)
    joined = text.low(max(start, opens - 2), opens).replace(",", " ").split()
    put_between = joined[-1:] in (["and"], ["but"])  # "brakes and, once it stands, turns"
    front = [a for i, a in outside if i < chunk.i and not put_between]
    return next(iter([*front[-1:], *(a for i, a in outside if i >= end)]), None)
