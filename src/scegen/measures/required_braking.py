"""Required against available deceleration: how hard one of a pair must brake to keep clear.

Definition: the least constant deceleration, from now on, with which the one who brakes
* stays behind its leader, who brakes on as it does now until it stands, or
* arrives at a conflict area only when the other, at its present speed, has left it; 0 if at
  present speeds the two are not in the area at the same time, or the one has entered it.
The larger of the two. The ratio to the available deceleration (brakes, friction) is the brake
threat number: above 1, braking alone no longer avoids.
Unit: m/s²; the ratio has none.
Direction: larger is worse.
Source: Brännström, Sjöberg, Coelingh, A situation and threat assessment algorithm for a rear-end
collision avoidance system, 2008 (leader, brake threat number); Hupfer, Deceleration to safety
time, 1997, with a safety time of 0 (conflict area).
Validity: no reaction time, no build-up of brake force. The one who has priority "requires"
braking as well: which of the pair ought to brake is for the reader to choose. inf once it cannot
be avoided by braking.
"""

from math import inf

import numpy as np

from scegen.motion.batch.arrays import SPEED, Floats, S
from scegen.motion.batch.kernels import inner_kernel, kernel


@inner_kernel
def behind_leader(gap_m: float, speed_mps: float, leader_mps: float, braking_mps2: float) -> float:
    """Deceleration needed to stay behind a leader, m/s²; ``braking_mps2`` >= 0 is the leader's."""
    if np.isnan(gap_m) or speed_mps <= 0.0:
        return 0.0
    closing = speed_mps - leader_mps
    if braking_mps2 > 0.0:
        room = gap_m + leader_mps * leader_mps / (2.0 * braking_mps2)
        to_stop = speed_mps * speed_mps / (2.0 * room) if room > 0.0 else inf
        if closing <= 0.0:
            return to_stop
        rate = braking_mps2 + closing * closing / (2.0 * gap_m) if gap_m > 0.0 else inf
        # Nearest while the leader still moves, or only when both stand.
        nearest = closing / (rate - braking_mps2) if rate > braking_mps2 else inf
        return rate if nearest * braking_mps2 < leader_mps else to_stop
    if closing <= 0.0:
        return 0.0
    return closing * closing / (2.0 * gap_m) if gap_m > 0.0 else inf


@inner_kernel
def before_area(
    ahead_m: float,
    speed_mps: float,
    length_m: float,
    other_ahead_m: float,
    other_mps: float,
    other_to_leave_m: float,
) -> float:
    """Deceleration needed to leave a conflict area to the other first, m/s².

    Args:
        ahead_m: from the present position to that of entry, m; negative once inside.
        speed_mps: own speed.
        length_m: from the position of entry to that of exit, m.
        other_ahead_m: the same as ``ahead_m`` for the other.
        other_mps: the other's speed.
        other_to_leave_m: from the other's present position to that of its exit, m; may be inf.
    """
    if ahead_m < 0.0 or speed_mps <= 0.0 or other_to_leave_m <= 0.0:
        return 0.0
    if other_mps <= 0.0:
        return speed_mps * speed_mps / (2.0 * ahead_m) if other_ahead_m <= 0.0 else 0.0
    # The other has left before; the other comes after (cross-multiplied: no divisions).
    if other_to_leave_m * speed_mps <= ahead_m * other_mps:
        return 0.0
    if other_ahead_m * speed_mps >= (ahead_m + length_m) * other_mps:
        return 0.0
    until = other_to_leave_m / other_mps
    to_stop = speed_mps * speed_mps / (2.0 * ahead_m) if ahead_m > 0.0 else inf
    if until * speed_mps >= 2.0 * ahead_m:  # it would stand before the other has left
        return to_stop
    return 2.0 * (speed_mps * until - ahead_m) / (until * until)


@kernel
def highest_behind_leader(
    follower: Floats, leader: Floats, gaps: Floats, dt_s: float, last: int
) -> float:
    """Highest deceleration needed behind a leader over the steps 0 to ``last``, m/s²."""
    worst = 0.0
    for t in range(last + 1):
        if gaps[t] >= 0.0:
            worst = max(worst, _behind_at(follower, leader, gaps[t], dt_s, t))
    return worst


@inner_kernel
def _behind_at(follower: Floats, leader: Floats, gap_m: float, dt_s: float, t: int) -> float:
    """Deceleration needed behind a leader at step t, m/s²."""
    braking = 0.0
    if t > 0 and leader[SPEED, t] >= 0.0:  # one that reverses is taken to keep its speed
        braking = (leader[SPEED, t - 1] - leader[SPEED, t]) / dt_s
    return behind_leader(gap_m, follower[SPEED, t], leader[SPEED, t], max(braking, 0.0))


@kernel
def highest_before_area(
    own: Floats, other: Floats, enter_m: Floats, leave_m: Floats, way: int, last: int
) -> float:
    """Highest deceleration needed before one conflict area over the steps 0 to ``last``, m/s².

    The positions are those of the area, (2,); ``way`` says which of the two is the own one.
    """
    worst = 0.0
    enter, leave = enter_m[way], leave_m[way]
    other_enter, other_leave = enter_m[1 - way], leave_m[1 - way]
    for t in range(last + 1):
        if own[S, t] > enter or other[S, t] >= other_leave:
            break  # positions never fall: from here on nothing is needed
        worst = max(
            worst,
            before_area(
                enter - own[S, t],
                abs(own[SPEED, t]),
                leave - enter,
                other_enter - other[S, t],
                abs(other[SPEED, t]),
                other_leave - other[S, t],
            ),
        )
    return worst
