"""Verbs joined by "and" or "or": whose subject the second one shares."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention
from scegen.understanding.clauses.dependents import alternative, chain
from scegen.understanding.clauses.located import is_it
from scegen.understanding.clauses.state import State

_ONES = frozenset({"brake", "hard_brake", "swerve", "lane_change", "overtake"})
"""What one does who comes up to others."""
_SHAPES = {"base": "inf", "ing": "ing"}
"""What a verb is without an auxiliary, by its form; any other is finite."""


def auxiliary(state: State) -> bool:
    """Whether an auxiliary stands before the verb."""
    return any(word.startswith("aux:") for word in state.between)


def _shape(event: Event) -> str:
    if event.link == "inf" or (event.modal and event.form == "base"):
        return "inf"
    return "finite" if event.finite and event.form != "ing" else event.form


def told_beside(state: State, *words: str) -> Mention | None:
    """``steps out with the ego 20 m away, doing 30 km/h``, ``hit by a van, travelling …``."""
    since = state.events[-1].i if state.events else 0
    named = (m for m in state.mentions if m.i > since)
    return next((m for m in named if m.stands_after(*words)), None)


def coordinate(event: Event, state: State) -> None:
    """``brakes and turns``, ``to brake and turn``: the verb of like form gives the subject."""
    helped = auxiliary(state)
    wanted = "finite" if helped or _in_the_past(event, state) else _SHAPES.get(event.form, "finite")
    verbs = [e for e in state.events if not e.nominal and _agree(event, e.subject)]
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
    exact = [e for e in alike if wanted == "finite" and _as_finite(e, event) and not e.perfect]
    parallel = next(reversed(exact or alike), None)
    if parallel is None:  # "we approach a bus, which is standing, and pass it"
        finite = [e for e in verbs if e.finite]
        parallel = next(reversed([e for e in finite if e.form == event.form] or finite), None)
    who = state.waiting
    if who is not None and (parallel is None or (parallel.i < who.i and event.finite and helped)):
        event.subject = chain(who)  # "… while the ego has green and goes straight"
        return
    goes_on = wanted == "ing" or (wanted == "finite" and not state.dependent)
    if goes_on and who is not None and who is state.being:
        event.subject = chain(who)  # "pulls out when the ego is 20 m away and doing 30 km/h"
        return
    beside = told_beside(state, "with") if wanted == "ing" else None
    if beside is not None:
        event.subject = [beside]
        return
    parallel = parallel or state.events[-1]
    event.subject = parallel.subject
    if wanted != "finite":
        event.parent, event.link = parallel.parent, parallel.link
        event.modal = event.modal or parallel.modal
    alternative(event, parallel, state)


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
    """``does not slow and swings out``: "do" bears the ending that the second verb bears."""
    return first.form == second.form or (first.form == "base" and not first.modal)


def _agree(verb: Event, subject: list[Mention]) -> bool:
    """``must wait until two trucks have passed and then turns``: no plural turns."""
    plural = len(subject) > 1 or any(m.head is not None and m.head.form == "s" for m in subject)
    if verb.form == "s" and any(m.is_me for m in subject):
        return False  # "fails to see that we stop and rams our rear"
    return verb.form != "s" or not plural or any(m.is_named for m in subject)
