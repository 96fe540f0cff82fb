"""Whose car it is: people who stand for what they drive, parts for the whole, and who tells it."""

from itertools import pairwise

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import teller_at
from scegen.understanding.phrases.lookahead import chunk_at, value_at
from scegen.understanding.reference.mention_words import ENDS, KINDS, mine, tells
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_BY_TRADE = frozenset({"bus", "truck", "van", "car", "emergency_vehicle", "motorcycle", "bicycle"})
_STEERED = frozenset({"move", "turn", "u_turn", "stop", "slow", "brake", "park", "swerve"})


def whole_for_part(chunks: list[Chunk], _: object) -> list[Chunk]:
    """``in front of our bumper``, ``behind the van's trailer``: in front of us, behind the van."""
    found: list[Chunk] = []
    for k, part in enumerate(chunks):
        flank = part if isinstance(part, Place) and part.kind == "flank" else None
        whole = part if isinstance(part, Thing) else flank
        owner = whole.owner if whole is not None else None
        own = flank.mod("possessive") if flank is not None else None
        if own is not None and value_at(chunks, k - 1) in ENDS.values():
            it = Mention(part.i, part.j, [], own, pronoun="it")
            found.append(teller_at(part.i) if own.value == "first_person" else it)
        elif owner is not None and value_at(chunks, k - 2) in ENDS.values():
            owner.possessor = False
        else:
            found.append(part)
    return found


def stand_for_vehicles(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """Makes one of somebody and the vehicle that he or she drives."""
    _own_vehicles(events)
    _driven(chunks)
    _vehicles_of_parties(chunks)
    _drivers(events)
    _ridden(chunks, events, tokens)
    _own_people(chunks, events, tokens)


def _own_vehicles(events: list[Event]) -> None:
    """``a woman backs her van out``, ``a man riding a moped``: they stand for what they drive."""
    for event in events:
        what = event.object
        if event.name == "lose_control":
            what = next((p.who for p in event.pps if p.value == "of" and p.who is not None), None)
        acts = bool(event.subject) and event.name in word_list("driven")
        if not (acts and isinstance(what, Mention)):
            continue
        who = event.subject[-1]
        driven = event.lemma in word_list("operating") or event.name == "reverse"
        driven = driven and (is_somebody(who) or tells(who))  # "a man backs a van out"
        own = tells(who) and event.name in _STEERED  # "I stopped the car"
        driven = driven or (own and what.opened_by("def"))
        if what.heads and not what.label and (what.opened_by("its") or driven):
            what.same_as = who
            who.marks.add("drives")


def _driven(chunks: list[Chunk]) -> None:
    """``the van I am driving``, ``the bike that we ride``: whoever tells it."""
    bare = [c for c in chunks if c.cat not in {"rel", "aux"}]
    for what, who, verb in zip(bare, bare[1:], bare[2:], strict=False):
        if isinstance(what, Mention) and isinstance(who, Mention) and isinstance(verb, Event):
            drives = tells(who) and verb.lemma in word_list("operating") and what.has("det")
            after = chunk_at(chunks, chunks.index(verb) + 1)
            if drives and after.cat not in {"prep", "locus"} and not verb.object:
                what.same_as = who


def _vehicles_of_parties(chunks: list[Chunk]) -> None:
    """``the insured's van``, ``driver 2's car``, ``the ego's driver``: the owner stands for it."""
    for k, chunk in enumerate(chunks):
        owner = chunk.owner if isinstance(chunk, Mention) else None
        if value_at(chunks, k - 1) == "whose":  # "the ego, whose driver is tired, …"
            owner = next((c for c in chunks[k - 1 :: -1] if isinstance(c, Mention)), None)
        if not isinstance(chunk, Mention) or owner is None or not chunk.heads:
            continue
        drives = any("driver" in h.data for h in owner.heads) and not is_somebody(chunk)
        if chunk.goes_by is None and (drives or chunk.noun == "driver"):
            chunk.same_as = owner


def _drivers(events: list[Event]) -> None:
    """``a van driven by a student``: the student drives it; ``towed by a truck``: the truck."""
    for event in (e for e in events if e.form == "ed" and e.subject):
        by = [p.who for p in event.pps if p.value == "by" and p.who is not None]
        if event.lemma in word_list("operating"):
            for who in filter(is_somebody, by):
                who.same_as = event.subject[-1]
            if by and tells(by[0]):
                event.subject[-1].same_as = by[0]
        elif event.name == "tow" and by:
            event.subject[-1].negated, towed = True, event.subject
            for other in (e for e in events if e.subject == towed):
                other.subject = by


def _ridden(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``I'm on a motorbike``, ``he overtook me in a van``: whoever it is stands for it."""
    moving = [e for e in events if not (e.passive or e.nominal or e.name in _AT_REST)]
    acting = [(m, p) for e in moving for m in e.subject for p in e.pps]
    told = [(m, p) for m, p in acting if tells(m) or is_somebody(m) or m.pronoun == "it"]
    named = [c for c in chunks if isinstance(c, Mention)]
    told += [(c, p) for c in named if tells(c) for p in c.pps]
    taken = {c.j for c in named if is_somebody(c)}  # "I pass a woman on a bicycle"
    taken |= {m.j for e in events for m in e.mods if e.name == "approach"}  # "close to 20 m on it"
    for who, prep in told:
        what, word = prep.who, tokens[prep.word.i].low
        aboard = prep.value == "in" and word in word_list("aboard") and prep.word.i not in taken
        if aboard and what is not None and what.same_as is None and is_one_vehicle(what):
            what.same_as = who
            who.marks.add("drives")


def _own_people(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> None:
    """``my wife brakes``: at the wheel, if the teller is not; ``my wife screams``: aboard."""
    own = [(e, m) for e in events for m in e.subject if tells(m)]
    drives = any(tokens[m.i].low == "i" or e.name in word_list("only_driven") for e, m in own)
    drives |= any(isinstance(c, Mention) and tokens[c.i].low == "me" for c in chunks)
    for who in [c for c in chunks if isinstance(c, Mention) and c.opened_by("first_person")]:
        placed = any(p.target is None or p.place or p.who for p in who.pps)
        if tokens[who.j - 1].low not in word_list("relatives") or who.prep or placed:
            continue  # "my wife behind me"
        done = [e for e in events if who in e.subject]
        steers = any(e.name in word_list("driven") or "drives" in e.data for e in done)
        at_wheel = steers and "walks" not in who.marks
        if at_wheel and not drives:
            wheel = Term("actor", "ego", who.i, who.j, data={"ego": True})
            who.same_as = Mention(who.i, who.j, [], wheel, heads=[wheel])
        elif done and all(e.name in {"inert", "unknown", "warn", "light", "note"} for e in done):
            who.negated = True


def is_one_vehicle(noun: Mention) -> bool:
    """Whether a noun names one vehicle."""
    head = noun.head if noun.pronoun is None and noun.owner is None else None
    return head is not None and head.value in _BY_TRADE and head.form != "s"


_OPENS = frozenset({"door", "alight"})
_AT_REST = frozenset({"try", "wait", "stop", "park", "locate", "hide", *_OPENS})
_DOORED = frozenset({"car", "van", "truck", "emergency_vehicle"})
_PEOPLE = frozenset({"driver", "pedestrian", "rider"})


def open_from_inside(events: list[Event], tokens: list[Token]) -> None:
    """Makes the vehicle the one whose door opens, and people nobody who do nothing else.

    That is before it is decided whom their nouns mean.
    """
    for event in events:
        around = _around(event, tokens)
        people = [m for m in event.subject if is_somebody(m)]
        if around is None or not people or len(people) < len(event.subject):
            continue
        event.name, event.object = "door", None
        event.pps = [p for p in event.pps if p.target is not around]
        if around.has("possessive"):
            around.same_as = people[-1]
            people[-1].marks.add("drives")
            continue  # "his van": he stands for it
        event.subject = [around]
        besides = {id(m) for e in events for m in e.subject}
        for who in people:
            who.negated = who.negated or id(who) not in besides
    for event in (e for e in events if e.name in _OPENS):
        _on_a_side(event)


def is_somebody(mention: Mention) -> bool:
    """Whether a noun names somebody, and no vehicle ("a driver", "a woman")."""
    return any(h.value in _PEOPLE for h in mention.heads)


def _on_a_side(event: Event) -> None:
    """``on the traffic side``: the side of the vehicle, not of the road."""
    on = [p for p in event.pps if p.names("side")]
    for who in event.subject:
        named = [(p, p.place.mods) for p in who.pps if p.place is not None]
        of_body = [p for p, mods in named if any("of_body" in m.data for m in mods)]
        who.pps = [p for p in who.pps if p not in of_body]
        on += of_body
    event.pps = [p for p in event.pps if p not in on]
    places = [p.place for p in on if p.place is not None]
    event.mods += [m for place in places for m in place.mods if m.cat == "dir"]
    event.j = max([event.j, *(place.j for place in places)])


def _around(event: Event, tokens: list[Token]) -> Mention | None:
    """The vehicle out of which somebody comes, or whose door somebody opens."""
    if event.nominal or event.passive or event.negated:
        return None
    targets: list[object] = [event.object] if event.lemma == "exit" else []
    for prep in event.pps:
        out = "out" in {tokens[event.j - 1].low, tokens[prep.word.i].low}
        opens = event.name in _OPENS and prep.value in {"of", "in", "from"}
        if opens or (out and prep.value == "of"):
            targets.append(prep.target)
    if tokens[event.j - 1].low == "of" or event.name == "alight":
        targets.append(event.object)  # "jumps out of a van", "gets off the bus"
    return next((t for t in targets if isinstance(t, Mention) and _doored(t)), None)


def _doored(vehicle: Mention) -> bool:
    """Whether it has a door of its own that opens into the traffic: no bus, no train."""
    head = vehicle.head
    return head is not None and head.value in _DOORED and head.form != "s" and not vehicle.is_ego


_STEPS = frozenset({"walk", "cross", "appear"})
_MY = frozenset({"my", "our"})
_REACH = 3
"""Within so many words after "my" stands what is mine."""


def teller_goes_by(
    chunks: list[Chunk], events: list[Event], tokens: list[Token]
) -> ParticipantKind | None:
    """``I was walking over the zebra``, ``on my handlebar``: no driver tells it.

    Returns:
        How the teller moves; None if it drives, or nothing says so.
    """
    mentions = [c for c in chunks if isinstance(c, Mention)]
    us = [(e, w) for e in events if not e.negated for m in e.subject for w in (m, m.whole)]
    own = [e for e, who in us if who is not None and tells(who)]
    my_car = any(m.is_ego and tokens[m.i].low in _MY for m in mentions)
    kinds = [(m, KINDS[h.value]) for m in mentions for h in m.heads if h.value in KINDS]
    mines = [kind for m, kind in kinds if mine(m, kind)]
    if my_car or any("drives" in e.data for e in own):
        return next(iter(mines), None)
    ridden = {m.value for c in mentions for m in c.heads} & {"bicycle", "motorcycle"}
    cycles = any(_cycles(e) for e in own) or _rides(tokens, others=bool(ridden))
    if ParticipantKind.BICYCLE in mines or cycles:
        return ParticipantKind.BICYCLE
    if any(e.name in word_list("only_driven") for e in own):
        return next(iter(mines), None)
    afoot = any(_afoot(e) for e in own) or any(_on_foot(m, tokens) for m in mentions)
    return ParticipantKind.PEDESTRIAN if afoot else next(iter(mines), None)


def _cycles(event: Event) -> bool:
    """``I was cycling``; ``I rode out of an alley``, where nothing else is ridden."""
    rides = event.lemma == "ride" and not isinstance(event.object, Mention)
    return rides or event.lemma in word_list("pedalling")


def _rides(tokens: list[Token], *, others: bool) -> bool:
    """``my handlebar``; ``my elbow on the handlebar``, where nobody else rides."""
    whose = _MY if others else _MY | {"the"}
    near = [tokens[k + 1 :][:_REACH] for k, t in enumerate(tokens) if t.low in whose]
    return any(token.forms[-1][0] in word_list("of_cyclists") for after in near for token in after)


def _afoot(event: Event) -> bool:
    """``I stepped out``, ``I was waiting on the pavement``, ``pushing the pram, I …``."""
    if event.name in _STEPS and event.lemma in word_list("stepping"):
        return True
    places = [event.object, *(p.target for p in event.pps)]
    waits = event.name in {"wait", "stop"}
    return waits and any(isinstance(p, Place) and p.kind == "sidewalk" for p in places)


def _on_foot(mention: Mention, tokens: list[Token]) -> bool:
    """``I was on foot``."""
    after = [t.low for t in tokens[mention.j :][: _REACH + 1]]
    return tells(mention) and mention.prep is None and ("on", "foot") in pairwise(after)


def is_apart(chunks: list[Chunk]) -> bool:
    """``the ego turned left as I crossed on foot``: who tells it beside a vehicle under test."""
    return any(isinstance(c, Mention) and c.is_ego and not tells(c) for c in chunks)
