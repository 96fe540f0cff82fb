"""What the claims of acts are made of: the claim, the moment, the way to the side, the contact."""

from collections.abc import Callable
from functools import partial

import numpy as np

from scegen.claims.boxes import contact
from scegen.claims.claim import Claim, ClaimKind, Judged, Test
from scegen.claims.told import Told
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats, Ints
from scegen.scenario.acts import Act


def claim_of(
    told: Told,
    act: Act,
    part: str,
    statement: str,
    unit: str,
    test: Callable[..., Judged],
    *args: object,
    tolerance: float = 0.0,
    scale: float = 1.0,
) -> Claim:
    """The claim about one part of an act; without a part, about its happening."""
    name = f"{act.id}.{part}" if part else act.id
    bound: Test = partial(test, told, act, *args)
    kind, field = ClaimKind.ACT, f"acts.{name}"
    return Claim(f"act.{name}", kind, statement, field, unit, bound, tolerance, scale)


def when_s(view: View, step: Ints) -> Floats:
    """The moment of a step, s; NaN where there is none (c,)."""
    return np.where(step < view.steps, view.time_of(step), np.nan)


def hits(told: Told, act: Act, view: View) -> Bools:
    """Whether it touches the one into whose lane it goes, as is said (c,)."""
    who, other = act.participant, act.into or told.ego
    if who == other or not told.may_touch(who, other):
        return np.zeros(view.count, dtype=np.bool_)
    return contact(view, who, other).happens
