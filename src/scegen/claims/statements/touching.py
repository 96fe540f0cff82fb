"""Contacts that are said: what comes after one is not judged."""

import numpy as np

from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats


def hit_s(told: Told, view: View, name: str) -> Floats:
    """When somebody is first in a contact that is said; inf: never (c,)."""
    hit = np.full(view.count, np.inf)
    for other in view.index:
        if other != name and told.may_touch(name, other):
            hit = np.fmin(hit, view.of_pair("contact_s", name, other))
    return hit


def touched(told: Told, view: View, name: str) -> Bools:
    """Whether it was in a contact that is said (c,)."""
    return np.isfinite(hit_s(told, view, name))
