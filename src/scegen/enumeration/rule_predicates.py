"""Right of way for the solver: facts about signs, lights and views, and who gives way to whom."""

from __future__ import annotations

from scegen.enumeration.facts import fact

# --- facts ----------------------------------------------------------------------------------

Minor = fact("minor(arm: int)", "A yield or stop sign stands at an arm.")
Phase = fact("phase(arm: int, number: int)", "An arm has green in a phase.")
Oncoming = fact(
    "oncoming(arm: int, other: int)", "The traffic of two arms comes towards each other."
)
RightOf = fact(
    "right_of(arm: int, other: int)", "Who enters at `arm` has the traffic of `other` to its right."
)
EntryFirst = fact(
    "entry_first", "A roundabout where those who come in go before those on the ring."
)
Crosswalk = fact("crosswalk(arm: int)", "Who crosses this arm does so on a marked crosswalk.")
CurvesMeet = fact(
    "curves_meet(entry: int, exit: int, other_entry: int, other_exit: int)",
    "As drawn, two ways cross although their ends do not interleave.",
)

# --- answers --------------------------------------------------------------------------------

GivesWay = fact(
    "gives_way(entry: int, exit: int, other_entry: int, other_exit: int, rule: word)",
    "The driver on `entry` -> `exit` gives way to the other one.",
)
Open = fact(
    "open(entry: int, exit: int, other_entry: int, other_exit: int, rule: word)",
    "Of two drivers nobody can say in advance who gives way.",
)
LetsCross = fact(
    "lets_cross(entry: int, exit: int, arm: int, rule: word)",
    "A driver gives way to one who crosses an arm.",
)
WaitsToCross = fact(
    "waits_to_cross(entry: int, exit: int, arm: int, rule: word)",
    "One who crosses an arm gives way to a driver.",
)
OpenToCross = fact(
    "open_to_cross(entry: int, exit: int, arm: int, rule: word)",
    "Between a driver and one who crosses, the light decides.",
)
Stuck = fact("stuck(way: way)", "A way that a deadlock may hold up.")
