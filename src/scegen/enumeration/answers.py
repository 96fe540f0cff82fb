"""What the solver tells: atoms of answer sets, and assumptions about them, as clorm types."""

from __future__ import annotations

from scegen.enumeration.facts import WAYS, WORD, fact

Enters = fact("enters", "A vehicle enters at an arm.", id=WORD, arm=int)
Drive = fact(
    "drive",
    "A vehicle's entry, symbolic move and manner.",
    id=WORD,
    entry=int,
    move=int,
    manner=WORD,
)
Two = fact(
    "two",
    "The drives of two vehicles, each (entry, move, manner).",
    id=WORD,
    way=tuple[int, int, WORD],
    other=WORD,
    other_way=tuple[int, int, WORD],
)
GoesOnFoot = fact(
    "goes_on_foot",
    "The arm and the way of one who is not in the traffic.",
    id=WORD,
    arm=int,
    way=WORD,
)
Place = fact(
    "place",
    "A vehicle is ahead of, behind or beside another on the same arm.",
    id=WORD,
    reference=WORD,
    word=WORD,
)
Wanted = fact(
    "wanted",
    "What the words allow a vehicle that enters at `entry`.",
    id=WORD,
    entry=int,
    move=int,
    manner=WORD,
)
Needs = fact(
    "needs",
    "What a hazard demands of the one who causes it and the one who suffers it.",
    statement=int,
    by=WORD,
    to=WORD,
    what=WORD,
)
TurnsAcross = fact(
    "turns_across", "A hazard by which a vehicle turns left.", statement=int, id=WORD
)
Dependent = fact("dependent", "A vehicle whose move matters to others.", id=WORD)
Meets = fact(
    "meets",
    "How the ways `entry` -> `exit` and `other_entry` -> `other_exit` meet.",
    **WAYS,
    kind=WORD,
)
Holds = fact("holds", "A statement is kept.", statement=int)
