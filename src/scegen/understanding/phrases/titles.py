"""Doings that a noun names, and nobody does: "Cut-in from the left, ego 100 km/h, a van …".

Whoever the text after the noun says does it, or can be the only one to, is its subject.
"""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.phrases.lookahead import ends, sentence_end, value_at
from scegen.understanding.words.nominal import WAYS
from scegen.understanding.words.tokens import Token

_DOINGS = frozenset({"cut_in", "lane_change", "merge", "lose_control", "obey", "breach"})
_BREACHES = frozenset({"obey", "breach", "stop", "yield"})
_UNSAFE = frozenset({"cut_in", "lane_change", "merge", "hard_brake", "swerve", "cut_off"})
_SIDEWAYS = frozenset({"move", "enter", "swerve", "walk", "return", "dash", "merge", "cut_in",
                       "lane_change", "sharp_turn", "speed", "accelerate", "turn",
                       "leave"})  # fmt: skip
_LONGEST = 10


def entitle(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Gives a doing that opens a sentence to the one who does it.

    A verb that says the same again is left out.
    """
    end = sentence_end(chunks, 0)
    title = chunks[:end]
    open_ones = [e for e in events if not e.subject or all(m.negated for m in e.subject)]
    for doing in [e for e in open_ones if e.parent is None or e.parent.name == "fail"]:
        told = [e for e in events if e.i > doing.i and e.subject]
        again = [e for e in told if e.name == doing.name]
        alike = next((e for e in again if e.premod_of is not None), None)
        inside = any(doing is c for c in title)
        who: list[Mention] = []
        if alike is not None and doing.nominal and _opens(doing, chunks):
            events.remove(alike)  # "cut-in vehicle 85 km/h"
            who = alike.subject
        elif inside and _whole_title(doing, title, events):
            after = [e for e in told if not e.nominal and e.i >= title[-1].j]
            who = [] if any(e in after for e in again) else _who(doing, after)
        who = who or (_told_next(doing, title, chunks, events) if inside else [])
        unsafe = doing.nominal and doing.name in _UNSAFE
        if not who and unsafe and _opens(doing, chunks):
            who = _other(doing, told, chunks, tokens)
        if who:
            doing.subject, doing.nominal = who, True


def _opens(doing: Event, chunks: list[Chunk]) -> bool:
    return ends(next((c for c in reversed(chunks) if c.j <= doing.i), None))


def _whole_title(doing: Event, title: list[Chunk], events: list[Event]) -> bool:
    """``Loss of control``, ``Failure to stop at a stop sign``: all that a title says, of nobody."""
    spoken = any(c.cat in {"aux", "copy"} for c in title)
    named = any(isinstance(c, Mention) and not c.negated for c in title)
    doings = [e for e in events if _is_doing(e) and any(e is c for c in title)]
    return doings == [doing] and len(title) <= _LONGEST and not (spoken or named)


def _is_doing(event: Event) -> bool:
    failed = event.parent is not None and event.parent.name == "fail"
    return event.name in _DOINGS or (failed and event.name in _BREACHES)


def _who(doing: Event, told: list[Event]) -> list[Mention]:
    told = [e for e in told if e.premod_of is None]
    others = [e for e in told if not any(m.is_ego for m in e.subject)]
    if doing.name == "lose_control":
        return next((e.subject for e in sorted(told, key=lambda e: not e.finite)), [])
    goal = next((e for e in told if e.name in _SIDEWAYS and _leads_into(e)), None)
    if goal is not None:
        return goal.subject
    return others[0].subject if others and doing.name == "cut_in" else []


def _leads_into(event: Event) -> bool:
    """``moves into the lane of the bus``, ``encroaches on the bus``."""
    lanes = [event.object, *(p.target for p in event.pps if p.value in {"into", "to", "in"})]
    into = any(isinstance(c, Place) and c.kind in {"lane", "path"} for c in lanes)
    onto = event.name == "enter" and isinstance(event.object, Mention)
    ahead = any(p.word.cat == "locus" and p.value in {"ahead", "between"} for p in event.pps)
    return into or onto or ahead


def _told_next(
    doing: Event, title: list[Chunk], chunks: list[Chunk], events: list[Event]
) -> list[Mention]:
    """``Right turn on red: the ego has to wait for …``: the title says what the ego does."""
    doings = [c for c in title if isinstance(c, Event) and c.dirs]
    named = doing.nominal or doing.form == "ing"
    who = next((c for c in chunks[len(title) :] if isinstance(c, Mention)), None)
    if doings != [doing] or not named or who is None or not who.is_ego:
        return []
    turned = any(e.i > doing.i and (e.name == "turn" or WAYS & {m.value for m in e.dirs})
                 for e in events)  # fmt: skip
    across = any(getattr(p.target, "kind", "") == "path" for p in doing.pps)
    titled = value_at(chunks, len(title)) in {":", "."}
    alone = not any(isinstance(c, Mention) for c in title)
    return [who] if titled and alone and not (turned or across) else []


def _other(
    doing: Event, told: list[Event], chunks: list[Chunk], tokens: list[Token]
) -> list[Mention]:
    """``Cut-in from the left, the ego at 80 km/h, a van …``: done by who is not the ego."""
    named = [c for c in chunks if isinstance(c, Mention) and c.heads and c.i > doing.i]
    others = [c for c in named if not c.is_ego]
    led = [c for c in others if "ahead" in c.dirs]
    if led and "out" in {t.low for t in tokens[doing.i : doing.j]}:
        acts = any(not e.nominal for e in told)
        return [] if acts else led[:1]  # "Cut-out: lead 60 km/h, ego 80 km/h"
    return others[:1]
