"""Nouns and verbs joined by "and", "or" or commas: what they share, and what is shared out."""

from dataclasses import replace
from itertools import dropwhile, groupby, pairwise

from scegen.understanding.chunks import Event, Mention, Place, Prep
from scegen.understanding.clauses.dependents import alternative, chain
from scegen.understanding.clauses.located import is_it
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import sentence_end
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.words.terms import NOTHING, Term

_SHAPES = {"base": "inf", "ing": "ing"}
"""What a verb is without an auxiliary, by its form; any other is finite."""


def auxiliary(state: State) -> bool:
    """Whether an auxiliary stands before the verb."""
    return any(word.startswith("aux:") for word in state.between)


def _shape(event: Event) -> str:
    if event.link == "inf" or (event.modal and event.form == "base"):
        return "inf"
    return "finite" if event.finite and not (event.form == "ing" and event.embedded) else event.form


def told_beside(state: State, *words: str) -> Mention | None:
    """``steps out with the ego 20 m away, doing 30 km/h``, ``hit by a van, travelling …``."""
    since = state.events[-1].i if state.events else 0
    named = (m for m in state.mentions if m.i > since)
    return next((m for m in named if m.stands_after(*words)), None)


_NEAR = 6
_ONES = frozenset({"brake", "hard_brake", "swerve", "lane_change", "overtake"})
"""What one does who comes up to others."""


def coordinate(event: Event, state: State) -> None:
    """``brakes and turns``, ``to brake and turn``: the verb of like form gives the subject."""
    helped = auxiliary(state)
    wanted = "finite" if helped or _in_the_past(event, state) else _SHAPES.get(event.form, "finite")
    helper = state.at(-1)  # "is standing" is said of no "I"
    third = event.form == "s" or (isinstance(helper, Term) and "third" in helper.data)
    verbs = [e for e in state.events if not e.nominal and _agree(event, e.subject, third=third)]
    main = [e for e in verbs if not any(m in state.trailing for m in e.subject)]
    if "," in state.between and main:
        verbs = main  # "A van turns as the ego waits, then stops."
    verbs = [e for e in verbs if e.subject] or verbs
    last = verbs[-1] if verbs else None
    if last is not None and last.supplement and last.finite and "," not in state.between:
        event.subject, event.supplement = last.subject, True
        return  # "ahead of the ego, which is doing 70 km/h and stops"
    outer = [e for e in verbs if not e.embedded]
    like = bool(verbs) and (verbs[-1].form == event.form or (verbs[-1].finite and helped))
    relative = like and verbs[-1].embedded
    # "A car passes the ego, which drives on, and changes lanes", "… a jam that crawls and brakes".
    if relative and ("," in state.between or no_jam(event, verbs[-1].subject, state)):
        verbs = outer or verbs
    alike = [e for e in verbs if _shape(e) == wanted]
    done = "aux:do" in state.between  # "you are driving and a van pulls out and does not stop"
    told = [e for e in alike if wanted == "finite" and (done or _as_finite(e, event))]
    exact = [e for e in told if not e.perfect]
    parallel = next(reversed(exact or alike), None)
    if parallel is None:  # "we approach a bus, which is standing, and pass it"
        finite = [e for e in verbs if e.finite]
        parallel = next(reversed([e for e in finite if e.form == event.form] or finite), None)
    who = state.waiting
    if who is not None and (parallel is None or (parallel.i < who.i and event.finite and helped)):
        event.subject = chain(who)  # "… while the ego has green and goes straight"
        return
    goes_on = wanted == "ing" or (wanted == "finite" and not state.dependent)
    # "the ego goes straight, a van oncoming and turning left"
    coming = wanted == "ing" and who is not None and bool(who.dirs) and who in state.mentions[-1:]
    if goes_on and who is not None and (who is state.being or coming):
        event.subject = chain(who)  # "pulls out when the ego is 20 m away and doing 30 km/h"
        return
    beside = told_beside(state, "with") if wanted == "ing" else None
    if beside is not None:
        event.subject = [beside]
        return
    parallel = parallel or state.events[-1]
    if parallel.parent is not None and _goes_on_itself(event, parallel, state):
        parallel = parallel.parent
    event.subject = parallel.subject
    if wanted != "finite":
        event.parent, event.link = parallel.parent, parallel.link
        event.modal = event.modal or parallel.modal
    alternative(event, parallel, state)


def _goes_on_itself(event: Event, let: Event, state: State) -> bool:
    """``we let a van pass and then turn left``: the one who lets it turns; not "force it to …"."""
    own = let.parent is not None and (let.parent.form, let.parent.control) == (event.form, "object")
    since = state.chunks.index(let)
    then = any(isinstance(c, Term) and "next" in c.data for c in state.chunks[since : state.k])
    return own and then and state.chunks[since - 1].value != "to"


def _in_the_past(event: Event, state: State) -> bool:
    """``failed to stop and hit the van``: a past tense that looks like an infinitive."""
    told = next((e for e in reversed(state.events) if e.finite and not e.link), None)
    hits = event.form == "base" and event.name == "collide"
    return hits and told is not None and told.form == "ed" and not told.modal


def no_jam(event: Event, subject: list[Mention], state: State) -> bool:
    """``comes up to a jam that crawls and brakes late``: what one does, and no jam.

    In "drives behind a van that does 40 km/h and overtakes it" it is the van that is overtaken.
    """
    passed = event.name in {"overtake", "pass"} and is_it(state.at(1))
    return passed or (event.name in _ONES and bool(subject) and subject[-1].is_mass)


def _as_finite(first: Event, second: Event) -> bool:
    """``does not slow and swings out``: "do", or "is", has the ending of the second verb."""
    return first.form == second.form or (first.form in {"base", "ing"} and not first.modal)


def _agree(verb: Event, subject: list[Mention], *, third: bool) -> bool:
    """``must wait until two trucks have passed and then turns``: no plural turns."""
    plural = len(subject) > 1 or any(m.head is not None and m.head.form == "s" for m in subject)
    if third and any("speaks" in h.data or m.is_me for m in subject for h in m.heads):
        return False  # "fails to see that we stop and rams our rear"
    return verb.form != "s" or not plural or any(m.is_named for m in subject)


def joins(mention: Mention, state: State) -> bool:
    """``a car and a truck``: the second takes the role of the first."""
    anchor = state.anchor
    _doing_the_same(mention, state)
    listed = "and" in state.between or "or" in state.between or state.between == {","}
    if not (isinstance(anchor, Mention) and listed) or state.between & {"sub", "copy"}:
        return False
    gone = any(m.value in WAYS and m.i >= anchor.j for m in anchor.mods)  # "me straight, and he …"
    waiting = anchor is state.waiting and not (gone and "," in state.between)
    waiting = waiting and not any(anchor in event.subject for event in state.events)
    since = [c for c in state.chunks[: state.k] if c.i >= anchor.j]
    measured = any(m.cat == "quantity" and m.i >= anchor.j for m in anchor.mods)
    later = any(c.cat == "conj" and "next" in c.data for c in since if isinstance(c, Term))
    verb = next((c for c in state.after(len(state.chunks)) if isinstance(c, Event)), None)
    later = later and (verb is None or verb.form != "base")  # "… then a bus come towards us"
    other = later or (mention.pronoun is None and state.mentions[0] is not anchor)
    if measured and "," in state.between and other:
        return False  # "ego 60 km/h, then the van ahead brakes"
    if mention.pronoun in {"count", "one", "another"} and "," in state.between:
        return False  # "four vans, two turning left": some of them, not further ones
    said = bool({"aux:be", "aux:have"} & state.between) or state.being is not None
    begin = (state.waiting or anchor).j
    begun = [c for c in state.chunks[: state.k] if c.i >= begin]
    said = said or any((c.cat, c.value) == ("aux", "be") for c in begun)
    told = state.verb_follows or _is_said_to_be(state) or _somewhere_else(anchor, state)
    complete = said and told  # "I'm here and a van …", "and a van is behind it"
    row = anchor.stands_after("of") and "," in state.between  # "the speeds of …"
    row = row and not state.events
    if complete or (state.between == {","} and not ((waiting or row) and _list_goes_on(state))):
        return False
    let = _let(anchor, state)
    anew = is_it(anchor) and isinstance(state.at(1), Event)  # "blocks it and three cars waiting"
    anew = anew or (state.verb_follows and not let)
    if not (waiting or row) and (anew or "," in state.between):
        return False
    if _in_parallel(anchor, state):
        return False
    mention.joined = anchor
    mention.pps += [p for p in anchor.pps if p.fronted]
    if waiting:
        state.candidate = mention
    for event in state.events:
        if event.object is anchor:
            event.object = mention
        met = (p for p in event.pps if p.target is anchor and p.value != "between")
        event.pps += [replace(p, target=mention) for p in met]  # "is followed by a van and a bus"
    state.stand_at(mention)
    return True


def _is_said_to_be(state: State) -> bool:
    """``and a van at 40 km/h is behind it``: a copula of its own comes behind the noun."""
    rest = dropwhile(lambda c: c.cat not in {"aux", "punct", "conj", "sub"}, state.after(_NEAR + 1))
    return next(rest, NOTHING).value == "be"


def _somewhere_else(anchor: Mention, state: State) -> bool:
    """``a van is ahead of it and a bus on its left``: the copula is left out."""
    rest = pairwise(state.after(_NEAR))
    fast = (w for w in rest if "quantity" not in (w[0].cat, w[1].cat) or w[0].cat == "locus")
    where, place = next(fast, (NOTHING, NOTHING))
    there = where.cat == "locus" or (where.value in {"in", "to"} and isinstance(place, Place))
    following = state.at(1)  # "and a bus driving at 40 on its left"
    there = there or (isinstance(following, Event) and following.form == "ing")
    known = anchor.is_ego or anchor.is_me or anchor.pronoun is not None
    return there and (known or anchor is state.waiting)


def _list_goes_on(state: State) -> bool:
    """``a car, a van and a bus``: a comma alone does not make a list."""
    rest = state.chunks[state.k + 1 : sentence_end(state.chunks, state.k + 1)]
    joints = (c for c in rest if isinstance(c, Event) or c.value in {"and", "or"})
    joint = next(joints, NOTHING)
    return joint is not NOTHING and not isinstance(joint, Event)


def _doing_the_same(mention: Mention, state: State) -> None:
    """``waits for a van coming from the left and a bus coming from the right``: for both."""
    last, following = state.last, state.at(1)
    if last is None or last.form != "ing" or last.finite or "and" not in state.between:
        return
    alike = isinstance(following, Event) and following.form == "ing"
    if alike and last.subject and mention.heads:
        mention.prep = last.subject[-1].prep


def _let(anchor: Mention, state: State) -> bool:
    """``lets two people and a cyclist cross``: both are let."""
    last = state.last
    if last is None or last.control != "object" or last.object is not anchor:
        return False
    verb = next((c for c in state.after(3) if isinstance(c, Event)), None)
    return verb is not None and verb.form == "base"


def _in_parallel(anchor: Mention, state: State) -> bool:
    """``a bus approaches the ego from the left and a taxi from the right``: the taxi does, too."""
    known = anchor.is_ego or anchor.pronoun is not None  # others are described by where they are
    if not known or state.last is None or state.last.object is not anchor:
        return False
    before, place, after = (state.at(n) for n in (-3, -2, 1))
    prep = before.cat == "prep" and after.value == before.value
    return prep and isinstance(place, Place)


def share_out(events: list[Event], terms: list[Term]) -> list[Event]:
    """The events with statements about several participants taken apart.

    Nobody drives north and east at once: as many ways as participants are one for each, in
    order, whether "respectively" is said or not. With it, the same holds for verbs ("stop and
    turn left, respectively").
    """
    found = [own for event in events for own in _apart(event)]
    for mark in (t.i for t in terms if t.value == "respectively"):
        _verbs(found, mark)
    return found


def _members(event: Event) -> list[Mention]:
    """One mention for each participant that acts."""
    return [replace(m, entities=[e]) for m in event.subject for e in m.entities]


def _apart(event: Event) -> list[Event]:
    count = len(event.doers)
    if count < 2 or event.alternative is not None:
        return [event]
    shares = [ways for cat in ("compass", "dir") if (ways := _ways(event, cat, count))]
    sides = _sides(event, count)
    if not (shares or sides):
        return [event]
    gone = {m.i for share in shares for m in share}
    mods = [m for m in event.mods if m.i not in gone]
    pps = [p for p in event.pps if p not in sides]
    return [
        replace(
            event,
            subject=[who],
            mods=[*mods, *(share[k] for share in shares)],
            pps=[*pps, *sides[k : k + 1]],
        )
        for k, who in enumerate(_members(event))
    ]


def _ways(event: Event, cat: str, count: int) -> list[Term]:
    """Headings or turns, if there are as many different ones as participants."""
    ways = [m for m in event.mods if m.cat == cat and (cat != "dir" or m.value in WAYS)]
    return ways if len(ways) == count and len({w.value for w in ways}) > 1 else []


def _sides(event: Event, count: int) -> list[Prep]:
    """``approach from the north and from the east``, ``in the left and in the right lane``."""
    for word, group in groupby(event.pps, key=lambda p: p.value):
        sides = [p for p in group if p.place is not None]
        alike = word in {"from", "to"} or all(p.names("lane") for p in sides)
        if alike and len(sides) == count:
            return sides
    return []


def _verbs(events: list[Event], mark: int) -> None:
    """As many verbs as participants before the word: one for each."""
    before = [e for e in events if e.i < mark and e.subject and not e.nominal and e.control is None]
    if not before:
        return
    last = before[-1]
    alike = [e for e in before if e.sentence == last.sentence and e.doers == last.doers]
    members = _members(last)
    if len(alike) == len(members) > 1:
        for event, who in zip(alike, members, strict=True):
            event.subject = [who]
