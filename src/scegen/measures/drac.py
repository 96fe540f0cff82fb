"""Deceleration rate to avoid a crash (DRAC): braking that just avoids hitting the leader.

Definition: (speed of the follower - speed of the leader)² / (2 gap) while closing in, else 0.
Unit: m/s².
Direction: larger is worse; 3.4 m/s² is the usual threshold, 6 m/s² that of emergency braking.
Source: Cooper, Ferguson, 1976; threshold: AASHTO, A policy on geometric design, 2004.
Validity: undefined (nan) without a leader in the corridor. The leader is taken to keep its speed;
``required_braking`` also sees its braking. inf with no gap left.
"""

from math import nan

import numpy as np

from scegen.motion.batch.arrays import SPEED, Floats
from scegen.motion.batch.kernels import inner_kernel, kernel


@inner_kernel
def deceleration_to_avoid(gap_m: float, follower_mps: float, leader_mps: float) -> float:
    """DRAC of a follower, m/s²."""
    if np.isnan(gap_m):
        return nan
    closing = follower_mps - leader_mps
    return closing * closing / (2.0 * gap_m) if closing > 0.0 else 0.0


@kernel
def highest_drac(follower: Floats, leader: Floats, gaps: Floats, last: int) -> float:
    """Highest DRAC over the steps 0 to ``last``, m/s²; ``gaps`` (steps,) to the leader, m."""
    worst = -1.0
    for t in range(last + 1):
        drac = deceleration_to_avoid(gaps[t], follower[SPEED, t], leader[SPEED, t])
        if drac > worst:  # noqa: PLR1730 -- never true of the undefined
            worst = drac
    return worst if worst >= 0.0 else nan
