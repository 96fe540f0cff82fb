"""Contact, distance, time to collision and line of sight against shapely."""

import numpy as np
import pytest
from criticality_geometry import polygon, random_boxes
from shapely import MultiPoint
from shapely.affinity import translate
from shapely.geometry import LineString

from scegen.measures.distance import box_distance
from scegen.measures.occlusion import cuts, hidden
from scegen.measures.time_to_collision import box_time_to_collision
from scegen.motion.batch.touching import Box, boxes_touch


@pytest.fixture(scope="module")
def pairs():
    rng = np.random.default_rng(11)
    return list(zip(random_boxes(rng, 1500), random_boxes(rng, 1500)[::-1], strict=True))


def test_contact_is_that_of_the_polygons(pairs):
    expected = [polygon(a).intersects(polygon(b)) for a, b in pairs]
    assert 0.2 < np.mean(expected) < 0.8
    assert [boxes_touch(a, b) for a, b in pairs] == expected


def test_distance_is_that_of_the_polygons(pairs):
    expected = [polygon(a).distance(polygon(b)) for a, b in pairs]
    got = [box_distance(a, b) for a, b in pairs]
    np.testing.assert_allclose(got, expected, rtol=0, atol=1e-9)
    np.testing.assert_allclose(got, [box_distance(b, a) for a, b in pairs], rtol=0, atol=1e-9)


def test_boxes_that_form_a_plus_touch():
    across, along = Box(0, 0, 1, 0, 5, 0.5), Box(0, 0, 0, 1, 5, 0.5)
    assert boxes_touch(across, along)
    assert box_distance(across, along) == 0.0


def swept_contact_time(a, b, vx, vy, horizon=40.0):
    """First contact by bisection: has the ground that b sweeps until then touched a?"""
    target, corners = polygon(a), np.array(polygon(b).exterior.coords)

    def touched(t):
        moved = np.vstack((corners, corners + np.array([vx * t, vy * t])))
        return MultiPoint(moved).convex_hull.intersects(target)

    if not touched(horizon):
        return np.inf
    low, high = 0.0, horizon
    if touched(0.0):
        return 0.0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (low, middle) if touched(middle) else (middle, high)
    return high


def test_time_to_collision_is_that_of_the_swept_polygons():
    rng = np.random.default_rng(5)
    boxes = list(zip(random_boxes(rng, 400, 15), random_boxes(rng, 400, 15)[::-1], strict=True))
    hits = 0
    for a, b in boxes:
        if rng.random() < 0.8:  # more or less towards each other
            vx, vy = np.array([a.x - b.x, a.y - b.y]) * rng.uniform(0.1, 1.0) + rng.normal(0, 2, 2)
        else:
            vx, vy = rng.choice([0.0, 0.0, 3.0, -3.0], 2)
        expected = swept_contact_time(a, b, vx, vy)
        got = box_time_to_collision(a, b, vx, vy)
        if np.isinf(expected) and np.isfinite(got):
            assert got > 40.0
        else:
            assert got == pytest.approx(expected, abs=1e-6)
        hits += 0 < got < 40
        if 0 < got < 40:
            moved = translate(polygon(b), vx * got, vy * got)
            assert moved.distance(polygon(a)) < 1e-6
    assert 100 < hits < 390


def test_a_box_cuts_what_shapely_says_it_cuts():
    rng = np.random.default_rng(6)
    boxes = random_boxes(rng, 1500)
    ends = rng.uniform(-10, 10, (1500, 4))
    expected = [
        polygon(b).intersects(LineString([e[:2], e[2:]])) for b, e in zip(boxes, ends, strict=True)
    ]
    assert 0.2 < np.mean(expected) < 0.8
    assert [cuts(b, *e) for b, e in zip(boxes, ends, strict=True)] == expected


def test_hidden_means_that_every_corner_is():
    rng = np.random.default_rng(7)
    seen = set()
    for _ in range(600):
        observer, target = random_boxes(rng, 2, 10)
        target = target._replace(half_length=0.3, half_width=0.3)
        heading = rng.uniform(-np.pi, np.pi)
        x, y = (observer.x + target.x) / 2 + rng.normal(0, 2), (observer.y + target.y) / 2
        occluder = Box(x, y, np.cos(heading), np.sin(heading), 3.0, 1.2)
        points = [(target.x, target.y), *list(polygon(target).exterior.coords)[:4]]
        sights = [LineString([(observer.x, observer.y), point]) for point in points]
        expected = all(polygon(occluder).intersects(sight) for sight in sights)
        assert hidden(observer, target, occluder) == expected
        seen.add(expected)
    assert seen == {True, False}
