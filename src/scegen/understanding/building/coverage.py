"""Nothing is dropped silently: words that changed no field, doings that nothing shows."""

from collections.abc import Iterator

from scegen.scenario.acts import LEAVING, ActKind
from scegen.scenario.control import STOPS, controlled_arms
from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import BAYS
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Approach, Control, Maneuver, Role
from scegen.understanding.chunks import Event
from scegen.understanding.frames import acts, always_acts
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token, base_words, low_at

_INSTEAD = {
    "manner": "says how it is done; no field holds that here",
    "dir": "a direction that no rule could attach; left out",
    "locus": "a position that no rule could attach; left out",
    "compass": "a direction that no rule could attach; left out",
    "quantity": "a measure that no rule could attach; left out",
    "state": "a state that no rule could attach; left out",
    "num": "a number that nothing says what it is of",
    "lane": "which lane of those that are built this is stays open",
    "env": "conditions are given once; the first counts",
    "control": "one rule of priority is kept for the whole junction; the strictest counts",
}
CONTRADICTS = "contradicts "
"""How the remark on words begins that say otherwise than words before them."""
_EMPTY = frozenset({"mild", "same", "respectively"})
"""Words that stress or order what other words say."""
_PORTION = ("place", "portion")
"""The left half of something: only that of a front has a field."""
_WHO = (".kind", ".role")
"""Fields that rest on a whole noun phrase, whatever adjectives stand in it."""
_MOST = 200
_MANY = 3
"""From so many on, a number in words is more than "the two" or "one of them"."""


def unattached(
    scenario: FunctionalScenario, terms: list[Term], events: list[Event], tokens: list[Token]
) -> FunctionalScenario:
    """Reports known words of manner, direction, state and measure on which nothing rests."""
    proved = [
        (e.field, e.start, e.end)
        for e in scenario.evidence
        if e.start is not None and e.end is not None
    ]
    named = [(start, end) for _, start, end in proved]
    spans = [(start, end) for field, start, end in proved if not field.endswith(_WHO)]
    spans += [(u.start, u.end) for u in scenario.unsupported]
    spans += [(tokens[t.i].start, tokens[t.j - 1].end) for t in _met(events, scenario)]
    told = [(start, end) for field, start, end in proved if field == "outcome.kind"]
    found = [  # "misses" denies no seeing
        u for u in scenario.unsupported if not any(a <= u.start < b for a, b in told)
    ]
    title = next((k for k, token in enumerate(tokens) if token.low == ":"), 0)
    for before, term in zip([None, *terms], terms, strict=False):
        cat, empty = _sort(term, before), term.value in _EMPTY or "figure" in term.data
        if cat not in _INSTEAD or empty or len(found) >= _MOST:
            continue
        start, end = tokens[term.i].start, tokens[term.j - 1].end
        gauge = low_at(tokens, term.i - 1) in word_list("gauged")
        if term.value == "between" and (gauge or (before and before.cat == "quantity")):
            continue  # "the gap between them", "1.5 s between them": the number is told of
        dark = scenario.junction.control is Control.SIGNALS_OFF
        if dark and (term.cat, term.value) == ("control", Control.SIGNALS):
            continue  # "a signalised intersection, whose lights are off"
        if term.cat == "num" and _counts(term, before, tokens, named, scenario):
            continue
        own = before is not None and before.cat == "possessive" and term.value == "front"
        resting = spans + (told if own or cat == "locus" else [])  # "stops in front of him"
        if any(a <= start and end <= b for a, b in resting) or _held(term, before, scenario):
            continue
        if term.j <= title and _told_below(term, terms, tokens, spans, title):
            continue
        text = scenario.description[start:end]
        instead = _otherwise(term, scenario) or _INSTEAD[cat]
        found.append(Unsupported(text=text, start=start, end=end, instead=instead))
    return with_remarks(scenario, found)


def _met(events: list[Event], scenario: FunctionalScenario) -> Iterator[Term]:
    """``crosses in front of it``, ``comes up from behind``: where one is met, as fields say."""
    named = {p.id: p for p in scenario.participants}
    backs = {act.participant for act in scenario.acts if act.kind is ActKind.REVERSE}
    follows = any(p.approaches == {Approach.AHEAD} for p in scenario.participants)
    for event in events:
        doers = [named[e.name] for m in event.subject for e in m.entities if e.name in named]
        crosses = event.name == "cross" or any(Maneuver.CROSS in d.maneuvers for d in doers)
        ours = follows and any(d.role is Role.EGO for d in doers)
        for prep in (p for p in event.pps if p.word.cat == "locus"):
            met = {e.name for e in prep.who.entities} if prep.who is not None else set()
            faced = crosses and met and prep.value == ("behind" if met & backs else "ahead")
            rear = (prep.outer, prep.value, prep.target) == ("from", "behind", None)
            if faced or (ours and rear):
                yield prep.word


def with_remarks(scenario: FunctionalScenario, found: list[Unsupported]) -> FunctionalScenario:
    """The scenario with these remarks, in the order of the text."""
    if found == list(scenario.unsupported):
        return scenario
    found.sort(key=lambda u: (u.start, u.end))
    return scenario.model_copy(update={"unsupported": tuple(found)})


def _sort(term: Term, before: Term | None) -> str:
    """What kind of word it is here: its class, but for a portion and the number of a lane."""
    if (term.cat, term.value) == _PORTION:
        return "dir"
    of_lane = term.cat == "num" and before is not None and before.value == "lane"
    return "lane" if of_lane else term.cat


def _told_below(
    term: Term, terms: list[Term], tokens: list[Token], spans: list[tuple[int, int]], title: int
) -> bool:
    """``Cut-in from the left: …``, and below it who comes from there."""
    again = (t for t in terms if (t.cat, t.value) == (term.cat, term.value) and t.i >= title)
    places = [(tokens[t.i].start, tokens[t.j - 1].end) for t in again]
    return any(a <= start and end <= b for start, end in places for a, b in spans)


def _held(term: Term, before: Term | None, scenario: FunctionalScenario) -> bool:
    """``the stationary car``, ``a lateral gap``, ``head-on``: words for what a field holds."""
    if term.cat == "state":
        known = before is not None and (before.cat, before.value) == ("det", "def")
        return known and any(p.maneuvers == {Maneuver.STAY} for p in scenario.participants)
    if term.value == "lateral":
        return any(s.measure.value.startswith("lateral") for s in scenario.spacings)
    met = scenario.outcome is not None and scenario.outcome.kind is OutcomeKind.COLLISION
    faced = any(Approach.OPPOSITE in p.approaches for p in scenario.participants)
    return term.value == "head_on" and met and faced


def _counts(
    term: Term,
    before: Term | None,
    tokens: list[Token],
    named: list[tuple[int, int]],
    scenario: FunctionalScenario,
) -> bool:
    """``two cars``, ``vehicle 1``, ``one of them``: a number that counts or names somebody."""
    start, end = tokens[term.i].start, tokens[term.j - 1].end
    inside = any(a <= start and end <= b for a, b in named)
    called = before is not None and before.cat in {"actor", "place", "label", "quant"}
    called = called and _sort(term, before) != "lane"  # the field rests on that
    if tokens[term.i].kind == "number":
        return inside or called
    junction, number = scenario.junction, term.data["number"]
    counted = {len(scenario.participants), junction.arms, *junction.lanes}  # "one on each of four"
    counted |= {group.number for group in scenario.groups}
    return number < _MANY or inside or called or number in counted


def _otherwise(term: Term, scenario: FunctionalScenario) -> str | None:
    """The remark if the word says otherwise than what a field holds."""
    if term.cat == "env":
        held = getattr(scenario.environment, term.data["field"])
    elif term.cat == "control":
        held = scenario.junction.control
    else:
        return None
    return None if held in {None, term.value} else f"{CONTRADICTS}'{held}', which is kept"


_UNDONE = "what is done here became no act; left out"
_RESTS = frozenset({ActKind.STOP, ActKind.WAIT, ActKind.GIVE_WAY})
_SHOWN_BY = {
    ActKind.BRAKE: _RESTS,
    ActKind.STOP: _RESTS | {ActKind.BRAKE, ActKind.CROSS, ActKind.SET_OFF},
    ActKind.GIVE_WAY: _RESTS | {ActKind.BRAKE, ActKind.ENTER, ActKind.SET_OFF},
    ActKind.SET_OFF: LEAVING
    | {ActKind.WAIT, ActKind.GIVE_WAY, ActKind.ACCELERATE, ActKind.TURN, ActKind.ENTER},
    ActKind.CHANGE_LANE: LEAVING,
    ActKind.SWERVE: LEAVING,
}
"""Acts by which another is seen to happen as well."""
_MOVES = {
    ActKind.STOP: {Maneuver.STAY, Maneuver.CROSS},
    ActKind.BRAKE: {Maneuver.STAY},
    ActKind.GIVE_WAY: {Maneuver.STAY, Maneuver.CROSS},
    ActKind.SET_OFF: {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE, Maneuver.CROSS},
    ActKind.CHANGE_LANE: {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE},
    ActKind.SWERVE: {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE},
}


def undone(
    scenario: FunctionalScenario, events: list[Event], tokens: list[Token]
) -> FunctionalScenario:
    """Reports acts that are told of somebody who does nothing of the kind in the scenario."""
    spans = [(e.start, e.end) for e in scenario.evidence if e.start is not None]
    spans += [(u.start, u.end) for u in scenario.unsupported]
    named = {p.id: p for p in scenario.participants}
    found = list(scenario.unsupported)
    for event in events:
        kind = acts().get(event.name) if event.name in always_acts() else None
        if kind is None or kind not in _SHOWN_BY or not _told(event, tokens):
            continue
        start, end = tokens[event.i].start, tokens[event.j - 1].end
        if any(a < end and start < (b or a) for a, b in spans):
            continue
        doers = [named[e.name] for m in event.subject if not m.denied for e in m.entities]
        if doers and not any(_shown(kind, doer, scenario) for doer in doers):
            text = scenario.description[start:end]
            found.append(Unsupported(text=text, start=start, end=end, instead=_UNDONE))
    return with_remarks(scenario, found)


def _told(event: Event, tokens: list[Token]) -> bool:
    """Whether it is told to happen, by a verb of its own: not wished, feared or denied."""
    if event.nominal or event.negated or event.unable or event.premod_of:
        return False
    words = base_words(tokens, event.i, event.j)
    if event.name == "leave" and words not in word_list("setting_off"):
        return False  # "leaves the stem", "leaves 1 m", "stays clear"
    above = event.parent
    return above is None or not (above.negated or above.control == "subject")


def _shown(kind: ActKind, doer: Participant, scenario: FunctionalScenario) -> bool:
    """Whether the scenario has an act or a way of one's own that amounts to it."""
    own = {act.kind for act in scenario.acts if act.participant == doer.id}
    stands = doer.speed_mps is not None and doer.speed_mps.high == 0.0
    at_rest = kind in {ActKind.STOP, ActKind.GIVE_WAY, ActKind.BRAKE}
    junction, arms = scenario.junction, doer.entries or frozenset(range(scenario.junction.arms))
    breaks = any(doer.id in h.by and HAZARDS[h.kind].breaks for h in scenario.hazards)
    halts = not breaks and junction.control in STOPS and arms <= controlled_arms(junction)
    if at_rest and (stands or doer.parked or doer.light in {AtLight.RED, AtLight.WAITS} or halts):
        return True
    if kind is ActKind.SET_OFF and (stands or doer.strip in BAYS):
        return True  # nobody drives along in a bay
    return bool(own & {kind, *_SHOWN_BY[kind]} or doer.maneuvers & _MOVES[kind])
