"""Verbs that make no clause of their own: nouns of events, infinitives, gerunds."""

from scegen.understanding.chunks import Event, Mention, NounPhrase
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.doings_named import DONE_TO

_OPENING = frozenset({"against", "in", "with", "of"})
_ABOUT_OTHERS = frozenset({"cause", "prevent", "block", "hide", "encounter", "overlook"})
"""Verbs whose object is what others do ("blocks the merge")."""


def chain(mention: Mention) -> list[Mention]:
    """A mention with those that it is joined to ("a car and a truck"), in order."""
    found = [mention]
    while found[-1].joined is not None and len(found) < 64:
        found.append(found[-1].joined)
    return found[::-1]


def depend(event: Event, parent: Event, link_kind: str) -> None:
    """Hangs a verb on another."""
    event.parent = parent
    event.link = link_kind
    parent.children.append(event)
    event.modal = event.modal or parent.modal or parent.name in {"cause", "prevent"}


def whose_bare(event: Event, state: State) -> Event | None:
    """``lets a van, which is late, go``, ``saw the car ahead of me swerve``: on what it hangs."""
    taking = [e for e in state.events if e.control == "object" or e.name == "encounter"]
    verb = next((e for e in reversed(taking) if isinstance(e.object, Mention)), None)
    bare = event.form == "base" and state.between <= {","} and state.waiting is None
    if verb is None or not bare or state.anchor is verb.object:
        return None
    return None if any(child.form == "base" for child in verb.children) else verb


def let_do(state: State) -> Mention | None:
    """``lets a cyclist, riding at 20 km/h, go by``: who is let do something."""
    whom = state.last.object if state.last is not None and state.last.control == "object" else None
    return whom if isinstance(whom, Mention) and whom is state.anchor else None


def on_foot(event: Event, state: State) -> Mention | None:
    """``a child …, running``: who is on foot."""
    walkers = (m for m in reversed(state.mentions) if m.noun == "pedestrian")
    return next(walkers, None) if event.name == "walk" else None


_LEADS_TO_A_SPEED = {"encounter": 3, "approach": 1}
_PACED = frozenset({"move", "light", "crawl", "walk", "use"})


def met_with(event: Event, state: State) -> Mention | None:
    """``sees a van ahead, doing 30 km/h``, ``comes up behind a van, doing 30 km/h``: who is met."""
    last = state.last
    reach = _LEADS_TO_A_SPEED.get(last.name, 0) if last and event.name in _PACED else 0
    paced = any(c.value == "speed" or "same" in getattr(c, "dirs", ()) for c in state.after(reach))
    named = last.nouns("behind") if last and paced else []
    others = (n for n in named if isinstance(n, Mention) and n.heads and not n.is_ego)
    return next(others, None)


def _share_subject(event: Event, other: Event, state: State) -> None:
    """Who does the one does the other, also if they come later ("while making a turn, …")."""
    event.subject = other.subject
    if any(e is other for e in state.pending) and not event.subject:
        state.pending.append(event)


def alternative(event: Event, other: Event, state: State) -> None:
    """Marks two doings joined by "or"."""
    if "or" in state.between:
        other.alternative = other.alternative or id(other)
        event.alternative = other.alternative


def nominal(event: Event, state: State) -> None:
    """``makes a left turn``, ``before its left turn``: who does what a noun names."""
    anchor = state.anchor
    owner = next((m for m in reversed(state.mentions) if m.possessor and m.j >= event.i - 1), None)
    if owner is not None:
        event.subject = [owner]
    if isinstance(anchor, Event) and not (state.between - {"either", "or"}):
        depend(event, anchor, "noun")
        during = state.prep is not None and state.prep.value != "to"  # "can't see during its turn"
        of, who = state.at(1), state.at(2)
        named = of.value in {"of", "by"} and isinstance(who, Mention)
        if named and event.name not in DONE_TO and anchor.name not in {"light", "try"}:
            return  # "is faced with a sudden stop of the car ahead"
        if not event.subject and (during or anchor.name not in _ABOUT_OTHERS):
            _share_subject(event, anchor, state)
    elif "conj" in state.between and state.events:
        event.subject = event.subject or state.events[-1].subject
        alternative(event, state.events[-1], state)
    elif state.prep is not None and not event.subject and not _opens(state):
        _in_a_phrase(event, state)
    elif not event.subject and state.last is not None and state.at(-1).value == "before":
        done = state.last.subject  # "stops after a cut-in"; "the ego brakes after a cut-in"
        own = any(m.cat == "possessive" for m in event.mods)
        event.subject = [] if not own and any(m.is_ego for m in done) else done
    elif not event.subject and not state.events and ("sub" in state.between or _opens(state)):
        state.pending.append(event)  # "after a right turn, the car …"


def _opens(state: State) -> bool:
    """``during a left turn, the car …``: who does it comes after."""
    word = state.prep.value if state.prep is not None else ""
    return state.candidate is None and not state.mentions and word in _OPENING


def _in_a_phrase(event: Event, state: State) -> None:
    """``is in the middle of a left turn``, ``during its left turn``: whose it is."""
    who, last = state.waiting, state.last
    if who is not None and (last is None or last.j <= who.i):
        event.subject = chain(who)
    elif last is not None:
        made = last.object if last.control == "object" and state.awaits("to") else None
        # "brings it to a stop"
        event.subject = chain(made) if isinstance(made, Mention) else last.subject


def infinitive(event: Event, state: State, parent: Event | None = None) -> None:
    """``tries to merge``, ``forces the van to stop``, ``for the van to pass``."""
    anchor, who = state.anchor, state.waiting
    if parent is None:
        parent = anchor if isinstance(anchor, Event) else state.last
        parent = _forced(parent, state) or parent
    if who is not None and parent is not None and parent.j <= who.i and anchor is not parent:
        event.subject = chain(who)  # "a van passes and the ego has a second to brake"
        event.modal = "aux:have" in state.between
        return
    if parent is None:
        _first_said_of(anchor, event, state)  # "to get past the bus, the car …"
        return
    depend(event, parent, "inf")
    event.negated = parent.negated and parent.control == "subject"
    if isinstance(anchor, Mention) and anchor.stands_after("for"):
        event.subject = chain(anchor)
    elif parent.control == "object" and isinstance(parent.object, Mention):
        event.subject = chain(parent.object)
        event.modal = True
        event.name = "inert" if parent.name == "inert" else event.name  # "no time to brake"
    else:
        _share_subject(event, parent, state)


def _forced(last: Event | None, state: State) -> Event | None:
    """``is forced by a van merging from the right to brake``: not the van."""
    agents = last.subject if last is not None and last.form == "ing" and not last.finite else []
    for verb in state.events if agents else []:
        by = [p.who for p in verb.pps if p.value == "by"]
        if verb.control == "object" and not verb.object and by[-1:] == agents[-1:]:
            return verb
    return None


def _first_said_of(phrase: Mention | NounPhrase | Event | None, event: Event, state: State) -> None:
    """The subject of a verb before any other one: the noun before it, or one that comes later."""
    if isinstance(phrase, Mention):
        event.subject = chain(phrase)
    elif isinstance(phrase, NounPhrase) and phrase.owner is not None:
        event.subject = [phrase.owner]  # "the ego's attempt to get past"
    else:
        state.pending.append(event)


def gerund(event: Event, state: State) -> None:
    """``blocking the car from returning``, ``without yielding``, ``by turning``."""
    prep = state.prep.value if state.prep else ""
    parent, who = state.last, state.waiting
    event.negated = prep in {"without", "instead"}
    if prep == "instead" and event.name not in {"yield", "stop"}:
        event.name = "inert"  # "speeds up instead of slowing down": only what is owed counts
    if parent is None:
        _first_said_of(state.anchor, event, state)
        return
    if who is not None and parent.j <= who.i and state.anchor is not parent and prep in _OPENING:
        event.subject = chain(who)  # "a man crosses while the ego is in the middle of turning"
        return
    if parent.supplement and "," in state.between:  # "passes a van, which waits, without braking"
        parent = next((e for e in reversed(state.events) if not e.embedded), parent)
    depend(event, parent, "ing")
    if prep == "from" and isinstance(parent.object, Mention):
        event.subject = chain(parent.object)
        event.negated = True
    else:
        event.subject = parent.subject
