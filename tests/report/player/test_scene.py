"""The scene says what was simulated: where, how near, hidden from whom, when."""

import json

import numpy as np
import pytest
from scenes import PROOF, claim, concrete, moved, scene
from things import thing

from scegen.measures.evaluation import measure
from scegen.measures.tables import build_tables
from scegen.motion.batch import stack_traces
from scegen.report.player.scene import STEP_S
from scegen.report.player.series import compact


def value(series, time_s):
    k = time_s / STEP_S
    low = min(int(k + 1e-9), len(series) - 1)
    high = min(low + 1, len(series) - 1)
    return series[low] + (series[high] - series[low]) * (k - int(k + 1e-9))


def test_everybody_is_where_the_simulation_has_them():
    made, traces = scene()
    for one in made["participants"]:
        trace = traces[one["id"]]
        for step in range(0, len(trace.time_s), 7):
            time_s = trace.time_s[step]
            x, y = value(one["x_m"], time_s), value(one["y_m"], time_s)
            assert np.hypot(x - trace.x_m[step], y - trace.y_m[step]) <= 0.05
        for step in range(0, len(trace.time_s), 5):
            speed = value(one["speed_mps"], trace.time_s[step])
            assert speed == pytest.approx(trace.speed_mps[step], abs=0.001)


def test_plotted_extremes_are_those_of_the_measures():
    scenario = concrete()
    _, paths, traces = moved(scenario)
    made, _ = scene(scenario)
    names = [p.id for p in scenario.participants]
    ways = [paths[name] for name in names]
    alone = build_tables(ways, [p.body for p in scenario.participants], pairs=[(0, 1)])
    summary = measure(stack_traces([traces[name] for name in names], ways), alone)
    (pair,) = (p for p in made["pairs"] if p["between"] == ["ego", "car_1"])
    least = min(v for v in pair["distance_m"] if v is not None)
    assert least == pytest.approx(summary.distance_m[0, 0], abs=0.006)
    assert pair["least"]["distance_m"] == pytest.approx(summary.distance_m[0, 0], abs=0.001)
    assert pair["least"]["pet_s"] == pytest.approx(summary.pet_s[0, 0], abs=0.001)
    area = next(a for a in made["areas"] if a["between"] == ["ego", "car_1"])
    (_, first_out), (second_in, _) = sorted(area["occupied_s"])
    assert second_in - first_out == pytest.approx(summary.pet_s[0, 0], abs=0.011)
    assert made["moment_s"] == pytest.approx(summary.closest_s[0, 0], abs=0.006)


def test_who_stands_behind_a_hedge_is_hidden_and_behind_a_kerb_is_not():
    ego = concrete().ego
    _, _, traces = moved(concrete())
    eye, walker = traces["ego"], traces["walker"]
    x, y = 0.1 * eye.x_m[0] + 0.9 * walker.x_m[0], 0.1 * eye.y_m[0] + 0.9 * walker.y_m[0]
    hedge = {"x_m": x, "y_m": y, "length_m": 3.0, "width_m": 3.0}
    for height_m, hides in ((2.0, True), (0.3, False)):
        box = thing(**hedge).model_copy(update={"height_m": height_m})
        made, _ = scene(concrete(objects=[box.model_dump(mode="json")]))
        spans = [h for h in made["hidden"] if (h["observer"], h["target"]) == (ego.id, "walker")]
        assert bool(spans) is hides
        assert not hides or spans[0]["spans_s"][0][0] == 0.0


def test_statements_and_dangers_become_moments_in_order():
    made, _ = scene()
    times = [moment["time_s"] for moment in made["moments"]]
    assert times == sorted(times)
    kinds = {moment["kind"] for moment in made["moments"]}
    assert kinds == {"danger", "claim", "closest"}
    assert [m["holds"] for m in made["moments"] if m["kind"] == "claim"] == [True, False]
    assert [c["who"] for c in made["claims"]] == [["car_1"], ["ego"], ["van"]]


def test_a_way_that_is_judged_at_the_end_is_shown_in_the_junction():
    leaves = claim("ego", "goes straight on", kind="exit", time_s=20.0)
    crosses = claim("walker", "crosses", kind="maneuver", time_s=20.0)
    made, traces = scene(proof=PROOF.model_copy(update={"claims": (leaves, crosses)}))
    through, over = (one["shown_s"] for one in made["claims"])
    drive = concrete().ego.motion
    inside = np.interp(through, traces["ego"].time_s, traces["ego"].s_m) + drive.start_m
    assert drive.turning_starts_m < inside < drive.turning_ends_m
    walked = traces["walker"].s_m
    assert np.interp(over, traces["walker"].time_s, walked) == pytest.approx(
        walked[-1] / 2, abs=0.1
    )


def test_without_a_proof_it_is_about_the_nearest():
    made, _ = scene(proof=None)
    assert made["claims"] == []
    assert made["pair"][0] == "ego"
    assert made["critical_s"][0] <= made["moment_s"] <= made["critical_s"][1]


def test_same_input_same_bytes_and_few_of_them():
    first, second = (json.dumps(scene()[0], allow_nan=False) for _ in range(2))
    assert first == second
    assert len(first) < 60_000


def test_lights_change_as_the_plan_says():
    road = concrete().road.model_dump(mode="json")
    road |= {"control": "signals", "controlled_arms": [0, 1, 2, 3]}
    groups = [
        {"id": 1, "arms": [0, 2], "green_from_s": 28.0, "green_s": 10.0},
        {"id": 2, "arms": [1, 3], "green_from_s": 13.0, "green_s": 10.0},
    ]
    plan = {"cycle_s": 30.0, "amber_s": 3.0, "groups": groups}
    made, _ = scene(concrete(road=road, signals=plan), proof=None)
    states = {light["arm"]: light["states"] for light in made["road"]["lights"]}
    assert states[0] == states[2]
    assert states[0][:3] == [[0.0, "green"], [8.0, "amber"], [11.0, "red"]]
    assert states[1][:2] == [[0.0, "red"], [13.0, "green"]][: len(states[1])]


def test_lights_without_a_plan_are_dark():
    road = concrete().road.model_dump(mode="json")
    made, _ = scene(
        concrete(road=road | {"control": "signals", "controlled_arms": [0]}), proof=None
    )
    assert [light["states"] for light in made["road"]["lights"]] == [[]]


def test_series_end_with_their_last_change():
    assert compact([1.0, 2.0, 2.0, 2.0], 2) == [1.0, 2.0]
    assert compact([float("inf"), 1.234, float("nan"), float("nan")], 1) == [None, 1.2, None]
    assert compact([-0.001], 2) == [0.0]
