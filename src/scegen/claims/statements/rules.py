"""Rules of the road: kept by everybody whom the text does not make break them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.moments import first
from scegen.claims.told import Told
from scegen.claims.tolerances import TIME_S
from scegen.claims.view import View, longest_run
from scegen.motion.batch.arrays import Bools
from scegen.motion.rules.stopping import (
    AT_LINE_M,
    OVER_LINE_M,
    STOPPED_MPS,
    STOPPED_S,
    must_stop,
)


def claims(told: Told) -> Iterator[Claim]:
    """One for everybody and every rule that it meets with."""
    for name in sorted(must_stop(told.functional, told.logical)):
        yield Claim(
            id=f"rule.stop.{name}",
            kind=ClaimKind.RULE,
            statement=f"{name} stands at the stop line before it goes over it",
            field="junction.control",
            unit="s",
            test=partial(_stops, name),
            tolerance=TIME_S,
            scale=0.5,
        )


def _stops(name: str, view: View) -> Judged:
    """The longest rest at the line before it is passed; at the end there is none to be missed."""
    front = view.place_m(name) + view.body(name).front_m - view.ways[name].line_m
    before = np.arange(view.steps) < first(front > OVER_LINE_M)[:, None]
    at_line = before & (front > -AT_LINE_M) & (view.speed_mps(name) < STOPPED_MPS)
    steps, begins = longest_run(at_line)
    rest = np.where(steps > 0, (steps - 1) * view.dt_s, 0.0)
    margin = np.where(_goes_over(front > OVER_LINE_M, view), rest - STOPPED_S + TIME_S, 0.0)
    return Judged(margin, rest, np.asarray(begins * view.dt_s))


def _goes_over(over: Bools, view: View) -> Bools:
    """Whether it passes before the scenario is over (c,)."""
    return first(over) <= view.last_step
