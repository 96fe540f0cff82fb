"""Contacts that follow from the one that is asked for."""

from types import SimpleNamespace

import numpy as np
import pytest

from scegen.criticality.search.problem import follows_from

EGO, FIRST, SECOND, THIRD = 0, 1, 2, 3
PAIRS = np.array([(EGO, FIRST), (EGO, SECOND), (SECOND, THIRD)])


def _view(contact_s):
    summary = SimpleNamespace(contact_s=np.array([contact_s]))
    scene = SimpleNamespace(pairs=PAIRS)
    return SimpleNamespace(count=1, summary=summary, scene=scene, pair=lambda *_: (0, False))


@pytest.mark.parametrize(
    ("contact_s", "other", "expected"),
    [
        ((5.0, 6.0, np.nan), 1, True),  # through the one that is hit into the next
        ((5.0, 4.0, np.nan), 1, False),  # the next one first: that was not asked for
        ((np.nan, 4.0, np.nan), 1, False),  # the contact that is asked for does not come
        ((5.0, np.nan, 6.0), 2, False),  # two others
    ],
)
def test_only_what_one_of_them_hits_later_follows(contact_s, other, expected):
    target = SimpleNamespace(contact=True)
    view = _view(contact_s)
    assert follows_from(view, target, ("ego", "car_1"), other)[0] == expected


def test_where_no_contact_is_asked_for_none_follows():
    view = _view((5.0, 6.0, np.nan))
    target = SimpleNamespace(contact=None)
    assert not follows_from(view, target, ("ego", "car_1"), 1)[0]
