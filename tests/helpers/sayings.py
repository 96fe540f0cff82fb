"""Functional scenarios with numbers, acts and outcomes, one of each manner."""

from saying import person, said

BRAKES = said(
    "straight",
    person("ego", speed=50),
    person("car", speed=50, approaches=["ahead"]),
    acts=[
        {
            "id": "brake",
            "participant": "car",
            "kind": "brake",
            "rate_mps2": 5,
            "target_speed_mps": 2,
        }
    ],
    spacings=[
        {"participant": "car", "reference": "ego", "measure": "gap_m", "value": 20, "at": "brake"}
    ],
    hazards=[{"kind": "hard_braking", "by": ["car"], "to": ["ego"]}],
    environment={"weather": "rain"},
)
CUTS_AND_BRAKES = said(
    "straight",
    person("ego", speed=50),
    person("car", speed=50, approaches=["adjacent", "left"], maneuvers=["lane_change"]),
    junction={"lanes": [2, 2]},
    acts=[
        {"id": "cut", "participant": "car", "kind": "change_lane", "side": "right", "into": "ego"},
        {"id": "brake", "participant": "car", "kind": "brake"},
    ],
    hazards=[
        {"kind": "cut_in", "by": ["car"], "to": ["ego"]},
        {"kind": "hard_braking", "by": ["car"], "to": ["ego"]},
    ],
)
CUTS_IN = said(
    "straight",
    person("ego", speed=90),
    person("van", "van", speed=70, approaches=["adjacent", "right"], maneuvers=["lane_change"]),
    junction={"lanes": [2, 2]},
    acts=[
        {"id": "cut", "participant": "van", "kind": "change_lane", "side": "left", "into": "ego"}
    ],
    spacings=[
        {"participant": "van", "reference": "ego", "measure": "gap_m", "value": 15, "at": "cut"}
    ],
    hazards=[{"kind": "cut_in", "by": ["van"], "to": ["ego"]}],
)
IGNORES = said(
    "straight",
    person("ego", speed=80, unresponsive=True),
    person("lorry", "truck", speed=85, approaches=["adjacent"], maneuvers=["lane_change"]),
    junction={"lanes": [2, 2]},
    acts=[{"id": "cut", "participant": "lorry", "kind": "change_lane", "into": "ego"}],
    hazards=[{"kind": "cut_in", "by": ["lorry"], "to": ["ego"]}],
)
CROSSES = said(
    "four_way",
    person("ego", speed=30, maneuvers=["straight"]),
    person("car", speed=50, approaches=["left"], maneuvers=["straight"]),
    junction={"control": "yield"},
)
WALKS = said(
    "straight",
    person("ego", speed=40, maneuvers=["straight"]),
    person("walker", "pedestrian", speed=5, approaches=["right"], maneuvers=["cross"]),
    hazards=[{"kind": "crossing_pedestrian", "by": ["walker"], "to": ["ego"]}],
    outcome={
        "kind": "collision",
        "between": ["ego", "walker"],
        "impact_percent": 50,
        "struck": "front",
    },
)
STANDS = said(
    "straight",
    person("ego", speed=40),
    person("car", approaches=["ahead"], maneuvers=["stay"]),
    outcome={"kind": "collision", "between": ["ego", "car"]},
    spacings=[
        {
            "participant": "car",
            "reference": "ego",
            "measure": "overlap_percent",
            "value": 100,
            "at": "contact",
        }
    ],
)
HIDES = said(
    "straight",
    person("ego", speed=40, maneuvers=["straight"]),
    person("child", "pedestrian", approaches=["right"], maneuvers=["cross"]),
    person("van", "van", parked=True, approaches=["right"]),
    hazards=[
        {"kind": "crossing_pedestrian", "by": ["child"], "to": ["ego"]},
        {"kind": "occlusion", "by": ["van"], "to": ["ego"]},
    ],
)
TURNS_LEFT = said(
    "four_way",
    person("ego", speed=40, maneuvers=["straight"]),
    person("car", approaches=["opposite"], maneuvers=["left"]),
    hazards=[{"kind": "unprotected_left_turn", "by": ["car"], "to": ["ego"]}],
)
RUSHES = said(
    "four_way",
    person("ego", speed=40, maneuvers=["straight"]),
    person("van", "van", approaches=["right"], maneuvers=["straight"]),
    junction={"control": "stop"},
    hazards=[{"kind": "failure_to_yield", "by": ["van"], "to": ["ego"]}],
)
QUEUE = said(
    "four_way",
    person("ego", maneuvers=["straight"]),
    person("bus", "bus", approaches=["ahead"], maneuvers=["straight"]),
    person("car", approaches=["left"], maneuvers=["straight"]),
)
RING = said(
    "roundabout",
    person("ego", speed=30, maneuvers=["straight"]),
    person("car", approaches=["left"]),
    junction={"arms": 4},
)
ZEBRA = said(
    "four_way",
    person("ego", speed=30, maneuvers=["right"]),
    person("walker", "pedestrian", approaches=["right"], maneuvers=["cross"], crosses="exit"),
    hazards=[{"kind": "crossing_pedestrian", "by": ["walker"], "to": ["ego"]}],
)
RED = said(
    "four_way",
    person("ego", speed=40, maneuvers=["straight"]),
    person("truck", "truck", approaches=["left"], maneuvers=["straight"]),
    junction={"control": "signals"},
    hazards=[{"kind": "red_light_running", "by": ["truck"], "to": ["ego"]}],
    outcome={"kind": "collision", "between": ["ego", "truck"]},
)
SKEWED = said(
    "skewed",
    person("ego", speed=40, maneuvers=["straight"]),
    person("car", approaches=["right"], maneuvers=["left"]),
    junction={"arm_angles_deg": [0, 60, 180, 240], "control": "yield"},
)
LANES = said(
    "four_way",
    person("ego", speed=40, maneuvers=["straight"], lanes=[1]),
    person("car", approaches=["adjacent", "right"], maneuvers=["straight"]),
    junction={"lanes": [2, 2, 2, 2]},
)
STRAYS = said(
    "four_way",
    person("ego", maneuvers=["straight"]),
    person("van", "van", approaches=["opposite"], maneuvers=["straight"]),
    hazards=[{"kind": "oncoming_lane", "by": ["van"], "to": ["ego"]}],
    outcome={"kind": "collision", "between": ["ego", "van"]},
)
AT_JUNCTIONS = [STRAYS, TURNS_LEFT, RUSHES, QUEUE, RING, ZEBRA, RED, SKEWED, LANES]
PASSES = said(
    "straight",
    person("ego", speed=80),
    person("car", speed=100, approaches=["adjacent", "left", "behind"]),
    junction={"lanes": [2, 2]},
)
RUNS_INTO = said(
    "straight",
    person("ego", speed=70),
    person("car", speed=70, approaches=["ahead"]),
    acts=[{"id": "brake", "participant": "car", "kind": "brake", "rate_mps2": 5}],
    outcome={"kind": "collision", "between": ["ego", "car"]},
)
EVERY = [
    BRAKES,
    CUTS_IN,
    CUTS_AND_BRAKES,
    IGNORES,
    CROSSES,
    WALKS,
    STANDS,
    HIDES,
    PASSES,
    RUNS_INTO,
]
