"""Films: the closest approach is a picture, views stay or follow, labels keep apart."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from scegen.concretization import concretize
from scegen.criticality.encounter import closest_encounter
from scegen.enumeration import enumerate_scenarios
from scegen.motion import simulate
from scegen.motion.paths import build_paths
from scegen.report.film import Cut, make_film
from scegen.report.moving_labels import MovingLabels
from scegen.report.theme import LIGHT
from scegen.road import build_network
from scegen.understanding import read

MOTORWAY = "The ego follows a car at 130 km/h. The car brakes with 6 m/s2 to 60 km/h."
CROSSING = "The ego goes straight at a four-way intersection. A car comes from the right."


def scene(sentence):
    functional = read(sentence)
    logical = enumerate_scenarios(functional).scenarios[0]
    concrete = concretize(functional, logical, seed=0)
    network = build_network(concrete.road, name=concrete.name)
    return concrete, network, build_paths(concrete, network)


@pytest.fixture(scope="module", params=[MOTORWAY, CROSSING])
def shot(request):
    concrete, network, paths = scene(request.param)
    return make_film(concrete, network, paths, Cut(), LIGHT), concrete, paths


def test_the_closest_approach_is_a_picture_that_stays(shot):
    film, concrete, paths = shot
    met = closest_encounter(concrete, simulate(concrete, paths))
    assert film.times_s[film.critical] == pytest.approx(met.time_s)
    assert film.lasts_s[film.critical] == film.lasts_s.max() > 1.0
    assert np.diff(film.times_s) == pytest.approx(0.1)
    words = "closest" if met.distance_m > 0 else "contact"
    for number in (0, film.critical):
        root = etree.fromstring(film.picture(number).encode())
        said = " ".join(root.itertext())
        assert (words in said) == (number == film.critical)
        assert film.picture(number) == film.picture(number)


def test_the_ego_is_always_seen(shot):
    film, concrete, _ = shot
    trace = film.stage.traces[concrete.ego.id]
    width, height = film.size
    assert height % 2 == 0
    for number, view in enumerate(film.views):
        x, y = view.seen(np.array([trace.x_m[number], trace.y_m[number]]))
        assert 0 < x < width
        assert 0 < y < height


def test_a_view_follows_only_where_it_must():
    followed, stays = (
        make_film(*scene(sentence), Cut(), LIGHT) for sentence in (MOTORWAY, CROSSING)
    )
    assert len({view.x_m for view in followed.views}) > 10
    assert max(np.diff([view.x_m for view in followed.views]).__abs__()) < 4.5  # 0.1 s each
    assert len(set(stays.views)) == 1


def test_a_cut_is_kept():
    cut = Cut(begin_s=1.0, end_s=2.0, fps=20, speed=0.5, width=400)
    film = make_film(*scene(CROSSING), cut, LIGHT)
    assert film.times_s[0] == 1.0
    assert film.times_s[-1] == pytest.approx(2.0)
    assert len(film) == 41
    assert film.size[0] == 400


@given(
    st.lists(
        st.lists(st.tuples(st.floats(0, 500), st.floats(0, 300)), min_size=5, max_size=5),
        min_size=1,
        max_size=6,
    )
)
def test_moving_labels_never_meet(places):
    names = [f"car_{n}" for n in range(len(places))]
    boxes = {
        name: np.array([(x - 12, y - 6, x + 12, y + 6) for x, y in way])
        for name, way in zip(names, places, strict=True)
    }
    labels = MovingLabels.arranged({n: f"{n} 50 km/h" for n in names}, boxes, (500, 300), "car_0")
    for number in range(5):
        shown = [labels.where[n][number] for n in names if labels.shown[n][number]]
        for a, b in combinations(shown, 2):
            assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
        for left, top, right, bottom in shown:
            assert left >= 0
            assert top >= 0
            assert right <= 500
            assert bottom <= 300
