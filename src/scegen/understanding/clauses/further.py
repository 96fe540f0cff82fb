"""What is said further of a noun: what else it is, parts of it, relative clauses."""

from itertools import dropwhile

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.clauses.dependents import chain, depend
from scegen.understanding.clauses.state import State
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, ends, predicate_opens
from scegen.understanding.words.terms import NOTHING

_OF_ANY_KIND = frozenset({"car", "driver", "traffic"})
_GOES_ON = frozenset({"prep", "locus", "sub", "rel", "quantity"})  # behind the second comma
_RELATIVE = 3
"""A noun, "which", and "is"."""


def apposed_to(state: State) -> Mention | None:
    """``vehicle 1, a sedan, was …``: the second only describes the first.

    Returns:
        Whom it describes; None if it is somebody else.
    """
    if _names_before(state) and isinstance(state.anchor, Mention):
        return state.anchor
    who = state.candidate
    # "the car behind it, a taxi, …": "it" only says which car
    waiting = who is not None and (
        state.anchor is who or any(p.target is state.anchor for p in who.pps)
    )
    if not waiting or state.between != {","} or state.candidate_done:
        return None
    verb = state.at(2)
    coming = isinstance(verb, Event) and verb.form == "ing" and not verb.nominal
    told = _described_role(state)
    if state.at(1).value == ",":  # "a car, a taxi, coming from the left, brakes"
        told = coming or predicate_opens(verb)
    return who if told else None


def also_from(noun: NounPhrase, state: State) -> bool:
    """``from the north and the east``: the preposition counts for both."""
    last = state.last_prep
    if last is None or not (isinstance(noun, Place) and noun.kind == "side"):
        return False
    aside = noun.has("possessive") and "," in state.between  # "from the left, its rear 20 m ahead"
    joined = state.between & {"and", "or", ","} and isinstance(last.target, Place) and not aside
    if not joined or last.target is None or last.target.j != noun.i - 1:
        return False
    further = Prep(last.word, noun, last.outer, last.on_mention)
    listed = [e.pps for e in state.events[-1:]] + [m.pps for m in state.mentions]
    for phrases in listed:
        if last in phrases:
            phrases.append(further)
    state.last_prep = further
    return True


def bracketed(state: State) -> bool:
    """``vehicle 1 (a taxi)``, ``vehicle A (ego, 60 km/h)``: it describes the noun before.

    In "60 km/h (van)" the number is its.
    """
    if state.at(-1).value != "(" or state.at(-2).cat == "quantity":
        return False
    after = state.after(_REACH + 1)
    rest = dropwhile(lambda c: c.cat in {"quantity", "prep"} or c.value == ",", after)
    return next(rest, NOTHING).value == ")"


def _names_before(state: State) -> bool:
    """``struck V2, a pickup.``, ``V1, also a car and …``: a noun without a name after a name."""
    here, before = state.at(0), state.anchor
    if state.between != {","} or not isinstance(before, Mention) or not isinstance(here, Mention):
        return False
    following, after = state.at(1), state.at(2)
    known = before.is_ego or before.label is not None or before.has("det", "def")
    known = known or before.noun in _OF_ANY_KIND
    closed = ends(following) or (following.value == "," and after.cat in _GOES_ON)
    closed &= known and (state.candidate_done or bool(state.events))  # "hits the SV, a car."
    listed = following.cat == "conj" and state.at(-1).value != "mild"
    acts = isinstance(following, Event) and following.form != "ing"
    named = (before.is_named or closed) and not here.is_named
    told = here.has("det", "indef") or (here.is_ego and bool(here.mods))
    return named and told and not (listed or acts)


def partitive_before(state: State) -> Mention | None:
    """``four of them trucks``, ``one a bus``: the noun says what kind they are."""
    part, of, whole = (state.at(n) for n in (-3, -2, -1))
    if isinstance(whole, Mention) and whole.pronoun in word_list("parts"):
        return None if whole.prep else whole  # "from behind the second a boy runs out"
    if not isinstance(part, Mention) or of.value != "of":
        return None
    named = isinstance(whole, Mention) and whole.pronoun == "they"
    return part if named or (whole.cat == "rel") else None


def _described_role(state: State) -> bool:
    """``the driver, a man from Leeds, lost …``: a noun and its phrases between two commas."""
    role, noun = state.candidate, state.at(0)
    if role is None or not role.heads or not isinstance(noun, Mention) or not noun.mods:
        return False
    after = state.after(8)
    end = next((m for m, c in enumerate(after) if c.value == ","), None)
    number = noun.mod("num")
    all_of_them = number is not None and number.data["number"] == len(chain(role)) > 1
    if end is None or not (noun.opened_by("indef") or noun.is_ego or all_of_them):
        return False
    joined = any(c.cat in {"conj", "sub", "copy"} for c in after[:end])
    verb = chunk_at(after, end + 1)
    return not joined and predicate_opens(verb)


def relative_noun(state: State) -> Mention | None:
    """``struck vehicle 2, which was a taxi``: the noun says what vehicle 2 is."""
    noun = state.at(0)
    before = [c for c in state.before(4) if c.value != ","]
    if len(before) < _RELATIVE or not isinstance(noun, Mention) or not noun.mods:
        return None
    who, joint, copula = before[-_RELATIVE:]
    relative = joint.cat == "rel"
    said = (copula.cat, copula.value) == ("aux", "be")
    single = noun.opened_by("indef") or noun.is_ego
    return who if relative and said and single and isinstance(who, Mention) else None


def further_ones(mention: Mention, state: State) -> bool:
    """``two cars coming from the left and one from the right``: three cars, not two."""
    if mention.pronoun not in {"one", "count"} or not {"and"} <= state.between <= {"and", "conj"}:
        return False
    who, following = state.anchor, state.at(1)
    participle = isinstance(who, Event) and who.form == "ing"
    if isinstance(who, Event) and participle and len(who.subject) == 1:
        who = who.subject[0]
    number = who.mod("num") if isinstance(who, Mention) and who.heads else None
    if number is None or number.data["number"] < 2:
        return False
    again = isinstance(following, Event) and following.form == "ing" and participle
    off = following.value == "from"
    return again or (off and state.last_prep is not None and state.last_prep.value == "from")


_ITS = frozenset({"it", "him", "they"})
_REACH = 6


def antecedent(state: State) -> Mention:
    """The noun before "which": the last one that does not merely own something.

    In "the car ahead of us, which" and "there is a car ahead of the ego, which" it is the car.
    """
    done_to = state.last.object if state.last is not None else None
    if isinstance(done_to, Mention) and any(done_to.i < m.i for m in state.events[-1].subject):
        return done_to  # "the car that the ego follows, which …"
    nouns = [m for m in reversed(state.mentions) if not m.possessor] or state.mentions[-1:]
    other = _about_another(state)
    beside = [m for m in nouns if located(m) and (told(m) or (other and m.is_ego))]
    return next((m for m in nouns if not (m in beside or m.aside)), nouns[0])


def _about_another(state: State) -> bool:
    """``a car ahead of the ego that …``, ``ahead of the ego, in its lane, which …``: of the car.

    "A car ahead of the ego, which …" is so where "there is" introduces the car.
    """
    begin = max(0, state.chunks.index(state.mentions[0]) - 1)
    k = next((k for k in range(state.k, 0, -1) if state.chunks[k].cat == "rel"), begin)
    if k <= begin:
        return False  # nothing stands before "which"
    comma, opened = state.chunks[k - 1].value == ",", [c.value for c in state.chunks[begin:k]]
    apart = not isinstance(state.chunks[k - 1 - comma], Mention)
    alone = not comma and state.waiting is not None and "be" not in opened
    return alone or apart or opened[0] == "thereis"


def located(mention: Mention) -> bool:
    """Whether somebody is said to be ahead of it, beside it and so on."""
    return mention.prep is not None and mention.prep.cat == "locus"


def told(mention: Mention) -> bool:
    """Whether one knows already who that is: "it", "them", "me"."""
    return mention.pronoun in _ITS or mention.is_me


def opens_relative(mention: Mention, state: State) -> bool:
    """Whether a noun begins a clause that says what is done to the noun before it.

    The state keeps both nouns.
    """
    that = state.at(-1)
    marked = that.cat == "rel"
    between = -1 - marked
    between -= marked and state.at(between).value == ","
    placed = state.at(between)  # "the car ahead, which the ego follows"
    between -= marked and placed.cat == "locus"
    about = state.at(between)
    if not isinstance(about, Mention) or not about.heads or about.possessor:
        return False
    waits = about is state.waiting and not state.between
    known = mention.pronoun is not None or mention.is_ego
    if not (marked or waits or known) or not _acts(state):
        return False
    state.relative = (mention, about)
    return True


def _acts(state: State) -> bool:
    """Whether a verb follows that wants an object and does not get one."""
    for n, chunk in enumerate(state.after(_REACH), start=1):
        if isinstance(chunk, Event):
            if chunk.control == "subject":
                continue  # "the van that the ego wants to overtake"
            free = not isinstance(state.at(n + 1), Mention)
            return chunk.name in word_list("done_to_somebody") and free and not chunk.nominal
    return False


def close_relative(event: Event, state: State) -> bool:
    """Gives the verb of such a clause its subject and object; the clause around it goes on.

    Returns:
        Whether there was such a clause.
    """
    if state.relative is None:
        return False
    actor, about = state.relative
    event.subject, event.object = [actor], about
    if state.last is not None and state.last.control == "subject" and state.last.object is about:
        depend(event, state.last, "inf")
    state.relative = state.relative if event.control == "subject" else None
    return True


def is_closed(state: State) -> bool:
    """``drives ahead of the ego, which is as fast, and brakes``: who drives, not the ego."""
    return "conj" in state.between and state.at(-2).value == "," and bool(state.events)


def aside(event: Event, events: list[Event]) -> bool:
    """``the ego comes to a spot where a van stops, and it …``: not what the sentence is about."""
    outer = (e for e in events if e.finite and e.subject and not e.embedded and e.i < event.i)
    return event.embedded and any(e.sentence == event.sentence for e in outer)
