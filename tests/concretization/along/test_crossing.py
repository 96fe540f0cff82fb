"""Who goes across is met where and as it is said."""

from __future__ import annotations

import numpy as np
import pytest
from roads import AHEAD, CROSS, TOWARDS, ego, ends, one, road
from saying import missed
from told import act, apart, as_soon_as, at_time, first

from scegen.motion import build_paths, simulate
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.vocabulary import ParticipantKind

EGO = BODIES[ParticipantKind.CAR]
WALKER = BODIES[ParticipantKind.PEDESTRIAN]


def movements(functional):
    concrete = first(functional)
    paths = build_paths(concrete, build_network(concrete.road))
    return concrete, simulate(concrete, paths, dt_s=0.01)


def seen(trace, other):
    """How far ahead and to the left another's middle lies from one's middle, by step."""
    body, others = trace.body, other.body
    away = (other.x_m - trace.x_m) + 1j * (other.y_m - trace.y_m)
    away = away + others.centre_ahead_m * np.exp(1j * other.heading_rad)
    away = away * np.exp(-1j * trace.heading_rad) - body.centre_ahead_m
    return away.real, away.imag


@pytest.mark.parametrize("percent", [10.0, 25.0, 50.0, 90.0])
@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize(("kind", "hazard"), [
    ("pedestrian", "crossing_pedestrian"), ("bicycle", "crossing_cyclist")
])  # fmt: skip
def test_it_is_hit_where_it_is_said(kind, hazard, side, percent):
    said = road(
        [ego(45), one("x", kind, [side], CROSS)],
        [(hazard, "x", "ego")],
        outcome=ends("collision", "ego", "x", impact_percent=percent),
    )
    concrete, found = movements(said)
    assert concrete.ego.speed_program == ()
    ahead, left = seen(found["ego"], found["x"])
    reach = EGO.length_m / 2 + BODIES[ParticipantKind(kind)].width_m / 2
    touches = int(np.argmax(ahead <= reach))
    wanted = (0.5 - percent / 100) * EGO.width_m
    early = 0.025 * float(found["x"].speed_mps.max())  # half a step of the players
    assert left[touches] == pytest.approx(wanted, abs=0.05 + early)


@pytest.mark.parametrize("speed", [30, 60])
@pytest.mark.parametrize("gap", [25.0, 50.0])
@pytest.mark.parametrize("how", ["spacing", "trigger"])
def test_it_sets_off_at_the_distance_that_is_said(speed, gap, how):
    when = as_soon_as("x", "ego", "gap_m", gap) if how == "trigger" else None
    said = road(
        [ego(speed), one("x", "pedestrian", ["right"], CROSS)],
        [("crossing_pedestrian", "x", "ego")],
        acts=[act("steps", "x", "cross", when=when)],
        spacings=[] if when else [apart("x", "ego", "gap_m", gap, "steps")],
    )
    _, found = movements(said)
    ahead, _ = seen(found["ego"], found["x"])
    sets_off = int(np.argmax(found["x"].speed_mps > 0.0))
    reach = EGO.length_m / 2 + WALKER.width_m / 2
    step_m = 0.025 * speed / 3.6  # a trigger fires in the step next to its moment
    assert ahead[sets_off] - reach == pytest.approx(gap, abs=0.1 + step_m)


def test_one_that_steps_out_too_near_is_braked_for():
    said = road(
        [ego(50), one("x", "pedestrian", ["right"], CROSS), one("tail", "car", ["behind"])],
        [("crossing_pedestrian", "x", "ego")],
        acts=[act("steps", "x", "cross", when=as_soon_as("x", "ego", "gap_m", 30.0))],
    )
    concrete, found = movements(said)
    assert found["ego"].speed_mps[-1] == 0.0
    assert found["tail"].speed_mps[-1] == 0.0
    brakes = concrete.ego.speed_program
    assert len(brakes) == 1
    assert any("brakes for x" in change.reason for change in concrete.provenance)


def test_they_set_off_at_the_time_that_is_said():
    said = road(
        [ego(50), one("x", "pedestrian", ["left"], CROSS)],
        [("crossing_pedestrian", "x", "ego")],
        acts=[act("steps", "x", "cross", when=at_time(3.0))],
    )
    _, found = movements(said)
    sets_off = found["x"].time_s[int(np.argmax(found["x"].speed_mps > 0.0))]
    assert sets_off == pytest.approx(3.0, abs=0.05)


def test_it_waits_so_far_aside_as_is_said():
    said = road(
        [ego(50), one("x", "pedestrian", ["right"], CROSS)],
        [("crossing_pedestrian", "x", "ego")],
        spacings=[apart("x", "ego", "lateral_offset_m", -4.0)],
    )
    _, found = movements(said)
    _, left = seen(found["ego"], found["x"])
    assert left[0] == pytest.approx(-4.0, abs=0.1)


@pytest.mark.parametrize("side", ["left", "right"])
def test_it_reaches_the_far_kerb_and_nobody_else_hits_it(side):
    said = road(
        [
            ego(50),
            one("x", "pedestrian", [side], CROSS, speed=5),
            one("lead", "car", AHEAD),
            one("other", "car", TOWARDS),
        ],
        [("crossing_pedestrian", "x", "ego")],
        outcome=ends("near_miss", "ego", "x"),
    )
    _, found = movements(said)
    walked = np.hypot(found["x"].x_m - found["x"].x_m[0], found["x"].y_m - found["x"].y_m[0])
    assert walked[-1] > 7.0
    for name in ("lead", "other"):
        ahead, left = seen(found[name], found["x"])
        close = (np.abs(ahead) < EGO.length_m / 2) & (np.abs(left) < EGO.width_m / 2)
        assert not close.any(), name


def test_who_waits_for_somebody_comes_to_rest_though_that_one_is_soon_gone():
    said = road(
        [ego(50), one("w", "pedestrian", ["right"], CROSS)],
        [("crossing_pedestrian", "w", "ego")],
        acts=[act("waits", "ego", "wait", into="w")],
        spacings=[apart("w", "ego", "gap_m", 60.0)],
    )
    concrete, found = movements(said)
    assert found["ego"].speed_mps.min() == pytest.approx(0.0, abs=1e-6)
    assert found["ego"].speed_mps[-1] > 1.0
    assert not missed(said, concrete)
    slows = [
        p.model_copy(update={"target_speed_mps": 3.0}) if p.target_speed_mps == 0.0 else p
        for p in concrete.ego.speed_program
    ]
    rolls = concrete.ego.model_copy(update={"speed_program": tuple(slows)})
    people = tuple(rolls if p.id == "ego" else p for p in concrete.participants)
    assert "act.waits.rest" in missed(said, concrete.model_copy(update={"participants": people}))


@pytest.mark.parametrize(("kind", "hazard", "pace"), [
    ("pedestrian", "crossing_pedestrian", 6), ("bicycle", "crossing_cyclist", 20)
])  # fmt: skip
def test_the_ego_brakes_so_long_before_it_hits_who_crosses(kind, hazard, pace):
    said = road(
        [ego(40), one("x", kind, ["right"], CROSS, speed=pace)],
        [(hazard, "x", "ego")],
        acts=[act("brakes", "ego", "brake")],
        spacings=[apart("ego", "x", "ttc_s", 1.0, "brakes")],
        outcome=ends("collision", "ego", "x"),
    )
    assert not missed(said, first(said))
