"""The search itself: quasi-random batches with closer looks, then CMA-ES with restarts.

Where many take part, mostly one or two are in the way: changing them alone comes first. Every
batch runs through the compiled simulator at once. What is found is then brought back towards the
scenario as it was concretized, as far as the demands allow.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from scegen.criticality.search.problem import Outcome, Problem
from scegen.loading import stand_ins
from scegen.motion.batch.arrays import Floats

with stand_ins({"scipy": None, "scipy.stats": None}):  # for other optimizers only
    from cmaes import CMA

FIRST_BATCH = 96
CLOSER_BATCH = 48
LEAD_BATCH = 24
CLOSER_SPANS = (0.5, 0.3, 0.15, 0.08)
ROUNDS = 3
RESTARTS = 2
GENERATIONS = 40
ALONE_ROUNDS = 6
SOME_ROUNDS = 8
SOME_BATCH = 96
_MANY = 10
_VAIN_ROUNDS, _VAIN_GENERATIONS = 3, 12
"""After so many that were no better, one more is not worth its time."""
_ALONE_ANYWHERE, _ALONE_NEAR = 4, 2
_NEAR = 0.15
_WORTH = 1e-3
_SIGMA = 0.2
_BACK_STEPS = 6
_BACK_ROUNDS = 3
_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79)


@dataclass(frozen=True, slots=True)
class Lead:
    """Where somebody proposes to begin: ``x`` (n,), and draws of its own to look around it."""

    x: Floats
    rng: np.random.Generator


@dataclass
class Best:
    """The best candidate so far, and by demand the least that any candidate missed."""

    x: Floats
    loss: float = np.inf
    missing: dict[str, float] = field(default_factory=lambda: {"all": np.inf})
    least: dict[str, float] = field(default_factory=dict)

    @property
    def found(self) -> bool:
        """Whether it misses nothing."""
        return sum(self.missing.values()) <= 0.0

    def take(self, x: Floats, outcome: Outcome) -> bool:
        """Keep the best of a batch if it is better; solutions before others."""
        for name, values in outcome.missing.items():
            self.least[name] = min(self.least.get(name, np.inf), float(values.min()))
        order = np.where(outcome.found, outcome.loss, 1e3 + outcome.loss)
        i = int(order.argmin())
        if float(order[i]) < (self.loss if self.found else 1e3 + self.loss):
            self.x, self.loss = x[i].copy(), float(outcome.loss[i])
            self.missing = {name: float(values[i]) for name, values in outcome.missing.items()}
            return True
        return False

    def keep(self, other: Best) -> None:
        """Take over what another search found, if it is better; solutions before others."""
        if (not other.found, other.loss) < (not self.found, self.loss):
            self.x, self.loss, self.missing = other.x, other.loss, other.missing


def search(
    problem: Problem, rng: np.random.Generator, *, rounds: int = ROUNDS, restarts: int = RESTARTS
) -> Best:
    """Look until something is found or the effort is spent; the same rng gives the same result."""
    space, origin = problem.space, problem.space.origin
    first = origin[None, :]
    outcome = problem.evaluate(first)
    best = Best(origin)
    best.take(first, outcome)
    count = len(space.variables)
    if best.found or not count:
        return best
    if count >= _MANY:
        # In so many dimensions nothing is found by looking everywhere.
        _one_by_one(problem, best, rng)
        _some_at_once(problem, best, rng)
        rounds, restarts = 0, min(restarts, 1)
    for _ in range(0 if best.found else rounds):
        # A fresh look is not drawn to what looked best before and led nowhere.
        fresh = Best(origin, least=best.least)
        points = halton(FIRST_BATCH, rng.random(count))
        reach = np.repeat([0.4, 1.0, 2.0], FIRST_BATCH // 3)[:, None]
        _look(problem, fresh, folded(space.unit(origin) + (points - 0.5) * reach))
        _look_closer(problem, fresh, CLOSER_SPANS, CLOSER_BATCH, rng)
        best.keep(fresh)
        if best.found:
            break
    for restart in range(restarts):
        if best.found:
            break
        start = space.unit(best.x) if restart == 0 else rng.random(count)
        _evolve(problem, best, start, rng)
    if best.found:
        _come_back(problem, best, origin)
    return best


def follow(problem: Problem, lead: Lead) -> Best:
    """Look at the lead, at a part of it, and then around the best of these; stay near the lead."""
    best = Best(lead.x)
    first = np.array([lead.x, *_nearer(lead.x, problem.space.origin)])
    problem.home = lead.x
    try:
        best.take(first, problem.evaluate(first))
        _look_closer(problem, best, CLOSER_SPANS[1:], LEAD_BATCH, lead.rng)
        if best.found and (best.x != lead.x).any():
            _come_back(problem, best, lead.x)
    finally:
        problem.home = None
    return best


def _look(problem: Problem, best: Best, u: Floats) -> Outcome:
    """Evaluate points of the unit cube."""
    x = problem.space.at(u)
    outcome = problem.evaluate(x)
    best.take(x, outcome)
    return outcome


def _look_closer(
    problem: Problem, best: Best, spans: Sequence[float], count: int, rng: np.random.Generator
) -> None:
    """Evaluate so many points around the best, nearer and nearer, until something is found."""
    for width in spans:
        if best.found:
            return
        points = halton(count, rng.random(len(best.x)))
        _look(problem, best, folded(problem.space.unit(best.x) + (points - 0.5) * width))


def _one_by_one(problem: Problem, best: Best, rng: np.random.Generator) -> None:
    """Change every variable alone, then those together of which that was better, while it helps."""
    n, tries = len(best.x), _ALONE_ANYWHERE + _ALONE_NEAR
    for _ in range(ALONE_ROUNDS):
        before = best.loss
        u = problem.space.unit(best.x)
        shift = rng.random((2, n))
        anywhere = (np.arange(_ALONE_ANYWHERE)[:, None] + shift[0]) / _ALONE_ANYWHERE
        near = u + _NEAR * np.array([[-1.0], [1.0]]) * (0.1 + 0.9 * shift[1])
        values = folded(np.concatenate([anywhere, near]))
        tried = np.repeat(u[None, :], tries * n, axis=0)
        rows = np.arange(tries * n).reshape(tries, n)
        tried[rows, np.arange(n)] = values
        outcome = _look(problem, best, tried)
        if best.found:
            return
        losses = outcome.loss.reshape(tries, n)
        gains, at = before - losses.min(axis=0), losses.argmin(axis=0)
        better = [int(k) for k in np.argsort(-gains, kind="stable") if gains[k] > _WORTH]
        if len(better) > 1:
            together = np.repeat(u[None, :], len(better) - 1, axis=0)
            for row, k in enumerate(better):
                together[max(row - 1, 0) :, k] = values[at[k], k]
            _look(problem, best, together)
        if best.found or best.loss > before - _WORTH:
            return


def _some_at_once(problem: Problem, best: Best, rng: np.random.Generator) -> None:
    """Change two, three or four variables of the best."""
    n, vain = len(best.x), 0
    for _ in range(SOME_ROUNDS):
        if best.found or vain >= _VAIN_ROUNDS:
            return
        before = best.loss
        u = problem.space.unit(best.x)
        order = rng.random((SOME_BATCH, n)).argsort(axis=1).argsort(axis=1)
        chosen = order < (2 + np.arange(SOME_BATCH) % 3)[:, None]
        near = u + _NEAR * (2.0 * rng.random((SOME_BATCH, n)) - 1.0)
        values = np.where(np.arange(SOME_BATCH)[:, None] % 2, near, rng.random((SOME_BATCH, n)))
        _look(problem, best, folded(np.where(chosen, values, u)))
        vain = 0 if best.loss < before - _WORTH else vain + 1


def _evolve(problem: Problem, best: Best, start: Floats, rng: np.random.Generator) -> None:
    """One run of CMA-ES, until something is found."""
    optimizer = CMA(
        mean=start,
        sigma=_SIGMA,
        population_size=max(16, 2 * (4 + int(3 * np.log(len(start))))),
        seed=int(rng.integers(2**31)),
        n_max_resampling=1,
    )
    vain, least = 0, np.inf
    for _ in range(GENERATIONS):
        asked = np.array([optimizer.ask() for _ in range(optimizer.population_size)])
        inside = np.clip(asked, 0.0, 1.0)
        outcome = _look(problem, best, inside)
        outside = np.sum((asked - inside) ** 2, axis=1)
        losses = outcome.loss + 10.0 * outside
        optimizer.tell(list(zip(asked, losses.tolist(), strict=True)))
        vain = 0 if losses.min() < least - _WORTH else vain + 1
        least = min(least, float(losses.min()))
        if best.found or vain >= _VAIN_GENERATIONS or optimizer.should_stop():
            return


def _come_back(problem: Problem, best: Best, origin: Floats) -> None:
    """Undo what was not needed: every variable alone, then all together, step by step."""
    for _ in range(_BACK_ROUNDS):
        x = np.array(list(_nearer(best.x, origin)))
        if not best.take(x, problem.evaluate(x)):
            return


def _nearer(x: Floats, origin: Floats) -> Iterator[Floats]:
    for share in np.linspace(0.15, 0.9, _BACK_STEPS):
        yield x + share * (origin - x)
    for n in np.flatnonzero(x != origin):
        for share in (1.0, 0.5):
            tried = x.copy()
            tried[n] += share * (origin[n] - tried[n])
            yield tried


def folded(u: Floats) -> Floats:
    """Points outside the unit cube reflected into it."""
    inside: Floats = 1.0 - np.abs(1.0 - np.mod(u, 2.0))
    return inside


def halton(count: int, shift: Floats) -> Floats:
    """Points of the Halton sequence, shifted (n,) around the unit cube (c, n).

    Higher dimensions than there are primes at hand use the shift alone to differ.
    """
    indices = np.arange(1, count + 1)
    columns = []
    for n in range(len(shift)):
        base = _PRIMES[n % len(_PRIMES)]
        left = indices * (1 + n // len(_PRIMES))
        value, share = np.zeros(count), 1.0
        while left.any():
            share /= base
            value += share * (left % base)
            left = left // base
        columns.append(value)
    points = np.array(columns).reshape(len(shift), count).T
    return np.mod(points + shift, 1.0)
