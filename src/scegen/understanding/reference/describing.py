"""What clauses say about their nouns, as marks on these.

* ``drives``, ``walks``: what only vehicles do, only people on foot; ``stood``: what only one does
  that stands ("it sets off"); ``stands``; ``seated``: who opens the door around them;
* ``elsewhere``: from another road; ``trails``: it follows the ego ("the car following us");
* ``besides``: it does something to "it", so that it is somebody else; ``narrowed``: words after it
  say which one is meant ("the car towing it").
"""

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.clauses.located import is_it
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.mention_words import is_pronoun, tells
from scegen.understanding.reference.own_vehicles import (
    is_one_vehicle,
    open_from_inside,
    stand_for_vehicles,
)
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_FROM_REST, _AWAY = frozenset({"unpark", "door"}), frozenset({"off", "away"})
_AT_SPEED = frozenset({"collide", "speed", "lose_control"})
_AGAIN = (
    frozenset({"overtake", "pass", "undertake", "bypass"}),
    frozenset({"cut_in", "lane_change", "merge", "return"}),
)
"""What a second clause may tell of another time, so that its subject is the same."""
_SIDES = frozenset({"left", "right", "opposite"})
_OFF_THE_ROAD = frozenset({"access", "parking", "road", "junction"})
_LADEN = {"": "carrying", "of": "laden", "with": "laden"}
_SEATED = 4
"""Within so many words after somebody stands the seat."""
_ALONG = frozenset({"behind", "ahead", "adjacent", "opposite"})


def describe(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Marks mentions by what they do, before it is decided whom they mean."""
    open_from_inside(events, tokens)
    for event in events:
        for mention in event.subject:
            _by_doing(mention, event, tokens)
    for chunk in chunks:
        if isinstance(chunk, Mention):
            chunk.sides |= _sides(chunk.pps)
    _people_in_traffic(chunks, events, tokens)
    _aside(chunks, events, tokens)
    _chases(events)
    stand_for_vehicles(chunks, events, tokens)
    _left_standing(events)
    _done_already(events, tokens)
    _besides_the_ego(chunks, events)


def _besides_the_ego(chunks: list[Chunk], events: list[Event]) -> None:
    """``passes the ego and the van following it``, ``… and the van behind it``: the ego."""
    for who in [c for c in chunks if isinstance(c, Mention) and c.joined is not None]:
        said = [n for e in events if e.subject == [who] and not e.finite for n in e.nouns()]
        for noun in [*said, *(p.target for p in who.pps)]:
            if who.joined is not None and who.joined.is_ego and is_it(noun):
                noun.same_as = who.joined


def _done_already(events: list[Event], tokens: list[Token]) -> None:
    """``a car overtakes the ego at 90 km/h; the ego does 70. Once it has passed``: the car."""
    for n, event in enumerate(events):
        who = event.subject[0] if len(event.subject) == 1 else None
        told = event.perfect and not event.negated and not event.modal
        if who is None or not told or tokens[who.i].low != "it":
            continue
        alike = next((kinds for kinds in _AGAIN if event.name in kinds), frozenset())
        same = [
            e for e in events[:n] if e.name in alike and e.finite and not (e.negated or e.perfect)
        ]
        one = same and not same[-1].passive and len(same[-1].subject) == 1
        if one and who.same_as is None and same[-1].subject[0] is not who:
            who.same_as = same[-1].subject[0]


def _by_doing(mention: Mention, event: Event, tokens: list[Token]) -> None:
    failing = event.negated and event.name in {"stop", "yield"}
    across = event.name == "cut_in" and tokens[event.j - 1].low == "across"
    afoot = mention.head is not None and "afoot" in mention.head.data
    springs = afoot and event.lemma in word_list("springing")  # "a boy bursts out of a gap"
    only = event.name in word_list("only_driven") and not (across or springs)
    made = event.object if event.name == "light" else None  # "makes a left": who says so drives
    alone = "drives" in event.data or only or (isinstance(made, Place) and made.kind == "side")
    vague = mention.head is not None and "vague" in mention.head.data
    turns = vague or event.name in {"turn", "sharp_turn"}
    turns = turns and any(d.value in {"left", "right"} for d in event.dirs)
    turns = turns or ((_person(mention) or vague) and _in_traffic(event))
    turns = turns or (vague and not event.passive and _at_the_wheel(mention, event, tokens))
    it = mention.pronoun == "it" and tokens[mention.i].low == "it"
    turns = turns or (it and event.name in word_list("not_from_rest") and not event.passive)
    away = event.name == "leave" and event.object is None and tokens[event.j - 1].low in _AWAY
    at_rest = event.name in {"wait", "stop"} and event.lemma in word_list("standing")
    told = 0 <= event.i - mention.j <= 1 and not event.finite and not event.nominal
    close = told and tokens[mention.j].low != ","  # "the car, doing 50 km/h": no other one
    tails = event.name in {"follow", "tailgate"} and not event.passive
    whom = event.object
    told = close or (event.embedded and event.finite)  # "the car that has been tailgating it"
    marks = {
        "seated": event.name in {"door", "alight"},
        "drives": failing or alone or turns,
        "walks": _on_foot(event),
        "stood": (away or event.name in _FROM_REST) and not event.negated,
        "stands": at_rest and not event.negated,
        "narrowed": close and event.premod_of is None,
        "trails": close and tails and isinstance(whom, Mention) and whom.is_ego,
        "besides": told and is_pronoun(whom),
    }
    mention.marks |= {mark for mark, so in marks.items() if so}
    if isinstance(whom, Mention) and whom.i < mention.i and is_pronoun(mention):
        whom.marks.add("besides")  # "the car it follows"
    if event.lemma in word_list("pedalling") and mention.heads:
        mention.goes_by = ParticipantKind.BICYCLE  # "the claimant was cycling"
    elif event.lemma in word_list("stepping") and all("driver" in h.data for h in mention.heads):
        on_foot = ParticipantKind.PEDESTRIAN  # "the insured walked", "she steps out": no driver
        mention.goes_by = on_foot if _on_foot(event) else mention.goes_by
    if event.passive:
        return  # "the car is hit by a van from the right": the van comes from there
    whence = [p for p in event.pps if p.value == "from" and p.place and "rear" not in p.place.dirs]
    mention.sides |= _sides(whence)
    if whence:
        mention.marks |= {"elsewhere"} if mention.pronoun is None else set()


def _person(mention: Mention) -> bool:
    return bool(mention.heads) and all(
        h.value == "pedestrian" and "vague" not in h.data for h in mention.heads
    )


def _sides(pps: list[Prep]) -> frozenset[str]:
    """``the one from the left``, ``comes from the right``, ``in the left lane``."""
    places = [p.place for p in pps if p.value in {"from", "in"} and p.place is not None]
    named = [p for p in places if p.owner is None or p.owner.is_ego]
    return frozenset(d for p in named for d in p.dirs if d in _SIDES)


def _chases(events: list[Event]) -> None:
    """``a boy chases a ball`` over the road; a police car that chases a van follows it."""
    for event in events:
        if event.name == "chase":
            afoot = any(h.value == "pedestrian" for m in event.subject for h in m.heads)
            event.name = "cross" if afoot and not event.passive else "follow"


def _left_standing(events: list[Event]) -> None:
    """``somebody left a van on the bend``, ``lost a ladder``: it is there, and nobody about."""
    put = {"leave", "park", "dump", "abandon"} | word_list("shedding")
    for event in events:
        what, who = event.object, event.subject[-1] if event.subject else None
        thing = isinstance(what, Thing) and "thing" in getattr(what.head, "data", ())
        vehicle = isinstance(what, Mention) and is_one_vehicle(what)
        if event.lemma not in put or event.passive or who is None or not (thing or vehicle):
            continue
        if who.noun == "pedestrian" and (vehicle or "vague" in getattr(who.head, "data", ())):
            who.negated = True
        if isinstance(what, Mention) and who.negated:
            what.same_as = None
            what.mods = [*what.mods, Term("state", "parked", event.i, event.j)]


def _on_foot(event: Event) -> bool:
    against = any(p.value == "into" and p.who is not None for p in event.pps)
    return event.name in {"cross", "walk", "appear"} and not against


def _people_in_traffic(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``the guy behind me``: somebody who is behind or in front, and does not walk, drives."""
    named = [c for c in chunks if isinstance(c, Mention)]
    walking = {id(m) for e in events if _on_foot(e) for m in e.subject}
    aboard = [m for m in named if m.head is not None and m.head.data.get("aboard")]
    aboard += [m for m in named if m.heads and not m.is_ego and carried(m, chunks, tokens)]
    on_foot = [m for m in named if id(m) in walking]  # "lets a man out; he crosses"
    again = any(is_pronoun(m) or m.pronoun == "one" for m in on_foot)
    afoot = any(id(m) in walking for m in aboard)
    for who in [m for m in aboard if id(m) not in walking]:
        told = who.mod("det", "def") is not None and afoot  # "…; the ego hits the passenger"
        who.negated = who.negated or not (told or again)
    for who in [m for m in named if id(m) not in walking]:
        done = [e for e in events if who in e.subject]
        sits = [p for e in done if e.lemma in word_list("at_the_wheel") for p in e.pps]
        alike = who.has("manner", "wrong_way") or any(e.how("wrong_way") for e in done)
        who.marks |= {"drives"} if alike or _along(who, sits) else set()


def carried(noun: NounPhrase, chunks: list[Chunk], tokens: list[Token]) -> bool:
    """``carrying four cars``, ``full of children``, ``with a girl on the back``."""
    prep = noun.prep.value if noun.prep is not None else ""
    k = max(0, (noun.prep or noun).i - 1)
    bearer = [c for c in chunks if isinstance(c, NounPhrase) and c.j <= k][-1:]
    laden = prep in _LADEN and tokens[k].base in word_list(_LADEN[prep])
    laden = laden and not any(isinstance(c, Place) for c in bearer)  # a road
    opened, *after = [t.low for t in tokens[noun.j : noun.j + _SEATED]] or [""]
    on_board = opened in word_list("aboard") and bool(word_list("whose") & {*after[:1]})
    return laden or (on_board and not word_list("seats").isdisjoint(after))


def _along(mention: Mention, sits: list[Prep]) -> bool:
    """Placed like a vehicle: behind, in front of, beside or across from the one who tells it."""
    head = mention.head
    if head is None:
        return False
    definite = mention.opened_by("def")
    known = definite or "vague" in head.data or head.form == "s" or sits
    if definite and "opposite" in mention.dirs:
        return True  # "the bloke opposite"
    for prep in (*mention.pps, *sits) if known else ():
        place, by = prep.place, prep.who
        if prep.value == "from" and place is not None and "vague" in head.data:
            return place.kind in _OFF_THE_ROAD or not _SIDES.isdisjoint(place.dirs)
        if place is not None and place.kind == "lane" and prep.value == "in" and place.dirs:
            return True
        seen = prep.target is None or (by is not None and (by.pronoun is not None or by.is_ego))
        come_from = prep.outer == "from"  # "hits the boy from behind"
        if prep.word.cat == "locus" and prep.value in _ALONG and seen and not come_from:
            return True
    return False


def _aside(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``officers said …``, ``she said I was …``, ``two people were hurt``: they take no part."""
    named = [c for c in chunks if isinstance(c, Mention)]
    asked = {id(m) for m in named[:1] if is_pronoun(m) and any(map(tells, named))}
    again = [m.i for m in named if is_pronoun(m) and tokens[m.i].low in word_list("persons")]
    acting = {id(m) for e in events for m in e.subject}
    for event in events:
        for noun in event.nouns() if "absent" in event.data else []:
            if isinstance(noun, Mention) and noun.opened_by("indef"):
                noun.negated = True
        called = event.nouns("to", "in", "with") if "calls" in event.data else []
        for who in (n for n in called if isinstance(n, Mention)):
            away = who.noun == "pedestrian" and who is not event.object
            away = who.is_mass or (away and all(i < event.i for i in again))
            who.negated = who.negated or (away and id(who) not in acting)
        said = [*event.subject, event.object, *event.nouns("to")] if "says" in event.data else []
        for who in (n for n in said if isinstance(n, Mention)):
            onlooks = any("onlooker" in h.data for h in who.heads)
            who.negated = who.negated or onlooks or id(who) in asked
    referred = [m.i for m in named if is_pronoun(m)]
    doing = {id(m) for e in events if e.name != "harm" for m in (*e.subject, e.object)}
    for event in (e for e in events if e.name == "harm"):
        for hurt in event.subject if event.passive or event.object is None else [event.object]:
            if isinstance(hurt, Mention) and id(hurt) not in doing and _person(hurt):
                afoot = any("afoot" in h.data for h in hurt.heads)
                hurt.negated = not (hurt.pps or afoot or any(i > event.i for i in referred))


def _at_the_wheel(mention: Mention, event: Event, tokens: list[Token]) -> bool:
    """``some guy comes towards us``, ``skids``, ``goes far too fast``: on a road, who drives."""
    words = {t.base for t in tokens[event.i : event.j]}
    aside = words & word_list("off_balance") or any(p.names("sidewalk") for p in event.pps)
    kind = event.object.kind if isinstance(event.object, Place) else ""
    light = kind in {"signal", "stop_sign"} and event.lemma in word_list("jumping")
    if light or (kind == "exit" and not _on_foot(event)):
        return True  # "runs a red light", "misses his exit"
    if event.name not in word_list("not_from_rest") | _AT_SPEED or aside:
        return False
    at = [p.target for p in event.pps if tokens[p.word.i].low in word_list("at_somebody")]
    at += [event.object] if words & word_list("towards") else []
    fast = event.name in _AT_SPEED or event.how("fast") is not None
    towards = any(isinstance(whom, Mention) and whom.is_ego for whom in at)
    return fast or (towards and "walks" not in mention.marks)


def _in_traffic(event: Event) -> bool:
    """``the man coming the other way``, ``she turns into her drive``: only drivers do so."""
    if event.name == "move":
        return any(d.value == "opposite" for d in event.dirs)
    goals: list[object] = [p.target for p in event.pps if p.value in {"into", "in"}]
    if event.name == "enter" and event.lemma in word_list("steering"):
        goals.append(event.object)
    goes_in = event.name in {"turn", "sharp_turn", "pull_over", "enter"} and not event.nominal
    return goes_in and any(isinstance(g, Place) and g.kind in _OFF_THE_ROAD for g in goals)
