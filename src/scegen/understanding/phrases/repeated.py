"""What is named again: "that lane", "the left one", "travelling there", "the truck in it"."""

from dataclasses import replace

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, GOVERNING, cat_at, chunk_at, value_at
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_SIDES = frozenset({"left", "right", "opposite"})
_CROSSED = frozenset({"crosswalk", "road", "access", "junction"})
_WHICH = frozenset({"which", "whom"})
_ROADS, _OUT_OF = frozenset({"access", "road", "leg"}), frozenset({"of", "from"})
_COME_FROM = frozenset({"lane", "leg", "road", "access", "side"})


def repeat(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """Gives "that lane", "from that side" and "there" the directions of what was named last.

    Returns:
        The chunks, "there" replaced by "in" and the lane that it stands for.
    """
    if not any(token.low in word_list("back_again") for token in tokens):
        return chunks
    last: dict[str, Place] = {}
    found: list[Chunk] = []
    for k, chunk in enumerate(chunks):
        before = chunk_at(found, len(found) - 1)
        if isinstance(chunk, Term) and _there(chunk, before, tokens):
            came = value_at(found, len(found) - 1) in _OUT_OF
            place = last.get("anywhere" if came else "lane")
            if place is not None:
                found += [] if came else [Term("prep", "in", chunk.i, chunk.j)]
                found.append(replace(place, i=chunk.i, j=chunk.j, mods=list(place.mods)))
                continue
        if isinstance(chunk, Mention) and "exit" in last and _taken(chunk, before):
            label = [m for m in chunk.mods if m.cat == "label"]
            chunk = replace(last["exit"], i=chunk.i, j=chunk.j, mods=label)  # noqa: PLW2901
        across = isinstance(before, Event) and before.name == "cross" and not before.nominal
        if "crossed" in last and across and _is_it(chunk):  # "…; a cyclist rides across it"
            chunk = replace(last["crossed"], i=chunk.i, j=chunk.j)  # noqa: PLW2901
        if isinstance(chunk, Mention) and "one" in last:
            one = last.pop("one")  # "one leg hidden from the other"
            other = chunk.pronoun == "other"
            chunk = replace(one, i=chunk.i, j=chunk.j, mods=chunk.mods) if other else chunk  # noqa: PLW2901
        if value_at(chunks, k) in BOUNDARIES | {","}:
            _remember_road(found, last)
        if "road" in last and _is_it(chunk) and value_at(found, len(found) - 1) in _OUT_OF:
            chunk = replace(last["road"], i=chunk.i, j=chunk.j)  # noqa: PLW2901
        found.append(chunk)
        _remember_goal(chunk, found, last)
        if isinstance(chunk, Place):
            _remember(chunk, last, tokens)
            _remember_beside(chunk, k, chunks, last)
    return found


def which_is_it(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``a parked van, from behind which a boy runs``: "…, and from behind it a boy runs".

    So is ``a side road from which a bus turns``; ``into a road that a boy is crossing`` is
    "into a road. A boy is crossing the road".
    """
    found: list[Chunk] = []
    known: Mention | Thing | None = None
    place: Place | None = None
    crossed: Place | None = None
    for k, chunk in enumerate(chunks):
        opens = k
        while cat_at(found, opens - 1) in GOVERNING:
            opens -= 1
        locus = any(c.cat == "locus" for c in found[opens:])
        its = tokens[chunk.i].low in _WHICH and isinstance(chunk_at(chunks, k + 1), Mention)
        led = value_at(found, len(found) - 1)  # "from which"; "across which", of one turned into
        it: Chunk | None = None
        last = chunk_at(found, opens - 1)
        if its and locus and known is not None and (last is known or last.value == ","):
            same = known if isinstance(known, Mention) else None
            it = Mention(chunk.i, chunk.j, [], None, pronoun="it", same_as=same)
        elif its and place is not None and (led == "from" or (place.arm and led == "in")):
            it = replace(place, i=chunk.i, j=chunk.j)
        if it is not None:
            at = found[opens].i
            joint = [Term("punct", ",", at, at), Term("conj", "and", at, at)]
            found[opens:] = [*joint, *found[opens:], it]
            continue
        if place is not None and _crossed_there(chunks, k, place):
            found.append(Term("punct", ".", chunk.i, chunk.i))
            crossed = place if isinstance(chunk_at(chunks, k + 1), Mention) else None
            found += [] if crossed is place else [replace(place, i=chunk.i, j=chunk.j)]
            continue
        known = chunk if isinstance(chunk, Mention | Thing) else known
        place = chunk if isinstance(chunk, Place) else None if chunk is known else place
        found.append(chunk)
        if crossed is not None and isinstance(chunk, Event):
            found.append(replace(crossed, i=chunk.j, j=chunk.j))
            crossed = None
    return found


def _crossed_there(chunks: list[Chunk], k: int, road: Place) -> bool:
    """``turns into a road that a boy crosses``, ``…, where a boy crosses``."""
    rel = cat_at(chunks, k) == "rel" or value_at(chunks, k) == "where"
    right_behind = road in (chunk_at(chunks, k - 1), chunk_at(chunks, k - 2))
    verb = next((c for c in chunks[k + 1 :] if isinstance(c, Event)), None)
    crosses = verb is not None and verb.name in {"cross", "walk"}
    return rel and right_behind and road.arm is not None and crosses


def _remember(chunk: Place, last: dict[str, Place], tokens: list[Token]) -> None:
    """Keeps a place by what may mean it again; one that is pointed at gets the sides of that."""
    kind = "side" if chunk.kind in {"side", "direction"} else chunk.kind
    if kind in _COME_FROM and _SIDES & set(chunk.dirs):
        last["anywhere"] = chunk
    if kind in _CROSSED:
        last["crossed"] = chunk
    if kind == "exit":
        last[kind] = chunk
    if chunk.has("num", "one"):
        last["one"] = chunk
    lane = last.get("lane")
    points = chunk.mods and tokens[chunk.mods[0].i].low in word_list("pointing")
    if kind == "lane" and points and lane is not None and not chunk.dirs:
        chunk.mods = [*chunk.mods, *lane.ways]
    elif kind == "side" and points and "side" in last and not chunk.dirs:
        chunk.mods = [*chunk.mods, *last["side"].mods]
    elif (kind == "lane" and chunk.dirs) or (kind == "side" and _SIDES & set(chunk.dirs)):
        kept = [m for m in chunk.mods if kind == "lane" or m.cat == "dir"]
        last[kind] = replace(chunk, mods=kept)


def _remember_beside(lane: Place, k: int, chunks: list[Chunk], last: dict[str, Place]) -> None:
    """``the lane on its left``: for "that lane", said later on."""
    side = chunk_at(chunks, k + 2) if cat_at(chunks, k + 1) == "prep" else None
    if isinstance(side, Place) and lane.kind == "lane" and side.kind == "side":
        sides = [m for m in side.ways if m.value in _SIDES]
        beside = Term("dir", "adjacent", lane.i, lane.i)
        last["lane"] = replace(lane, mods=[*lane.mods, beside, *sides]) if sides else lane


def _remember_goal(goal: Chunk, before: list[Chunk], last: dict[str, Place]) -> None:
    """``the ego changes lanes to the left``, ``moves left``: for "that lane", said later on."""
    at = len(before) - (3 if value_at(before, len(before) - 2) == "to" else 2)
    verb = chunk_at(before, at)
    who = next((c for c in reversed(before[: max(at, 0)]) if isinstance(c, Mention)), None)
    moves = isinstance(verb, Event) and verb.name in MOVING | {"lane_change"}
    ways = [goal] if isinstance(goal, Term) else goal.ways if isinstance(goal, Place) else []
    sides = [m for m in ways if m.value in {"left", "right"}]
    aside = not isinstance(goal, Place) or goal.kind == "side"
    if who is not None and who.is_ego and moves and aside and sides:
        last["lane"] = Place(goal.i, goal.j, sides, None, kind="lane")


def _remember_road(before: list[Chunk], last: dict[str, Place]) -> None:
    """``there is a side road on the left``, where nobody is yet: for "comes out of it"."""
    ends = [n for n, c in enumerate(before) if c.value in BOUNDARIES | {","}]
    part = before[ends[-1] + 1 if ends else 0 :]
    roads = [c for c in part if isinstance(c, Place) and c.kind in _ROADS]
    sides = [m for c in part if isinstance(c, Place) for m in c.ways if m.value in _SIDES]
    if len(roads) == len(sides) == 1 and not any(isinstance(c, Mention) for c in part):
        last["road"] = replace(roads[0], mods=[*roads[0].mods, *sides])


def _taken(mention: Mention, before: Chunk) -> bool:
    """``takes the first exit, the bus takes the second``: an exit, too."""
    taken = isinstance(before, Event) and before.name in {"leave", "use"}
    return mention.pronoun == "ordinal" and (before.cat == "prep" or taken)


def _is_it(chunk: Chunk) -> bool:
    return isinstance(chunk, Mention) and chunk.pronoun == "it" and not chunk.possessor


def _there(word: Term, before: Chunk, tokens: list[Token]) -> bool:
    """``travelling there``, ``but there it brakes``, ``from where``: not "there" at the start."""
    low = tokens[word.i].low
    if low not in {"there", "where"} or word.j - word.i != 1:
        return False
    again = isinstance(before, Event | Mention) or before.cat == "conj"
    return before.value in _OUT_OF or (again and low == "there")


_LANES = frozenset({"lane", "ramp"})  # "the right lane ends"
_ASIDE = frozenset({"left", "right", "adjacent"})
_JOINTS = frozenset({("from", "to"), ("from", "into"), ("in", "and")})
_OF_A_LANE = 3
"""Phrases: the side, "of", the lane."""
MOVING = frozenset({"move", "swerve", "try", "dash", "enter", "cross", "sharp_turn", "pull_out"})


def lanes_meant(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """The chunks with a lane in place of each "one" and "it" that means one."""
    found: list[Chunk] = []
    named: Place | None = None
    chunks = _within_a_lane(chunks, tokens)
    for k, chunk in enumerate(chunks):
        lane = _lane(chunk, k, chunks, named, tokens)
        if lane is not None and found[-1:] and found[-1].i == lane.i:
            found.pop()  # "the left" of "the left one"
        found.append(lane or chunk)
        part = found[-3:-2] == [named] and found[-2].value == "of"
        if isinstance(found[-1], Place) and found[-1].kind in _LANES and not part:
            named = found[-1]
        elif isinstance(chunk, Event) and tokens[chunk.j - 1].base == "lane":
            named = Place(chunk.j - 1, chunk.j, [], None, kind="lane")  # "leaves its lane"
    return found


def _within_a_lane(chunks: list[Chunk], tokens: list[Token]) -> list[Chunk]:
    """``on the right-hand side of the lane``, ``to the left of its lane``: in that lane."""
    found: list[Chunk] = []
    after = 0
    for k, chunk in enumerate(chunks):
        lane = _whole(k, chunks) if isinstance(chunk, Place) else None
        if isinstance(chunk, Place) and lane is not None and _is_within(chunk, lane, k, chunks):
            where = tokens[chunk.i - 1].low
            keeps = isinstance(chunk_at(chunks, k - 2), Event) and lane.has("possessive", "its")
            if where in word_list("inside") or (where == "to" and keeps):  # not "1 m to the right"
                found.append(Place(chunk.i, lane.j, chunk.ways, None, kind="within_lane"))
                after = k + _OF_A_LANE
        if k >= after:
            found.append(chunk)
    return found


def _is_within(side: Place, lane: Place, k: int, chunks: list[Chunk]) -> bool:
    """One side of one lane, of which no more is said."""
    several = lane.has("num") or lane.plural
    sided = side.kind == "side" and bool({"left", "right"} & set(side.dirs))
    more = isinstance(chunk_at(chunks, k + _OF_A_LANE), Place)
    return sided and not several and not more and side.i > 0


def _lane(
    chunk: Chunk, k: int, chunks: list[Chunk], named: Place | None, tokens: list[Token]
) -> Place | None:
    before, word, whole = chunk_at(chunks, k - 1), value_at(chunks, k - 1), _whole(k, chunks)
    if isinstance(chunk, Term) and chunk.cat == "det" and cat_at(chunks, k + 1) == "prep":
        head = Term("place", "lane", chunk.i, chunk.j)  # "into that of the ego"
        return Place(chunk.i, chunk.j, [], head, kind="lane") if named is not None else None
    if isinstance(chunk, Place) and chunk.kind in {"side", "middle"}:
        bare = chunk.head is None and _sided(chunk)
        named_side = chunk.has("det") and (bare or (chunk.kind == "middle" and whole is None))
        part = whole is not None or _to_another(k, chunks)
        return _as_lane(chunk, chunk) if named_side and part and word not in {"to", "on"} else None
    if not isinstance(chunk, Mention):
        return None
    used = isinstance(before, Event) and before.name == "use"
    over = isinstance(before, Event) and tokens[before.j - 1].low == "into"
    over = over and tokens[chunk.i - 2].base in word_list("shifting")  # "a van moves into it, too"
    if chunk.pronoun == "one":
        led = before.cat == "prep" and value_at(chunks, k + 1) in {"in", "to"}
        aside = chunk_at(chunks, k + 2) if led else before  # "for the one on the left"
        side = aside if isinstance(aside, Place) and aside.kind in {"side", "middle"} else chunk
        middle = isinstance(side, Place) and side.kind == "middle"  # "of three, in the middle one"
        meant = (whole or named) is not None and (middle or _sided(side))
        if used and chunk.has("dir", "opposite"):
            return _as_lane(chunk, chunk)  # "leaves its lane and uses the oncoming one"
        alone = middle or side.head in (None, chunk.head)
        return _as_lane(side if side is before else chunk, chunk) if meant and alone else None
    if chunk.pronoun == "it" and named is not None and (used or over or word == "in"):
        return replace(_as_lane(chunk, chunk), mods=named.mods)
    return None


def _to_another(k: int, chunks: list[Chunk]) -> bool:
    """``from the left to the right lane``, ``in the middle and in the right lane``."""
    joint = (value_at(chunks, k - 1), value_at(chunks, k + 1))
    again = joint == ("in", "and") and value_at(chunks, k + 2) == "in"
    lane = chunk_at(chunks, k + 3 if again else k + 2)
    return joint in _JOINTS and isinstance(lane, Place) and lane.kind == "lane"


def _as_lane(first: NounPhrase, last: NounPhrase) -> Place:
    middle = isinstance(first, Place) and first.kind == "middle"
    data = {"ranked": True, "rank": "middle"} if middle else {}
    head = Term("place", "lane", last.j - 1, last.j, data=data)
    return Place(first.i, last.j, list(first.mods), head, kind="lane")


def _sided(noun: NounPhrase) -> bool:
    return noun.has("dir", *_ASIDE)


def _whole(k: int, chunks: list[Chunk]) -> Place | None:
    """``of two lanes``: the lanes of which it is one."""
    lanes = chunk_at(chunks, k + 2) if value_at(chunks, k + 1) == "of" else None
    return lanes if isinstance(lanes, Place) and lanes.kind == "lane" else None
