"""Titles that name a doing: "Static cut-in. Out of a queue of vans one moves over …"."""

from __future__ import annotations

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Word
from scegen.understanding.phrases.lookahead import BOUNDARIES

_DOINGS = frozenset({"cut_in", "lane_change", "merge", "lose_control", "obey", "breach"})
_BREACHES = frozenset({"obey", "breach", "stop", "yield"})
_SIDEWAYS = frozenset({"move", "enter", "swerve", "walk", "return", "dash", "merge", "cut_in",
                       "lane_change", "sharp_turn", "speed", "accelerate", "turn",
                       "leave"})  # fmt: skip
_LONGEST = 10


def entitle(chunks: list[Chunk], events: list[Event]) -> None:
    """Gives the doing that a title names to the one who does it in the sentence after it.

    Args:
        chunks: the chunks of the text.
        events: its events, subjects found.
    """
    end = next((k for k, c in enumerate(chunks) if _ends(c)), len(chunks))
    title = chunks[:end]
    if end > _LONGEST or any(isinstance(c, Word) and c.cat in {"aux", "copy"} for c in title):
        return
    doings = [e for e in events if _is_doing(e) and any(e is c for c in title)]
    if len(doings) != 1 or not _of_nobody(doings[0], title):
        return
    doing, close = doings[0], chunks[end].i if end < len(chunks) else 0
    told = [e for e in events if e.i > close and e.subject and not e.nominal]
    if any(e.name == doing.name for e in told):
        return
    who = _who(doing, [e for e in told if e.premod_of is None])
    if who:
        doing.subject, doing.nominal = who, True


def _is_doing(event: Event) -> bool:
    """``Loss of control``, ``Failure to stop at a stop sign``."""
    failed = event.parent is not None and event.parent.name == "fail"
    return event.name in _DOINGS or (failed and event.name in _BREACHES)


def _ends(chunk: Chunk) -> bool:
    return isinstance(chunk, Word) and chunk.value in BOUNDARIES


def _of_nobody(doing: Event, title: list[Chunk]) -> bool:
    """Whether nobody in particular does it: "Vehicle changing lanes", "Loss of control"."""
    named = [c for c in title if isinstance(c, Mention) and not c.negated]
    return not named and (not doing.subject or all(m.negated for m in doing.subject))


def _who(doing: Event, told: list[Event]) -> list[Mention]:
    others = [e for e in told if not _is_ego(e)]
    finite = [e for e in told if e.finite]
    if doing.name == "lose_control":
        return (finite or told)[0].subject if told else []
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


def _is_ego(event: Event) -> bool:
    return any(h.data.get("ego") for m in event.subject for h in m.heads)
