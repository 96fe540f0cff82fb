"""Who is said to let another go first does, and goes on; who overtakes comes back and brakes."""

import numpy as np
import pytest
from saying import made, missed, person, said

from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network

CROSSES = [{"kind": "crossing_pedestrian", "by": ["child"]}]
CHILD = person("child", "pedestrian", maneuvers=["cross"])
ROAD = {"carriageway": "undivided", "lanes": [2, 2]}
BACK = {"id": "back", "participant": "van", "kind": "change_lane", "side": "right", "into": "ego"}
BRAKES = {
    "id": "brakes",
    "participant": "van",
    "kind": "brake",
    "rate_mps2": 5.0,
    "when": {"type": "after", "act": "back"},
}
SITUATIONS = {
    "a child, turning": said(
        "four_way",
        person("ego", maneuvers=["right"]),
        CHILD,
        acts=[{"id": "a", "participant": "ego", "kind": "give_way", "into": "child"}],
        hazards=CROSSES,
    ),
    "a child, standing": said(
        "straight",
        person("ego", maneuvers=["straight"], speed=50),
        CHILD,
        acts=[{"id": "a", "participant": "ego", "kind": "wait", "into": "child"}],
        hazards=CROSSES,
    ),
    "who comes towards it": said(
        "four_way",
        person("ego", maneuvers=["left"]),
        person("car", approaches=["opposite"], maneuvers=["straight"]),
        acts=[{"id": "a", "participant": "ego", "kind": "give_way", "into": "car"}],
    ),
    "at a stop sign": said(
        "four_way",
        person("ego", maneuvers=["right"]),
        person("car", approaches=["left"], maneuvers=["straight"]),
        junction={"control": "stop"},
        acts=[{"id": "a", "participant": "ego", "kind": "wait", "into": "car"}],
    ),
    "who turns off elsewhere": said(
        "four_way",
        person("ego", maneuvers=["right"]),
        person("car", approaches=["right"], maneuvers=["left"]),
        acts=[{"id": "a", "participant": "ego", "kind": "give_way", "into": "car"}],
    ),
    "who turns off elsewhere, on the left": said(
        "four_way",
        person("ego", maneuvers=["left"]),
        person("car", approaches=["left"], maneuvers=["right"]),
        junction={"driving_side": "left"},
        acts=[{"id": "a", "participant": "ego", "kind": "give_way", "into": "car"}],
    ),
    "an ambulance": said(
        "straight",
        person("ego", maneuvers=["lane_change"], speed=50),
        person(
            "other", "emergency_vehicle", approaches=["behind"], maneuvers=["overtake"], speed=90
        ),
        acts=[
            {"id": "aside", "participant": "ego", "kind": "change_lane", "side": "right"},
            {"id": "a", "participant": "ego", "kind": "give_way", "into": "other"},
        ],
        hazards=[{"kind": "overtaking", "by": ["other"], "to": ["ego"]}],
    ),
    "passed in the next lane": said(
        "straight",
        person("ego", maneuvers=["straight"], speed=50),
        person("van", "van", approaches=["left", "adjacent"], maneuvers=["lane_change"]),
        junction=ROAD,
        acts=[BACK, BRAKES],
        hazards=[{"kind": "overtaking", "by": ["van"], "to": ["ego"]}],
    ),
    "passed and braked for": said(
        "straight",
        person("ego", maneuvers=["straight"], speed=70),
        person("van", "van", approaches=["behind"], maneuvers=["overtake"], speed=90),
        acts=[BACK, BRAKES],
        spacings=[
            {
                "participant": "van",
                "reference": "ego",
                "measure": "gap_m",
                "value": 12.0,
                "at": "back",
            }
        ],
        hazards=[{"kind": "overtaking", "by": ["van"], "to": ["ego"]}],
    ),
}


@pytest.mark.parametrize("name", SITUATIONS)
def test_every_statement_holds(name):
    functional = SITUATIONS[name]
    assert missed(functional, made(functional).concrete) == set()


@pytest.mark.parametrize("name", ["a child, turning", "a child, standing", "at a stop sign"])
def test_who_stood_goes_on(name):
    concrete = made(SITUATIONS[name]).concrete
    trace = simulate(concrete, build_paths(concrete, build_network(concrete.road)))["ego"]
    stood = np.flatnonzero(trace.speed_mps < 0.1)
    assert stood.size
    assert trace.speed_mps[stood[-1] :].max() > 5.0


def test_who_does_not_wait_is_caught():
    functional = SITUATIONS["who comes towards it"]
    concrete = made(functional).concrete
    others = [
        one.model_copy(update={"motion": one.motion.model_copy(update={"start_m": 1.0})})
        if one.id == "car"
        else one.model_copy(update={"speed_program": ()})
        for one in concrete.participants
    ]
    hasty = concrete.model_copy(update={"participants": tuple(others)})
    assert "act.a.into" in missed(functional, hasty)


@pytest.mark.parametrize(
    ("acts", "problem"),
    [
        ([{"id": "a", "participant": "ego", "kind": "give_way"}], "gives way to nobody"),
        (
            [
                {"id": "a", "participant": "ego", "kind": "give_way", "into": "child"},
                {
                    "id": "b",
                    "participant": "ego",
                    "kind": "turn",
                    "when": {"type": "after", "act": "a"},
                },
            ],
            "no moment of its own",
        ),
    ],
)
def test_giving_way_is_to_somebody_and_has_no_moment(acts, problem):
    with pytest.raises(ValueError, match=problem):
        said("four_way", person("ego", maneuvers=["right"]), CHILD, acts=acts)
