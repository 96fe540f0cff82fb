"""Reads nouns within a clause: who acts, who is acted on, who is only named along the way."""

from collections.abc import Iterator

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep, Thing
from scegen.understanding.clauses.attachment import attach
from scegen.understanding.clauses.coordination import joins
from scegen.understanding.clauses.further import (
    also_from,
    apposed_to,
    bracketed,
    further_ones,
    opens_relative,
    partitive_before,
    relative_noun,
)
from scegen.understanding.clauses.located import place_in_front, side_of_place
from scegen.understanding.clauses.state import State
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import DONE_TO
from scegen.understanding.phrases.headings import turns_out
from scegen.understanding.phrases.lookahead import finite_follows
from scegen.understanding.words.terms import NOTHING

_REACH = 3
_PARTS = frozenset({"side", "flank", "view"})
_OWNED = frozenset({"side", "flank", "lane", "path", "right_of_way", "centerline"})
_STOPPING = frozenset({"stop", "slow", "brake"})
"""What is done to somebody by what is nobody."""
_TURNS = frozenset({"turn", "u_turn"})
"""Nouns of doings that somebody has before him ("a left turn for the ego")."""


def premodifiers(mention: Mention, sentence: int) -> Iterator[Event]:
    """``a speeding car``, ``the left turning truck``: events of the noun itself."""
    for mod in (m for m in mention.mods if m.cat == "verb"):
        event = Event(mod.value, mod.i, mod.j, mod.form, subject=[mention], sentence=sentence)
        event.premod_of = mention
        event.mods = [m for m in mention.ways if m.j == mod.i]
        event.passive = mod.form == "ed" and mod.value in word_list("done_to") - {"hide"}
        yield event


def read_mention(mention: Mention, state: State) -> None:
    """A participant: as the subject, an object, an apposition, or in a phrase of place."""
    if _emphasises(mention, state):
        return
    state.mentions.append(mention)
    within = state.awaits("of") or (state.prep is not None and state.prep.word.cat == "locus")
    state.topic = state.topic if within else None  # "the view of the road is blocked"
    if mention.possessor:
        owned = state.at(1)
        lent = isinstance(owned, Mention | Thing) and mention.opened_by("indef")
        mention.negated |= lent and mention.noun == "pedestrian"  # "a child's scooter lies there"
        return
    if state.prep is not None:
        _prepositional(mention, state.prep, state)
        return
    if opens_relative(mention, state):
        return
    anchor = state.anchor
    direct = isinstance(anchor, Event) and not anchor.nominal and not state.between
    whole = partitive_before(state)
    if whole is not None and (not mention.mods or mention.opened_by("indef")):
        mention.same_as = whole
        return
    if further_ones(mention, state):
        mention.pronoun = "further"
    if state.fronted or (direct and any(e is anchor and e.finite for e in state.pending)):
        listed = state.waiting if {"and", "conj"} & state.between else None
        _start_clause(mention, state)
        # "the ego and, 30 m in front of it, a van approach"; not "a van, and behind it a boy runs"
        verb = next((c for c in state.after(_REACH) if isinstance(c, Event)), None)
        alone = listed is None or listed.pps or (verb is not None and verb.form == "s")
        mention.joined = mention.joined if alone else listed
    elif isinstance(anchor, Event) and direct and _takes(anchor, state):
        anchor.object = mention
        stopped = anchor.name in _STOPPING and not anchor.negated
        anchor.subject = anchor.subject or [mention] * stopped  # "full braking stops the van"
        _carried(anchor, mention, state)
    elif (described := _described(mention, state)) is not None:
        which = described if described.pronoun == "one" else mention
        named = described.is_ego or described.pronoun == "one"
        named = named and which.opened_by("def") and "aux:be" in state.between
        one, other = (described, mention) if named else (mention, described)
        one.same_as = other  # "the ego is the van": one that was told of before
        if described is state.candidate or bracketed(state):
            return
    elif joins(mention, state):
        return
    else:
        _start_clause(mention, state)
    state.stand_at(mention)


def _takes(verb: Event, state: State) -> bool:
    """Whether a noun after a verb is its object; "he said the van stopped" tells of the van."""
    if _waits_for_subject(verb, state) or _goes_on_with(verb, state):
        return False
    tells = "says" in verb.data or (verb.control == "subject" and isinstance(state.at(0), Mention))
    return verb.object is None and not (tells and state.verb_follows)


def _goes_on_with(verb: Event, state: State) -> bool:
    """``once it has cut in it brakes``: the next verb has no other subject."""
    complete = verb.finite and state.candidate_done and state.relative is None
    following = next((c for c in state.after(3) if c.cat != "manner"), NOTHING)
    acts = isinstance(following, Event) and following.form == "s" and not following.nominal
    return complete and verb.control != "object" and (acts or following.cat == "aux")


def _carried(verb: Event, mention: Mention, state: State) -> None:
    """``a lane change brings the ego into the left lane``: it changes lanes, into that one."""
    doing = next((e for e in state.events if e.nominal and not e.subject), None)
    if "carries" in verb.data and doing is not None and not doing.negated:
        _done_by(doing, mention)
        verb.name, verb.object = "inert", None
        state.events.remove(verb)
        state.stand_at(doing)


def _done_by(doing: Event, mention: Mention) -> None:
    doing.subject, doing.form, doing.nominal, doing.finite = [mention], "s", False, True


def _waits_for_subject(verb: Event, state: State) -> bool:
    """``while passing into the left lane the ego sees a van``: the ego passes and sees."""
    placed = verb.form == "ing" and not verb.subject and bool(verb.pps or verb.dirs)
    return placed and verb.i < state.chunks[state.k - 1].i and state.verb_follows


def _described(mention: Mention, state: State) -> Mention | None:
    """Whom a noun says more of: "V1 is a taxi", "V1 (a taxi)", "V1, a taxi, …"."""
    if _is_predicate(mention, state):
        return state.candidate
    told = relative_noun(state) or apposed_to(state)
    if bracketed(state) and isinstance(state.anchor, Mention):
        told = state.anchor
    if told is not None and told.is_mass and not mention.is_mass:
        turns_out(told, mention)
    return told


def _is_predicate(mention: Mention, state: State) -> bool:
    """``vehicle 1 is a pickup truck``: the noun after "is" says what the subject is."""
    who = state.waiting
    right_after = state.at(-1).value == "be" and state.at(-1).cat == "aux"
    if who is None or not (state.anchor is who or right_after):
        return False  # "the car that hits it is a taxi", not "is 20 m behind it in a van"
    bare = all(m.cat != "det" or m.value == "indef" for m in mention.mods[:1])
    bare = bare or mention.is_ego or who.is_ego or who.pronoun == "one"  # "the ego is the truck"
    new = not (mention.pronoun or mention.is_named or who.pronoun in {"it", "they"})
    only = "aux:be" in state.between and not state.between & {"copy", "conj", "sub", ","}
    return only and bare and new and not state.verb_follows


def _start_clause(mention: Mention, state: State) -> None:
    opens = state.at(-1).value == "have" and state.at(-2).cat in {"", "punct"}
    verb = next((c for c in state.after(_REACH) if isinstance(c, Event)), None)
    if opens and verb is not None and verb.form == "ed":
        mention.marks.add("had")
    mention.denied = "neg:not" in state.between
    exists = "copy" in state.between or ("aux:be" in state.between and bool(state.fronted))
    others = any(e.finite and e.subject and not e.subject[-1].is_ego for e in state.events)
    if "sub" in state.between and others and mention.is_ego:
        state.trailing.append(mention)
    if "sub" in state.between and state.waiting is not None and state.events:
        state.relating = state.waiting  # "a child, unseen because two cars are parked, runs out"
    state.candidate, state.dependent = mention, "sub" in state.between
    state.candidate_done = exists  # "there is a van": that is all of its clause
    for event in state.pending:
        event.subject = event.subject if event.nominal and event.subject else [mention]
        inverted = event.finite and (bool(state.fronted) or state.anchor is event)
        event.pps += state.fronted if inverted else []
        state.candidate_done = state.candidate_done or inverted
    state.pending = []
    place_in_front(mention, state)
    state.opening, state.fronted = ([] if state.candidate_done else state.fronted), []


def _prepositional(mention: Mention, prep: Prep, state: State) -> None:
    state.prep = None
    prep.target = mention
    mention.prep = prep.word
    last = state.last
    if prep.value == "of" and last and last.nominal and last.name in DONE_TO and not last.object:
        last.object = mention  # "performs an overtaking manoeuvre of a van"
        state.stand_at(mention)
        return
    owns = prep.value == "of" and _owns_place(mention, state)
    if not owns:
        attach(prep, state)
    if prep.fronted:
        state.last_pp = mention  # "behind a van on the right a man …": the van is there
        return
    undergone = any(e.passive for e in state.events[-2:-1])  # "is forced into a stop by a van"
    agents = {"by", "from"} if last and last.name == "react" else {"by"}  # "no reaction from us"
    doer = prep.value in agents and state.anchor is last and not (undergone or state.between)
    done_by = {"by", "of", "for"} if last and last.name in _TURNS else {"of", *agents}
    gerund = last and doer and last.form == "ing" and state.verb_follows  # "swerving by a van"
    if last and (last.nominal or gerund) and prep.value in done_by and (doer or not last.subject):
        last.subject = [] if owns and last.pps else [mention]  # "a turn across the path of a van"
    made = next((e for e in reversed(state.events[:-1]) if e.nominal or e.form == "ing"), None)
    if made and last and last.control == "subject" and last.form == "ed" and prep.value == "by":
        last.subject = [mention]  # "a U-turn is made by a van": the van makes one
        _done_by(made, mention)
    if prep.value == "of" and state.anchor and prep.on_mention is not None and not owns:
        prep.on_mention.whole = mention
        return
    if state.waiting is not None and state.verb_follows:
        state.last_pp = mention
        return
    if prep.value in {"with", "against"} and state.candidate is None:
        _start_clause(mention, state)
    state.stand_at(mention)


def _owns_place(mention: Mention, state: State) -> bool:
    """``the path of the bus``, ``to the left of the truck``: whose place it is."""
    place = state.at(-2)
    if isinstance(place, Thing) and place is state.topic:
        place.owner = mention  # "the headlamps of a van come towards us"
    if not isinstance(place, Place) or place.kind not in _OWNED or place.owner is not None:
        return False
    place.owner = mention
    mention.aside = place.kind == "side" and place.stands_after("in", "to")
    return True


def read_noun(noun: NounPhrase, state: State) -> None:
    """A place or thing: what a preposition or verb governs."""
    if state.prep is None and state.fronted and any(e.finite for e in state.pending):
        state.pending, state.fronted = [], []  # "ahead of the ego lies a crossing"
    opens = not state.events or bool(state.between & {"sub", ",", "conj"})
    whole, behind = _whole(noun, state)
    if state.prep is None and opens and finite_follows(state.chunks, state.k + behind):
        of_one = whole is not noun or (isinstance(noun, Place | Thing) and noun.kind in _PARTS)
        of_whom = state.at(1).value == "of" and isinstance(state.at(2), Mention)
        part = of_one and (whole.owner is not None or of_whom)
        first = state.candidate is None and not (state.events and "," in state.between)
        # "the ego brakes, a hedge hides the child"
        anew = isinstance(noun, Thing) and noun.has("det", "indef") and state.at(-1).value == ","
        state.topic = noun if first or part or anew or "sub" in state.between else None
    if (prep := state.prep) is not None:
        owned = noun.owner is not None or noun.has("possessive")
        if prep.value == "of" and state.topic is not None and owned:
            state.topic = noun  # "the right part of the ego's front strikes …"
        prep.target, noun.prep = noun, prep.word
        if not side_of_place(noun, state):
            attach(prep, state)
        state.prep = None
        return
    if also_from(noun, state):
        return
    verb = state.anchor
    takes = isinstance(verb, Event) and verb.object is None and not state.between - {"or", "either"}
    # not "without a reaction our front hits …"
    if isinstance(verb, Event) and takes and not (verb.nominal and noun.owner is not None):
        verb.object = noun
        state.stand_at(noun)
    elif not state.events and state.candidate is None:
        state.stand_at(noun)


def _whole(part: NounPhrase, state: State) -> tuple[NounPhrase, int]:
    """``the left part of the ego's front``: what it is a part of, and how far behind."""
    owner = state.at(2)
    behind = 3 if isinstance(owner, Mention) and owner.possessor else 2
    whole = state.at(behind) if state.at(1).value == "of" else None
    return (whole, behind) if isinstance(whole, Place | Thing) else (part, 0)


def _emphasises(mention: Mention, state: State) -> bool:
    """``the van itself brakes``, ``the van, not the bus, brakes``: nobody else than the van."""
    if mention.negated and state.waiting is not None and state.between <= {",", "and", "conj"}:
        return True
    if mention.pronoun != "reflexive" or state.between or state.prep is not None:
        return False
    mention.same_as = state.anchor if isinstance(state.anchor, Mention) else None
    return mention.same_as is not None
