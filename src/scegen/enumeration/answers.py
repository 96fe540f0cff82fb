"""What the solver tells: atoms of answer sets, and assumptions about them, as clorm types."""

from scegen.enumeration.facts import fact

Enters = fact("enters(id: word, arm: int)", "A vehicle enters at an arm.")
Drive = fact(
    "drive(id: word, entry: int, move: int, manner: word)",
    "A vehicle's entry, symbolic move and manner.",
)
GoesOnFoot = fact(
    "goes_on_foot(id: word, arm: int, way: word)",
    "The arm and the way of one who is not in the traffic.",
)
Place = fact(
    "place(id: word, reference: word, word: word)",
    "A vehicle is ahead of, behind or beside another on the same arm.",
)
Wanted = fact(
    "wanted(id: word, entry: int, move: int, manner: word)",
    "What the words allow a vehicle that enters at `entry`.",
)
Needs = fact(
    "needs(statement: int, by: word, to: word, what: word)",
    "What a hazard demands of the one who causes it and the one who suffers it.",
)
Dependent = fact("dependent(id: word)", "A vehicle whose move matters to others.")
Meets = fact(
    "meets(entry: int, exit: int, other_entry: int, other_exit: int, kind: word)",
    "How the ways `entry` -> `exit` and `other_entry` -> `other_exit` meet.",
)
Holds = fact("holds(statement: int)", "A statement is kept.")
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
