"""Names: numbers and letters (``cars A and B``), and two that are one (``V1 (ego, a truck)``)."""

from dataclasses import replace
from itertools import pairwise, takewhile

from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, ends, value_at
from scegen.understanding.words.terms import Term, cat_at
from scegen.understanding.words.tokens import Token, low_at

_WIDEST_GAP = 2
"""Room for a space and a "#"."""


def name_noun(mention: Mention, m: int, terms: list[Term], tokens: list[Token]) -> int:
    """``vehicle 1``, ``car A``: names the mention; a plural only as the first of a list.

    Returns:
        The index of the term after the name, ``m`` if there is none.
    """
    plural = tokens[mention.j - 1].text.endswith("s")
    bare = not mention.mods and not plural
    name = _name(m, terms, tokens, bare=bare)
    if name is None or (plural and not _listed(m + 1, terms, tokens)):
        return m
    mention.label, mention.label_at, mention.j = name, terms[m].i, terms[m].j
    return m + 1


def name_further(
    first: Mention, m: int, terms: list[Term], tokens: list[Token]
) -> tuple[list[Chunk], int]:
    """``vehicles 1, 2 and 3``: a mention for each name after the first.

    Returns:
        The further chunks and the index of the term after them.
    """
    found: list[Chunk] = []
    named = [first]
    while first.label is not None and first.plural and _listed(m, terms, tokens):
        name = _name(m + 1, terms, tokens)
        term = terms[m + 1]
        mention = Mention(term.i, term.j, list(first.mods), first.head, heads=first.heads)
        mention.label, mention.label_at = name, term.i
        found += [terms[m], mention]
        named.append(mention)
        m += 2
    for one in named if found else []:  # "two cars A and B": the names say who the two are
        one.mods = [t for t in one.mods if t.cat not in {"num", "quant"}]
    return found, m


def numbered(head: Term, m: int, terms: list[Term], tokens: list[Token]) -> bool:
    """``lane 2``, ``exit two``: the number is the place's name."""
    if cat_at(terms, m) != "num" or head.value not in {"lane", "road", "exit"}:
        return False
    bare = cat_at(terms, m - 2) not in {"det", "dir"}
    written = tokens[terms[m].i].kind == "number"
    return (bare or written) and cat_at(terms, m + 1) not in {"actor", "place"}


def _listed(m: int, terms: list[Term], tokens: list[Token]) -> bool:
    """Whether a further name comes after a joint."""
    joint = m < len(terms) and terms[m].value in {"and", "or", ","}
    return joint and _name(m + 1, terms, tokens) is not None


def _model(i: int, tokens: list[Token]) -> bool:
    """``F-150``: a letter joined to a number is a model, not a name."""
    after = tokens[i + 1] if i + 1 < len(tokens) else None
    joined = after is not None and after.start == tokens[i].end + 1
    written = after is not None and after.kind == "number"
    return joined and written and tokens[i].text != "A"


def _name(m: int, terms: list[Term], tokens: list[Token], *, bare: bool = False) -> str | None:
    """The name that the term is, if it is one; after a bare noun ("vehicle two") it is."""
    if m >= len(terms):
        return None
    term = terms[m]
    token = tokens[term.i]
    if token.start - tokens[term.i - 1].end > _WIDEST_GAP:
        return None  # "ego + 2 others"
    alone = term.j - term.i == 1  # no "T-bones"
    follows = cat_at(terms, m + 1)
    told = bare or token.kind == "number" or follows not in {"place", "verb", "manner"}
    if term.cat == "num" and told and alone and follows != "actor":
        return f"#{term.data['number']:g}"
    letter = alone and len(token.text) == 1 and token.text.isupper() and token.text != "I"
    letter = letter and not _model(term.i, tokens)
    if letter and follows not in {"actor", "place", "dir", "shape", "manner", "state"}:
        return f"#{token.low}"
    return None


_JOINTS = frozenset({"punct", "sub", "conj"})
_FROM = frozenset({"from", "in"})
_ENDS = frozenset({":", ",", "."})
_LOOKING = 8
"""Within so many words before a vehicle it is said that one looks from there."""


def in_brackets(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with each of two further names of somebody in brackets of its own."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        marks = [value_at(chunks, m) for m in (k - 2, k, k + 2)]
        first, second = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
        named = marks == ["(", ",", ")"] and isinstance(chunk_at(chunks, k - 3), Mention)
        if named and _says_who(first) and _says_who(second):
            found += [Term("punct", mark, chunk.i, chunk.i) for mark in ")("]
        else:
            found.append(chunk)
    return found


def under_test(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``the vehicle follows a van …; the vehicle under test stops``: the vehicle is that one.

    Whom a text begins with by a mere noun is nobody new, if the ego is called by that noun later.
    """
    named = [c for c in chunks if isinstance(c, Mention) and c.heads]
    first = named[0] if named else None
    if first is None or first.head is None or first.is_ego:
        return chunks
    after = chunks[chunks.index(first) + 1 :]
    verb = next((c for c in after if c.cat not in {"aux", "manner"}), None)
    mere = [(m.cat, m.value) for m in first.mods] == [("det", "def")]
    clause = takewhile(lambda c: c.cat not in _JOINTS, after)  # "the vehicle leading the ego"
    meets = any(isinstance(c, Mention) and c.is_ego for c in clause)
    if mere and isinstance(verb, Event) and not meets:  # "the vehicle ahead" is another one
        noun = tokens[first.head.i].low
        egos = [a for a in named[1:] if a.is_ego and noun in {t.low for t in tokens[a.i : a.j]}]
        first.heads = [*(egos[0].heads if egos else []), *first.heads]
    return chunks


def filmed_from(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``View from inside a van: …``, ``camera of a lorry, …``: that one is the ego."""
    named = [k for k, c in enumerate(chunks) if isinstance(c, Mention) and c.heads]
    who = chunks[named[0]] if named else None
    if not isinstance(who, Mention) or not 0 < who.i <= _LOOKING:
        return chunks
    around = value_at(chunks, named[0] - 1), value_at(chunks, named[0] + 1)
    looks = {t.base for t in tokens[: who.i]} & word_list("filming")
    of = low_at(tokens, who.i - 1) == "of" and low_at(tokens, who.i - 2) in word_list("views_of")
    egos = [h for c in chunks if isinstance(c, Mention) and c.is_ego for h in c.heads]
    another = any(h.data.get("ego") and not {"me", "speaks"} & {*h.data} for h in egos)
    plain = not (who.dirs or who.noun == "pedestrian" or who.has("state"))
    if looks and plain and not another and (of or around[0] in _FROM) and around[1] in _ENDS:
        data = {"ego": True, "speaks": True}
        who.heads = [Term("actor", "ego", who.i, who.i, data=data), *who.heads]
    return chunks


def counted_in(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``four cars including mine``, ``mine included``: three others and the ego."""
    named = [k for k, c in enumerate(chunks) if isinstance(c, Mention)]
    left_out: set[int] = set()
    for k, m in pairwise(named):
        group, who = chunks[k], chunks[m]
        if not (isinstance(group, Mention) and isinstance(who, Mention)):
            continue
        number = group.mod("num")
        if number is None or any(map(ends, chunks[k:m])):
            continue
        own = who.is_ego or who.is_me or who.opened_by("first_person")
        around = [tokens[who.i - 1].low, low_at(tokens, who.j)]
        among = [word in word_list("including") for word in around]
        if own and any(among) and number.data["number"] > 1:
            rest = replace(number, data={"number": number.data["number"] - 1})
            group.mods = [rest if t is number else t for t in group.mods]
            who.heads = [*group.heads, *who.heads]  # "four trucks including ours"
            chunks[m - 1] = Term("conj", "and", who.i, who.i)
            left_out |= {n for n in range(k + 1, m - 1) if chunks[n].value == ","}
            left_out |= {m + 1, m + 2} if among[1] else set()
    return [c for k, c in enumerate(chunks) if k not in left_out]


def _says_who(chunk: Chunk) -> bool:
    """The ego, or a kind ("a truck", "passenger car")."""
    if not isinstance(chunk, Mention):
        return False
    kind = not chunk.label and all(m.value == "indef" for m in chunk.mods if m.cat == "det")
    return kind or chunk.is_ego
