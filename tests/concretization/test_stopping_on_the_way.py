"""Who goes across and stops on the way comes to rest where that is said, and is met at rest."""

import numpy as np
import pytest
from mutating import changed, phase
from roads import CROSS, ego, ends, one
from saying import missed
from told import act, apart, as_soon_as, made, told

from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.road import build_network

HIT = ends("collision", "ego", "x", struck="front")
PASSED = ends("near_miss", "ego", "x")
INTO, OUT_OF = {"crosses": "exit"}, {"crosses": "entry"}


def aside(metres, reference="ego", measure="lateral_offset_m"):
    return {**apart("x", reference, measure, metres, "halts"), "since": "end"}


def stopping(spacing=None, outcome=HIT, side="right", kind="straight", turns="straight", **where):
    walker = one("x", "pedestrian", [] if kind != "straight" else [side], CROSS, speed=5)
    when = where.pop("when", None)
    return told(
        kind,
        [ego(50 if turns == "straight" else 20, [turns]), {**walker, **where}],
        [("crossing_pedestrian", "x", "ego")],
        acts=[act("halts", "x", "stop", when=when)],
        spacings=[spacing] if spacing else [],
        outcome=outcome,
    )


CASES = {
    "amid the way": stopping({}, ends("collision", "ego", "x", struck="front", impact_percent=50)),
    "so far left": stopping(aside(0.5)),
    "at a share of the front": stopping(
        None, ends("collision", "ego", "x", struck="front", impact_percent=20), "left"
    ),
    "amid the road": stopping(aside(0.0, "x"), PASSED),
    "short of it": stopping(aside(0.5, measure="lateral_gap_m"), PASSED, "left"),
    "at a distance": stopping(aside(30.0, measure="gap_m"), PASSED),
    "as the ego is near": stopping(when=as_soon_as("x", "ego", "gap_m", 20.0)),
    "in the road turned into": stopping(
        None,
        ends("collision", "ego", "x", impact_percent=50),
        kind="four_way",
        turns="right",
        **INTO,
    ),
    "in the road come by": stopping(aside(-0.5), kind="four_way", **OUT_OF),
    "amid that road": stopping(aside(0.0, "x"), PASSED, kind="t", turns="left", **INTO),
}


@pytest.mark.parametrize("name", CASES)
def test_it_stands_there_when_it_is_met(name):
    functional = CASES[name]
    concrete, _ = made(functional)
    assert missed(functional, concrete) == set()
    traces = simulate(concrete, build_paths(concrete, build_network(concrete.road)))
    one, other = traces["ego"], traces["x"]
    far = np.hypot(one.x_m - other.x_m, one.y_m - other.y_m)
    nearest = int(far.argmin())
    assert traces["x"].speed_mps[: nearest + 1].max() > 1.0
    assert traces["x"].speed_mps[nearest:].max() == 0.0


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("amid the way", {"rests.x.place", "outcome.impact_percent"}),
        ("so far left", {"spacing.0"}),
        ("amid the road", {"spacing.0"}),
    ],
)
def test_one_that_walks_on_or_stops_elsewhere_is_noticed(name, wrong):
    functional = CASES[name]
    concrete, _ = made(functional)
    walker = concrete.participant("x")
    ends_m = walker.motion.stops_after_m
    on = walker.speed_program[1].trigger.model_copy(update={"distance_m": ends_m + 1.0})
    program = (walker.speed_program[0], walker.speed_program[1].model_copy(update={"trigger": on}))
    farther = changed(concrete, "x", {"stops_after_m": ends_m + 1.6}, speed_program=program)
    assert wrong <= missed(functional, farther)


def test_one_that_comes_too_late_to_stand_there_is_noticed():
    functional = CASES["in the road turned into"]
    concrete, _ = made(functional)
    slow = concrete.participant("x").speed_program[0].target_speed_mps * 0.7
    assert "rests.x.met" in missed(functional, phase(concrete, "x", target_speed_mps=slow))
