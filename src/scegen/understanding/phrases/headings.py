"""Headings: "Car-to-car rear braking: the test vehicle follows …" names nobody new."""

from __future__ import annotations

from itertools import pairwise

from scegen.scenario.vocabulary import ANIMALS
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing, Word
from scegen.understanding.phrases.lookahead import BOUNDARIES

_SPECIFIC = frozenset({"pedestrian", "bicycle", "motorcycle", "truck", "bus"})
_QUALITIES = frozenset({("manner", "slow"), ("manner", "fast"), ("manner", "wrong_way")})
_ASIDES = frozenset({"punct", "unknown", "dir", "label", "manner", "state", "quantity"})
_FIRST_WORDS = frozenset({"det", "num", "quant", "possessive"})


def lead(chunks: list[Chunk]) -> list[Chunk]:
    """``a man with a dog``, ``walks her dog``: a part of somebody, and nobody of its own.

    Args:
        chunks: the chunks of the text; such animals are marked as ``negated``.
    """
    for before, chunk in pairwise(chunks):
        head = chunk.head if isinstance(chunk, Mention) else None
        if head is None or head.value not in ANIMALS or not isinstance(chunk, Mention):
            continue
        along = isinstance(before, Word) and before.value == "with"
        led = isinstance(before, Event) and before.name == "walk"
        chunk.negated = chunk.negated or along or led
    return chunks


def silence(chunks: list[Chunk]) -> list[Chunk]:
    """Marks the participants of a heading as nobody, if the sentence after it names its own.

    A heading has no verb of its own, and its nouns stand without article or number.

    Args:
        chunks: the chunks of the text; mentions in a heading are marked as ``negated``.

    Returns:
        The chunks without the colons after which it is said what the one before them does.
    """
    begin = 0
    joints: set[int] = set()
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Word) or chunk.value not in BOUNDARIES:
            continue
        title, rest = chunks[begin:k], chunks[k + 1 :]
        if chunk.value == ":" and _of_one(title, rest):
            joints.add(id(chunk))
        elif _is_heading(title, rest) and (chunk.value == ":" or _is_title(title, rest)):
            _silence(title, rest)
        elif not begin:
            _resume(title, rest)
        begin = k + 1
    return [c for c in chunks if id(c) not in joints]


def _of_one(title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Ego: left turn.``, ``Hard-braking coach: 0.55 g from 26 m/s``: of who is named before."""
    who = title[0] if title and (len(title) == 1 or _goes_on(title, rest)) else None
    if not isinstance(who, Mention) or not who.heads or not rest or isinstance(rest[0], Mention):
        return False
    if any("mass" in h.data for h in who.heads):
        return False  # "Tail of a jam: 300 m to a stationary lorry"
    if isinstance(rest[0], Word) and rest[0].cat == "quantity":
        return True  # "Lead car: 100 km/h, ego …"
    return True


def _goes_on(title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Cyclist, lengthwise: rides ahead of the ego.``: the title is the subject."""
    first = rest[0] if rest else None
    finite = isinstance(first, Event) and not first.nominal and first.form == "s"
    return finite and all(
        (isinstance(c, Word) and c.cat in _ASIDES) or (isinstance(c, Thing) and c.kind == "noun")
        for c in title[1:]
    )


def _is_title(title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Car-to-cyclist, crossing from the near side. The cyclist …``: all come up again."""
    mentions = [c for c in title if isinstance(c, Mention)]
    named = [c for c in rest if isinstance(c, Mention) and c.pronoun is None]
    if mentions and all(_in_general(m, title) for m in mentions):
        return any(_telling(n) for n in rest if isinstance(n, Mention))
    if len(mentions) == 1 and _type_of(mentions[0], title, named):
        return True
    if not mentions or any(isinstance(c, Event) for c in title):
        return False
    pair = len(mentions) > 1 and any(isinstance(c, Word) and c.value == "to" for c in title)
    again = all(any(_stands_for(n, m) for n in named) for m in mentions)
    return pair and again and len(named) >= len(mentions)


def _in_general(mention: Mention, title: list[Chunk]) -> bool:
    """``Control loss without prior vehicle action``, ``Vehicle failure``: no vehicle of its own."""
    bare = mention.head is not None and not (mention.mods or mention.label)
    bare = bare and not mention.is_ego
    after = title[title.index(mention) + 1 :][:1]
    compound = bool(after) and (
        isinstance(after[0], Thing) or (isinstance(after[0], Event) and after[0].form == "base")
    )
    governed = mention.prep is not None or any(
        isinstance(c, Word) and c.cat == "prep" for c in title[: title.index(mention)]
    )
    return bare and compound and (governed or mention is title[0])


def _telling(mention: Mention) -> bool:
    """Whether a noun after the title names a vehicle."""
    return any(h.value != "pedestrian" for h in mention.heads)


def _resume(title: list[Chunk], rest: list[Chunk]) -> None:
    """``A drifting vehicle. The adversary …``, ``End of a queue: three cars …``: the same ones."""
    mentions = [c for c in title if isinstance(c, Mention)]
    spoken = any(_finite(c) for c in title) or any(
        isinstance(c, Word) and c.cat in {"aux", "copy"} for c in title
    )
    first = next((c for c in rest if isinstance(c, Mention)), None)
    if spoken or len(mentions) != 1 or first is None or first.head is None:
        return
    named = mentions[0]
    generic = named.head is not None and named.head.value == "car" and not named.label
    role = any(h.data.get("label") == "adversary" for h in first.heads)
    if generic and role and not named.is_ego:
        first.same_as = named


def _type_of(mention: Mention, title: list[Chunk], named: list[Mention]) -> bool:
    """``Overtaking truck. … a lorry …``, ``Lead vehicle stopped. A van …``: a kind of situation."""
    if mention.head is None or mention.is_ego or mention.prep:
        return False
    described = any(m.cat in {"verb", "state", "manner"} for m in mention.mods)
    described = described or any(isinstance(c, Event) for c in title)
    whole = all(
        isinstance(c, Mention | Event | Place | Thing) or c.cat in {"punct", "prep", "state"}
        for c in title
    )
    sided = any(isinstance(c, Word) and c.value in {"left", "right"} for c in title)
    ego = any(n.is_ego for n in named)
    fresh = [n for n in named if n.mods and n.mods[0].value == "indef"]
    alike = [n for n in fresh if _of_kind(n, mention.head.value)]
    generic = mention.head.value == "car" and not mention.label
    again = bool(alike) or (generic and any(n.head is not None for n in fresh))
    return described and whole and not sided and ego and again


def _stands_for(named: Mention, mention: Mention) -> bool:
    generic = mention.head is not None and mention.head.value == "car"
    ego = named.is_ego
    return (generic and ego) or (mention.head is not None and _of_kind(named, mention.head.value))


def _silence(title: list[Chunk], rest: list[Chunk]) -> None:
    """Those of whom a heading says more are the same as those of their kind after it."""
    mentions = [c for c in title if isinstance(c, Mention)]
    others = [c for c in rest if isinstance(c, Mention) and c.heads and not _names_ego([c])]
    if not others:  # "Stationary traffic ahead: the ego brakes": nobody else can be meant
        mentions = [m for m in mentions if _names_ego([m]) or _in_general(m, title)]
    for mention in mentions:
        kind = mention.head.value if mention.head is not None else ""
        alone = sum(m.head is not None and m.head.value == kind for m in mentions) == 1
        told = title[title.index(mention) + 1 :][:1]
        described = (bool(told) and isinstance(told[0], Event)) or bool(mention.dirs)
        same = next((c for c in rest if isinstance(c, Mention) and _of_kind(c, kind)), None)
        if alone and described and same is not None and kind in _SPECIFIC:
            same.same_as = mention
        else:
            mention.negated = True
            if len(mentions) == 1:
                _pass_on(mention, title, rest)


def _names_ego(chunks: list[Chunk]) -> bool:
    return any(c.is_ego for c in chunks if isinstance(c, Mention))


def _pass_on(mention: Mention, title: list[Chunk], rest: list[Chunk]) -> None:
    """``Slow vehicle: a tractor …``: what the heading says holds for the first one named."""
    words = [*mention.mods, *(c.term for c in title if isinstance(c, Word))]
    told = [m for m in words if (m.cat, m.value) in _QUALITIES or m.cat == "state"]
    others = [c for c in rest if isinstance(c, Mention) and c.pronoun is None and c.heads]
    others = [c for c in others if not c.is_ego]
    for other in others[:1] if told else []:
        other.mods = [*other.mods, *told]


def _of_kind(mention: Mention, kind: str) -> bool:
    return mention.head is not None and mention.head.value == kind and not mention.label


def _is_heading(title: list[Chunk], rest: list[Chunk]) -> bool:
    first = title[0] if len(title) == 1 else None
    told = rest[0] if rest else None
    if isinstance(first, Mention) and isinstance(told, Event) and told.dirs:
        return False  # "Truck: left turn."
    if isinstance(first, Mention) and first.is_ego:
        return False  # "Ego: left turn."
    spoken = any(_finite(c) for c in title) or any(
        isinstance(c, Word) and c.cat in {"aux", "copy"} for c in title
    )
    titled = [c for c in title if isinstance(c, Mention)]
    bare = all(
        c.pronoun is None and (not _introduced(c) or _role(c, title) or _done_to(c, title, rest))
        for c in titled
    )
    named = any(isinstance(c, Mention) and c.pronoun is None for c in rest)
    stated = any(isinstance(c, Word) and c.cat in {"aux", "copy"} for c in rest)
    told_of = any(isinstance(c, Event) for c in rest) or (_names_ego(rest) and not stated)
    return not spoken and bare and named and told_of


def _finite(chunk: Chunk) -> bool:
    return isinstance(chunk, Event) and not chunk.nominal and chunk.form == "s"


def _role(mention: Mention, title: list[Chunk]) -> bool:
    """``Deceleration of the preceding vehicle: …``: whoever is told of after it plays it."""
    opened = [(m.cat, m.value) for m in mention.mods if m.cat in _FIRST_WORDS] == [("det", "def")]
    generic = mention.head is not None and mention.head.value == "car" and not mention.label
    doing = isinstance(title[0], Event) and not isinstance(title[-1], Event)
    return opened and generic and bool(mention.dirs) and doing and not mention.is_ego


def _done_to(mention: Mention, title: list[Chunk], rest: list[Chunk]) -> bool:
    """``Overtaking a bicyclist: EBT 22 km/h, …``: one of its kind is told of after it."""
    kind = mention.head.value if mention.head is not None else ""
    alone = isinstance(title[0], Event) and title[0].form == "ing" and title[-1] is mention
    again = (c for c in rest if isinstance(c, Mention) and c.head is not None and not c.is_ego)
    return alone and kind in _SPECIFIC and any(c.head and c.head.value == kind for c in again)


def _introduced(mention: Mention) -> bool:
    return any(m.cat in _FIRST_WORDS for m in mention.mods) or bool(mention.label)
