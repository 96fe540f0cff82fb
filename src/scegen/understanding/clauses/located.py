"""Where words put a noun: those after it, or before its clause; on which side a place lies."""

from typing import TypeGuard

from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.clauses.state import State
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import (
    GOVERNING,
    behind_insertion,
    cat_at,
    chunk_at,
    sentence_end,
    value_at,
)


def is_it(noun: object) -> TypeGuard[Mention]:
    """Whether a noun is "it" or "him"."""
    return isinstance(noun, Mention) and noun.pronoun in {"it", "him"}


def loci_of(mention: Mention) -> set[str]:
    """Where a noun is said to be: "the car behind" is not "the car in front".

    "Hits the car from behind" tells how it is done, and not where the car is; "in front of the
    lead vehicle stands a van" makes the van no lead vehicle.
    """
    told = (p for p in mention.pps if not (p.predicate or p.outer == "from" or _by_another(p)))
    loci = {p.value for p in told if p.word.cat == "locus"}
    loci |= {"behind"} if "trails" in mention.marks else set()
    return loci | (mention.marks & {"elsewhere"})


def _by_another(prep: Prep) -> bool:
    """``ahead of the van stands a bus``: not as the ego sees it."""
    by = prep.who.entities if prep.fronted and prep.who is not None else []
    return bool(by) and not any(e.ego for e in by)


def as_the_ego_sees(mention: Mention) -> bool:
    """``the car ahead``, ``the car ahead of the ego``: placed by nobody but the ego."""
    by = [p.who is not None and p.who.is_ego for p in mention.pps if p.target is not None]
    return all(by) and all(p.word.cat == "locus" for p in mention.pps)


def own_lane(event: Event, prep: Prep) -> bool:
    """``the ego follows a van in the right lane``: that is the ego's lane, too."""
    lane = prep.names("lane") and prep.value == "in"
    ego = any(e.ego for e in event.doers)
    return lane and ego and event.name in {"follow", "tailgate"} and not event.passive


_BESIDE_THE_ROAD = frozenset({"access", "bus_stop", "parking", "feature"})
_BY_ROAD = frozenset({"from", "into"})
_LEADING = frozenset({"in", "into", "to", "for"})


def side_of_place(noun: NounPhrase, state: State) -> bool:
    """``a driveway on the right``, ``the lane to its right``: the side at which it lies.

    Returns:
        Whether it is the side of the place before it.
    """
    if not isinstance(noun, Place) or noun.kind != "side":
        return False
    place = state.at(-2 if noun.owner is None else -3)  # "the lane to the ego's right"
    if isinstance(place, Thing) and set(noun.dirs) & {"left", "right"}:
        if place.prep is None or place.prep.cat != "locus":
            return place.has("quantity")  # "with 50 % overlap on the left side"
    elif isinstance(place, Place):
        arm = place.kind in _ROADS and place.stands_after(*_BY_ROAD) and place.owner is None
        arm = arm and bool({"left", "right"} & set(noun.dirs)) and noun.stands_after("in", "to")
        beside = place.kind in _BESIDE_THE_ROAD and not noun.stands_after("from")
        beside = beside or arm or _lane_beside(place, noun, state)
        if not beside or (noun.head is None and "opposite" in noun.dirs):  # "… direction"
            return False
        place.j = noun.j
    else:
        return False
    place.mods = [*place.mods, *(m for m in noun.mods if m.cat == "dir")]
    return True  # "a driveway on the right", "from behind a hedge on the right"


def _lane_beside(lane: Place, side: Place, state: State) -> bool:
    """``in the lane to the right of the bus``: no movement to the right."""
    along = lane.kind in {"lane", "bike_lane", "sidewalk", "shoulder"}
    ways = _LEADING | ({"from", "of"} if lane.kind == "lane" else set())
    within = along and (lane.prep is None or lane.prep.value in ways)
    if not within or not set(side.dirs) & {"left", "right"}:
        return False
    whose, who = state.at(1), state.at(2)
    owned = whose.value == "of" and isinstance(who, Mention)
    if owned and isinstance(who, Mention):
        lane.beside = who
    verb = state.at(-3)  # "enters the lane to the left"
    gone_to = isinstance(verb, Event) and verb.name != "leave"
    there = lane.kind == "lane" and (gone_to or lane.prep is not None or "adjacent" in lane.dirs)
    there = there and side.stands_after("in", "to")
    there = there and lane.owner is None and not lane.has("possessive")
    return owned or there or side.has("possessive")


_SIDES = frozenset({"side", "direction", "lane", "sidewalk", "shoulder", "bike_lane", "access",
                    "parking", "bus_stop", "signal", "stop_sign", "stop_line", "ramp",
                    "yield_sign"})  # fmt: skip
_ASIDE_OF_THE_ROAD = frozenset({"side", "sidewalk", "shoulder", "bus_stop", "parking"})
RESTING = frozenset({("park", "ed"), ("park", "ing"), ("wait", "ing"), ("stop", "ed")})
"""How who stands is described: "behind a bus standing at a stop"."""
_ROADS = frozenset({"leg", "road"})
"""Roads, if it is said which one: "from the right arm", "on the road that it turns into"."""


def opens_clause(state: State) -> bool:
    """Whether the phrase that begins here says where the participant after it is.

    "Behind the ego is a truck", "from the left comes a bus, and from the right a van".
    """
    begins = not state.events and state.candidate is None and not state.mentions
    road = isinstance(state.anchor, Place) and state.anchor.kind == "highway"
    begins = begins and (state.anchor is None or road)  # "a kiosk on the left hides a child"
    opened = bool(state.fronted) and not state.events and state.candidate is None
    lane = state.at(1)
    named = isinstance(lane, Place) and lane.kind in {"lane", "side"} and bool(lane.dirs)
    known = any(who.is_ego or who.pronoun for p in state.fronted[-1:] if (who := p.who))
    begins |= opened and named and (known or "," in state.between)  # "beside it in the left lane …"
    joins = {"conj", "sub", ","} & state.between and "or" not in state.between
    inserted = {"conj", ","} <= state.between  # "a child and, behind the child, a bus"
    listed = "conj" in state.between
    waits = state.candidate is not None and not state.candidate_done  # for its verb
    complete = not waits or bool(state.events) or state.being is not None
    if not begins and not (joins and (inserted or complete)):
        return False
    chunks = state.chunks
    m = _phrase_end(state.k, chunks)
    if m is None:
        return False
    while cat_at(chunks, m) in GOVERNING and (further := _phrase_end(m, chunks)) is not None:
        m = further  # "in the left lane beside the ego a van drives"
    # or in brackets, "ahead of the ego (40 km/h) a van", or: "behind a bus that is slow, the ego"
    rest = range(m, sentence_end(chunks, m))
    if value_at(chunks, m) == "(":
        m = next((n + 1 for n in rest if value_at(chunks, n) == ")"), m)
    elif cat_at(chunks, m) == "rel":
        m = next((n for n in rest if value_at(chunks, n) == ","), m)
    if value_at(chunks, m) == ",":
        if not (begins or listed or "sub" in state.between):
            return False
        m = behind_insertion(chunks, m + 1)
    m += value_at(chunks, m) == "mild"  # "there stands"
    inverted = _stands_before_subject(chunks, m)
    m += cat_at(chunks, m) in {"aux", "copy"} or inverted
    # "50 m ahead of the ego lies a pedestrian crossing"
    return isinstance(chunk_at(chunks, m), NounPhrase if inverted else Mention)


def _stands_before_subject(chunks: list[Chunk], m: int) -> bool:
    verb = chunk_at(chunks, m)
    finite = isinstance(verb, Event) and not verb.nominal and verb.form != "ing"
    return finite and isinstance(verb, Event) and verb.name in word_list("before_their_subject")


def _phrase_end(k: int, chunks: list[Chunk]) -> int | None:
    """Index after a phrase of place that begins at chunk ``k``; None if none does."""
    first = chunks[k]
    m = k + 1
    locus = first.cat == "locus"
    while cat_at(chunks, m) in GOVERNING:
        locus |= cat_at(chunks, m) == "locus"
        m += 1
    target = chunk_at(chunks, m)
    placed = isinstance(target, Place) and (
        target.kind in _SIDES
        or (target.kind in _ROADS and (target.arm or target.dirs or _side_after(chunks, m + 1)))
    )
    whence = first.value == "from" and value_at(chunks, m) == ","  # "from behind, a van comes up"
    bare = "bare" in getattr(first, "data", ())  # "in front, a van"
    whence = whence or (bare and value_at(chunks, m) == ",")
    if locus and (whence or _stands_before_subject(chunks, m)):
        return m  # "from ahead comes a van"
    owned = chunk_at(chunks, m + 1)
    sided = isinstance(target, Mention) and target.possessor and isinstance(owned, Place)
    if not placed and not (locus and isinstance(target, Mention | Thing)) and not sided:
        return None
    m += 1 + bool(sided)  # "from the ego's left a van comes"
    parked = chunk_at(chunks, m)
    m += isinstance(parked, Event) and (parked.name, parked.form) in RESTING
    while value_at(chunks, m) == "of" and isinstance(chunk_at(chunks, m + 1), Mention | Place):
        m += 2
    return m


def _side_after(chunks: list[Chunk], m: int) -> bool:
    side = chunk_at(chunks, m + 1)
    sided = isinstance(side, Place) and side.kind in _ASIDE_OF_THE_ROAD
    return sided and value_at(chunks, m) in {"in", "to"}


def place_in_front(mention: Mention, state: State) -> None:
    """Gives the phrases that opened the clause to the participant that they place."""
    mention.pps += [p for p in state.fronted if p.outer != "from" and p.value != "due"]


def who_comes(chunks: list[Chunk], events: list[Event]) -> None:
    """``hits a cyclist at 15 km/h, coming from the left``: the ego comes from no own side."""
    for event in events:
        coming = (event.lemma, event.form) == ("come", "ing") and not event.finite
        ego = bool(event.subject) and all(m.is_ego for m in event.subject)
        sides = [p.place.dirs for p in event.pps if p.value == "from" and p.place is not None]
        if not (coming and ego and any({"left", "right"} & {*dirs} for dirs in sides)):
            continue
        named = [c for c in chunks if isinstance(c, Mention) and c.i < event.i and c.heads]
        others = [m for m in named if m.i > event.subject[0].i and not (m.is_ego or m.possessor)]
        event.subject = others[-1:] or event.subject
