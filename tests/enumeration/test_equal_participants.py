"""In which order participants are listed, and how they are called, changes nothing."""

from collections import Counter

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from scegen.enumeration import enumerate_scenarios
from scegen.errors import InputError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import HazardKind, Reduction

SAID = [
    {},
    {"approaches": ["left", "right"]},
    {"approaches": ["behind"]},
    {"approaches": ["ahead"]},
    {"approaches": ["adjacent"]},
    {"maneuvers": ["left"]},
    {"maneuvers": ["lane_change"]},
    {"kind": "truck"},
]
MOST = 3_000
NAMES = {"participant", "beside", "members", "by", "to"}


@st.composite
def described(draw):
    """Two to four who drive, perhaps one on foot, dangers that name one or both sides or none."""
    kind, arms = draw(st.sampled_from([("four_way", 4), ("t", 3), ("roundabout", 4)]))
    others = [
        {"id": f"car_{n}", **draw(st.sampled_from(SAID))} for n in range(draw(st.integers(1, 3)))
    ]
    cars = [other["id"] for other in others]
    if draw(st.booleans()):
        others.append({"id": "walker", "kind": "pedestrian", "maneuvers": ["cross"]})
    names = ["ego", *(other["id"] for other in others)]
    hazards = []
    for kind_of_danger in draw(st.lists(st.sampled_from(list(HazardKind)), max_size=2)):
        pair = draw(st.permutations(names))[:2]
        sides = dict(zip(("by", "to"), ([name] for name in pair), strict=True))
        for side in draw(st.sets(st.sampled_from(["by", "to"]))):
            del sides[side]
        hazards.append({"kind": kind_of_danger.value, **sides})
    grouped = len(cars) > 1 and draw(st.booleans())
    return {
        "description": "made for a test",
        "junction": {"kind": kind, "arms": arms},
        "participants": [{"id": "ego", "role": "ego"}, *others],
        "hazards": hazards,
        "groups": [{"members": cars, "number": 1, "maneuvers": ["left"]}] if grouped else [],
    }


def renamed(data, names):
    """The same description with other ids."""
    people = [p | {"id": names[p["id"]]} for p in data["participants"]]
    said = {
        section: [
            {
                field: [names[name] for name in value] if field in NAMES else value
                for field, value in item.items()
            }
            for item in data[section]
        ]
        for section in ("hazards", "groups")
    }
    return {**data, "participants": people, **said}


def listed(data, reduction):
    """All scenarios; how many there are if they are too many; None if there is none."""
    functional = FunctionalScenario.model_validate(data)
    try:
        return enumerate_scenarios(functional, reduction=reduction, limit=MOST)
    except InputError:
        return None


def done_by(scenario, names):
    """Who does what; who is first on an arm is as listed where nothing is said of it."""
    ways = []
    for assignment in scenario.assignments:
        way = assignment.model_dump(mode="json", exclude={"rank"})
        told = {k: names.get(v, v) if k in NAMES else v for k, v in way.items()}
        ways.append(tuple(sorted((field, str(value)) for field, value in told.items())))
    return tuple(sorted(ways))


@settings(max_examples=12, suppress_health_check=list(HealthCheck))
@given(described(), st.data())
def test_nothing_binds_to_who_is_listed_first(data, more):
    people = more.draw(st.permutations(data["participants"]))
    own = [p["id"] for p in data["participants"]]
    names = dict(zip(own, more.draw(st.permutations([f"n_{i}" for i in range(5)])), strict=False))
    back = {new: old for old, new in names.items()}
    other = renamed({**data, "participants": people}, names)
    for reduction in (Reduction.NONE, Reduction.EXACT):
        here, there = listed(data, reduction), listed(other, reduction)
        assert (here is None) == (there is None)
        if here is None or there is None:
            return
        assert here.certificate.count == there.certificate.count
        assert here.certificate.total == there.certificate.total
        if not here.certificate.complete:
            continue
        sizes = [Counter(s.class_size for s in found.scenarios) for found in (here, there)]
        assert sizes[0] == sizes[1]
        if reduction is Reduction.NONE:
            assert {done_by(s, {}) for s in here.scenarios} == {
                done_by(s, back) for s in there.scenarios
            }
