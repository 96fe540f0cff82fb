"""Scenarios on a plain road, told by hand: every act, measure, moment and outcome in one."""

from __future__ import annotations

from told import act, after, apart, as_soon_as, at_time, told, who

from scegen.scenario.functional import FunctionalScenario

AHEAD, BEHIND, TOWARDS = ["ahead"], ["behind"], ["opposite"]
LEFT_LANE, RIGHT_LANE = ["adjacent", "left"], ["adjacent", "right"]
STAY, STRAIGHT, CROSS = ["stay"], ["straight"], ["cross"]


def kmh(speed: float) -> float:
    """In m/s."""
    return speed / 3.6


def ego(speed: float | None = None, maneuvers=STRAIGHT, **more):
    """The ego, in km/h."""
    return who("ego", maneuvers=maneuvers, speed=None if speed is None else kmh(speed), **more)


def one(name, kind, approaches, maneuvers=STRAIGHT, speed=None, **more):
    """Another, in km/h."""
    pace = None if speed is None else kmh(speed)
    return who(name, kind, approaches, maneuvers, speed=pace, **more)


def ends(kind, *between, **more):
    """The outcome."""
    return {"kind": kind, "between": list(between), **more}


def road(people, hazards=(), **more):
    """On a plain road."""
    return told("straight", people, hazards, **more)


SCENARIOS: dict[str, FunctionalScenario] = {
    "brakes_at_a_gap": road(
        [ego(72), one("lead", "van", AHEAD, speed=72)],
        [("hard_braking", "lead", "ego")],
        acts=[act("slows", "lead", "brake", rate_mps2=6.0, target_speed_mps=kmh(30))],
        spacings=[apart("ego", "lead", "gap_m", 24.0, "slows")],
    ),
    "follows_at_a_headway": road(
        [ego(50), one("lead", "car", AHEAD, speed=50)],
        acts=[act("halts", "lead", "stop", rate_mps2=4.0)],
        spacings=[apart("ego", "lead", "headway_s", 1.4)],
        outcome=ends("avoided", "ego", "lead"),
    ),
    "is_followed_and_brakes": road(
        [ego(60), one("tail", "truck", BEHIND, speed=60)],
        acts=[act("slows", "ego", "brake", rate_mps2=3.0, target_speed_mps=kmh(20))],
        spacings=[apart("tail", "ego", "gap_m", 18.0, "slows")],
    ),
    "loses_control_and_stops": road(
        [ego(50), one("lead", "motorcycle", AHEAD, speed=50)],
        [("loss_of_control", "lead", "ego"), ("stopping", "lead", "ego")],
        acts=[act("halts", "lead", "stop")],
        spacings=[apart("ego", "lead", "headway_s", 1.2)],
    ),
    "swerves_and_then_stops": road(
        [ego(70), one("lead", "car", AHEAD, speed=70)],
        [("swerving", "lead", "ego"), ("stopping", "lead", "ego")],
        acts=[act("jinks", "lead", "swerve"), act("halts", "lead", "stop", when=after("jinks"))],
    ),
    "overtakes_and_brakes": road(
        [ego(70), one("fast", "car", BEHIND, ["overtake"], speed=90)],
        [("overtaking", "fast", "ego"), ("hard_braking", "fast", "ego")],
        acts=[act("slows", "fast", "brake", target_speed_mps=kmh(40))],
    ),
    "overtakes_and_then_stops": road(
        [ego(None, ["overtake"]), one("slow", "truck", AHEAD)],
        [("overtaking", "ego", "slow")],
        acts=[
            act("passes", "ego", "overtake", into="slow"),
            act("halts", "ego", "stop", when=after("passes")),
        ],
    ),
    "crawls_behind_one_that_stops": road(
        [ego(15), one("lead", "truck", AHEAD)],
        [("stopping", "lead", "ego")],
        acts=[act("halts", "lead", "stop")],
    ),
    "the_lead_lets_one_cross": road(
        [ego(), one("lead", "car", AHEAD), one("walker", "pedestrian", ["right"], CROSS)],
        [("crossing_pedestrian", "walker", "lead")],
        acts=[act("waits", "lead", "wait", into="walker"), act("halts", "ego", "stop")],
    ),
    "hits_a_corner_of_a_truck": road(
        [ego(30), one("wreck", "truck", AHEAD, STAY)],
        spacings=[apart("wreck", "ego", "overlap_percent", 25.0, "contact", side="right")],
        outcome=ends("collision", "ego", "wreck"),
    ),
    "stops_as_near_as_said_from_a_headway": road(
        [ego(70), one("lead", "van", AHEAD, speed=70)],
        [("hard_braking", "lead", "ego"), ("stopping", "lead", "ego")],
        acts=[
            act("slows", "lead", "brake", target_speed_mps=kmh(0)),
            act("halts", "ego", "stop"),
        ],
        spacings=[
            apart("ego", "lead", "headway_s", 2.0, "slows"),
            {**apart("ego", "lead", "gap_m", 1.0, "halts"), "since": "end"},
        ],
    ),
    "called_slow_at_a_speed": road(
        [ego(120), one("other", "truck", RIGHT_LANE, ["lane_change"], speed=80)],
        [("slow_driving", "other", "ego"), ("cut_in", "other", "ego")],
        acts=[act("over", "other", "change_lane", side="left", into="ego")],
    ),
    "comes_up_behind_one_slower": road(
        [ego(90), one("tractor", "truck", AHEAD, speed=40)],
        [("slow_driving", "tractor", "ego")],
        spacings=[apart("ego", "tractor", "ttc_s", 6.0)],
    ),
    "runs_into_one_that_stands": road(
        [ego(50), one("wreck", "car", AHEAD, STAY)],
        spacings=[apart("wreck", "ego", "overlap_percent", 50.0, "contact", side="left")],
        outcome=ends("collision", "ego", "wreck"),
    ),
    "stops_behind_a_queue": road(
        [ego(60), *(one(name, "car", AHEAD, STAY) for name in ("first", "second", "third"))],
        outcome=ends("avoided"),
    ),
    "cuts_in_ahead": road(
        [ego(100), one("van", "van", LEFT_LANE, speed=80)],
        [("cut_in", "van", "ego")],
        acts=[act("cuts", "van", "change_lane", side="right", into="ego")],
        spacings=[apart("van", "ego", "gap_m", 30.0, "cuts")],
    ),
    "cuts_in_from_the_right_at_a_time_to_collision": road(
        [ego(110), one("truck", "truck", RIGHT_LANE, speed=70)],
        acts=[
            act(
                "drifts",
                "truck",
                "change_lane",
                side="left",
                into="ego",
                lateral_mps=1.2,
                when=as_soon_as("ego", "truck", "ttc_s", 4.0),
            )
        ],
    ),
    "cuts_out_before_one_that_stands": road(
        [
            ego(60),
            one("lead", "car", AHEAD, speed=60),
            one("wreck", "car", AHEAD, STAY),
        ],
        acts=[act("leaves", "lead", "change_lane", side="left")],
        spacings=[
            apart("ego", "lead", "headway_s", 1.5, "leaves"),
            apart("lead", "wreck", "ttc_s", 3.0, "leaves"),
        ],
        relations=[{"participant": "wreck", "reference": "lead", "approaches": ["ahead"]}],
    ),
    "ego_changes_lane_before_a_faster_one": road(
        [ego(80, []), one("fast", "motorcycle", LEFT_LANE, speed=110)],
        acts=[act("changes", "ego", "change_lane", side="left", duration_s=4.0)],
        spacings=[apart("fast", "ego", "gap_m", 25.0, "changes")],
    ),
    "overtakes_against_the_oncoming": road(
        [
            ego(80, ["overtake"]),
            one("slow", "truck", AHEAD, speed=50),
            one("other", "car", TOWARDS, speed=80),
        ],
        [("overtaking", "ego", "slow"), ("oncoming_lane", "ego", "other")],
        acts=[act("passes", "ego", "overtake", into="slow")],
    ),
    "is_overtaken": road(
        [ego(60), one("fast", "car", BEHIND, ["overtake"], speed=85)],
        [("overtaking", "fast", "ego")],
        acts=[act("passes", "fast", "overtake", into="ego")],
    ),
    "comes_into_the_oncoming_lane": road(
        [ego(60), one("stray", "car", TOWARDS, speed=60)],
        [("oncoming_lane", "stray", "ego")],
        acts=[act("strays", "stray", "swerve", side="left")],
        outcome=ends("near_miss", "ego", "stray"),
    ),
    "meets_head_on": road(
        [ego(50), one("stray", "car", TOWARDS, speed=50)],
        [("oncoming_lane", "stray", "ego")],
        acts=[act("drifts", "stray", "change_lane", side="left", into="ego")],
        outcome=ends("collision", "ego", "stray", impact_percent=50.0),
    ),
    "drifts_within_its_lane": road(
        [ego(70), one("beside", "car", LEFT_LANE, speed=70)],
        acts=[act("drifts", "beside", "swerve", side="right", lateral_m=0.6, duration_s=2.0)],
        outcome=ends("avoided", "ego", "beside"),
    ),
    "brakes_twice": road(
        [ego(70), one("lead", "car", AHEAD, speed=70)],
        acts=[
            act("taps", "lead", "brake", rate_mps2=2.0, target_speed_mps=kmh(50)),
            act("halts", "lead", "stop", rate_mps2=5.0, when=after("taps", 2.0, since="end")),
        ],
        spacings=[apart("ego", "lead", "headway_s", 2.0, "taps")],
        outcome=ends("avoided"),
    ),
    "accelerates_after_a_time": road(
        [ego(50), one("lead", "car", AHEAD, speed=50)],
        acts=[
            act(
                "gains",
                "lead",
                "accelerate",
                rate_mps2=1.5,
                target_speed_mps=kmh(80),
                when=at_time(5.0),
            )
        ],
        spacings=[apart("ego", "lead", "gap_m", 30.0)],
    ),
    "sets_off_before_the_ego": road(
        [ego(40), one("lead", "bus", AHEAD)],
        acts=[
            act(
                "goes",
                "lead",
                "set_off",
                rate_mps2=1.0,
                target_speed_mps=kmh(30),
                when=as_soon_as("ego", "lead", "gap_m", 45.0),
            )
        ],
    ),
    "ego_stops_then_sets_off": road(
        [ego(40), one("tail", "car", BEHIND)],
        acts=[
            act("halts", "ego", "stop", rate_mps2=3.0, when=at_time(4.0)),
            act("goes", "ego", "set_off", target_speed_mps=kmh(30), when=after("halts", 3.0)),
        ],
    ),
    "walker_is_struck": road(
        [ego(40), one("child", "pedestrian", ["right"], CROSS, speed=5)],
        [("crossing_pedestrian", "child", "ego")],
        acts=[act("steps", "child", "cross")],
        outcome=ends("collision", "ego", "child", impact_percent=25.0),
    ),
    "walker_from_the_left_is_missed": road(
        [ego(50), one("walker", "pedestrian", ["left"], CROSS, speed=6)],
        [("crossing_pedestrian", "walker", "ego")],
        outcome=ends("near_miss", "ego", "walker"),
    ),
    "walker_steps_out_at_a_gap": road(
        [ego(50), one("walker", "pedestrian", ["right"], CROSS)],
        [("crossing_pedestrian", "walker", "ego")],
        acts=[
            act("steps", "walker", "cross", when=as_soon_as("walker", "ego", "gap_m", 30.0)),
        ],
    ),
    "ego_brakes_for_a_walker": road(
        [ego(50), one("walker", "pedestrian", ["right"], CROSS, speed=5)],
        [("crossing_pedestrian", "walker", "ego"), ("hard_braking", "ego", "walker")],
        acts=[act("brakes", "ego", "brake", rate_mps2=7.0, target_speed_mps=0.0)],
        outcome=ends("avoided", "ego", "walker"),
    ),
    "walker_from_behind_a_van": road(
        [
            ego(40),
            who("van", "van", ["right"], STAY, parked=True),
            one("child", "pedestrian", ["right"], CROSS, speed=8),
        ],
        [("crossing_pedestrian", "child", "ego"), ("occlusion", "van", "ego")],
        outcome=ends("near_miss", "ego", "child"),
    ),
    "cyclist_crosses": road(
        [ego(50), one("rider", "bicycle", ["left"], CROSS, speed=15)],
        [("crossing_cyclist", "rider", "ego")],
        outcome=ends("collision", "ego", "rider", impact_percent=50.0),
    ),
    "passes_a_cyclist": road(
        [ego(60), one("rider", "bicycle", AHEAD, speed=18)],
        spacings=[apart("rider", "ego", "lateral_offset_m", -0.8)],
        outcome=ends("avoided"),
    ),
    "passes_by_with_room": road(
        [ego(50), one("beside", "car", LEFT_LANE, speed=65)],
        spacings=[apart("beside", "ego", "lateral_gap_m", 1.2)],
        outcome=ends("avoided"),
    ),
    "stops_short_of_a_thing": road(
        [ego(50)],
        objects=[{"id": "box", "kind": "box", "in_way_of": "ego"}],
        hazards=[("obstacle", "box", "ego")],
    ),
    "swerves_round_a_thing": road(
        [ego(50), one("lead", "car", AHEAD, speed=50)],
        [("obstacle", "tyre", "lead"), ("swerving", "lead", "ego")],
        objects=[{"id": "tyre", "kind": "tyre", "in_way_of": "lead"}],
        acts=[act("swerves", "lead", "swerve")],
    ),
    "goes_round_one_that_stands": road(
        [ego(50, ["lane_change"]), one("van", "van", AHEAD, STAY)],
        outcome=ends("near_miss", "ego", "van"),
    ),
    "merges_from_beside": road(
        [ego(90), one("joiner", "car", RIGHT_LANE, speed=90)],
        [("merging_conflict", "joiner", "ego")],
    ),
    "tailgates_on_the_left_side": road(
        [ego(90), one("tail", "car", BEHIND)],
        [("tailgating", "tail", "ego")],
        side="left",
    ),
    "cuts_in_on_the_left_side": road(
        [ego(80), one("car", "car", RIGHT_LANE, speed=70)],
        acts=[act("cuts", "car", "change_lane", side="left", into="ego")],
        spacings=[apart("ego", "car", "headway_s", 0.8, "cuts")],
        side="left",
        lanes=2,
    ),
    "a_door_opens_before_it": road(
        [ego(40), one("parked", "van", AHEAD, STAY, parked=True)],
        [("obstacle", "parked", "ego")],
        acts=[act("opens", "parked", "open_door")],
        spacings=[apart("ego", "parked", "gap_m", 22.0, "opens")],
    ),
    "a_rider_swerves_for_a_door_on_the_left_side": road(
        [
            ego(50),
            one("rider", "bicycle", AHEAD, speed=18),
            one("parked", "car", [], STAY, parked=True),
        ],
        [("obstacle", "parked", "rider"), ("swerving", "rider", "ego")],
        acts=[
            act("opens", "parked", "open_door", when=as_soon_as("rider", "parked", "ttc_s", 1.5)),
            act("swerves", "rider", "swerve"),
        ],
        side="left",
    ),
    "a_rider_hits_a_door": road(
        [ego(), one("rider", "bicycle", AHEAD), one("parked", "car", [], STAY, parked=True)],
        [("obstacle", "parked", "rider")],
        acts=[act("opens", "parked", "open_door")],
        outcome=ends("collision", "rider", "parked"),
    ),
}
