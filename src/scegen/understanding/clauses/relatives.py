"""Relative clauses: whom "which" is, and those about their object ("that the ego follows")."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention
from scegen.understanding.clauses.state import State
from scegen.understanding.words.terms import Term

_ITS = frozenset({"it", "him", "they"})
_DONE_TO_SOMEBODY = frozenset({"follow", "overtake", "pass", "bypass", "tailgate", "encounter",
                               "approach", "avoid", "collide", "cut_off", "undertake", "hide",
                               "overlook"})  # fmt: skip
_REACH = 4


def antecedent(state: State) -> Mention:
    """The noun before "which": the last one that does not merely own something.

    In "the car ahead of us, which" and "there is a car ahead of the ego, which" it is the car.
    """
    nouns = [m for m in reversed(state.mentions) if not m.possessor] or state.mentions[-1:]
    other = _about_another(state)
    beside = [m for m in nouns if m.is_landmark and (told(m) or (other and m.is_ego))]
    return next((m for m in nouns if not (m in beside or m.aside)), nouns[0])


def _about_another(state: State) -> bool:
    """``a car ahead of the ego that …``, ``ahead of the ego, in its lane, which …``: of the car.

    "A car ahead of the ego, which …" is so where "there is" introduces the car.
    """
    begin = max(0, state.chunks.index(state.mentions[0]) - 1)
    k = next((k for k in range(state.k, 0, -1) if state.chunks[k].cat == "rel"), begin)
    if k <= begin:
        return False  # nothing stands before "which"
    comma, opened = state.chunks[k - 1].value == ",", [c.value for c in state.chunks[begin:k]]
    apart = not isinstance(state.chunks[k - 1 - comma], Mention)
    alone = not comma and state.waiting is not None and "be" not in opened
    return alone or apart or opened[0] == "thereis"


def told(mention: Mention) -> bool:
    """Whether one knows already who that is: "it", "them", "me"."""
    return mention.pronoun in _ITS or mention.is_me


def opens(mention: Mention, state: State) -> bool:
    """Whether a noun begins a clause that says what is done to the noun before it.

    The state keeps both nouns.
    """
    that = state.at(-1)
    marked = that.cat == "rel"
    between = -1 - marked
    between -= marked and state.at(between).value == ","
    placed = state.at(between)  # "the car ahead, which the ego follows"
    between -= marked and placed.cat == "locus"
    about = state.at(between)
    if not isinstance(about, Mention) or not about.heads or about.possessor:
        return False
    waits = about is state.waiting and not state.between
    known = mention.pronoun is not None or any("speaks" in h.data for h in mention.heads)
    if not (marked or waits or known) or not _acts(state):
        return False
    state.relative = (mention, about)
    return True


def _acts(state: State) -> bool:
    """Whether a verb follows that wants an object and does not get one."""
    for n, chunk in enumerate(state.after(_REACH), start=1):
        if isinstance(chunk, Event):
            free = not isinstance(state.at(n + 1), Mention)
            return chunk.name in _DONE_TO_SOMEBODY and free and not chunk.nominal
        if not isinstance(chunk, Term) or chunk.cat not in {"aux", "manner", "neg"}:
            return False
    return False


def close(event: Event, state: State) -> bool:
    """Gives the verb of such a clause its subject and object; the clause around it goes on.

    Returns:
        Whether there was such a clause.
    """
    if state.relative is None:
        return False
    actor, about = state.relative
    event.subject, event.object = [actor], about
    event.negated = any(word.startswith("neg:") for word in state.between)
    event.unable = event.negated and bool({"neg:unable", "aux:can"} & state.between)
    state.relative = None
    state.events.append(event)
    state.stand_at(about)
    return True


def closed(state: State) -> bool:
    """``drives ahead of the ego, which is as fast, and brakes``: who drives, not the ego."""
    return "conj" in state.between and state.at(-2).value == "," and bool(state.events)


def aside(event: Event, events: list[Event]) -> bool:
    """``the ego comes to a spot where a van stops, and it …``: not what the sentence is about."""
    return event.embedded and any(
        e.finite and e.subject and not e.embedded and e.sentence == event.sentence and e.i < event.i
        for e in events
    )
