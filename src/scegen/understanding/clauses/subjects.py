"""Finds the subject of a verb from the words before it."""

from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.clauses.coordination import auxiliary, coordinate, no_jam, told_beside
from scegen.understanding.clauses.dependents import (
    chain,
    depend,
    gerund,
    infinitive,
    let_do,
    met_with,
    nominal,
    on_foot,
    whose_bare,
)
from scegen.understanding.clauses.further import antecedent, is_closed, located, told
from scegen.understanding.clauses.located import RESTING
from scegen.understanding.clauses.state import State
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.doings_named import teller_at
from scegen.understanding.phrases.lookahead import main_verb_follows

_PASSING = frozenset({"overtake", "bypass", "pass"})
_OF_PARTS = frozenset({"collide", "appear", "approach", "lose_control", "swerve"})  # and of wholes
_NAMED = frozenset({"", "between", "of", "with"})
_SHOWN = frozenset({"encounter", "cause", "prevent"})
"""Verbs that say what their object is doing."""


def link(event: Event, state: State) -> None:
    """Gives the event its subject, its parent verb and its mood."""
    interrupts = {"rel", ","} <= state.between and bool(state.mentions) and event.form == "ing"
    state.relating = antecedent(state) if interrupts else state.relating
    _link(event, state)
    if interrupts and state.relating is not None:  # "a man who, looking down, walks on"
        event.subject = [state.relating]
    done = event.form == "ed" and event.object is None and event.name not in _OF_PARTS
    sign = state.at(-1)
    if done and event.subject and isinstance(sign, Place) and sign.prep is None:
        event.object = sign  # "a car comes from the left, red light ignored"


def _link(event: Event, state: State) -> None:
    if event.nominal:
        nominal(event, state)
        return
    helped = auxiliary(state)
    if state.awaits("to") and event.form == "base":
        infinitive(event, state)
    elif (verb := whose_bare(event, state)) is not None and verb.control == "object":
        infinitive(event, state, verb)
    elif state.prep is not None and (
        event.form == "ing"
        or (state.prep.value == "without" and {"aux:can", "aux:have"} & state.between)
    ):  # "without being able to stop", "without having braked"
        gerund(event, state)
    else:
        event.finite = event.form in {"s", "ed", "base"} or helped
        if event.finite and state.topic is not None:
            _said_of_a_thing(event, state)
            return
        _clause(event, state)
    parent = event.parent
    if parent is not None and parent.control == "object" and event.form == "base":
        event.finite = event.finite and helped  # "lets them cross": no clause of its own
    be = "aux:be" in state.between
    undergone = be and event.form == "base" and event.name in word_list("done_to")
    if undergone and not state.awaits("to"):
        event.form = "ed"  # "is cut off", "was hit": the participle looks like the base form
    if event.reduced and event.form == "ed" and not helped:
        event.finite = False
        event.passive = event.name in word_list("describing") & word_list("done_to")
        return
    if event.form == "ed" and event.name in word_list("done_to"):
        event.passive = be
    if event.finite and event.subject:
        state.main = event.subject
        waits = "rel" in state.between and event.subject[-1] is state.candidate
        state.candidate_done = state.candidate_done or not waits


def before_by(event: Event) -> None:
    """``…, obstructed by a van``: a participle with "by" after it is passive."""
    crossed = event.name == "cross" and event.object is not None and not event.subject
    participle = event.form == "ed" or (event.form == "base" and event.name == "collide")  # "hit"
    if participle and not event.nominal and (crossed or event.name in word_list("done_to")):
        event.passive = True


def _said_of_a_thing(event: Event, state: State) -> None:
    """``the view is blocked by a van``: nobody acts but who stands after "by"."""
    topic, state.topic = state.topic, None
    passive = event.form == "ed" or (event.form == "base" and event.name in word_list("done_to"))
    if "aux:be" in state.between:
        if passive:
            event.passive, event.object = event.name in word_list("done_to"), topic
    elif topic is not None and (event.name in _OF_PARTS or state.at(1).value == "into"):
        known = topic.has("possessive", "its") or event.name == "lose_control"
        its = state.main if known else []  # "I braked and the back end let go"
        its = [teller_at(topic.i)] if topic.has("possessive", "first_person") else its
        # "the front of the van struck …", "its front appears …", "my bumper runs into …"
        event.subject = [topic.owner] if topic.owner is not None else its


def _clause(event: Event, state: State) -> None:
    anchor, between = state.anchor, state.between
    event.embedded = ("rel" in between and not is_closed(state)) or state.where
    event.supplement = {"rel", ","} <= between
    described = _noun_described(event, state) if event.reduced else None
    seen = whose_bare(event, state)
    noun = described or (seen.object if seen is not None else None)
    if isinstance(noun, Mention):
        event.subject, event.finite = chain(noun), event.finite and described is None
        return
    if "thing" in between:
        return  # "a fallen tree that blocks the lane"
    if state.relating is not None and event.finite and between == {","}:
        event.subject, state.relating = [state.relating], None
    elif state.resumed and event.finite and _resumes(state):
        event.subject, state.resumed = _goes_on(event, state), []
    elif state.waiting is not None and _past_being(event, state):
        event.subject, event.embedded = chain(state.waiting), False
    elif (
        "rel" in between
        and state.mentions
        and event.embedded
        and not ("conj" in between and no_jam(event, [], state))
    ):  # "comes up to a van that is slow and overtakes it": the one that comes up does
        which = antecedent(state)
        singular = event.form == "s" and (which.head is None or which.head.form != "s")
        event.subject = [which] if singular else chain(which)
    elif "sub" in between:
        _subjectless(event, state)
    elif "conj" in between and state.events:
        coordinate(event, state)
    elif "," in between:
        _after_comma(event, state)
    elif isinstance(anchor, Mention):
        _after_mention(event, anchor, state)
    elif isinstance(anchor, Event):
        _after_event(event, anchor, state)
    else:
        _subjectless(event, state)


def _after_event(event: Event, anchor: Event, state: State) -> None:
    if event.finite and state.waiting is not None:
        event.subject = chain(state.waiting)  # "a man with a walking frame crosses"
        return
    depend(event, anchor, "ing")
    event.subject = anchor.subject
    event.negated = anchor.name == "prevent"  # "oncoming cars prevent overtaking"


def _past_being(event: Event, state: State) -> bool:
    """``a van that is behind the ego brakes``: the van, as "is" has its end before the verb."""
    if not {"rel", "aux:be"} <= state.between or "," in state.between:
        return False
    helped = bool({"aux:do", "aux:will", "aux:can", "aux:modal", "aux:shall"} & state.between)
    beside = state.mentions[-1:] != [state.candidate] and event.name not in word_list("done_to")
    return helped or event.form == "s" or (event.form == "ed" and beside)


def _subjectless(event: Event, state: State) -> None:
    """``while turning``: who waits for a verb, acted before, or acts in the clause that follows."""
    if state.waiting is not None:
        event.subject = chain(state.waiting)
    elif state.last is not None and not event.finite and "," not in state.between:
        event.subject = state.main or state.last.subject
    elif state.main and state.events:
        event.subject = state.main
    else:
        state.pending.append(event)


def _after_comma(event: Event, state: State) -> None:
    who = state.waiting
    beside = None
    if not event.finite:
        beside = let_do(state) or on_foot(event, state) or met_with(event, state)
        beside = beside or told_beside(state, "with", "by")
    if (named := _past_an_aside(event, state)) is not None:
        event.subject = [named]
    elif event.form == "s" and state.dependent and "aux:be" in state.between and state.events:
        event.subject = main_in_sentence(state)  # "brakes when the ego is 20 m away, swerves"
    elif who is not None and state.anchor in (who, *(p.target for p in who.pps)):
        event.subject = _last_of(who, event, state)  # "when a van, turning left, fails to yield"
    elif beside is not None:
        event.subject = [beside]
    elif state.candidate is not None and (event.finite or not state.main):
        event.subject = _last_of(state.candidate, event, state)
    elif state.last is not None:
        event.subject = main_in_sentence(state)
        if not event.finite:  # what hangs on an obliged verb is no less obliged
            event.modal = event.modal or state.last.modal
    elif isinstance(noun := state.anchor, Mention) and noun.opening in _NAMED and not event.finite:
        event.subject = chain(noun)  # "there is a van, turning left", "a crash of a van, doing …"
    else:
        state.pending.append(event)


def _resumes(state: State) -> bool:
    """``and, once it has passed, …``, ``and, once it is past, …``: that clause has its verb."""
    done = state.waiting is None or "aux:be" in state.between
    return done and "," in state.between and "rel" not in state.between


def _goes_on(event: Event, state: State) -> list[Mention]:
    """``overtaken by a van that comes up and, once it is past, brakes``: the van, like "comes"."""
    last, outer = state.resumed[-1], [e for e in state.resumed if not e.embedded]
    again = state.candidate is not None and state.candidate.noun == last.subject[-1].noun
    alike = last.form == event.form and not (again or no_jam(event, last.subject, state))
    return last.subject if alike or not outer else outer[-1].subject


def _past_an_aside(event: Event, state: State) -> Mention | None:
    """``two men, one doing 3 km/h and the other doing 6 km/h, cross``: the two, not the other.

    So does the van in "a van ahead of us, both doing 60 km/h, brakes".
    """
    one = state.candidate
    single = event.form == "s" and one is not None and one.pronoun in {"both", "all"}
    several = event.form == "base" and not auxiliary(state)
    if one is None or one.heads or one.pronoun is None or not (single or several):
        return None
    fits = (m for m in state.mentions if m.heads and (m.plural and m.has("num")) != single)
    return next(fits, None)


def main_in_sentence(state: State) -> list[Mention]:
    """Who acts in the last main clause of the sentence."""
    acting = [e for e in state.events if e.subject]
    finite = [e for e in acting if e.finite]
    main = [e for e in finite if not e.embedded]  # "hits a man who walks, killing …"
    return next((e.subject for e in reversed(main or finite or acting)), [])


def _noun_described(event: Event, state: State) -> Mention | None:
    """``hidden by two cars parked there``: the noun in a phrase that a participle is said of."""
    noun = state.last_pp or state.anchor
    if not isinstance(noun, Mention) or noun.prep is None or noun.j != event.i:
        return None
    rests = bool(state.fronted) and (event.name, event.form) in RESTING
    return noun if rests or (event.form == "ed" and event.name in word_list("describing")) else None


def only_describes(event: Event, state: State) -> bool:
    """``hidden behind a van runs out``, ``by two cars parked there``: no clause of its own."""
    noun = _noun_described(event, state)
    if noun and (noun.stands_after("by") or state.candidate_done or state.fronted):
        return True
    described = state.anchor is state.candidate or noun is not None
    return described and main_verb_follows(state.chunks, state.k)


def _after_mention(event: Event, anchor: Mention, state: State) -> None:
    let = event.form == "base" and let_do(state) is not None  # "is in place to let a man cross"
    if event.finite and state.waiting is not None and not let:
        event.subject = chain(state.waiting)
        return
    event.finite = event.finite and (event.form != "ed" or anchor is state.candidate)
    last, known = state.last, told(anchor)
    # "with the van ahead of the ego braking": but "the car behind the ego turning left stops"
    known = known or (anchor.is_ego and state.waiting is not None and not state.verb_follows)
    done_to = last if last is not None and last.object is anchor else None
    if done_to is not None and done_to.name in {"cause", "prevent"}:
        depend(event, done_to, "ing")
    within = anchor.stands_after("in") and anchor.is_mass
    if last is not None and within and event.form == "ing":
        event.subject = last.subject  # "is stopped in traffic waiting to turn"
    elif known and located(anchor) and not event.finite and state.candidate is not None:
        event.subject = chain(state.candidate)  # "the car in front of it reversing towards it"
    elif done_to is not None and not event.finite and _by_doing(event, done_to, known, state):
        event.subject = done_to.subject
    else:
        own = anchor is state.candidate and not _one_of_them(state)
        event.subject = chain(anchor) if own else _last_of(anchor, event, state)


def _by_doing(event: Event, done_to: Event, told: bool, state: State) -> bool:
    """``nearly hit me coming from the right``, ``overtakes a bus using the opposite lane``.

    Who rests is the other: ``hits it standing there``.
    """
    if event.name == "use" and done_to.name in _PASSING:
        return isinstance(lane := state.at(1), Place) and "opposite" in lane.dirs
    return told and done_to.name not in _SHOWN and (event.name, event.form) not in RESTING


def _last_of(noun: Mention, event: Event, state: State) -> list[Mention]:
    """``passes the ego and a van driving on``, ``a bus and a van overtaking it``: the van."""
    listed = chain(noun)
    apart = _one_of_them(state) or any(m.is_ego or m.pps for m in listed[:-1])
    return [noun] if not event.finite and apart else listed


def _one_of_them(state: State) -> bool:
    """``a bus and a van overtaking it``: one of those who are listed, or some."""
    return isinstance(whom := state.at(1), Mention) and whom.pronoun in {"it", "they"}
