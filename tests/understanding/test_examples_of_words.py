"""Every example of the glossary, read in a sentence, gives the word that it is the example of."""

from __future__ import annotations

from enum import StrEnum

import pytest

from scegen.scenario.acts import ActKind
from scegen.scenario.environment import RoadSurface, TimeOfDay, Visibility, Weather
from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.glossary import VOCABULARY, meaning_of
from scegen.scenario.outcome import BodySide, OutcomeKind
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.spacings import Measure
from scegen.scenario.things import ThingKind
from scegen.scenario.vocabulary import (
    ANIMALS,
    Approach,
    ArmsMode,
    Control,
    CrossedArm,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Reduction,
    Role,
    Side,
)
from scegen.understanding import read

_NOT_READ = {EvidenceSource, Reduction, ArmsMode, Role, Side}
"""Words of evidence and of counting, and words that stand for no phrase of their own."""
_AROUND = (Weather, TimeOfDay, RoadSurface, Visibility)
_NOUNS = ("a ", "an ", "the ", "Germany", "black ice", "debris", "pylons", "roadworks", "shrubs")
_PREPOSITIONS = ("at ", "in ", "on ", "along ", "with ", "hit ")

_STATED = {
    JunctionKind: "Two cars meet at {}.",
    Control: "Two cars meet at {}.",
    DrivingSide: "The ego follows a car {}.",
    Carriageway: "The ego follows a car on {}.",
    ParticipantKind: "{} is ahead of the ego.",
    Approach: "{} meets the ego.",
    ThingKind: "A child runs out from behind {} in front of the ego.",
    Maneuver: "A car {} in front of the ego.",
    AuxiliaryLane: "A car {} in front of the ego.",
    CrossedArm: "At a crossroads the ego turns left and a pedestrian {}.",
    AtLight: "The ego {} at the traffic lights of a crossroads.",
    OutcomeKind: "A car from the left {} the ego.",
    ActKind: "The ego drives and a car ahead {}.",
    Measure: "The ego follows a car {}.",
    BodySide: "The ego is {} by a car.",
}
"""The sentence into which an example of each list is put."""


_OWN = {
    "a row of parked cars": "A child steps out from a row of parked cars in front of the ego.",
    "in the acceleration lane": "On a motorway a car drives in the acceleration lane.",
    "the right lane ends": "On a motorway the right lane ends, and a car merges before the ego.",
    "oncoming": "The ego meets an oncoming car.",
    "crosses the street": "A woman crosses the street in front of the ego.",
    "the truck sticks to the ego's bumper": "A truck drives behind the ego. It sticks to the ego's "
    "bumper.",
    "a lost wheel": "A lost wheel lies on the road ahead of the ego.",
    "turns left as soon as the ego is near": "An oncoming car turns left at a crossroads when the "
    "ego is 20 m away.",
    "a van enters from the right 2 s after the ego": "At a crossroads a van enters from the right "
    "2 s after the ego.",
    "steps off the kerb when the ego is 30 m away": "A man steps off the kerb when the ego is 30 m "
    "away.",
    "opens its door when the cyclist is 10 m away": "The ego follows a cyclist. A parked car opens "
    "its door when the cyclist is 10 m away.",
    "crosses on green for pedestrians": "At traffic lights a woman crosses on green for "
    "pedestrians.",
    "a pedestrian crosses at red": "At traffic lights a pedestrian crosses at red.",
    "when the light turns green it sets off": "The ego waits at a crossroads; when the light turns "
    "green it sets off.",
    "the light turns red and it stops": "The ego comes to a crossroads; the light turns red and it "
    "stops.",
    "hit head-on": "The ego is hit head-on by an oncoming car.",
    "hit from behind": "The ego is hit from behind by a van.",
    "struck in the driver's side": "At a crossroads the ego is struck in the driver's side by a "
    "van.",
    "struck from the right": "At a crossroads the ego is struck from the right by a van.",
    "0.5 m left of the ego's line": "A car drives ahead of the ego, 0.5 m left of the ego's line.",
    "the ego turns left across an oncoming truck": "At a crossroads the ego turns left across an "
    "oncoming truck.",
    "brakes with 4 m/s2 to a standstill": "The ego follows a car that brakes with 4 m/s2 to a "
    "standstill.",
    "pulls away with 2 m/s2 to 30 km/h": "A parked car pulls away with 2 m/s2 to 30 km/h as the "
    "ego approaches.",
    "pulls out to overtake the truck": "A truck drives ahead of the ego, which pulls out to "
    "overtake the truck.",
    "at the stop line of a side road": "A car stands at the stop line of a side road as the ego "
    "approaches.",
    "takes the right-hand branch": "At a fork the ego takes the right-hand branch.",
}
"""Examples that do not stand alone, in a sentence of their own."""


_OPEN = {
    "a row of parked cars": "they are parked; the strip for them is left to the road",
    "in the acceleration lane": "a place in that lane asks for no ramp",
    "a deer in the lane": "who reads makes it a participant, which may run",
    "a tree trunk at the kerb": "a trunk lies, unless more is said",
    "brakes with 4 m/s2 to a standstill": "braking to no speed at all is the same act",
    "pulls out to overtake the truck": "read as the maneuver, without an act",
    "hit head-on": "the side of the body that is struck",
    "struck from the right": "the side of the body that is struck",
    "one can hardly see": "who sees badly is read as hidden",
}
"""Examples that the reader does not give their word yet, and why."""


def _sentence(words: type[StrEnum], word: StrEnum, example: str) -> str:
    if example in _OWN:
        return _OWN[example]
    continued = words in (CrossedArm, ActKind, Maneuver)
    if words is HazardKind or ("the ego" in example and not continued):
        return f"{example[0].upper()}{example[1:]}."
    if words in _AROUND:
        joint = " " if example.startswith(_PREPOSITIONS) else ", "
        return f"The ego follows a car{joint}{example}."
    if words is Strip:
        return f"A van stands {example} ahead of the ego."
    if isinstance(word, Maneuver) and word.startswith("exit_"):
        return f"At a roundabout a car {example} in front of the ego."
    if isinstance(word, ParticipantKind) and word in {*ANIMALS, ParticipantKind.PEDESTRIAN}:
        return f"{example[0].upper()}{example[1:]} crosses the road in front of the ego."
    if example.startswith(_PREPOSITIONS) and words in (JunctionKind, Control, Carriageway):
        return f"Two cars meet {example}."
    sentence = _STATED[words].format(example)
    return sentence[0].upper() + sentence[1:]


def _found(words: type[StrEnum], scenario: FunctionalScenario) -> set[StrEnum | None]:
    junction, around, who = scenario.junction, scenario.environment, scenario.participants
    outcome = scenario.outcome
    return {
        JunctionKind: {junction.kind},
        Control: {junction.control},
        DrivingSide: {junction.driving_side},
        Carriageway: {junction.carriageway},
        Strip: {*junction.strips, *(p.strip for p in who)},
        AuxiliaryLane: {junction.auxiliary},
        ParticipantKind: {p.kind for p in who},
        Approach: {a for p in who for a in p.approaches},
        Maneuver: {m for p in who for m in p.maneuvers},
        AtLight: {p.light for p in who},
        CrossedArm: {p.crosses for p in who},
        HazardKind: {h.kind for h in scenario.hazards},
        ThingKind: {o.kind for o in scenario.objects},
        Measure: {s.measure for s in scenario.spacings},
        ActKind: {a.kind for a in scenario.acts},
        OutcomeKind: {outcome.kind if outcome is not None else None},
        BodySide: {outcome.struck if outcome is not None else None},
        Weather: {around.weather},
        TimeOfDay: {around.time_of_day},
        RoadSurface: {around.road_surface},
        Visibility: {around.visibility},
    }[words]


_EXAMPLES = [
    (words, word, example)
    for words in VOCABULARY
    if words not in _NOT_READ
    for word in words
    for example in meaning_of(word).example.split("; ")
    if example and example != "not said"
]


def _case(words: type[StrEnum], word: StrEnum, example: str):
    open_ = example in _OPEN
    marks = [pytest.mark.xfail(reason=_OPEN[example], strict=True)] if open_ else []
    name = f"{words.__name__}.{word}-{example}"
    return pytest.param(words, word, example, marks=marks, id=name)


@pytest.mark.parametrize(("words", "word", "example"), [_case(*e) for e in _EXAMPLES])
def test_an_example_gives_its_word(words, word, example):
    assert word in _found(words, read(_sentence(words, word, example)))


def test_every_sentence_and_exception_is_of_an_example():
    assert {*_OWN, *_OPEN} <= {example for _, _, example in _EXAMPLES}
