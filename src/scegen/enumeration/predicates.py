"""What the solver is told: facts about the junction, the words, and symmetry, as clorm types."""

from __future__ import annotations

from scegen.enumeration.facts import WAYS, WORD, fact

# --- the junction -------------------------------------------------------------------------

Arms = fact("arms", "The junction has the arms 0..number-1.", number=int)
Turn = fact(
    "turn", "Who enters at `entry` and makes `move` turns `word`.", entry=int, move=int, word=WORD
)
Straightest = fact("straightest", "The move that bends least.", entry=int, move=int)
Sees = fact(
    "sees",
    "Who enters at `reference` says that one entering at `other` comes from `word`.",
    reference=int,
    other=int,
    word=WORD,
)
Lanes = fact(
    "lanes",
    "Lanes of an arm in the entering direction, where the text gives them.",
    arm=int,
    number=int,
)
Ring = fact("ring", "The junction is a roundabout.")
LeftHand = fact("left_hand", "Traffic keeps left.")

# --- who takes part -----------------------------------------------------------------------

Vehicle = fact("vehicle", "One who enters and leaves the junction.", id=WORD)
Crosser = fact("crosser", "One who crosses an arm.", id=WORD)
OnStrip = fact("on_strip", "A vehicle on a strip beside the lanes at first.", id=WORD)
SquareToRoad = fact(
    "square_to_road",
    "A vehicle that goes straight back, square to the road, if it backs out.",
    id=WORD,
)
Ego = fact("ego", "The vehicle under test.", id=WORD)
Kind = fact("kind", "What a participant is; for users' rules.", id=WORD, word=WORD)
VehicleCount = fact("vehicle_count", "Number of vehicles.", number=int)
Position = fact(
    "position",
    "Place of a participant in the listing order, from 1; vehicles come first.",
    id=WORD,
    number=int,
)
Decides = fact(
    "decides", "The move of this vehicle is chosen by the solver, not counted outside.", id=WORD
)

# --- statements: numbered, so that a contradiction can be told in words ----------------------

Statement = fact("statement", "Number of something that the functional scenario says.", number=int)
Entries = fact("entries", "A statement limits the arms of a participant.", statement=int, id=WORD)
Entry = fact("entry", "An arm that is allowed.", id=WORD, arm=int)
Maneuvers = fact("maneuvers", "A statement limits what a vehicle does.", statement=int, id=WORD)
Wants = fact("wants", "A word that is allowed.", id=WORD, word=WORD)
WantsMove = fact("wants_move", "A symbolic move that is allowed.", id=WORD, move=int)
Approach = fact(
    "approach",
    "A statement says where a participant comes from, seen from a reference.",
    statement=int,
    id=WORD,
    reference=WORD,
)
Says = fact(
    "says", "A word that is allowed for where it comes from.", id=WORD, reference=WORD, word=WORD
)
Hazard = fact("hazard", "A hazard.", statement=int, kind=WORD)
By = fact("by", "Who causes it.", statement=int, id=WORD)
To = fact("to", "Who suffers it.", statement=int, id=WORD)
Row = fact(
    "row",
    "A hazard of a kind needs something of the ways of both, in a case of scenario.hazards.",
    kind=WORD,
    case=int,
    what=WORD,
)
LeavesLane = fact("leaves_lane", "Who causes a hazard of this kind leaves its lane.", kind=WORD)
MustMeet = fact(
    "must_meet",
    "A hazard that needs nothing by its kind: the ways of the two that are named meet.",
    statement=int,
)
OwesWay = fact(
    "owes_way",
    "Who causes this hazard does not have right of way before who suffers it.",
    statement=int,
)
GoesFirst = fact(
    "goes_first",
    "Who drives `entry` -> `exit` goes before the other one, by the rules of the junction.",
    **WAYS,
)
Outcome = fact("outcome", "A statement says how it ends.", statement=int)
MayMeet = fact(
    "may_meet",
    "Between these two an outcome may come about, a vehicle first.",
    statement=int,
    id=WORD,
    other=WORD,
)
ComesBeside = fact(
    "comes_beside",
    "Who comes into another's lane starts beside it, where both enter by one arm.",
    statement=int,
    id=WORD,
    reference=WORD,
)
ComesInto = fact(
    "comes_into",
    "Somebody comes into another's lane from beside it.",
    statement=int,
    id=WORD,
    reference=WORD,
)
Changes = fact("changes", "Somebody changes lane, by an act.", id=WORD)
Goes = fact("goes", "The side to which somebody changes lane.", id=WORD, side=WORD)
InLanes = fact(
    "in_lanes", "A statement says in which lanes somebody may be.", statement=int, id=WORD
)
Lane = fact(
    "lane", "A lane in which somebody may be, counted from the centre line.", id=WORD, number=int
)
SomeOf = fact(
    "some_of",
    "A statement says how many of a group do something.",
    statement=int,
    group=int,
    number=int,
    members=int,
)
InGroup = fact("in_group", "Somebody is one of a group.", group=int, id=WORD)
GroupWay = fact(
    "group_way",
    "Of who does this, it counts as what the group says.",
    group=int,
    entry=int,
    move=int,
    manner=WORD,
)
OnFoot = fact(
    "on_foot", "A way that the words allow one who is not in the traffic.", id=WORD, way=WORD
)
Over = fact("crossing", "A way over an arm, from a side.", way=WORD, side=WORD)
Along = fact(
    "along",
    "A way along an arm: on which side, in a lane or at the edge, headed inward or outward.",
    way=WORD,
    side=WORD,
    lane=WORD,
    heading=WORD,
)
Nth = fact("nth", "Ways on foot in the order of the listing.", way=WORD, number=int)
DefaultPlace = fact(
    "default_place",
    "Nothing else being said, a crosser crosses where the ego drives.",
    statement=int,
    id=WORD,
)
SaysArm = fact(
    "says_arm",
    "A statement says which arm a crosser crosses: the `entry` or `exit` of whom it meets.",
    statement=int,
    id=WORD,
    which=WORD,
)
QueueLimit = fact(
    "queue_limit", "So many vehicles fit on one approach road.", statement=int, vehicles=int
)

# --- symmetry -------------------------------------------------------------------------------

Member = fact("member", "A vehicle belongs to a group of interchangeable ones.", id=WORD, group=int)
Size = fact("size", "Members of a group.", group=int, number=int)
Next = fact(
    "next", "Two members of a group, the second right after the first.", first=WORD, second=WORD
)
OpenPlace = fact(
    "open_place",
    "On one arm with its reference, a vehicle has more than one place to choose from.",
    id=WORD,
    reference=WORD,
)
Trades = fact(
    "trades",
    "Two vehicles that may trade their moves without changing a pattern.",
    first=WORD,
    second=WORD,
)
Rotation = fact(
    "rotation",
    "Turning the junction by so many arms maps it and its facts onto themselves.",
    arms=int,
)
Anchor = fact(
    "anchor", "One of a kind: it turns along, so it shows how far the junction is turned.", id=WORD
)
Cell = fact(
    "cell",
    "A choice that members of a group may make, numbered.",
    number=int,
    group=int,
    entry=int,
    move=int,
    manner=WORD,
)
Turned = fact(
    "turned",
    "Turning by `arms` carries what stands in cell `before` to cell `after`.",
    arms=int,
    before=int,
    after=int,
)

# --- reading ------------------------------------------------------------------------------

Pair = fact("pair", "Two vehicles whose drives are shown as one atom.", first=WORD, second=WORD)
