"""Situations in which two are to meet, told without the reader."""

from __future__ import annotations

from told import told, who

EGO = who("ego", maneuvers=["straight"])
BLOCKED = who("van", "van", ["ahead"], ["stay"], parked=True)
AROUND = who("ego", maneuvers=["overtake"])
BUS = who("bus", "bus", ["opposite"], ["straight"])
OBSTACLE = ("obstacle", "van", "ego")

MEETINGS = {
    "drifts over from the right": told(
        "straight", [EGO, who("x", "truck", ["adjacent", "right"])], [("swerving", "x", "ego")]
    ),
    "drifts over from the left": told(
        "straight", [EGO, who("x", "car", ["adjacent", "left"])], [("swerving", "x", "ego")]
    ),
    "loses control beside": told(
        "straight", [EGO, who("x", "car", ["adjacent"])], [("loss_of_control", "x", "ego")]
    ),
    "drifts over before a junction": told(
        "four_way",
        [EGO, who("x", "car", ["adjacent"], ["straight"])],
        [("swerving", "x", "ego")],
    ),
    "changes lanes beside, no danger named": told(
        "straight", [EGO, who("x", "car", ["adjacent"], ["lane_change"])]
    ),
    "cuts in on a motorway": told(
        "straight",
        [who("ego", speed=29.0), who("x", "truck", ["adjacent", "right"], ["lane_change"])],
        [("cut_in", "x", "ego")],
        lanes=3,
    ),
    "strays towards one at 90 km/h": told(
        "straight",
        [who("ego", maneuvers=["straight"], speed=25.0), who("x", "car", ["opposite"])],
        [("oncoming_lane", "x", "ego")],
    ),
    "the ego strays towards a lorry": told(
        "straight", [EGO, who("x", "truck", ["opposite"])], [("oncoming_lane", "ego", "x")]
    ),
    "swerves towards one who comes": told(
        "straight", [EGO, who("x", "car", ["opposite"])], [("swerving", "x", "ego")], lanes=2
    ),
    "right hook": told(
        "four_way",
        [who("ego", maneuvers=["right"]), who("x", "bicycle", ["adjacent"], ["straight"])],
    ),
    "left hook where traffic keeps left": told(
        "four_way",
        [who("ego", maneuvers=["left"]), who("x", "bicycle", ["adjacent"], ["straight"])],
        side="left",
    ),
    "both turn right, one across the other": told(
        "four_way",
        [who("ego", maneuvers=["right"]), who("x", "car", ["adjacent", "left"], ["right"])],
        [("sudden_turn", "x", "ego")],
    ),
    "turns left from the wrong lane": told(
        "four_way",
        [EGO, who("x", "car", ["adjacent", "right"], ["left"])],
        [("failure_to_yield", "x", "ego")],
    ),
    "both turn left from opposite sides": told(
        "four_way",
        [who("ego", maneuvers=["left"]), who("x", "car", ["opposite"], ["left"])],
        [("unprotected_left_turn", "ego", "x")],
    ),
    "turns back in front of one who comes": told(
        "straight", [EGO, who("x", "van", ["opposite"], ["u_turn"])]
    ),
    "turns back in front of one behind": told(
        "straight", [EGO, who("x", "car", ["ahead"], ["u_turn"])], [("sudden_turn", "x", "ego")]
    ),
    "a parked car pulls out": told(
        "straight",
        [EGO, who("x", "car", ["right"], ["lane_change"], parked=True)],
        [("cut_in", "x", "ego")],
    ),
    "a bus leaves its stop": told(
        "four_way",
        [EGO, who("x", "bus", ["ahead"], ["straight"], parked=True)],
        [("failure_to_yield", "x", "ego")],
    ),
    "a rider ahead comes over": told(
        "straight",
        [EGO, who("x", "bicycle", ["ahead"], ["straight"])],
        [("crossing_cyclist", "x", "ego")],
    ),
    "comes up behind a rider": told(
        "straight", [EGO, who("x", "bicycle", ["ahead"], ["straight"], speed=4.0)]
    ),
    "comes up behind a queue that stands": told(
        "straight",
        [
            who("ego", maneuvers=["straight"], speed=27.8),
            who("x", "car", ["ahead"], ["stay"]),
            who("y", "car", ["ahead"], ["stay"]),
        ],
        [("stopping", "x", "ego")],
    ),
    "comes up behind slow ones": told(
        "straight",
        [
            who("ego", maneuvers=["straight"], speed=27.8),
            who("x", "car", ["ahead"]),
            who("y", "car", ["ahead"]),
        ],
        [("slow_driving", "x", "ego"), ("slow_driving", "y", "ego")],
    ),
    "speeds up behind and tailgates": told(
        "straight",
        [EGO, who("x", "car", ["behind"], ["straight"])],
        [("speeding", "x", "ego"), ("tailgating", "x", "ego")],
    ),
    "one from behind in the next lane": told(
        "straight",
        [
            who("ego", maneuvers=["lane_change"]),
            BLOCKED,
            who("x", "car", ["adjacent", "behind"], ["straight"]),
        ],
        [("speeding", "x", "ego"), OBSTACLE],
        lanes=2,
    ),
    "round an obstacle, one comes and brakes late": told(
        "straight", [AROUND, BLOCKED, BUS], [OBSTACLE, ("delayed_braking", "bus", "ego")]
    ),
    "round an obstacle, one comes and does not yield": told(
        "straight", [AROUND, BLOCKED, BUS], [OBSTACLE, ("failure_to_yield", "bus", "ego")]
    ),
    "round an obstacle, one comes and stops": told(
        "straight", [AROUND, BLOCKED, BUS], [OBSTACLE, ("stopping", "bus", "ego")]
    ),
    "a rider rides across on red": told(
        "four_way",
        [EGO, who("x", "bicycle", ["left"], ["cross"])],
        [("failure_to_yield", "x", "ego")],
        control="stop",
    ),
    "a rider is fast": told(
        "four_way",
        [who("ego", maneuvers=["left"]), who("x", "bicycle", ["opposite"], ["straight"])],
        [("unprotected_left_turn", "ego", "x"), ("speeding", "x", "ego")],
    ),
    "a rider stops in the way": told(
        "four_way",
        [who("ego", maneuvers=["left"]), who("x", "bicycle", ["right"], ["cross"])],
        [("crossing_cyclist", "x", "ego"), ("stopping", "x", "ego")],
    ),
    "runs the red light and stalls": told(
        "four_way",
        [EGO, who("x", "bus", ["right"], ["straight"])],
        [("red_light_running", "x", "ego"), ("stopping", "x", "ego")],
        control="signals",
    ),
}
