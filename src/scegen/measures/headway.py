"""Time headway: how long until the follower's front is where the leader's rear is now.

Definition: gap along the follower's path / speed of the follower.
Unit: s.
Direction: smaller is worse; below 1 s is tailgating in most codes, 2 s the usual advice.
Source: ISO 34502 and Westhofen et al., Criticality metrics for automated driving, 2022 (there
with the distance between reference points; here the clear gap, as UNECE R157 uses it).
Validity: undefined (nan) without a leader in the corridor and below 0.1 m/s. Says nothing about
the leader's speed.
"""

from math import inf, nan

from scegen.motion.batch.arrays import SPEED, Floats
from scegen.motion.batch.kernels import inner_kernel, kernel

CREEP_MPS = 0.1
"""Below this speed a follower counts as standing."""
_ROUGHLY = 1.0 + 1e-9
"""What is longer by more is not worth a division."""


@inner_kernel
def time_headway(gap_m: float, speed_mps: float) -> float:
    """Headway of a follower, s."""
    return gap_m / speed_mps if speed_mps >= CREEP_MPS else nan


@kernel
def least_headway(follower: Floats, gaps: Floats, last: int) -> float:
    """Smallest headway over the steps 0 to ``last``, s; ``gaps`` (steps,) to the leader, m."""
    best = inf
    for t in range(last + 1):
        if gaps[t] <= _ROUGHLY * best * follower[SPEED, t]:
            headway = time_headway(gaps[t], follower[SPEED, t])
            if headway < best:  # noqa: PLR1730 -- never true of the undefined
                best = headway
    return best if best < inf else nan
