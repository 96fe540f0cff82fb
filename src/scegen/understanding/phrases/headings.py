"""Headings and entries: "Car-to-car rear braking: …" names nobody new, "Ego: 50 km/h" tells."""

from collections.abc import Sequence
from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.phrases.lookahead import (
    cat_at,
    chunk_at,
    free_mentions,
    sentences,
    value_at,
)
from scegen.understanding.words.terms import Term

_NOBODY = "nobody"
_GENERIC = frozenset({"car", "driver", "adversary"})
_SPECIFIC = frozenset({"pedestrian", "bicycle", "motorcycle", "truck", "bus"})
_QUALITIES = frozenset({("manner", "slow"), ("manner", "fast"), ("manner", "wrong_way")})
_FROM_THERE = frozenset({"opposite", "lateral", "left", "right"})
_AUXILIARIES = frozenset({"aux", "copy"})
_TWO, _WITH_A_PLACE = 2, 3
_FIRST_WORDS = frozenset({"det", "num", "quant", "possessive"})


def announce(chunks: list[Chunk]) -> list[Chunk]:
    """``oncoming traffic: three cars come``, ``somebody jumps the light: a taxi races …``.

    Whoever a heading names without a number are those told after its colon, and nobody besides.
    """
    left_out: set[int] = set()
    for begin, k in sentences(chunks):
        who = next(iter(_others(chunks[begin:k])), None)
        first = next(iter(free_mentions(chunks[k + 1 :])), None)
        title = chunks[begin:k]
        if chunks[k].value == ":" and first is not None:
            left_out |= _says_where(begin, k, chunks)
        if chunks[k].value != ":" or who is None or who.head is None or who.has("num"):
            continue
        mere = chunk_at(chunks, k + 1).cat == "manner"  # "oncoming traffic: just one lorry"
        again = chunk_at(chunks, k + 1 + mere)
        number = again.mod("num") if isinstance(again, Mention) and again.head else None
        told = _listed(chunks, k + 1)
        entry = _opens_entry(title, who, again)
        new = first in told and (_new(first) or (entry and _bare(first)))
        if first is not None and new and (entry or _anybody(who)):
            _turns_out(who, first)
            if title == [who] and not entry:
                first.same_as = None  # "A wrong-way driver: 300 m ahead, a car comes"
                left_out |= {begin, k}
            continue
        if "mass" in who.head.data and number is not None and isinstance(again, Mention):
            turns_out(who, again)
        elif who.plural and who.noun in _GENERIC and len(told) > 1:
            count = Term("num", "count", who.i, who.i, data={"number": float(len(told))})
            who.mods = [count, *(m for m in who.mods if m.cat != "quant")]
    return _without(left_out, chunks)


def _says_where(begin: int, k: int, chunks: list[Chunk]) -> set[int]:
    """``Oncoming: a lorry and a van``, ``From the left: a van``: the chunks to leave out."""
    title = chunks[begin:k]
    if len(title) == _TWO and title[0].cat == "prep" and isinstance(title[1], Place):
        return {k}  # "from the left a van …"
    if not title or any(c.cat not in {"dir", "locus"} for c in title):
        return set()
    where = [replace(c, cat="dir") for c in title if isinstance(c, Term)]
    while isinstance(who := chunk_at(chunks, k + 1), Mention):
        who.mods = [*who.mods, *where]
        k += 2 if value_at(chunks, k + 2) in {"and", ","} else len(chunks)
    return {*range(begin, begin + len(title) + 1)}


def _anybody(mention: Mention) -> bool:
    """``somebody``, ``a wrong-way driver``, ``oncoming traffic``: of no kind yet."""
    data = mention.head.data if mention.head is not None else {}
    flows = "mass" in data and "stands" not in data and not _FROM_THERE.isdisjoint(mention.dirs)
    return "vague" in data or "driver" in data or flows


def _opens_entry(title: list[Chunk], who: Mention, after: Chunk) -> bool:
    """``Target: bus, 40 km/h``, ``Vehicle ahead: van``: its kind comes right after the colon."""
    mere = title[0] is who and [c.cat for c in title[1:]] in ([], ["locus"])
    return mere and isinstance(after, Mention) and _bare(who) and who.noun in _GENERIC


def _bare(mention: Mention) -> bool:
    """``target``, ``other vehicle``: without an article."""
    opened = [m for m in mention.mods if m.cat in _FIRST_WORDS | {"quantity"}]
    return not mention.plural and all(m.value == "other" for m in opened)


def _turns_out(who: Mention, named: Mention) -> None:
    """``somebody …: a taxi …``: that is who it is, and of what kind."""
    does = {k: v for head in who.heads for k, v in head.data.items() if k == "does"}
    named.heads = [replace(head, data=head.data | does) for head in named.heads]
    named.head = named.heads[-1]
    named.mods = [*named.mods, *(m for m in who.mods if m.cat not in _FIRST_WORDS)]
    named.same_as, who.heads, who.head = who, named.heads, named.head


def turns_out(flow: Mention, named: Mention) -> None:
    """``oncoming traffic: two vans``, ``oncoming traffic, a van``: that is who it is."""
    flow.mods = [*flow.mods, *(m for m in named.mods if m.cat == "num")]
    flow.heads, flow.head, named.same_as = named.heads, named.head, flow


def _new(mention: Mention) -> bool:
    """``a taxi``: nobody who is named before."""
    return any(m.value == "indef" for m in mention.mods[:1])


def _listed(chunks: list[Chunk], k: int) -> list[Mention]:
    """Who is told one after the other up to the end of a sentence, the ego left out."""
    end = next((m for m in range(k, len(chunks)) if chunks[m].value in {".", ";"}), len(chunks))
    return _others(free_mentions(chunks[k:end]))


def _others(chunks: Sequence[Chunk]) -> list[Mention]:
    """Whom nouns name, the ego left out."""
    return [c for c in chunks if isinstance(c, Mention) and c.heads and not c.is_ego]


def silence(chunks: list[Chunk]) -> list[Chunk]:
    """Marks the participants of a heading as nobody, if the sentence after it names its own.

    A heading has no verb of its own, and its nouns stand without article or number.

    Returns:
        The chunks without the colons after which it is said what the one before them does.
    """
    joints: set[int] = set()
    for begin, k in sentences(chunks):
        title, rest, mark = chunks[begin:k], chunks[k + 1 :], chunks[k].value
        if mark == ":" and _of_one(title, rest):
            joints.add(k)
        elif (mark == ":" or not begin) and _is_heading(title, rest, mark):
            _silence(title, rest)
    return _without(joints, chunks)


def _without(places: set[int], chunks: list[Chunk]) -> list[Chunk]:
    return [c for k, c in enumerate(chunks) if k not in places]


def _of_one(title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Ego: left turn.``, ``Hard-braking coach: 0.55 g from 26 m/s``: of who is named before."""
    somewhere = [c.cat for c in title[1:2]] == ["prep"] and isinstance(title[-1], Place)
    who = title[0] if len(title) == 1 or (somewhere and len(title) == _WITH_A_PLACE) else None
    named = isinstance(who, Mention) and any("mass" not in h.data for h in who.heads)
    told = rest[0] if rest else None
    if isinstance(told, Event) and told.form == "ing":  # "Runner: coming from the left, a boy …"
        comma = next((k for k, c in enumerate(rest) if c.value == ","), len(rest))
        told = rest[comma + 1] if comma + 1 < len(rest) else told
    return named and told is not None and not isinstance(told, Mention)


def _silence(title: list[Chunk], rest: list[Chunk]) -> None:
    """Those of whom a heading says more are the same as those of their kind after it."""
    mentions = [c for c in title if isinstance(c, Mention)]
    if not _others(rest):  # "Stationary traffic ahead: the ego brakes": nobody else can be meant
        mentions = [m for m in mentions if _names_ego([m])]
    again = [c.same_as for c in rest if isinstance(c, Mention)]
    doing = any(isinstance(c, Event) for c in title)
    entries = doing and only_entries(rest)
    for mention in (m for m in mentions if m not in again):
        kind = mention.noun
        alone = [m.noun for m in mentions].count(kind) == 1
        told = isinstance(chunk_at(title, title.index(mention) + 1), Event)
        same = next((c for c in rest if isinstance(c, Mention) and _of_kind(c, kind)), None)
        if entries and mention in _others(title) and kind not in _SPECIFIC:
            for named in _others(rest)[:1]:  # "Lead car braking: ego 50 km/h, lead 50 km/h"
                named.same_as = mention
        elif alone and (told or mention.dirs) and same is not None and kind in _SPECIFIC:
            same.same_as = mention
        else:
            mention.negated = True
            if len(mentions) == 1 and not _introduced(mention):
                _pass_on(mention, title, rest)


def only_entries(chunks: list[Chunk]) -> bool:
    """Whether nobody but the ego is told to do something: "ego 50 km/h, lead 50 km/h"."""
    others = False
    for chunk in chunks:
        others = not chunk.is_ego if isinstance(chunk, Mention) else others
        if others and isinstance(chunk, Event) and not chunk.nominal:
            return False
    return True


def _names_ego(chunks: list[Chunk]) -> bool:
    return any(c.is_ego for c in chunks if isinstance(c, Mention))


def _pass_on(mention: Mention, title: list[Chunk], rest: list[Chunk]) -> None:
    """``Slow vehicle: a tractor …``: what the heading says holds for the first one named."""
    words = [*mention.mods, *(c for c in title if isinstance(c, Term))]
    told = [m for m in words if (m.cat, m.value) in _QUALITIES or m.cat == "state"]
    for other in _others(rest)[:1]:
        other.mods = [*other.mods, *told]


def _of_kind(mention: Mention, kind: str) -> bool:
    return mention.noun == kind and not mention.label


def _comes_again(mention: Mention, title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Overtaking truck. … a lorry …``: whoever a title names is told of as somebody new."""
    named = next((h.value for h in mention.heads if h.value in _SPECIFIC), mention.noun)
    kind = "" if mention.plural else named  # "cyclist target": no vehicle like any other
    told = [c for c in rest if isinstance(c, Mention) and c.head is not None]
    fresh = [c for c in told if _new(c)]
    there = any(m.cat == "quantity" for m in (*title, *mention.mods))  # "car target 80 m ahead"
    generic = kind == "car" and any(c.is_ego or _of_kind(c, kind) for c in told)
    return (generic and not there) or any(kind in _GENERIC or _of_kind(c, kind) for c in fresh)


def _introduced_again(mention: Mention, rest: list[Chunk]) -> bool:
    """``Cut-out before a stopped car: … a car that has broken down``."""
    named = [c for c in _others(rest) if mention.noun == "car" or _of_kind(c, mention.noun)]
    return not mention.plural and not mention.label and any(map(_new, named))


def _is_heading(title: list[Chunk], rest: list[Chunk], mark: str) -> bool:
    """Whether words up to a colon, or the first sentence, only name what is told after them."""
    verbs = [c for c in title if isinstance(c, Event) and not c.nominal and c.form == "s"]
    spoken = bool(verbs) or any(c.cat in _AUXILIARIES for c in title)
    if title and title[-1].value == "speed" and not _others(title):
        spoken = spoken or _names_ego(title)  # "Motorway, ego at 120 km/h: a van …"
    if spoken:
        return False
    titled = [c for c in title if isinstance(c, Mention)]
    if mark != ":":
        sided = any(c.value in {"left", "right"} for c in title)
        again = all(_comes_again(c, title, rest) for c in titled) and not _names_ego(title)
        before = {value_at(title, title.index(c) - 1) for c in titled}
        of_kinds = before <= {"for", "and"} and all(c.plural for c in titled)
        told = (again and not sided) or of_kinds  # "Blind-spot test for trucks."
        if mark != "." or not titled or not told:
            return False
    bare = all(
        c.pronoun is None
        and (
            not _introduced(c)
            or _role(c, title)
            or _done_to(c, title, rest)
            or (mark == ":" and _introduced_again(c, rest))
        )
        for c in titled
    )
    who = [c for c in rest if isinstance(c, Mention)]
    if who and who[0].pronoun == "it" and titled:
        return False  # "VUT on the minor leg: it turns right"
    named = any(c.pronoun is None for c in who)
    stated = any(c.cat in _AUXILIARIES for c in rest)
    told_of = any(isinstance(c, Event) for c in rest) or (_names_ego(rest) and not stated)
    return bare and named and told_of


def _role(mention: Mention, title: list[Chunk]) -> bool:
    """``Deceleration of the preceding vehicle: …``: whoever is told of after it plays it."""
    opened = [(m.cat, m.value) for m in mention.mods if m.cat in _FIRST_WORDS] == [("det", "def")]
    generic = _of_kind(mention, "car")
    doing = isinstance(title[0], Event) and not isinstance(title[-1], Event)
    return opened and generic and bool(mention.dirs) and doing and not mention.is_ego


def _done_to(mention: Mention, title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Overtaking a bicyclist: EBT 22 km/h, …``: one of its kind is told of after it."""
    alone = isinstance(title[0], Event) and title[0].form == "ing" and title[-1] is mention
    again = any(c.noun == mention.noun for c in _others(rest))
    anybody = mention.noun == "car" and mention.has("det", "another")
    return alone and ((mention.noun in _SPECIFIC and again) or (anybody and bool(_others(rest))))


def _introduced(mention: Mention) -> bool:
    return any(m.cat in _FIRST_WORDS for m in mention.mods) or bool(mention.label)


def read_entries(chunks: list[Chunk]) -> list[Chunk]:
    """``Lead car, same lane: 30 km/h``, ``Other road users: none``: entries of a protocol.

    A speed behind a colon is that of who opens the entry, "none" denies who does.
    """
    titles = [(chunks[begin:k], k) for begin, k in sentences(chunks) if chunks[k].value == ":"]
    left_out = {m for title, k in titles for m in range(k, _entry(title, chunks, k))}
    return _without(left_out, chunks)


def _entry(title: list[Chunk], chunks: list[Chunk], k: int) -> int:
    """Where the text goes on behind what an entry says of who opens it."""
    who = [m for m in free_mentions(title) if m.heads and not m.possessor]
    if not who or any(isinstance(c, Event) and not c.nominal for c in title):
        return k
    m = k + 1
    while cat_at(chunks, m) in {"manner", "prep"}:
        m += 1
    value = chunk_at(chunks, m)
    last = m + 1 == len(chunks) or value_at(chunks, m + 1) in {".", ";", ","}
    if isinstance(value, Mention) and value.pronoun == _NOBODY and last:
        who[0].negated = True
        return m + 1
    if isinstance(value, Term) and (value.cat, value.value) == ("quantity", "speed"):
        for each in who:
            each.mods = [*each.mods, value]
        return m + 1
    return k
