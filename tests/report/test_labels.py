"""Labels: never on one another, never outside, next to what they name where there is room."""

from itertools import combinations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from scegen.report.labels import Label, draw_labels, place
from scegen.report.theme import LIGHT

PICTURE = (0.0, 0.0, 600.0, 400.0)
NOTHING = np.zeros((0, 2))


def box(x, y):
    return (x - 10, y - 5, x + 10, y + 5)


@given(
    st.lists(st.tuples(st.floats(-20, 620), st.floats(-20, 420)), max_size=14),
    st.lists(st.tuples(st.floats(0, 600), st.floats(0, 400)), max_size=40),
)
def test_labels_lie_inside_and_apart(places, way):
    labels = [Label(f"car_{n} 50 km/h", box(x, y), bold=n == 0) for n, (x, y) in enumerate(places)]
    taken = (0.0, 360.0, 120.0, 400.0)
    found = place(labels, PICTURE, [taken], np.array(way).reshape(-1, 2))
    for item in found:
        left, top, right, bottom = item.where
        assert left >= 0
        assert top >= 0
        assert right <= 600
        assert bottom <= 400
    for one, other in combinations([*(item.where for item in found), taken], 2):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart


def test_a_label_is_beside_its_body_and_off_the_way():
    way = np.column_stack((np.linspace(0, 600, 200), np.full(200, 190.0)))
    (found,) = place([Label("ego", box(300, 200))], PICTURE, [], way)
    left, top, right, bottom = found.where
    assert not found.led
    assert not ((way[:, 0] > left) & (way[:, 0] < right) & (top < 190) & (bottom > 190)).any()


def test_what_cannot_be_placed_is_left_out_and_what_lies_far_is_led():
    crowd = [Label("a rather long name", box(300, 200)) for _ in range(400)]
    found = place(crowd, PICTURE, [], NOTHING)
    assert 4 < len(found) < len(crowd)
    led = [item for item in found if item.led]
    drawn = draw_labels(found, LIGHT)
    assert drawn.count("<path") == len(led) > 0


def test_words_are_escaped():
    found = place([Label("<b>&", box(300, 200))], PICTURE, [], NOTHING)
    assert "&lt;b&gt;&amp;" in draw_labels(found, LIGHT)
