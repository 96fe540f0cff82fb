"""A file of every level in which every field is filled, as plain data."""

FUNCTIONAL = {
    "level": "functional",
    "description": "made for a test",
    "junction": {
        "kind": "four_way",
        "arms": 4,
        "arm_angles_deg": [0, 90, 180, 270],
        "lanes": [2, 2, 2, 2],
        "speed_limit_mps": 14.0,
        "driving_side": "right",
        "control": "priority_to_right",
        "crosswalks": [0],
    },
    "participants": [
        {
            "id": "ego",
            "role": "ego",
            "maneuvers": ["straight"],
            "entries": [0],
            "lanes": [1],
            "speed_mps": {"low": 10.0, "high": 12.0},
        },
        {"id": "car_1", "approaches": ["left"], "maneuvers": ["straight"], "speed_mps": 9.0},
        {"id": "walker", "kind": "pedestrian", "maneuvers": ["cross"]},
        {"id": "van", "kind": "van", "parked": True, "maneuvers": ["stay"]},
    ],
    "relations": [{"participant": "walker", "reference": "car_1", "approaches": ["right"]}],
    "hazards": [{"kind": "failure_to_yield", "by": ["car_1"], "to": ["ego"]}],
    "objects": [{"id": "box", "kind": "box", "side": "right", "called": "a crate"}],
    "spacings": [
        {
            "participant": "car_1",
            "reference": "ego",
            "measure": "ttc_s",
            "value": {"low": 1.0, "high": 2.0},
            "at": "slows",
        }
    ],
    "acts": [
        {
            "id": "slows",
            "participant": "car_1",
            "kind": "brake",
            "target_speed_mps": 5.0,
            "rate_mps2": {"low": 2.0, "high": 3.0},
            "when": {"type": "start", "delay_s": 1.0},
        },
        {
            "id": "stops",
            "participant": "car_1",
            "kind": "stop",
            "when": {"type": "after", "act": "slows", "since": "begin", "delay_s": 2.0},
        },
    ],
    "outcome": {"kind": "near_miss", "between": ["ego", "car_1"], "impact_percent": 50.0},
    "environment": {"weather": "rain", "time_of_day": "night"},
    "evidence": [{"field": "junction.kind", "source": "default", "reason": "made for a test"}],
    "unsupported": [{"text": "made", "start": 0, "end": 4, "instead": "left out"}],
}

_LOGICAL_ONE = {
    "index": 0,
    "slug": "ego-straight",
    "pattern": [2, 2],
    "class_size": 1,
    "assignments": [
        {
            "type": "drive",
            "participant": "ego",
            "entry": 0,
            "move": 2,
            "exit": 2,
            "turn": "straight",
            "maneuver": "straight",
            "lane": 1,
        },
        {
            "participant": "car_1",
            "entry": 3,
            "move": 2,
            "exit": 1,
            "turn": "straight",
            "maneuver": "straight",
        },
        {"type": "crossing", "participant": "walker", "arm": 2, "start": "right"},
        {"type": "standing", "participant": "van", "arm": 0, "side": "right"},
    ],
    "hazards": FUNCTIONAL["hazards"],
    "acts": FUNCTIONAL["acts"],
    "conflicts": [
        {
            "first": "ego",
            "second": "car_1",
            "kind": "crossing",
            "yields": "car_1",
            "rule": "priority_to_right",
        }
    ],
    "deadlock": [],
    "parameters": [
        {"name": "ego.speed_mps", "low": 10.0, "high": 12.0, "default": 11.0, "reason": "stated"}
    ],
}
LOGICAL = {
    "level": "logical",
    "functional": FUNCTIONAL,
    "reduction": "exact",
    "arms": "distinct",
    "certificate": {"total": 1, "count": 1, "complete": True, "method": "by hand"},
    "notes": ["made for a test"],
    "scenarios": [_LOGICAL_ONE],
}


def _arm(number):
    return {
        "id": number,
        "length_m": 150.0,
        "angle_deg": 90.0 * number,
        "angle_to_previous_deg": 90.0,
        "lanes_in": 2,
        "lanes_out": 2,
        "speed_limit_mps": 14.0,
    }


def _drive(entry, exit_):
    return {
        "type": "drive",
        "entry": entry,
        "entry_lane": 1,
        "exit": exit_,
        "exit_lane": 1,
        "start_m": 20.0,
        "turning_starts_m": 150.0,
        "turning_ends_m": 170.0,
    }


CONCRETE = {
    "level": "concrete",
    "name": "000-ego-straight",
    "description": "made for a test",
    "seed": 0,
    "logical": _LOGICAL_ONE,
    "road": {"kind": "four_way", "arms": [_arm(n) for n in range(4)], "crosswalks": [2]},
    "participants": [
        {
            "id": "ego",
            "kind": "car",
            "role": "ego",
            "speed_mps": 11.0,
            "motion": _drive(0, 2),
        },
        {
            "id": "car_1",
            "kind": "car",
            "speed_mps": 9.0,
            "motion": {
                **_drive(3, 1),
                "exit_lane": 2,
                "lane_changes": [{"position_m": 40.0, "length_m": 30.0, "lane_after": 2}],
            },
            "speed_program": [
                {
                    "trigger": {"type": "distance_below", "participant": "ego", "distance_m": 20.0},
                    "target_speed_mps": 5.0,
                    "rate_mps2": 2.5,
                },
                {
                    "trigger": {"type": "stood_still", "participant": "ego", "duration_s": 2.0},
                    "target_speed_mps": 8.0,
                    "rate_mps2": 1.5,
                },
            ],
        },
        {
            "id": "walker",
            "kind": "pedestrian",
            "speed_mps": 1.4,
            "motion": {
                "type": "crossing",
                "arm": 2,
                "start_side": "right",
                "from_junction_m": 4.0,
                "setback_m": 1.0,
            },
        },
        {
            "id": "van",
            "kind": "van",
            "parked": True,
            "speed_mps": 0.0,
            "motion": {"type": "standing", "arm": 0, "side": "right", "from_junction_m": 30.0},
        },
    ],
    "objects": [
        {
            "id": "box",
            "category": "obstacle",
            "what": "a crate",
            "x_m": 60.0,
            "y_m": -9.0,
            "heading_deg": 0.0,
            "length_m": 1.0,
            "width_m": 1.0,
            "height_m": 1.0,
        }
    ],
    "environment": {"weather": "rain"},
    "hazards": FUNCTIONAL["hazards"],
    "duration_s": 20.0,
    "provenance": [
        {
            "parameter": "ego.speed_mps",
            "by": "test",
            "after": 11.0,
            "reason": "by hand",
            "rejected": {"by": "test", "value": "12", "why": "too much"},
        }
    ],
}
WHOLE = {"functional": FUNCTIONAL, "logical": LOGICAL, "concrete": CONCRETE}
