"""Car following: how one in a lane answers the braking and going on of whoever is ahead of it.

Sources: [Gipps] P. G. Gipps, A behavioural car-following model for computer simulation,
Transportation Research Part B 15 (1981) 105-111: a reaction time after the one ahead has begun,
a driver brakes so that it comes to stand behind it. [Newell] G. F. Newell, A simplified
car-following theory: a lower order model, Part B 36 (2002) 195-205: whose time gap is its reaction
time does what the one ahead did, that much later and farther back. [Green] M. Green, How long does
it take to stop?, Transportation Human Factors 2 (2000) 195-216: about 1.25 s to the brakes where
the brake lights ahead come unexpectedly, 0.75 s where they are expected. [EDM] Treiber and Kesting,
Traffic Flow Dynamics (2013): 2 m between those who stand, braking of up to 2 m/s2 as long as that
does (*). (*) all quoted from memory: the texts themselves could not be consulted.

Whoever is ahead changes its speed at a steady rate. Then a steady rate, begun once, keeps the time
gap, so that Gipps's driver is exactly one phase of a speed program for every change ahead of it,
and needs no integration: simulators and players carry out the same.
"""

from dataclasses import dataclass

import numpy as np

STANDS_BEHIND_M = 2.0
"""The free length between two who stand: [EDM]."""
SOFTEST_MPS2 = 1.5
"""Who can do with less than this brakes later instead."""
REACTIONS_S = (0.75, 1.25)
"""[Green]."""
TIME_GAPS_S = (1.4, 2.2)
"""About the two seconds of driving schools."""
_SAME_MPS = 0.3
_GAINS_MPS2 = 2.0


@dataclass(frozen=True, slots=True)
class Driver:
    """How soon somebody brakes for brake lights, and the time gap that it likes to keep."""

    reaction_s: float
    time_gap_s: float


@dataclass(frozen=True, slots=True)
class Change:
    """From ``begins_s`` on the speed goes over to ``to_mps`` at ``rate_mps2``."""

    begins_s: float
    to_mps: float
    rate_mps2: float


def driver_of(seed: int, number: int) -> Driver:
    """The driver of the vehicle of this number: no two alike, the same each time."""
    rng = np.random.Generator(np.random.PCG64([seed, number]))
    reaction, gap = rng.uniform(*REACTIONS_S), rng.uniform(*TIME_GAPS_S)
    return Driver(round(float(reaction), 2), round(float(gap), 2))


def brakes(
    driver: Driver, speed_mps: float, gap_m: float, ahead_mps: float, ahead: Change
) -> Change | None:
    """How one answers the braking of another that has driven as fast; None if it comes too late.

    Both brake from the speed v to u, the one ahead at the rate b from time 0 on. The free length s
    is to be STANDS_BEHIND_M + T u in the end, with the time gap T = (s - STANDS_BEHIND_M) / v that
    it has had. What is lost until then is (v - u) (t + (v - u) / 2 r - (v - u) / 2 b) for braking
    begun after t at the rate r; it has to be T (v - u).

    Args:
        driver: who drives.
        speed_mps: how fast.
        gap_m: the free length to the one ahead when that begins to brake.
        ahead_mps: how fast that one is then.
        ahead: what it does.
    """
    change = speed_mps - ahead.to_mps
    if abs(speed_mps - ahead_mps) > _SAME_MPS or change <= _SAME_MPS:
        return None
    keeps_s = (gap_m - STANDS_BEHIND_M) / speed_mps
    if keeps_s < driver.reaction_s:
        return None
    lasts_s = 2 * (keeps_s - driver.reaction_s) + change / ahead.rate_mps2
    after_s, rate = driver.reaction_s, change / lasts_s
    softest = min(SOFTEST_MPS2, ahead.rate_mps2)
    if rate < softest:
        rate = softest
        after_s = keeps_s - (change / rate - change / ahead.rate_mps2) / 2
    return Change(ahead.begins_s + after_s, ahead.to_mps, rate)


def goes_on(driver: Driver, speed_mps: float, ahead: Change) -> Change:
    """How one that has slowed down for another goes on with it, up to its own speed."""
    rate = min(ahead.rate_mps2, _GAINS_MPS2)
    return Change(ahead.begins_s + driver.reaction_s, min(speed_mps, ahead.to_mps), rate)
