"""What each parameter can do, changed alone: how far it goes, what stops it, what it is worth."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from scegen.claims.claim import Claim, ClaimKind
from scegen.claims.view import View
from scegen.criticality.proposals.driving import hindrances_in
from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.search.problem import Problem, finishing
from scegen.motion.batch.arrays import Floats

_SAME = 1e-6
_LOOKS = 8
"""Values that are tried on either side of the present one."""


@dataclass(frozen=True, slots=True)
class Reach:
    """The range in which a parameter can be driven, and breaks nothing, if nothing else changes.

    ``stops`` says what stands in the way beyond it, if its own bounds do not. ``sooner_s`` is by
    how much whoever it belongs to comes sooner to its encounter, per unit; None if that is unknown.
    """

    low: float
    high: float
    stops: tuple[str, ...]
    sooner_s: float | None


@dataclass(frozen=True, slots=True)
class Said:
    """A statement that must hold, and by how much it does (below 0: it does not)."""

    statement: str
    margin: float
    unit: str


@dataclass(frozen=True, slots=True)
class Explored:
    """What every parameter can do, and the statements that depend on them or do not hold yet."""

    reaches: Mapping[str, Reach]
    said: tuple[Said, ...]


def explored(
    problem: Problem, parameters: Sequence[Parameter], places_m: Mapping[str, float]
) -> Explored:
    """Try values of every parameter, one at a time.

    ``places_m``: where on its way somebody comes to the ground that it shares with another.
    """
    origin = problem.space.origin
    tried = [_values(p) for p in parameters]
    rows = [origin]
    for parameter, values in zip(parameters, tried, strict=True):
        for value in values:
            row = origin.copy()
            row[parameter.column] = value
            rows.append(row)
    made = problem.space.candidates(np.array(rows))
    view = problem.view(made)
    found = [set(why) for why in hindrances_in(problem, made, view)]
    said = []
    for claim, margin in _margins(problem, view):
        if float(np.ptp(margin)) > _SAME or margin[0] < 0.0:
            said.append(Said(claim.statement, float(margin[0]), claim.unit))
        for why, broken in zip(found, (margin < 0.0) & (margin[0] >= 0.0), strict=True):
            if broken:
                why.add(f"it would no longer hold that {claim.statement}")
    comes = {
        name: _arrives_s(view.place_m(name), place, view.dt_s) for name, place in places_m.items()
    }
    reached, begin = {}, 1
    for parameter, values in zip(parameters, tried, strict=True):
        here = slice(begin, begin + len(values))
        begin += len(values)
        fresh = [why - found[0] for why in found[here]]
        who = parameter.name.split(".")[0]
        times = comes[who][[0, *range(*here.indices(len(rows)))]] if who in comes else None
        reached[parameter.name] = _reach(parameter, values, fresh, times)
    return Explored(reached, tuple(said))


def _margins(problem: Problem, view: View) -> Iterator[tuple[Claim, Floats]]:
    """Of what must hold beside dangers and contacts, which are told by themselves."""
    _, duration_s = finishing(view, problem.pair)
    ending = replace(view, ends_s=duration_s)
    for claim in problem.claims:
        told = claim.kind in {ClaimKind.HAZARD, ClaimKind.CONTACT}
        if not told and claim.id not in problem.given_up:
            yield claim, claim.judge(ending).margin


def _values(parameter: Parameter) -> list[float]:
    """Values from the present one outwards, down and then up."""
    down = np.linspace(parameter.value, parameter.low, _LOOKS + 1)[1:]
    up = np.linspace(parameter.value, parameter.high, _LOOKS + 1)[1:]
    return [float(value) for value in (*down, *up)]


def _reach(
    parameter: Parameter, values: Sequence[float], fresh: Sequence[set[str]], times: Floats | None
) -> Reach:
    """Outwards until the first value that cannot be driven; ``times`` begin with the present."""
    ends, stops = [], set[str]()
    for side in (range(_LOOKS), range(_LOOKS, 2 * _LOOKS)):
        end = parameter.value
        for n in side:
            if fresh[n]:
                stops |= fresh[n]
                break
            end = values[n]
        ends.append(end)
    sooner = None
    for n in (_LOOKS, 0):
        step = values[n] - parameter.value
        if times is not None and sooner is None and abs(step) > 0.0 and not fresh[n]:
            gained = float((times[0] - times[n + 1]) / step)
            sooner = gained if np.isfinite(gained) else None
    return Reach(ends[0], ends[1], tuple(sorted(stops)), sooner)


def _arrives_s(place_m: Floats, at_m: float, dt_s: float) -> Floats:
    """When each candidate (c, t) comes to a place, within a step; nan where it does not."""
    times_s = np.arange(place_m.shape[1]) * dt_s
    return np.array([np.interp(at_m, own, times_s, left=np.nan, right=np.nan) for own in place_m])
