"""Attaches prepositional phrases: to the noun right before them, or to the verb."""

from __future__ import annotations

from scegen.understanding.chunks import (
    Chunk,
    Event,
    Mention,
    NounPhrase,
    Place,
    Prep,
    Thing,
    Word,
)
from scegen.understanding.clauses.located import is_it
from scegen.understanding.clauses.state import State
from scegen.understanding.phrases.lookahead import GOVERNING, behind_insertion, chunk_at, value_at

_SIDES = frozenset({"side", "direction", "lane", "sidewalk", "shoulder", "bike_lane", "access",
                    "parking", "bus_stop"})  # fmt: skip
_ROADS = frozenset({"leg", "road"})
"""Roads, if it is said which one: "from the right arm", "on the road that it turns into"."""
_MEETING = frozenset({"move", "approach", "appear", "locate", "wait", "stop", "park", "hide",
                      "walk", "cross", "follow", "brake", "slow"})  # fmt: skip
"""Verbs that may stand before their subject ("from the left comes a bus")."""
_PASSING = frozenset({"overtake", "pass", "undertake"})
_MET = _PASSING | {"collide"}
_ASIDE = frozenset({",", "unknown", "inert"})


def preposition(word: Word, state: State) -> None:
    """Opens a phrase; what it governs comes next."""
    before = state.prep
    if before is not None and (word.cat != "locus" or before.word.cat == "locus"):
        release(state)
    outer = state.prep.value if state.prep is not None else None
    fronted = (before is not None and before.fronted) or _opens_clause(state)
    state.prep = Prep(word, None, outer, _noun_before(word, state), fronted)


def _noun_before(word: Word, state: State) -> Mention | None:
    """The noun right before a preposition, or whom that one places if it is known already."""
    near = state.last_pp or state.anchor
    if state.between or not isinstance(near, Mention):
        return None
    since = (c for c in state.chunks if near.j <= c.i < word.i)
    if any((c.cat, c.value) == ("quantity", "percentage") for c in since):
        return None  # "hits the rider at 20 % of its width from the left edge": where, not which
    if near is not state.last_pp and is_it(near) and not near.mods and word.value == "in":
        return None  # "passes it in the left lane": where it is done
    told = near.pronoun is not None or near.is_me
    placed = _placed_by(near, state) if told else None
    return placed or near  # "my friend in front of me on his moped": the friend is on it, not I


def _placed_by(landmark: Mention, state: State) -> Mention | None:
    """The noun that is said to be behind, beside, … another one."""
    for mention in reversed(state.mentions):
        if any(p.target is landmark and p.word.cat == "locus" for p in mention.pps):
            return mention
    return None


def release(state: State) -> None:
    """A preposition without a target: "the car ahead", "positioned behind on the right"."""
    if state.prep is not None:
        if state.prep.word.cat == "locus":
            attach(state.prep, state)
        state.prep = None


def _counts_lanes(prep: Prep, before: Prep | None) -> bool:
    """``on a road with two lanes in each direction, a car …``: so many lanes, nobody is there."""
    lanes = before.place if before is not None else None
    return (
        prep.names("direction")
        and lanes is not None
        and lanes.kind == "lane"
        and lanes.j == prep.word.i
    )


def _before(prep: Prep, state: State) -> Prep | None:
    """The phrase before; ``behind or beside it`` are both of the same one."""
    last = state.last_prep
    both = last is not None and last.word.cat == prep.word.cat == "locus"
    if both and last is not None and "or" in state.between and prep.word.i - last.word.j == 1:
        last.target = last.target or prep.target
    return last


def attach(prep: Prep, state: State) -> None:
    """Gives a phrase to who follows it, the noun right before it, the verb, or who acts."""
    before, state.last_prep = _before(prep, state), prep
    cause = prep.value == "due" and not state.events and state.candidate is None
    if prep.fronted or cause:  # "because of a parked van the ego does not see the child"
        _of_the_one_listed(prep, state)
        if not _counts_lanes(prep, before):
            state.fronted.append(prep)
        return
    prep.on_mention = _noun(prep, state)
    if prep.on_mention is not None:
        prep.on_mention.pps.append(prep)
    described = None if _astern(prep, state) else _described(prep, state) or _also_there(state)
    if described is not None and not _of_who_acts(prep, described, state):
        described.pps.append(prep)
        prep.predicate = "rel" not in state.between
    elif state.events and (prep.on_mention is None or state.anchor is not state.candidate):
        _told_of(prep, state).pps.append(prep)
    elif prep.on_mention is None and state.candidate is not None:
        state.candidate.pps.append(prep)


def _noun(prep: Prep, state: State) -> Mention | None:
    """The noun to which a phrase belongs; None: none."""
    whom = prep.on_mention
    if whom is not None and whom.whole is not None and whom.whole.j == prep.word.i:
        whom = prep.on_mention = whom.whole  # "one of the two cars ahead": both are
    head = _head_of(prep, state)
    if prep.value == "due" and state.events:
        return None  # "a boy whom I can't see because of a van"
    if whom is None:
        return head
    if _of_who_acts(prep, whom, state) or _came_from(prep, whom, state) or _astern(prep, state):
        return None
    if head is None and whom.is_landmark and prep.value == "from" and state.events:
        # "falls onto the road ahead of the ego from the pavement"; the ego itself comes from no
        # side of its own: "turns in front of a car from the left"
        own = any(m.is_ego for m in state.events[-1].subject) and _from_a_side(prep)
        return whom if own else None
    return head or whom


def _astern(prep: Prep, state: State) -> bool:
    """``hits the ego, which is stationary, from behind``: it comes from there, not the ego."""
    behind = (prep.outer, prep.value) == ("from", "behind")
    return behind and "," in state.between and bool(state.events)


def _told_of(prep: Prep, state: State) -> Event:
    """``passes a van, which does 60 km/h, on the left``: the comma closes what is put in.

    So it does in "steps out from behind a van parked there, 10 m ahead of the ego".
    """
    closed = "," in state.between and (prep.names("side") or prep.outer == "from")
    last = state.events[-1]
    if "," in state.between and prep.who is not None and last.name == "park" and not last.finite:
        return next((e for e in reversed(state.events) if e.finite), last)
    around = (e for e in reversed(state.events) if not e.embedded and e.name in _MET)
    return next(around, last) if closed and last.embedded else last


def _of_the_one_listed(prep: Prep, state: State) -> None:
    """``ahead of the ego: a van and, 10 m in front of it, a bus``: in front of the van."""
    listed = {"conj", ","} <= state.between and not state.events
    if listed and state.waiting is state.anchor and is_it(prep.target):
        prep.target.same_as = state.waiting


def _of_who_acts(prep: Prep, whom: Mention, state: State) -> bool:
    """Whether a phrase behind a noun says where who acts is, or on which side it is done.

    "In the lane of the ego ahead of it", "follows a van, 20 m behind it", "is overtaken by a van
    on the left".
    """
    verb, place = state.last, prep.place
    if place is not None:
        if verb is None or prep.value != "in":
            return False
        past = (p for p in verb.pps if p.leads_past)
        stands = any(m.cat == "state" for m in whom.mods)
        if place.kind == "side" and not stands and any(p.target is whom for p in past):
            return True  # "moves past a van on the left", but "past a parked van on the left"
        if verb.name not in _PASSING:  # "is hit by a van in its left side"
            return verb.name == "collide" and verb.passive and place.kind == "side"
        # "passes a truck in the left lane"; who is in the right lane is passed
        lane = verb.object is whom and place.kind == "lane" and "left" in place.dirs
        return lane or (verb.passive and place.kind == "side")
    if prep.who is None or prep.who.pronoun is None or prep.word.cat != "locus":
        return False
    if whom.stands_after("of"):
        return True
    followed = verb is not None and (verb.object is whom or whom.pronoun == "both")
    return followed and verb is not None and verb.name == "follow" and prep.value == "behind"


def _came_from(prep: Prep, whom: Mention, state: State) -> bool:
    """``steps out from behind a van 20 m in front of the ego``: not the van is there."""
    phrases = state.last.pps if state.last is not None and prep.who is not None else []
    far = any(c.j == prep.word.i and c.cat == "quantity" for c in state.chunks)
    out = [p for p in phrases if p.outer == "from" or (far and p.value == "between")]
    return any(p.target is whom and p.value in {"behind", "ahead", "between"} for p in out)


def _from_a_side(prep: Prep) -> bool:
    return prep.names("side", "direction")


def _head_of(prep: Prep, state: State) -> Mention | None:
    """``the car behind the lead vehicle in the next lane``: the car is in that lane."""
    inner, lane, verb = prep.on_mention, prep.place, state.last
    if inner is None or lane is None:
        return None
    ego = inner.is_ego or is_it(inner)
    if lane.kind != "lane" and not (ego and lane.kind == "side"):
        return None
    if verb is not None and any(p.names("lane") for p in verb.pps):
        return None  # "stands in the left lane 30 m ahead of the ego in the middle lane"
    if (head := _placed_by(inner, state)) is not None:
        return head
    if verb is None or not ego or not verb.subject:
        return None
    met = verb.name == "approach" and verb.object is inner
    return verb.subject[-1] if met or any(p.target is inner for p in verb.pps) else None


def _described(prep: Prep, state: State) -> Mention | None:
    """``a van that is behind the ego``, ``and the van is on the left``: no verb but "is"."""
    anchor = state.anchor
    if prep.on_mention is not None or not isinstance(anchor, Mention):
        return None
    if "aux:be" not in state.between:
        return anchor if _aside(prep, state) else None
    return anchor if anchor is state.waiting or "rel" in state.between else None


def _also_there(state: State) -> Mention | None:
    """``while the ego drives, a van is ahead of it in the left lane``: in both places."""
    who = state.waiting
    is_there = who is not None and any(p.predicate for p in who.pps)
    since = who is not None and bool(state.events) and state.events[-1].i < who.i
    return who if is_there and since and not state.between else None


def _aside(prep: Prep, state: State) -> bool:
    """``a truck, previously in its lane and behind it, accelerates``: put between commas."""
    who = state.waiting
    placed = prep.word.cat == "locus" or prep.value in {"in", "from", "into"}
    again = {"and", "conj"} if who is not None and who.pps else set[str]()
    waits = who is not None and who is state.anchor
    return waits and placed and "," in state.between and state.between <= _ASIDE | again


def _opens_clause(state: State) -> bool:
    """Whether the phrase that begins here says where the participant after it is.

    "Behind the ego is a truck", "from the left comes a bus, and from the right a van".
    """
    begins = not state.events and state.candidate is None and not state.mentions
    road = isinstance(state.anchor, Place) and state.anchor.kind == "highway"
    begins = begins and (state.anchor is None or road)  # "a kiosk on the left hides a child"
    opened = bool(state.fronted) and not state.events and state.candidate is None
    lane = state.at(1)
    named = isinstance(lane, Place) and lane.kind == "lane" and bool(lane.dirs)
    begins |= opened and named and "," in state.between  # "behind the ego, in the left lane, a …"
    joins = {"conj", "sub", ","} & state.between and "or" not in state.between
    inserted = {"conj", ","} <= state.between  # "a child and, behind the child, a bus"
    listed = "conj" in state.between
    complete = state.candidate_done or bool(state.events) or state.being is not None
    if not begins and not (joins and (inserted or complete)):
        return False
    chunks = state.chunks
    m = _phrase_end(state.k, chunks)
    if m is None:
        return False
    while _word_of(chunks, m, GOVERNING) and (further := _phrase_end(m, chunks)) is not None:
        m = further  # "in the left lane beside the ego a van drives"
    if value_at(chunks, m) == "(":  # "ahead of the ego (40 km/h) a van drives"
        closed = (n + 1 for n, c in enumerate(chunks[m:], start=m) if c.value == ")")
        m = next(closed, m)
    if value_at(chunks, m) == ",":
        if not (begins or listed or "sub" in state.between):
            return False
        m = behind_insertion(chunks, m + 1)
    inverted = _stands_before_subject(chunks, m)
    m += _word_of(chunks, m, frozenset({"aux", "copy"})) or inverted
    # "50 m ahead of the ego lies a pedestrian crossing"
    return isinstance(chunk_at(chunks, m), NounPhrase if inverted else Mention)


def _stands_before_subject(chunks: list[Chunk], m: int) -> bool:
    verb = chunk_at(chunks, m)
    finite = isinstance(verb, Event) and not verb.nominal and verb.form != "ing"
    return finite and isinstance(verb, Event) and verb.name in _MEETING


def _word_of(chunks: list[Chunk], m: int, classes: frozenset[str]) -> bool:
    chunk = chunk_at(chunks, m)
    return isinstance(chunk, Word) and chunk.cat in classes


def _phrase_end(k: int, chunks: list[Chunk]) -> int | None:
    """Index after a phrase of place that begins at chunk ``k``; None if none does."""
    first = chunks[k]
    m = k + 1
    locus = isinstance(first, Word) and first.cat == "locus"
    while _word_of(chunks, m, GOVERNING):
        locus |= _word_of(chunks, m, frozenset({"locus"}))
        m += 1
    target = chunk_at(chunks, m)
    placed = isinstance(target, Place) and (
        target.kind in _SIDES
        or (target.kind in _ROADS and (target.arm or target.dirs or _side_after(chunks, m + 1)))
    )
    if locus and _stands_before_subject(chunks, m):
        return m  # "from ahead comes a van"
    owned = chunk_at(chunks, m + 1)
    sided = isinstance(target, Mention) and target.possessor and isinstance(owned, Place)
    if not placed and not (locus and isinstance(target, Mention | Thing)) and not sided:
        return None  # "from the ego's left a van comes"
    m += 1
    if isinstance(target, Mention) and target.possessor and isinstance(owned, NounPhrase):
        m += 1  # "behind the ego's bumper"
    parked = chunk_at(chunks, m)
    m += isinstance(parked, Event) and (parked.name, parked.form) == ("park", "ed")
    if _side_after(chunks, m):
        m += 2  # "behind a van (parked) on the right a man …", "from the road on the left a van …"
    while value_at(chunks, m) == "of" and isinstance(chunk_at(chunks, m + 1), Mention | Place):
        m += 2
    return m


def _side_after(chunks: list[Chunk], m: int) -> bool:
    side = chunk_at(chunks, m + 1)
    sided = isinstance(side, Place) and side.kind in {"side", "sidewalk", "shoulder"}
    return sided and value_at(chunks, m) in {"in", "to"}


def place_in_front(mention: Mention, state: State) -> None:
    """Gives the phrases that opened the clause to the participant that they place."""
    mention.pps += [p for p in state.fronted if p.outer != "from" and p.value != "due"]
