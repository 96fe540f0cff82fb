"""Telegraphic style: "Ego straight, truck from the left: right turn", "Cut-in by a van".

What is left out is put back before the clauses are read: "goes" before a bare direction, the
colon after a heading that says who or where, and who does what a noun names.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import noted, spell_out_doings, teller_at
from scegen.understanding.phrases.lookahead import (
    GOVERNING,
    by_follows,
    cat_at,
    chunk_at,
    ends,
    free_mentions,
    sentence_end,
    sentences,
    value_at,
)
from scegen.understanding.phrases.touching import ARTICLES, touching
from scegen.understanding.words.terms import NOTHING, Term

_WAYS = frozenset({("dir", "left"), ("dir", "right"), ("dir", "straight"), ("manner", "backwards")})
_SEPARATORS = frozenset({",", "and", "but", "or", "while", "when", "as", "both"})
_AFTER = frozenset({"prep", "conj", "sub", "manner", "env", "locus", "control"})
_WITHIN = frozenset({"", "prep", "locus", "dir", "manner", "label", "quantity"})
_NAMED = frozenset({"cut_in", "lane_change", "merge", "u_turn", "hard_brake", "swerve"})
_MARKS = frozenset({".", ";", "!", "?"})
_MEASURED = frozenset({"prep", "quantity", "punct"})
_UNDERGONE = frozenset({"park", "hide", "block", "collide", "locate", "follow", "overtake",
                        "encounter", "cut_off", "cut_in", "cause", "prevent"})  # fmt: skip
"""Verbs whose participle says what happened to somebody."""


_STOPS = frozenset({".", ";", "!"})


def spell_out(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks with what telegraphic style leaves out."""
    chunks = _in_lanes([c for k, c in enumerate(chunks) if not _before_its_side(chunks, k)])
    if any(chunk.value == ":" for chunk in chunks):
        chunks = _after_headings(_from_titles(chunks))
    chunks = spell_out_doings(chunks)
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Event):
            chunk.nominal = chunk.nominal or _named_doing(chunk, chunks, k)
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        if _told_by_nobody(chunks, k):
            found.append(teller_at(chunk.i))
        if isinstance(chunk, Place) and chunk.kind == "exit" and _clause_opener(chunks, k):
            found.append(Event("leave", chunk.i, chunk.i, "s"))  # "ego 3rd exit"
        found += touching(chunks, k)
        found += _of_the_same(chunks, k, found)
        found += _going(chunks, k) or [chunk]
    return found


def _before_its_side(chunks: list[Chunk], k: int) -> bool:
    """``50 % overlap, left``, ``offset 0.4 m, right``: a comma between a measure and its side."""
    if chunks[k].value != "," or value_at(chunks, k + 1) not in {"left", "right"}:
        return False
    measure, after = chunk_at(chunks, k - 1), chunk_at(chunks, k + 2)
    told = {measure.value, *(m.value for m in getattr(measure, "mods", []))}
    return (ends(after) or after.value == ",") and not told.isdisjoint({"percentage", "length"})


def _after_headings(chunks: list[Chunk]) -> list[Chunk]:
    """``From the left: a truck``, ``Ego: straight``: the colon adds nothing."""
    titles = [(chunks[begin:k], k) for begin, k in _headings(chunks)]
    dropped = {k for title, k in titles if _plays(chunks, k) or _adds_nothing(title, chunks, k)}
    return [c for k, c in enumerate(chunks) if k not in dropped]


def _headings(chunks: list[Chunk]) -> Iterator[tuple[int, int]]:
    """Where the words before each colon begin, after a mark or a comma, and where the colon is."""
    begin = 0
    for k, chunk in enumerate(chunks):
        if chunk.value == ":" and k > begin:
            yield begin, k
        if chunk.value == "," or ends(chunk):
            begin = k + 1


def _from_titles(chunks: list[Chunk]) -> list[Chunk]:
    """``Side road on the right: van``, ``Left lane: a bus``, ``Right: a taxi``: from there."""
    found: list[Chunk] = []
    done = 0
    for begin, k in _headings(chunks):
        place = _titled(chunks[begin:k])
        if (entry := _lane_entry(chunks[begin:k], chunks, k)) is not None:
            found += [*chunks[done:begin], *entry]
            done = chunks.index(entry[-1]) + 1 if entry[-1] in chunks else k + 2
        elif place is not None and isinstance(chunk_at(chunks, k + 1), Mention):
            word = "in" if place.kind == "lane" else "from"
            road = chunks[begin + 1 : k] if place.kind == "access" else []
            preposed = Term("prep", word, place.i, place.i)
            found += [*chunks[done:begin], preposed, place, *road]
            done = k + 1
    return [*found, *chunks[done:]]


def _lane_entry(title: list[Chunk], chunks: list[Chunk], k: int) -> list[Chunk] | None:
    """``Ego lane: left``, ``Lane of the van: lane 2``: in that one."""
    lanes = [c for c in title if isinstance(c, Place) and c.kind == "lane"]
    who = [c for c in title if isinstance(c, Mention)]
    told = chunk_at(chunks, k + 1 + (value_at(chunks, k + 1) == "in"))
    if len(title) > 1 + len(lanes) + len(who) or (len(lanes), len(who)) != (1, 1):
        return None
    which = told.mods if isinstance(told, Event) else [told] if isinstance(told, Term) else []
    if {m.value for m in which} & {"left", "right"}:
        told = Place(told.i, told.j, which, None, kind="lane")
    elif isinstance(told, Mention) and told.mod("num"):
        told = Place(told.i, told.j, [], lanes[0].head, kind="lane")
    if not isinstance(told, Place) or told.kind != "lane":
        return None
    who[0].possessor = False
    return [who[0], Term("prep", "in", told.i, told.i), told]


def _in_lanes(chunks: list[Chunk]) -> list[Chunk]:
    """``ego 100 km/h, right lane``, ``a van 80 km/h right lane``: in that lane."""
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Place) or chunk.kind != "lane" or not _bare_lane(chunk, chunks, k):
            found.append(chunk)
            continue
        told = [m for m in chunk.mods if m.cat == "quantity"]
        mods = chunk.mods[len(told) :]
        begins = mods[0].i if mods else chunk.i
        preposed = Term("prep", "in", begins, begins)
        found += [*told, preposed, replace(chunk, i=begins, mods=mods)]
    return found


def _bare_lane(lane: Place, chunks: list[Chunk], k: int) -> bool:
    before = chunk_at(chunks, k - 1)
    whose = isinstance(before, Mention) and not before.possessor
    bare = whose or value_at(chunks, k - 1) in {",", ":"}
    placed = cat_at(chunks, k + 1) in {"prep", "locus"}  # "lane right of it"
    last = k + 1 == len(chunks) or cat_at(chunks, k + 1) in {"punct", "conj"}
    plain = all(m.cat in {"dir", "quantity"} for m in lane.mods)
    which = placed or bool({"left", "right"} & set(lane.dirs))
    which = which or (lane.head is not None and lane.head.j > lane.head.i + 1)  # "middle lane"
    return plain and which and (last or placed or whose) and bare


def _titled(title: list[Chunk]) -> Place | None:
    first = title[0]
    simple = all(isinstance(c, Term | Place) for c in title)
    named = isinstance(first, Place) and first.kind in {"access", "lane", "side", "leg"}
    return first if simple and named and isinstance(first, Place) else None


def _told_by_nobody(chunks: list[Chunk], k: int) -> bool:
    """``Turned right and hit a van``, ``Was going straight``: whoever tells it did.

    So did who is "Following a truck at 80 km/h." or "Overtaking a bus. It swerves.", and so does
    who is told "Overtake the truck." or is "60 km/h, 20 m behind a van."
    """
    if k and value_at(chunks, k - 1) not in _MARKS:
        return False
    auxiliary = (cat_at(chunks, k), value_at(chunks, k)) == ("aux", "be")
    verb, following = chunk_at(chunks, k + auxiliary), chunk_at(chunks, k + auxiliary + 1)
    end = sentence_end(chunks, k)
    beyond = (m for m in range(k + auxiliary, end) if chunks[m].cat not in _MEASURED)
    there = next(beyond, end)
    placed = cat_at(chunks, there) == "locus" and isinstance(chunk_at(chunks, there + 1), Mention)
    if placed and value_at(chunks, end) != ":":
        others = [m for m in free_mentions(chunks[k:end]) if m.pronoun != "both"]
        return not others and not any(isinstance(c, Event) for c in chunks[k:end])
    if not isinstance(verb, Event) or verb.nominal or following.value == "by":
        return False
    if following.value == "of" and verb.form != "ed":  # "braking of the bus", not "backed out of"
        return False
    egos = any(isinstance(c, Mention) and c.is_ego for c in chunks)
    if verb.form == "base" or (verb.form == "s" and k == 0 and not egos):
        named = isinstance(following, NounPhrase) and following.mod(*ARTICLES) is not None
        named = named or (isinstance(following, Mention) and following.pronoun is not None)
        placed = following.cat in {"prep", "locus", "dir"} or following.value == "length"
        told = verb.form == "s" or verb.name in word_list("commanded")
        return told and (named or placed)
    past = verb.form == "ing" if auxiliary else verb.form == "ed"
    past = past or (verb.form == "ing" and _whole_sentence(chunks))
    undergone = verb.name in _UNDERGONE and not isinstance(following, Mention)
    return k == 0 and past and (auxiliary or not undergone)


def _whole_sentence(chunks: list[Chunk]) -> bool:
    """Whether the first sentence has no verb but participles ("braking of the bus:" has none)."""
    end = sentence_end(chunks, 0)
    if value_at(chunks, end) == ":":
        return False
    return all(c.nominal or c.form == "ing" for c in chunks[:end] if isinstance(c, Event))


def _plays(chunks: list[Chunk], k: int) -> bool:
    """``Ego: van, 50 km/h``: the noun after the colon says what the ego is."""
    role, actor = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
    alone = ends(chunk_at(chunks, k + 2)) or value_at(chunks, k + 2) == ","
    if not (isinstance(role, Mention) and isinstance(actor, Mention) and alone):
        return False
    if not (role.is_ego or role.label) or actor.is_ego or not ends(chunk_at(chunks, k - 2)):
        return False
    actor.same_as = role
    return True


def _adds_nothing(title: list[Chunk], chunks: list[Chunk], k: int) -> bool:
    first, following = title[0], chunk_at(chunks, k + 1)
    way = (following.cat, following.value) in _WAYS
    named = isinstance(first, Mention) and not any(isinstance(c, Event) for c in title)
    return way and named


def _named_doing(event: Event, chunks: list[Chunk], k: int) -> bool:
    """``Cut-in from the left``, ``Cut-in test: ego 100 km/h``: a doing, as yet of nobody."""
    bare = event.form == "base" and event.name in _NAMED
    placed = cat_at(chunks, k + 1) in {"prep", "locus", "manner", "dir"}
    after = k + 1 + isinstance(chunk_at(chunks, k + 1), Thing)  # "scenario"
    listed = value_at(chunks, after) in {",", ":", "."}  # "Cut-in, ego 100 km/h, target …"
    opens = ends(chunk_at(chunks, k - 1)) or noted(event, k, chunks)
    return bare and (placed or listed) and opens


def _going(chunks: list[Chunk], k: int) -> list[Chunk]:
    """``ego straight``, ``ego in reverse``: goes there, backwards; ``parked van left``: stands.

    So do ``van from the left lane into ours``, ``van towards us``.
    """
    way, places = chunks[k], (c for c in chunks[k + 1 : k + 3] if isinstance(c, Place))
    into = way.value == "into" and any(place.kind == "lane" for place in islice(places, 1))
    if into or "faces" in getattr(way, "data", ()):
        return [Event("move", way.i, way.i, "s"), way] if _clause_opener(chunks, k) else []
    if not isinstance(way, Term) or (way.cat, way.value) not in _WAYS:
        return []
    following, who = chunk_at(chunks, k + 1), _clause_opener(chunks, k)
    free = ends(following) or value_at(chunks, k + 1) == "," or cat_at(chunks, k + 1) in _AFTER
    if not free or value_at(chunks, k + 1) == "of" or who is None:
        return []
    if any(m.cat == "state" for m in who.mods):
        return [Term("prep", "in", way.i, way.i), Place(way.i, way.j, [way], None, kind="side")]
    return [Event("move", way.i, way.j, "s", mods=[way], data={"drives": True})]


def _of_the_same(chunks: list[Chunk], k: int, before: list[Chunk]) -> list[Chunk]:
    """``A van follows us. Brakes hard.``: whom the sentence before is about.

    ``Struck in the left side by a van.`` was the ego, if there is one.
    """
    verb = chunks[k]
    if not isinstance(verb, Event) or verb.nominal:
        return []
    last = next((c for c in reversed(before) if c.cat not in {"manner", "conj"}), NOTHING)
    if not ends(last):
        return []
    told = [free_mentions(before[begin:end]) for begin, end in sentences(before)]
    about = next((named[0] for named in reversed(told) if named), None)
    it = Mention(verb.i, verb.i, [], None, pronoun="it", same_as=about)
    if verb.name == "collide" and verb.form in {"ed", "base"} and by_follows(chunks, k):
        others = free_mentions(chunks[k : sentence_end(chunks, k)])
        named = [c for c in chunks if isinstance(c, Mention)]
        by = next((m for m in named if m.i > verb.i), it)
        egos = any(m.is_ego for m in named) or bool(by.pronoun) or by.opened_by("def")
        egos = about is None or (egos and not by.is_ego)
        whom = teller_at(verb.i) if egos else it
        return [whom, Term("aux", "be", verb.i, verb.i)] if not others else []
    return [it] if about is not None and verb.form == "s" and last.value in _STOPS else []


def _clause_opener(chunks: list[Chunk], k: int) -> Mention | None:
    """The participant with which the clause before chunk ``k`` begins, if it has no verb."""
    for m in range(k - 1, -1, -1):
        chunk = chunks[m]
        if isinstance(chunk, Mention):
            if cat_at(chunks, m - 1) not in GOVERNING:
                return chunk if _introduced(chunks, m - 1) else None
        elif isinstance(chunk, Event) or chunk.cat not in _WITHIN:
            return None
    return None


def _introduced(chunks: list[Chunk], m: int) -> bool:
    """Whether a clause begins after chunk ``m``."""
    before = chunk_at(chunks, m)
    parted = before.value in _SEPARATORS and not isinstance(chunk_at(chunks, m - 1), Event)
    return parted or ends(before)
