"""Attaches prepositional phrases: to the noun right before them, or to the verb."""

from scegen.understanding.chunks import Event, Mention, Place, Prep
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.clauses.further import located
from scegen.understanding.clauses.located import is_it, opens_clause
from scegen.understanding.clauses.state import State
from scegen.understanding.words.terms import Term

_PASSING = frozenset({"overtake", "pass", "undertake", "bypass"})
_MET = _PASSING | {"collide"}
_OUT, _HALVES = frozenset({"overtake", "bypass"}), frozenset({"lane", "side"})
_ASIDE = frozenset({",", "unknown", "inert"})
_SHOWS = frozenset({"reveal", "encounter"})


def preposition(word: Term, state: State) -> None:
    """Opens a phrase; what it governs comes next."""
    before = state.prep
    if before is not None and (word.cat != "locus" or before.word.cat == "locus"):
        release(state)
    outer = state.prep.value if state.prep is not None else None
    there = "bare" in word.data and isinstance(state.at(1), Mention)  # "in front a van brakes"
    fronted = there or (before is not None and before.fronted) or opens_clause(state)
    state.prep = Prep(word, None, outer, _noun_before(word, state), fronted)
    if there:
        state.fronted, state.prep = [*state.fronted, state.prep], None


def _noun_before(word: Term, state: State) -> Mention | None:
    """The noun right before a preposition, or whom that one places if it is known already."""
    near = state.last_pp or state.anchor
    if state.between or not isinstance(near, Mention):
        return None
    since = (c for c in state.chunks if near.j <= c.i < word.i)
    if any((c.cat, c.value) == ("quantity", "percentage") for c in since):
        return None  # "hits the rider at 20 % of its width from the left edge": where, not which
    done = near is not state.last_pp and is_it(near) and not near.mods and word.value == "in"
    if done and near.opening != "adjacent":
        return None  # "passes it in the left lane": where it is done; not "beside it on the right"
    told = near.pronoun is not None or near.is_me
    placed = _placed_by(near, state) if told else None
    return placed or near  # "my friend in front of me on his moped": the friend is on it, not I


def _placed_by(landmark: Mention, state: State) -> Mention | None:
    """The noun that is said to be behind, beside, … another one."""
    placed = ((m, p) for m in reversed(state.mentions) for p in m.pps if p.word.cat == "locus")
    return next((m for m, p in placed if p.target is landmark), None)


def release(state: State) -> None:
    """A preposition without a target: "the car ahead", "positioned behind on the right"."""
    if state.prep is not None:
        if state.prep.word.cat == "locus":
            attach(state.prep, state)
        state.prep = None


def _shared(prep: Prep, state: State) -> None:
    """``behind or beside it``: both are of the same one."""
    last = state.last_prep
    both = last is not None and last.word.cat == prep.word.cat == "locus"
    if both and last is not None and "or" in state.between and prep.word.i - last.word.j == 1:
        last.target = last.target or prep.target


def attach(prep: Prep, state: State) -> None:
    """Gives a phrase to who follows it, the noun right before it, the verb, or who acts."""
    _shared(prep, state)
    state.last_prep = prep
    cause = prep.value == "due" and not state.events and state.candidate is None
    if prep.fronted or cause:  # "because of a parked van the ego does not see the child"
        _of_the_one_listed(prep, state)
        state.fronted.append(prep)
        return
    prep.on_mention = _noun(prep, state)
    for whom in _placed_alike(prep, state):
        whom.pps.append(prep)
    described = None if _astern(prep, state) else _described(prep, state) or _also_there(state)
    if described is not None and not _of_who_acts(prep, described, state):
        described.pps.append(prep)
        prep.predicate = "rel" not in state.between
    elif state.events and (prep.on_mention is None or state.anchor is not state.candidate):
        if not _of_another_noun(prep, state):
            _told_of(prep, state).pps.append(prep)
    elif prep.on_mention is None and state.candidate is not None:
        state.candidate.pps.append(prep)


def _placed_alike(prep: Prep, state: State) -> list[Mention]:
    """``a van and a bus ahead of the ego``: both are, unless the first is told about itself."""
    if prep.on_mention is None:
        return []
    *others, last = [m for m in chain(prep.on_mention) if m is prep.on_mention or not m.is_ego]
    told = prep.word.cat == "locus" or prep.names("lane", "side")
    told = told and prep.outer is None
    known = any(isinstance(c, Mention) and c.i < others[0].i for c in state.chunks if others)
    known = known and (state.last is None or state.last.object is not last)
    told = told and (known or not is_it(prep.target))  # "a van and a bus behind it": the van
    plain = all(m.heads and not (m.is_me or m.has("det", "def")) for m in others)
    plain = plain and all(m.pps == last.pps for m in others)
    return [*others, last] if told and plain else [last]


def _of_another_noun(prep: Prep, state: State) -> bool:
    """``moves to the right lane, and the road in front of the ego is free``: nobody is there."""
    before = next((c for c in reversed(state.chunks) if c.j <= prep.word.i), None)
    parted = not {"conj", ","}.isdisjoint(state.between)
    return parted and isinstance(before, Place) and before.prep is None


def _noun(prep: Prep, state: State) -> Mention | None:
    """The noun to which a phrase belongs; None: none."""
    whom = prep.on_mention
    if whom is not None and whom.whole is not None and whom.whole.j == prep.word.i:
        whom = prep.on_mention = whom.whole  # "one of the two cars ahead": both are
    head = _head_of(prep, state)
    if whom is None:
        return head or shown(state)
    if prep.value == "due" and state.events:
        return None  # "a boy whom I can't see because of a van"
    if _of_who_acts(prep, whom, state) or _came_from(prep, whom, state) or _astern(prep, state):
        return None
    if head is None and located(whom) and prep.value == "from" and state.events:
        # "falls onto the road ahead of the ego from the pavement"; the ego itself comes from no
        # side of its own: "turns in front of a car from the left"
        own = any(m.is_ego for m in state.events[-1].subject) and prep.names("side", "direction")
        return whom if own else None
    return head or whom


def shown(state: State) -> Mention | None:
    """``reveals a slow car at 20 km/h, 40 m ahead of it``: who is so fast, and there."""
    seen = state.last.object if state.last is not None and state.last.name in _SHOWS else None
    return seen if isinstance(seen, Mention) and seen is state.anchor else None


def _astern(prep: Prep, state: State) -> bool:
    """``hits the ego, which is stationary, from behind``, ``drives up to a bus from behind``."""
    whom, last = prep.on_mention, state.last
    if (prep.outer, prep.value) != ("from", "behind") or last is None:
        return False
    up_to = whom is not None and whom.stands_after("to") and last.name in {"approach", "move"}
    return up_to or "," in state.between


def _told_of(prep: Prep, state: State) -> Event:
    """``passes a van, which does 60 km/h, on the left``: the comma closes what is put in.

    So it does in "steps out from behind a van parked there, 10 m ahead of the ego".
    """
    outer = outside(state)
    since = (c for c in state.chunks[: state.k] if c.i >= outer.j)
    aside = sum(c.value == "," for c in since if isinstance(c, Term)) % 2 == 0  # ", at speed, …"
    due = prep.value == "due"  # "does not see a child, who crosses, because of a van"
    closed = (prep.names("side") or prep.outer == "from") and not aside
    closed = "," in state.between and (closed or due)
    met = (e for e in reversed(state.events) if not e.embedded)
    around = (e for e in met if due or e.name in _MET)
    return next(around, outer) if closed and outer.embedded else outer


def outside(state: State, number: Term | None = None) -> Event:
    """``comes from behind a van parked there, at 8 km/h``: a comma closes where somebody stands.

    So does a speed: ``hits a van standing there at 50 km/h``.
    """
    last = state.events[-1]
    nouns = [m for e in state.events for m in (e.object, *(p.target for p in e.pps))]
    put_in = last.name in {"park", "wait", "stop"} and (last.embedded or not last.finite)
    put_in = put_in and any(m in nouns for m in last.subject)  # not "there is a van standing …"
    outer = [e for e in state.events if put_in and e.finite and not e.embedded]
    closed = "," in state.between or (number is not None and number.value == "speed")
    return outer[-1] if outer and closed else last


def _of_the_one_listed(prep: Prep, state: State) -> None:
    """``ahead of the ego: a van and, 10 m in front of it, a bus``: in front of the van."""
    listed = {"conj", ","} <= state.between and not state.events
    if listed and state.waiting is state.anchor and is_it(prep.target):
        prep.target.same_as = state.waiting


def _of_who_acts(prep: Prep, whom: Mention, state: State) -> bool:
    """Whether a phrase behind a noun says where who acts is, or on which side it is done.

    "In the lane of the ego ahead of it", "follows a van 20 m behind", "is overtaken by a van on
    the left".
    """
    verb, place = state.last, prep.place
    if place is not None:
        if verb is None or prep.value != "in":
            return False
        other = "opposite" in place.dirs or place.has("det", "other")
        if other and verb.name in _OUT and place.kind in _HALVES:
            return True  # "overtakes a truck in the oncoming lane"
        past = (p for p in verb.pps if "passes" in p.word.data)
        if not verb.subject and (whom.is_me or whom.is_ego or is_it(whom)):
            # "driving next to us in the right lane, a lorry …"
            return any(p.target is whom and p.word.cat == "locus" for p in verb.pps)
        stands = any(m.cat == "state" for m in whom.mods)
        if place.kind == "side" and not stands and any(p.target is whom for p in past):
            return True  # "moves past a van on the left", but "past a parked van on the left"
        if verb.name not in _PASSING:  # "is hit by a van in its left side"
            return verb.name == "collide" and verb.passive and place.kind == "side"
        # "passes a truck in the left lane"; who is in the right lane is passed
        inside = "right" if verb.name == "undertake" else "left"
        aside = state.at(1).value == "to" and isinstance(state.at(2), Place)  # "lane to the right"
        aside = (aside or "adjacent" in place.dirs) and whom.is_ego
        there = inside in place.dirs or aside
        lane = verb.object is whom and place.kind == "lane" and there
        return lane or (verb.passive and place.kind == "side")
    its = prep.who is not None and prep.who.pronoun is not None
    if prep.word.cat != "locus" or not (its or prep.target is None):
        return False
    if its and whom.stands_after("of"):
        return True
    followed = verb is not None and (verb.object is whom or whom.pronoun == "both")
    return followed and verb is not None and verb.name == "follow" and prep.value == "behind"


def _came_from(prep: Prep, whom: Mention, state: State) -> bool:
    """``steps out from behind a van 20 m in front of the ego``: not the van is there."""
    phrases = state.last.pps if state.last is not None and prep.who is not None else []
    far = any(c.j == prep.word.i and c.cat == "quantity" for c in state.chunks)
    out = [p for p in phrases if p.outer == "from" or (far and p.value == "between")]
    return any(p.target is whom and p.value in {"behind", "ahead", "between"} for p in out)


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
        side = state.at(2)  # "the ego is behind a van in the lane to its left": the van is there
        aside = isinstance(side, Place) and side.has("possessive")
        aside |= any(p.value == "adjacent" for p in head.pps)  # "the ego is beside a van in …"
        return None if head.is_ego and aside else head
    if verb is None or not ego or not verb.subject:
        return None
    met = verb.name == "approach" and verb.object is inner
    placed = any(p.target is inner and p.value != "by" for p in verb.pps)
    return verb.subject[-1] if met or placed else None


def _described(prep: Prep, state: State) -> Mention | None:
    """``a van that is behind the ego``, ``and the van is on the left``: no verb but "is"."""
    anchor = state.anchor
    if isinstance(anchor, Event) and anchor.form == "ing" and anchor.subject == [state.waiting]:
        return state.waiting if "aux:be" in state.between else None  # "a van doing 40 is ahead"
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
