"""Doings that a noun names: ``Braking of the lead car``, ``Cut-in from the left, ego 100 km/h``."""

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.headings import only_entries
from scegen.understanding.phrases.lookahead import (
    BOUNDARIES,
    GOVERNING,
    cat_at,
    chunk_at,
    ends,
    finite_follows,
    sentence_end,
    value_at,
)
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.words.terms import NOTHING, Term
from scegen.understanding.words.tokens import Token

_HOW = frozenset({"prep", "quantity", "manner", "dir", "punct", "sub"})
DONE_TO = frozenset({"overtake", "pass", "bypass", "follow", "encounter"})
"""Doings of which "of" names whom they are done to."""
_MADE = frozenset({"turn", "u_turn", "reverse"})
"""Doings that a title names before who does them."""
_DOERS = frozenset({"of", "by"})
_JOINTS = frozenset({",", "and", "then"})


def teller_at(i: int) -> Mention:
    """Whoever tells it, where the text names nobody."""
    term = Term("actor", "ego", i, i, data={"ego": True, "speaks": True})
    return Mention(i, i, [], term, heads=[term])


def spell_out_doings(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with who does what a noun names before it, and whom it is done to behind it."""
    found: list[Chunk] = []
    k = 0
    while k < len(chunks):
        event = chunks[k]
        told = _told(event, k, chunks) if isinstance(event, Event) else None
        if told is None:
            found.append(event)
            k += 1
        else:
            clause, k = told
            found += clause
    return found


def _told(event: Event, k: int, chunks: list[Chunk]) -> tuple[list[Chunk], int] | None:
    first = k - (cat_at(chunks, k - 1) == "manner")  # "unbraked collision of the ego with …"
    before = value_at(chunks, first - 1) if first else "."
    opens = before in BOUNDARIES or (before in _JOINTS and (event.nominal or event.form == "ing"))
    hit = event.name == "collide" and not event.nominal and value_at(chunks, k + 1) != "of"
    if hit or not (opens or noted(event, k, chunks)) or event.form not in {"base", "ing"}:
        return None
    after = chunk_at(chunks, k + 1)
    where = chunks[k + 1 : k + 3] if isinstance(chunk_at(chunks, k + 2), Place) else []
    m = k + 1 + len(where)
    who_else = chunk_at(chunks, m + 1)
    if event.name in _MADE and value_at(chunks, m) == "," and isinstance(who_else, Mention):
        rest = chunks[m + 2 : sentence_end(chunks, m + 2)]
        done = any(isinstance(c, Event) for c in rest)
        # "Left turn, ego at 12 km/h", "Left turn at a junction, ego 12 km/h"
        return None if done else ([who_else, _verb(event), *where], m + 2)
    where = where if value_at(chunks, m) == "by" else []  # "cut-in from the left by a van"
    m = m if where else k + 1 + isinstance(after, Thing)  # "manoeuvre"
    named: dict[str, list[Chunk]] = {}
    while (group := _group(m, chunks)) and group[0] not in named:
        named[group[0]] = group[1]
        m = group[2]
    end = sentence_end(chunks, m)
    is_heading = value_at(chunks, end) == ":" and not only_entries(chunks[end + 1 :])
    if finite_follows(chunks, m - 1) or is_heading:
        return None
    if not named:
        who = _last_told(k, chunks) if before in BOUNDARIES else None
        if before in BOUNDARIES and event.name in _MADE and event.form == "base":
            rest = chunks[k + 1 :]
            told = _entitles(rest, first=k == 0)
            who = (_of_the_other(event.i, rest) or teller_at(event.i)) if told else who
        if who is None or event.name != "overtake":
            return None if who is None else ([who, _verb(event)], k + 1)
        of_ego = who.same_as is not None and who.same_as.is_ego
        return None if of_ego else ([teller_at(event.i), _verb(event), who], k + 1)
    of, by = named.get("of", []), named.get("by", [])
    if not by and event.name not in DONE_TO:  # but not "reversing out of a drive, …"
        return ([*of, _verb(event), *where], m) if isinstance(of[0], Mention) else None
    return [*(by or [teller_at(event.i)]), _verb(event), *where, *of], m


def _entitles(rest: list[Chunk], *, first: bool) -> bool:
    """``Right turn at 10 km/h. …``, ``Left turn, a bus comes towards us``: whoever tells it."""
    mark = next((m for m, c in enumerate(rest) if c.value == "," or ends(c)), len(rest))
    told = any(isinstance(c, Mention) and c.is_ego for c in rest[mark:])
    told = told if value_at(rest, mark) == "," else first
    return told and all(isinstance(c, Term | Place) for c in rest[:mark])


def _of_the_other(i: int, rest: list[Chunk]) -> Mention | None:
    """``Left turn across path from opposite direction, ego going straight``: not the ego's."""
    after = [c for c in rest if isinstance(c, Mention | Event) or c.cat == "dir"]
    straight = any(m.value == "straight" for c in after for m in getattr(c, "mods", [c]))
    if not straight or not any(isinstance(c, Place) and c.kind == "path" for c in rest[:2]):
        return None
    named = next((c for c in after if isinstance(c, Mention) and not c.is_ego and c.heads), None)
    car = None if named is not None else Term("actor", "car", i, i)
    return Mention(i, i, [], car, heads=[car] if car else [], same_as=named)


def noted(event: Event, k: int, chunks: list[Chunk]) -> bool:
    """``Ego 80 km/h, cut-in from the left``: after a comma, in notes without a verb before it."""
    if event.name != "cut_in" or value_at(chunks, k - 1) != ",":
        return False
    opens = (j for j in range(k, 0, -1) if ends(chunks[j - 1]))
    return not any(isinstance(c, Event) or c.cat == "aux" for c in chunks[next(opens, 0) : k])


def _verb(event: Event) -> Event:
    return replace(event, form="s", nominal=False)


def _last_told(k: int, chunks: list[Chunk]) -> Mention | None:
    """``Lead: 80 km/h, 30 m ahead. Braking with 8 m/s²``: of whom the entry before tells.

    An entry has no verb; what follows the noun of the doing is a measure or a phrase of place.
    """
    event, mark, told = chunks[k], chunk_at(chunks, k - 1), None
    if not isinstance(event, Event) or event.name not in word_list("entered"):
        return None
    bare = all(m.cat == "manner" for m in event.mods)
    if not bare or mark is NOTHING or cat_at(chunks, k + 1) not in _HOW:
        return None
    for m in range(k - 2, -1, -1):
        who = chunks[m]
        if isinstance(who, Event) or (told is not None and ends(who)):
            break
        free = cat_at(chunks, m - 1) not in GOVERNING
        if isinstance(who, Mention) and not who.possessor and free:
            told = told or Mention(event.i, event.i, [], None, same_as=who)
    else:
        return told
    return None if isinstance(who, Event) else told


def _group(m: int, chunks: list[Chunk]) -> tuple[str, list[Chunk], int] | None:
    """``of a car ahead of the ego``: the word, the noun with its place, where it ends."""
    word, noun = value_at(chunks, m), chunk_at(chunks, m + 1)
    if word not in _DOERS or not isinstance(noun, Mention | Place):
        return None
    there = cat_at(chunks, m + 2) == "locus" and ends(chunk_at(chunks, m + 3))
    end = m + 2 + there  # "by the van ahead"
    speed = chunk_at(chunks, end + 1)
    told = isinstance(noun, Mention) and value_at(chunks, end + 2) in _DOERS
    if told and isinstance(speed, Term) and speed.cat == "quantity":
        noun.mods = [*noun.mods, speed]  # "of a cyclist at 15 km/h by …"
        return word, chunks[m + 1 : end], end + 2
    return word, chunks[m + 1 : end], end


_DOINGS = frozenset({"cut_in", "lane_change", "merge", "lose_control", "obey", "breach"})
_BREACHES = frozenset({"obey", "breach", "stop", "yield"})
_UNSAFE = frozenset({"cut_in", "lane_change", "merge", "hard_brake", "swerve", "cut_off"})
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
        titled = doing.nominal and doing.name in _UNSAFE and _opens(doing, chunks)
        same = next((e for e in again if e.finite and not e.nominal), None)
        if not who and titled and same is not None:
            same.mods, same.pps = [*doing.mods, *same.mods], [*doing.pps, *same.pps]
            events.remove(doing)  # "Cut-out right. The ego follows a van. It leaves its lane."
            continue
        who = who or (_told_next(doing, title, chunks, events) if inside else [])
        if not who and titled:
            who = _other(doing, told, chunks, tokens)
        if who:
            doing.subject, doing.nominal = who, True


def _opens(doing: Event, chunks: list[Chunk]) -> bool:
    k = next((k for k in range(len(chunks) - 1, -1, -1) if chunks[k].j <= doing.i), -1)
    return ends(chunks[k] if k >= 0 else NOTHING) or noted(doing, k + 1, chunks)


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
    goal = next((e for e in told if e.name in word_list("leading_aside") and _leads_into(e)), None)
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
    titled = value_at(chunks, len(title)) in {":", ".", ";"}
    alone = all(m.stands_after("with") for m in title if isinstance(m, Mention))
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
