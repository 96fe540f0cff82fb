"""Right of way for the solver: facts about signs, lights and views, and who gives way to whom."""

from __future__ import annotations

from scegen.enumeration.facts import WAYS, WORD, fact

# --- facts ----------------------------------------------------------------------------------

Minor = fact("minor", "A yield or stop sign stands at an arm.", arm=int)
Phase = fact("phase", "An arm has green in a phase.", arm=int, number=int)
Oncoming = fact("oncoming", "The traffic of two arms comes towards each other.", arm=int, other=int)
RightOf = fact(
    "right_of", "Who enters at `arm` has the traffic of `other` to its right.", arm=int, other=int
)
EntryFirst = fact(
    "entry_first", "A roundabout where those who come in go before those on the ring."
)
Crosswalk = fact("crosswalk", "Who crosses this arm does so on a marked crosswalk.", arm=int)
CurvesMeet = fact(
    "curves_meet", "As drawn, two ways cross although their ends do not interleave.", **WAYS
)

# --- answers --------------------------------------------------------------------------------

GivesWay = fact(
    "gives_way", "The driver on `entry` -> `exit` gives way to the other one.", **WAYS, rule=WORD
)
Open = fact("open", "Of two drivers nobody can say in advance who gives way.", **WAYS, rule=WORD)
LetsCross = fact(
    "lets_cross",
    "A driver gives way to one who crosses an arm.",
    entry=int,
    exit=int,
    arm=int,
    rule=WORD,
)
WaitsToCross = fact(
    "waits_to_cross",
    "One who crosses an arm gives way to a driver.",
    entry=int,
    exit=int,
    arm=int,
    rule=WORD,
)
OpenToCross = fact(
    "open_to_cross",
    "Between a driver and one who crosses, the light decides.",
    entry=int,
    exit=int,
    arm=int,
    rule=WORD,
)
Stuck = fact("stuck", "A way that a deadlock may hold up.", way=tuple[int, int])
