"""How long and how far a crossing, a change of lane, a swerve or a reversing goes is as said."""

import pytest
from mutating import changed
from pydantic import ValidationError
from saying import missed
from told import act, first, raised, told, who

from scegen.understanding import read

EGO = who("ego", maneuvers=["straight"], speed=12.0)


def claim_of(functional, name):
    proof = raised(functional).proof
    (claim,) = (c for c in proof.claims if c.id == name)
    return claim


def crossing(kind, seconds, road="straight", **more):
    walker = who("walker", kind, ["right"], ["cross"])
    acts = [act("goes", "walker", "cross", duration_s=seconds)]
    dangers = [(f"crossing_{kind if kind == 'pedestrian' else 'cyclist'}", "walker", "ego")]
    return told(road, [EGO, walker], dangers, acts=acts, **more)


@pytest.mark.parametrize(
    ("functional", "seconds"),
    [
        (crossing("pedestrian", 6.0), 6.0),
        (crossing("pedestrian", 9.0, lanes=2), 9.0),
        (crossing("bicycle", 3.0), 3.0),
        (crossing("pedestrian", 5.0, lane_width_m=2.8), 5.0),
        (crossing("pedestrian", 7.0, "four_way"), 7.0),
    ],
)
def test_who_crosses_takes_so_long(functional, seconds):
    claim = claim_of(functional, "maneuver.cross.walker.takes")
    assert claim.holds
    assert claim.measured == pytest.approx(seconds, abs=0.2)


def test_who_crosses_faster_is_noticed():
    functional = crossing("pedestrian", 8.0)
    concrete = first(functional)
    assert "maneuver.cross.walker.takes" not in missed(functional, concrete)
    go, stop = concrete.participant("walker").speed_program
    faster = go.model_copy(update={"target_speed_mps": 1.4 * go.target_speed_mps})
    quick = changed(concrete, "walker", speed_program=(faster, stop))
    assert "maneuver.cross.walker.takes" in missed(functional, quick)


@pytest.mark.parametrize("seconds", [2.0, 3.5, 5.0])
def test_a_change_of_lane_takes_so_long(seconds):
    van = who("van", "van", ["adjacent", "left"], ["lane_change"], speed=12.0)
    changes = act("changes", "van", "change_lane", side="right", into="ego", duration_s=seconds)
    functional = told("straight", [EGO, van], acts=[changes], lanes=2)
    claim = claim_of(functional, "act.changes.duration_s")
    assert claim.holds
    assert claim.measured == pytest.approx(seconds, abs=0.2)
    concrete = first(functional)
    (change,) = concrete.participant("van").motion.lane_changes
    longer = change.model_copy(update={"length_m": 1.3 * change.length_m})
    slow = changed(concrete, "van", {"lane_changes": (longer,)})
    assert "act.changes.duration_s" in missed(functional, slow)


def test_a_swerve_is_as_far_aside_after_so_long():
    bicycle = who("bike", "bicycle", ["ahead"], ["straight"], speed=5.0)
    swerves = act("swerves", "bike", "swerve", side="left", lateral_m=0.8, duration_s=2.0)
    claim = claim_of(told("straight", [EGO, bicycle], acts=[swerves]), "act.swerves.duration_s")
    assert claim.holds
    assert claim.measured == pytest.approx(2.0, abs=0.2)


@pytest.mark.parametrize("kind", ["turn", "overtake", "enter", "reverse"])
def test_what_lasts_as_long_as_its_way_has_no_duration(kind):
    with pytest.raises(ValidationError, match="leave duration_s out"):
        told("straight", [EGO], acts=[act("does", "ego", kind, duration_s=4.0)])


@pytest.mark.parametrize(
    ("text", "times"),
    [
        ("A pedestrian takes 6 s to cross the road in front of the ego.", {"cross": 6.0}),
        ("The car ahead of the ego brakes for 1.5 s and 4 s later brakes again.", {"brake": 1.5}),
        ("The ego overtakes a truck, taking 9 s, and then brakes.", {}),
        ("A taxi makes a U-turn, taking 6 s, in front of the ego.", {}),
    ],
)
def test_durations_are_read_or_reported(text, times):
    found = read(text)
    assert {a.kind.value: a.duration_s.middle for a in found.acts if a.duration_s} == times
    delays = [a.when.delay_s.middle for a in found.acts if a.when and a.when.delay_s]
    assert delays == ([4.0] if "4 s later" in text else [])
    assert bool(times) or " s" in " ".join(u.text for u in found.unsupported)


@pytest.mark.parametrize(("road", "speed"), [("straight", 1.3), ("straight", 3.0), ("t", 1.3)])
def test_who_stops_on_the_road_stops_so_far_from_the_kerb(road, speed):
    walker = who("walker", "pedestrian", ["right"], ["cross"], speed=speed)
    acts = [act("goes", "walker", "cross", distance_m=2.5)]
    functional = told(road, [EGO, walker], acts=acts)
    concrete = first(functional)
    assert "maneuver.cross.walker.stops" not in missed(functional, concrete)
    motion = concrete.participant("walker").motion
    farther = {"stops_after_m": motion.stops_after_m + 1.0}
    go, stop = concrete.participant("walker").speed_program
    later = stop.trigger.model_copy(update={"distance_m": stop.trigger.distance_m + 1.0})
    program = (go, stop.model_copy(update={"trigger": later}))
    strayed = changed(concrete, "walker", farther, speed_program=program)
    assert "maneuver.cross.walker.stops" in missed(functional, strayed)


@pytest.mark.parametrize("metres", [0.8, 4.0])
def test_who_reverses_goes_so_far_back(metres):
    back = act("back", "ego", "reverse", distance_m=metres)
    behind = who("child", "pedestrian", ["behind"], ["stay"])
    ego = who("ego", maneuvers=["straight"], speed=1.0)
    functional = told("straight", [ego, behind], [("reversing", "ego", "child")], acts=[back])
    concrete = first(functional)
    assert "act.back.distance_m" not in missed(functional, concrete)
    never = changed(concrete, "ego", speed_program=concrete.ego.speed_program[:-1])
    assert "act.back.distance_m" in missed(functional, never)


@pytest.mark.parametrize("kind", ["turn", "overtake", "change_lane", "swerve"])
def test_what_goes_no_way_of_its_own_has_no_distance(kind):
    with pytest.raises(ValidationError, match="leave distance_m out"):
        told("straight", [EGO], acts=[act("does", "ego", kind, distance_m=4.0)])
