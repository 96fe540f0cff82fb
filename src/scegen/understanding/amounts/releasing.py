"""What sets acts off: how far somebody is, "then", "as soon as", what one does in turn."""

from scegen.scenario.acts import SLOWING, ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.figures import Figure, has_a_size
from scegen.understanding.amounts.items import item_of, kind_of
from scegen.understanding.amounts.pairs import before_they_meet, tell_order, two_between
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.amounts.timing import act_of, endless, since_green, told_in
from scegen.understanding.chunks import Mention, Place, Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Amount, Apart, Doing, Since, Trigger, name_them
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import ends_a_quantity, quantity_at
from scegen.understanding.words.terms import Term

JUNCTION = frozenset({"junction", "signal", "stop_line", "stop_sign", "yield_sign"})
_LINES = JUNCTION | {"crosswalk"}


def sets_off(figure: Figure) -> bool:
    """``when the gap is 20 m``, ``50 m before the junction``: what sets an act off."""
    noun, word, clause = figure.noun, figure.led_by, figure.clause
    opened = clause is not None and clause[2] in word_list("triggers")
    if clause is not None and clause[2] == "as" and not isinstance(noun, Place):  # "as it nears it"
        opened = figure.verb is not None and figure.verb.lemma in word_list("nearing")
    short = word in word_list("short_before")
    told = short or word == "to"
    line = noun if isinstance(noun, Place) and noun.kind in _LINES and told else None
    thing = _thing(figure) if short and figure.measure is Measure.GAP_M else None
    when = clause if opened else None
    if thing is not None:
        return _before_a_thing(figure, thing, when)
    before = isinstance(noun, Mention) and not noun.stands_after("ahead")
    before = before and word in {"before", "short"}
    if not (opened or line is not None or before):
        return False
    doing = _main(figure, when) or (_starts_crossing(figure) if opened else None)
    if doing is None or (before and not opened and doing.ends_at_rest) or doing.when is not None:
        return False
    # whose distance sets it off: who is named in that clause, else who acts
    subject = next(iter(figure.last_named(when[0]) if when else []), doing.entity)
    acts = figure.text.acts(*when[:2]) if when is not None else []
    if any(a.entity is subject and (a.i < figure.i or a is not doing) for a in acts):
        return False  # "when the truck moves over 30 m in front of it", "when one 20 m ahead stops"
    if line is None or not (line.kind in JUNCTION or figure.text.context.junction.crossing):
        return _comes_down(figure, doing, subject, line)
    subject = subject if opened else figure.said_of or subject
    moved = subject if subject is not doing.entity else None
    rests = figure.does in {"wait", "stop", "park"} and moved in figure.actors
    if moved is not None and (moved.still or rests):
        return False  # "where a van waits 5 m before the line": so far it stays
    doing.when = figure.trigger("junction", entity=moved)
    return True


def _comes_down(figure: Figure, doing: Doing, subject: Entity, line: Place | None) -> bool:
    """Between whom a measure comes down to a value that sets something off."""
    text, noun = figure.text, figure.noun
    own = noun is not None and noun.has("possessive")
    named = [e for e in (text.named(noun) if not own else []) if e is not subject]
    if line is not None:  # who crosses there: how far that is off is how far they are
        crossing = [e for e in text.draft.entities if Maneuver.CROSS in e.maneuvers]
        named = [e for e in crossing if e is not subject]
        if len(named) != 1:
            return False  # from there, and from nobody
    other = named[0] if named else doing.entity if subject is not doing.entity else doing.into
    near = [e for e in text.spoken_of(0, figure.i) if e is not subject]
    other = other or text.counterpart(subject, near)
    for meeting in [m for m in (before_they_meet(figure), *two_between(figure)) if m]:
        subject, other = meeting[0], next(iter(meeting[1:]), None)
    if other is None or other is subject:
        return False
    tell_order(figure, figure.measure, subject, other)
    if figure.measure is not Measure.GAP_M:
        subject, other = text.in_file(subject, other)
    doing.when = figure.trigger("measure", measure=figure.measure, entity=subject, reference=other)
    return True


def _thing(figure: Figure) -> Thing | None:
    """The thing that a phrase of place names, or that "it" stands for."""
    noun = figure.noun
    if isinstance(noun, Mention) and noun.pronoun is not None:
        told = (c for c in figure.text.chunks if isinstance(c, Thing | Mention) and c.i < figure.i)
        others = [c for c in told if isinstance(c, Thing) or not (c.pronoun or c.is_ego)]
        noun = others[-1] if others else None
    return noun if isinstance(noun, Thing) and has_a_size(noun) else None


def _before_a_thing(figure: Figure, thing: Thing, clause: tuple[int, int, str] | None) -> bool:
    """``35 m before the crate it brakes``: the gap to what lies there sets it off."""
    text, doing = figure.text, _main(figure, clause)
    if doing is None:
        return False
    items = text.found.items
    item = next((x for x in items if x.kind.value == kind_of(thing)), None)
    if item is None:
        item = item_of(thing, text)
        item.blocks, item.blocked = True, None if doing.entity.ego else doing.entity
        items.append(item)
        name_them(items)
    who = doing.entity
    if clause is None and doing.ends_at_rest:  # "stops 2 m short of the crate"
        text.found.spacings += [Apart(figure.measure, item, who, figure.placed, doing, since="end")]
    else:
        doing.when = figure.trigger("measure", measure=figure.measure, entity=who, reference=item)
    return True


def driven(figure: Figure) -> bool:
    """``after 250 m``, ``the ego has driven 600 m when the van slows``: what sets it off."""
    later = (a for a in figure.text.found.acts if a.i > figure.i and a.when is None)
    moves = figure.does == "move" and figure.clause is None  # "drives 200 m and then brakes"
    doing = (None if moves else act_of(figure)) or next(later, None)
    if doing is None or doing.when is not None:
        return False
    who = next((e for e in figure.actors if e.is_vehicle), doing.entity)
    moved = who if who is not doing.entity else None
    doing.when = figure.trigger("driven", entity=moved)
    return True


def _starts_crossing(figure: Figure) -> Doing | None:
    """``followed by a child when the ego is 18 m away``: when it crosses."""
    for mention in (m for m in figure.text.mentions if figure.start <= m.i < figure.i):
        for who in (e for e in mention.entities if Maneuver.CROSS in e.maneuvers):
            basis = who.maneuver_basis or Basis(mention.i, mention.j)
            return figure.text.add(Doing(ActKind.CROSS, who, basis, mention.i, always=False))
    return None


def _main(figure: Figure, clause: tuple[int, int, str] | None) -> Doing | None:
    """The act that a clause sets off: before it, or after it where it opens the sentence."""
    here = figure.text.acts(figure.start, figure.end)
    if clause is None:
        before = [a for a in here if a.i < figure.i]
        return next(iter((*before[-1:], *here)), None)
    begin, stop, _ = clause
    before = [a for a in here if a.i < begin]
    after = [a for a in here if a.i >= stop]
    between = _is_put_between(figure.text, figure.start, begin)
    if not after and (between or not before):
        after = [a for a in here if a.i > figure.i]  # no comma: "when it is 20 m away it brakes"
    front = [] if between and after else before[-1:]
    return next(iter((*front, *after)), None)


def _is_put_between(text: Telling, start: int, opens: int) -> bool:
    """``brakes and, once it stands, turns``: the clause belongs to what comes after it."""
    joined = text.low(max(start, opens - 2), opens).replace(",", " ").split()
    return joined[-1:] in (["and"], ["but"])


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
    text.found.acts = acts = sorted(acts, key=lambda a: _moment(a, text))
    for n, (doing, before) in enumerate(zip(acts[1:], acts, strict=False), start=1):
        if doing.when is not None:
            continue
        together = doing.i == before.i  # "both return"
        awaits = {id(a) for a in acts[:n] if a.when is not None and a.when.act is doing}
        phrase = _then(before, doing, text) if not (together or id(before) in awaits) else None
        basis = Basis(*phrase) if phrase is not None else doing.basis
        own = before.entity is doing.entity
        sure = [a for a in acts[:n] if a.always and a.i != doing.i and id(a) not in awaits]
        mine = [a for a in sure if a.entity is doing.entity]
        if own and before.kind is ActKind.OVERTAKE and doing.kind in SLOWING:
            forms = {s.event.form for s in text.within(before.i, doing.i)}
            mine += [before] if forms - {"ing"} else []  # not "a taxi overtaking us brakes"
        told = before.always or bool(before.amounts) or doing.always
        if phrase is not None and (told or not own):
            # "brakes before the ego turns", "starts to overtake, then": not that it is over by then
            starts = any(f" {w} " in text.low(before.i - 2, before.i) for w in word_list("begun"))
            starts = starts or text.low(*phrase) == " before " or endless(before, text)
            begun = not own and starts
            at_once = _at_once(before, doing, text)
            doing.when = Trigger("after", basis, at_once, before, "begin" if begun else "end")
        elif doing.forced and sure and sure[-1].entity is not doing.entity and not together:
            basis = basis.because("what one has to do answers what the other does")
            doing.when = Trigger("after", basis, act=sure[-1], since="begin")
        elif mine and doing.always:
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
    start = text.bounds(doing.i)[0]  # there "before it brakes, the ego swerves" begins
    start = start if before.i > doing.i else max(before.basis.j or before.i, start)
    span = text.find("then", start, doing.i)
    if span is None or text.tokens[span[0]].low != "before":
        return span
    told = [scene.event for scene in text.within(doing.i, doing.i + 1)]
    goes_on = before.entity is doing.entity or any(e.finite and not e.embedded for e in told)
    return span if goes_on else None  # "halts before a man crossing there": a place, no order


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
        once = chunk.value == "once" or opening in {"because", "since"}
        start, stop = text.bounds(chunk.i)
        trigger = once or (opening in word_list("triggers") and opening != "until")
        if not trigger and (chunk.i > start or opening not in word_list("while_begun")):
            continue
        if chunk.j >= stop or quantity_at(text.tokens, chunk.j) is not None:
            continue  # "after 2 s"
        end = _end(chunk, start, stop, text)
        inside = [a for a in text.found.acts if any(chunk.j <= i < end for i in a.places)]
        outside = [(i, a) for i, a in told_in(text, start, stop) if a not in inside]
        main = _set_off(chunk, start, end, outside, text)
        if main is None or main.when is not None:
            continue
        if not inside:
            main.when = _level(chunk, end, main, text)
            continue
        if not main.always and (not trigger or (opening == "when" and chunk.i > start)):
            continue  # "passes a bus when a child runs out": what goes on meanwhile
        first = inside[0]
        over = any(c.event.perfect for c in text.within(chunk.j, end))
        over = over or any(r.i in first.told for r in first.entity.rests)  # "when it has stopped"
        begun = opening in word_list("while_begun") and not over
        steps = first.kind is ActKind.CROSS and endless(first, text)
        since: Since = "begin" if steps or begun else "end"
        soon = text.find("at_once", max(chunk.i - 1, start), chunk.j)  # "right after"
        at_once = Amount(STILL, Basis(*soon)) if soon else None
        main.when = Trigger("after", Basis(chunk.i, chunk.j), at_once, first, since)


def _level(chunk: Term, end: int, main: Doing, text: Telling) -> Trigger | None:
    """``as soon as the ego is alongside``: when nothing is left between them along the road."""
    told = [(s.event.i, s.event.pps) for s in text.scenes] + [(m.i, m.pps) for m in text.mentions]
    beside = (p for i, pps in told if chunk.j <= i < end for p in pps if p.word.cat == "locus")
    there = next((p for p in beside if p.word.value == Approach.ADJACENT), None)
    who = text.spoken_of(chunk.j, end)
    lanes = {c.j for c in text.chunks if isinstance(c, Place)}  # "in the lane next to it"
    if there is None or not who or isinstance(there.target, Place) or there.word.i in lanes:
        return None
    one, near = who[0], [main.entity, *text.spoken_of(0, chunk.i)]
    whom = there.target.entities if isinstance(there.target, Mention) else []
    named = (e for e in (*whom, *near) if e is not one)
    other = next(named, None) or text.counterpart(one, near)
    basis = Basis(chunk.i, there.word.j)
    gap, level = Measure.GAP_M, Amount(STILL, basis)
    found = Trigger("measure", basis, level, measure=gap, entity=one, reference=other)
    return found if other is not None else None


def _set_off(
    chunk: Term, start: int, end: int, outside: list[tuple[int, Doing]], text: Telling
) -> Doing | None:
    """What a clause sets off: the act before it, else the one that follows."""
    opens = chunk.i - (2 if ends_a_quantity(text.tokens, chunk.i) else 0)
    between = _is_put_between(text, start, opens)
    front = [a for i, a in outside if i < chunk.i and not between]
    return next(iter([*front[-1:], *(a for i, a in outside if i >= end)]), None)
