"""What a collision leaves: nobody drives on through whom it has hit."""

import numpy as np
import pytest
from playing import play

from scegen.claims.boxes import boxes, gap_m
from scegen.claims.hazards.scenes import scene_of
from scegen.claims.view import view_of
from scegen.claims.ways import paths_of, ways_of
from scegen.motion.batch.compilation import compile_program
from scegen.motion.batch.simulation import simulate_batch
from scegen.road import build_network
from scegen.understanding import read

CRUSHED_M = 0.8


def _view(concrete, pair):
    ways = ways_of(concrete, build_network(concrete.road))
    program, own = compile_program(concrete, paths_of(ways))
    scene = scene_of(concrete, paths_of(ways), [pair], 1.0)
    traces = simulate_batch(program, own, duration_s=concrete.duration_s, dt_s=0.01)
    return view_of(concrete, ways, scene, traces, 1.0)


@pytest.mark.parametrize(
    "text",
    [
        "The ego drives at 50 km/h and hits a stationary car in its lane.",
        "The lead car brakes hard, and the ego, 12 m behind it at 60 km/h, runs into it.",
        "The ego at 40 km/h hits a rock that lies in its lane.",
    ],
)
def test_who_hits_somebody_with_its_front_is_halted(text):
    made = play(read(text), files=False)
    concrete = made.concrete
    assert not made.missed
    pair = made.proof.pair
    struck = concrete.ego.on_contact
    assert struck is not None
    assert struck.participant in pair
    view = _view(concrete, pair)
    gap = gap_m(boxes(view, pair[0]), boxes(view, pair[1]))[0]
    assert gap.min() <= 0.0
    assert gap.min() > -CRUSHED_M
    assert view.speed_mps("ego")[0, -1] == 0.0


def test_who_is_on_foot_is_no_wall():
    made = play(read("A pedestrian crosses and the ego at 40 km/h hits her."), files=False)
    concrete = made.concrete
    assert concrete.ego.on_contact.rate_mps2 < 10.0
    walker = next(p for p in concrete.participants if p.id != "ego")
    view = _view(concrete, made.proof.pair)
    assert view.speed_mps(walker.id)[0, -1] == 0.0


def test_who_touches_nobody_keeps_its_program():
    made = play(read("The lead car brakes with 5 m/s2 in front of the ego."), files=False)
    assert all(p.on_contact is None for p in made.concrete.participants)


@pytest.mark.esmini
def test_the_player_halts_them_too():
    made = play(read("The ego drives at 50 km/h and hits a stationary car in its lane."))
    assert made.recorded
    assert not made.disagreeing
    assert np.all([claim.holds for claim in made.recorded])
