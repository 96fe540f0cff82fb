"""Numbers of ordinary and dangerous driving, each with its source.

Sources: [EDM] Treiber and Kesting, Traffic Flow Dynamics (2013), ch. 11: comfortable
acceleration 1-2 m/s2, comfortable braking 2-3 m/s2 (*); [ISO15622] ISO 15622:2018: time gaps of
adaptive cruise control from 0.8 s, decelerations beyond 3.5 m/s2 are not comfort (*); [AASHTO] A
Policy on Geometric Design: about nine in ten drivers brake harder than 3.4 m/s2 when something
surprises them; [2S] the two-second rule of driving schools; [UN152] UN R152: emergency braking of
at least 5 m/s2 (*); [UN157] UN R157: the delay of its
careful driver (*).
(*) quoted from memory: the text itself could not be consulted. Where no source is named, the
number is this program's own choice.
"""

COMFORTABLE_BRAKING_MPS2 = 2.5  # [EDM]
COMFORTABLE_ACCELERATION_MPS2 = 2.0  # [EDM]
HARD_BRAKING_MPS2 = (7.0, 8.0)  # well above [UN152], below the tyre's limit on dry road
LATE_BRAKING_MPS2 = 5.0  # between comfort and [UN152]: one who comes up behind another
STOPPING_MPS2 = 4.0  # above the 3.4 of [AASHTO]
SUDDEN_ACCELERATION_MPS2 = (3.0, 4.0)

LATERAL_MPS2 = 4.0
FAST_LATERAL_MPS2 = 6.0  # those who speed or turn suddenly
LANE_CHANGE_S = 3.0  # the short end of usual durations, 3-6 s
ABRUPT_LANE_CHANGE_S = 2.0

HEADWAY_S = 2.0  # [2S]
TAILGATING_HEADWAY_S = (0.4, 0.8)  # below the least gap of [ISO15622]
CLOSE_FOLLOWING_S = 0.8  # followed closely, but not tailgated
CUT_IN_HEADWAY_S = (0.3, 0.6)

REVERSING_MPS = (1.8, 2.6)  # 6 to 9 km/h
REVERSING_MPS2 = 1.5
REACTION_S = 0.75  # [UN157]: from a danger that can be seen to the brakes
CREEP_MPS = 0.5
"""Who is to stand at a place creeps the last bit."""

JITTER = 0.04  # relative spread of ordinary speeds

WALKING_START_MPS2 = 2.5

HOLDS_S = 1.5
"""Between two acts of one driver, where no time is said: long enough to see the speed held."""
STOPS_FOR_S = 1.5
"""At stop lines vehicles stand so long at least: clearly longer than ``rules.stopping`` asks."""

APPROACH_S = 6.023
"""The ego drives at least this long before it meets its first conflict partner."""
LEAD_IN_S = 1.023
"""Everybody drives at least this long before its first phase. No multiple of a time step, so that
no trigger falls on a step, where rounding would decide differently in every simulator."""
PASSING_LAG_S = 2.5
"""Where a text names dangers, those who have no part in them pass this much later."""
MAX_DURATION_S = 60.0
LONGEST_DURATION_S = 150.0
"""Where 60 s are not enough to leave: long ways at walking pace."""
