"""Post-encroachment time (PET): how long after the first has left does the second enter.

Definition: time of entry of the second minus time of exit of the first, over a conflict area of
``scegen.measures.conflict_areas``; where paths merge, the gap at the merge point (front of the
second minus rear of the first). Negative: the second entered before the first had left. A pair
with several areas has the smallest of their values.
Unit: s.
Direction: smaller is worse; critical below 1 s (1.5 s), more than 2 s is normal.
Source: Allen, Shin, Cooper, Analysis of traffic conflicts and collisions, 1978.
Validity: undefined (nan) where the paths share no area, one of the pair starts beyond it, one
never enters, or the first never leaves. Times are interpolated within steps, which is exact,
because speed is constant within a step.
"""

from math import nan

from scegen.motion.batch.arrays import Floats, S
from scegen.motion.batch.kernels import kernel


@kernel
def time_of_reaching(track: Floats, s_m: float, dt_s: float) -> float:
    """When a participant reaches position ``s_m`` on its path, s; 0 if it starts there or beyond.

    nan if it does not get there.
    """
    low, high = 0, track.shape[1] - 1
    if track[S, 0] >= s_m:
        return 0.0
    if not track[S, high] >= s_m:
        return nan
    while high - low > 1:  # positions never fall
        middle = (low + high) // 2
        if track[S, middle] >= s_m:
            high = middle
        else:
            low = middle
    share = (s_m - track[S, low]) / (track[S, high] - track[S, low])
    return float((low + share) * dt_s)


@kernel
def post_encroachment_time(
    a: Floats, b: Floats, enter_m: Floats, leave_m: Floats, dt_s: float
) -> float:
    """PET of two tracks at one area, s; positions (2,): of a and of b."""
    if a[S, 0] >= leave_m[0] or b[S, 0] >= leave_m[1]:
        return nan
    a_in = time_of_reaching(a, enter_m[0], dt_s)
    b_in = time_of_reaching(b, enter_m[1], dt_s)
    if a_in <= b_in:
        return b_in - time_of_reaching(a, leave_m[0], dt_s)
    return a_in - time_of_reaching(b, leave_m[1], dt_s)
