"""What somebody is told to do, and nothing of the scenario shows: said, not dropped."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.roadway import BAYS
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.building.coverage import with_remarks
from scegen.understanding.chunks import Event
from scegen.understanding.frames import acts, always_acts
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token, base_words

_INSTEAD = "what is done here became no act; left out"
_RESTS = frozenset({ActKind.STOP, ActKind.WAIT, ActKind.GIVE_WAY})
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE, ActKind.OVERTAKE})
_SHOWN_BY = {
    ActKind.BRAKE: _RESTS,
    ActKind.STOP: _RESTS | {ActKind.BRAKE, ActKind.CROSS, ActKind.SET_OFF},
    ActKind.GIVE_WAY: _RESTS | {ActKind.BRAKE, ActKind.ENTER, ActKind.SET_OFF},
    ActKind.SET_OFF: _ASIDE
    | {ActKind.WAIT, ActKind.GIVE_WAY, ActKind.ACCELERATE, ActKind.TURN, ActKind.ENTER},
    ActKind.CHANGE_LANE: _ASIDE,
    ActKind.SWERVE: _ASIDE,
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
            found.append(Unsupported(text=text, start=start, end=end, instead=_INSTEAD))
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
    at_rest = kind in {ActKind.STOP, ActKind.GIVE_WAY, ActKind.BRAKE}
    if at_rest and (doer.parked or doer.light in {AtLight.RED, AtLight.WAITS}):
        return True
    if kind is ActKind.SET_OFF and doer.strip in BAYS:
        return True  # nobody drives along in a bay
    return bool(own & {kind, *_SHOWN_BY[kind]} or doer.maneuvers & _MOVES[kind])
