"""The same situation in other words is the same scenario."""

import pytest

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding import read


def essence(text):
    """What a scenario says, whatever its participants are called and in which order they come."""
    scenario = read(text)
    names = {p.id: (p.kind.value, p.role.value, p.parked) for p in scenario.participants}
    participants = sorted(
        (
            *names[p.id],
            tuple(sorted(p.approaches)),
            tuple(sorted(p.maneuvers)),
            p.speed_mps and (round(p.speed_mps.low, 2), round(p.speed_mps.high, 2)),
        )
        for p in scenario.participants
    )
    hazards = sorted(
        (h.kind.value, sorted(names[n] for n in h.by), sorted(names[n] for n in h.to))
        for h in scenario.hazards
    )
    junction = scenario.junction
    where = (junction.kind, junction.arms, junction.control, junction.driving_side)
    return where, participants, hazards, scenario.environment


SYNONYMS = [
    ("A lorry turns left at a crossroads.", "A truck makes a left turn at a four-way junction."),
    (
        "The ego drives on a highway behind a motorbike.",
        "The ego vehicle travels along a motorway behind a motorcycle.",
    ),
    (
        "A cyclist suddenly crosses the street in front of the ego.",
        "A bicyclist abruptly crosses the road in front of the ego car.",
    ),
    ("A bus brakes hard at a roundabout.", "A coach slams on the brakes at a traffic circle."),
    (
        "A van fails to yield to the ego at a T-junction.",
        "A van does not give way to the ego at a three-way intersection.",
    ),
    (
        "A taxi runs the red light at an intersection with the ego.",
        "A taxi ignores the red traffic signal at a junction with the ego.",
    ),
    (
        "A pedestrian steps out from behind a parked van.",
        "Somebody emerges from behind a van that is parked.",
    ),
    ("The ego loses control on an icy road.", "The ego skids on black ice."),
]
ORDER = [
    (
        "At a crossroads the ego turns right while a bus goes straight.",
        "While a bus goes straight, the ego turns right at a crossroads.",
    ),
    (
        "A van stops abruptly. The ego is following it on a wet road.",
        "On a wet road the ego is following a van. The van stops abruptly.",
    ),
    (
        "When the ego reaches a T-junction, a boy runs across the road.",
        "A boy runs across the road when the ego reaches a T-junction.",
    ),
]
VOICE = [
    ("A bus overtakes the ego on a motorway.", "The ego is overtaken by a bus on a motorway."),
    ("A van tailgates the ego.", "The ego is being tailgated by a van."),
    ("A taxi cuts off the ego.", "The ego is cut off by a taxi."),
    ("A lorry follows the ego too closely.", "The ego is followed too closely by a lorry."),
    (
        "A parked van hides a pedestrian who crosses in front of the ego.",
        "A pedestrian who crosses in front of the ego is hidden by a parked van.",
    ),
]
NUMBERS = [
    ("Twelve cars meet at a six-way intersection.", "12 cars meet at a 6-way intersection."),
    ("Three vans enter a roundabout with five exits.", "3 vans enter a roundabout with 5 exits."),
    (
        "Two lorries and 3 buses reach a crossroads.",
        "2 lorries and three buses reach a crossroads.",
    ),
    ("A taxi drives at fifty km/h.", "A taxi drives at 50 km/h."),
]


@pytest.mark.parametrize(("one", "other"), [*SYNONYMS, *ORDER, *VOICE, *NUMBERS])
def test_the_same_in_other_words(one, other):
    assert essence(one) == essence(other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("A van turns left at a crossroads.", "A van turns right at a crossroads."),
        ("A bus overtakes the ego.", "The ego overtakes a bus."),
        ("Three vans enter a roundabout.", "Four vans enter a roundabout."),
        ("A van brakes.", "A van brakes too late."),
        ("The ego waits behind a van.", "The ego waits in front of a van."),
    ],
)
def test_another_situation_is_another_scenario(one, other):
    assert essence(one) != essence(other)


TURNED = {
    Maneuver.LEFT: Maneuver.RIGHT,
    Maneuver.RIGHT: Maneuver.LEFT,
    Approach.LEFT: Approach.RIGHT,
    Approach.RIGHT: Approach.LEFT,
}
MIRRORED = [
    "The ego turns left at a crossroads while a bus from the right goes straight.",
    "The ego goes straight; a cyclist crosses from the left front.",
    "At a T-junction a van turns right and the ego, which comes from the left, turns left.",
    "Coming from the right, a lorry runs a red light while the ego goes straight on.",
    "The ego either turns left or goes straight at a junction; a taxi on the left turns right.",
    "On the left a van turns right, and the ego turns left at a crossroads.",
]


def swapped(text):
    return text.replace("left", "\0").replace("right", "left").replace("\0", "right")


@pytest.mark.parametrize("text", MIRRORED)
def test_left_and_right_swapped_is_the_mirror_image(text):
    here, there = read(text), read(swapped(text))
    assert here.junction == there.junction
    for p, q in zip(here.participants, there.participants, strict=True):
        assert {TURNED.get(m, m) for m in p.maneuvers} == q.maneuvers
        assert {TURNED.get(a, a) for a in p.approaches} == q.approaches
    assert any(
        p.maneuvers != q.maneuvers or p.approaches != q.approaches
        for p, q in zip(here.participants, there.participants, strict=True)
    )


def test_driving_on_the_left_mirrors_the_turn_across():
    right = read("A car turns left in front of an oncoming van at a crossroads.")
    left = read(
        "In left-hand traffic a car turns right in front of an oncoming van at a crossroads."
    )
    assert [(h.kind, h.by, h.to) for h in right.hazards] == [
        (h.kind, h.by, h.to) for h in left.hazards
    ]
    assert right.hazards[0].kind == "unprotected_left_turn"
    easy = read("In left-hand traffic a car turns left in front of a van at a crossroads.")
    assert "unprotected_left_turn" not in {h.kind for h in easy.hazards}


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("{} cars meet at a crossroads.", 0),
        ("{} cars meet at a crossroads and a bus turns left.", 1),
        ("A van follows {} cars on a motorway.", 1),
        ("A lorry and {} cars wait; a pedestrian crosses.", 2),
    ],
)
@pytest.mark.parametrize(("word", "number"), [("two", 2), ("5", 5), ("eleven", 11)])
def test_counts_stay_whatever_stands_around_them(text, count, word, number):
    scenario = read(text.format(word))
    kinds = [p.kind.value for p in scenario.participants]
    assert kinds.count("car") == number
    assert len(kinds) == number + count
