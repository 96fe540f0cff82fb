"""What the solver is told: facts about the junction, the words, and symmetry, as clorm types."""

from scegen.enumeration.facts import fact

# --- the junction -------------------------------------------------------------------------

Arms = fact("arms(number: int)", "The junction has the arms 0..number-1.")
Turn = fact(
    "turn(entry: int, move: int, word: word)",
    "Who enters at `entry` and makes `move` turns `word`.",
)
Straightest = fact("straightest(entry: int, move: int)", "The move that bends least.")
Sees = fact(
    "sees(reference: int, other: int, word: word)",
    "Who enters at `reference` says that one entering at `other` comes from `word`.",
)
Lanes = fact(
    "lanes(arm: int, number: int)",
    "Lanes of an arm in the entering direction, where the text gives them.",
)
Ring = fact("ring", "The junction is a roundabout.")
LeftHand = fact("left_hand", "Traffic keeps left.")

# --- right of way: signs, lights and views ---------------------------------------------

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

# --- who takes part -----------------------------------------------------------------------

Vehicle = fact("vehicle(id: word)", "One who enters and leaves the junction.")
Crosser = fact("crosser(id: word)", "One who crosses an arm.")
OnStrip = fact("on_strip(id: word)", "A vehicle on a strip beside the lanes at first.")
SquareToRoad = fact(
    "square_to_road(id: word)",
    "A vehicle that goes straight back, square to the road, if it backs out.",
)
Ego = fact("ego(id: word)", "The vehicle under test.")
Kind = fact("kind(id: word, word: word)", "What a participant is; for users' rules.")
VehicleCount = fact("vehicle_count(number: int)", "Number of vehicles.")
Position = fact(
    "position(id: word, number: int)",
    "Place of a participant in the listing order, from 1; vehicles come first.",
)
Decides = fact(
    "decides(id: word)", "The move of this vehicle is chosen by the solver, not counted outside."
)

# --- statements: numbered, so that a contradiction can be told in words ----------------------

Statement = fact("statement(number: int)", "Number of something that the functional scenario says.")
Entries = fact("entries(statement: int, id: word)", "A statement limits the arms of a participant.")
Entry = fact("entry(id: word, arm: int)", "An arm that is allowed.")
Maneuvers = fact("maneuvers(statement: int, id: word)", "A statement limits what a vehicle does.")
Wants = fact("wants(id: word, word: word)", "A word that is allowed.")
WantsMove = fact("wants_move(id: word, move: int)", "A symbolic move that is allowed.")
Approach = fact(
    "approach(statement: int, id: word, reference: word)",
    "A statement says where a participant comes from, seen from a reference.",
)
Says = fact(
    "says(id: word, reference: word, word: word)", "A word that is allowed for where it comes from."
)
Hazard = fact("hazard(statement: int, kind: word)", "A hazard.")
By = fact("by(statement: int, id: word)", "Who causes it.")
To = fact("to(statement: int, id: word)", "Who suffers it.")
Row = fact(
    "row(kind: word, case: int, what: word)",
    "A hazard of a kind needs something of the ways of both, in a case of scenario.hazards.",
)
LeavesLane = fact("leaves_lane(kind: word)", "Who causes a hazard of this kind leaves its lane.")
MustMeet = fact(
    "must_meet(statement: int)",
    "A hazard that needs nothing by its kind: the ways of the two that are named meet.",
)
OwesWay = fact(
    "owes_way(statement: int)",
    "Who causes this hazard does not have right of way before who suffers it.",
)
GoesFirst = fact(
    "goes_first(entry: int, exit: int, other_entry: int, other_exit: int)",
    "Who drives `entry` -> `exit` goes before the other one, by the rules of the junction.",
)
Outcome = fact("outcome(statement: int)", "A statement says how it ends.")
MayMeet = fact(
    "may_meet(statement: int, id: word, other: word)",
    "Between these two an outcome may come about, a vehicle first.",
)
ComesBeside = fact(
    "comes_beside(statement: int, id: word, reference: word)",
    "Who comes into another's lane starts beside it, where both enter by one arm.",
)
ComesInto = fact(
    "comes_into(statement: int, id: word, reference: word)",
    "Somebody comes into another's lane from beside it.",
)
Changes = fact("changes(id: word)", "Somebody changes lane, by an act.")
Goes = fact("goes(id: word, side: word)", "The side to which somebody changes lane.")
InLanes = fact(
    "in_lanes(statement: int, id: word)", "A statement says in which lanes somebody may be."
)
Lane = fact(
    "lane(id: word, number: int)", "A lane in which somebody may be, counted from the centre line."
)
SomeOf = fact(
    "some_of(statement: int, group: int, number: int, members: int)",
    "A statement says how many of a group do something.",
)
InGroup = fact("in_group(group: int, id: word)", "Somebody is one of a group.")
GroupWay = fact(
    "group_way(group: int, entry: int, move: int, manner: word)",
    "Of who does this, it counts as what the group says.",
)
OnFoot = fact(
    "on_foot(id: word, way: word)", "A way that the words allow one who is not in the traffic."
)
Over = fact("crossing(way: word, side: word)", "A way over an arm, from a side.")
Along = fact(
    "along(way: word, side: word, lane: word, heading: word)",
    "A way along an arm: on which side, in a lane or at the edge, headed inward or outward.",
)
Nth = fact("nth(way: word, number: int)", "Ways on foot in the order of the listing.")
DefaultPlace = fact(
    "default_place(statement: int, id: word)",
    "Nothing else being said, a crosser crosses where the ego drives.",
)
SaysArm = fact(
    "says_arm(statement: int, id: word, which: word)",
    "A statement says which arm a crosser crosses: the `entry` or `exit` of whom it meets.",
)
QueueLimit = fact(
    "queue_limit(statement: int, vehicles: int)", "So many vehicles fit on one approach road."
)

# --- symmetry -------------------------------------------------------------------------------

Member = fact(
    "member(id: word, group: int)", "A vehicle belongs to a group of interchangeable ones."
)
Size = fact("size(group: int, number: int)", "Members of a group.")
Next = fact(
    "next(first: word, second: word)", "Two members of a group, the second right after the first."
)
OpenPlace = fact(
    "open_place(id: word, reference: word)",
    "On one arm with its reference, a vehicle has more than one place to choose from.",
)
Trades = fact(
    "trades(first: word, second: word)",
    "Two vehicles that may trade their moves without changing a pattern.",
)
Rotation = fact(
    "rotation(arms: int)",
    "Turning the junction by so many arms maps it and its facts onto themselves.",
)
Anchor = fact(
    "anchor(id: word)", "One of a kind: it turns along, so it shows how far the junction is turned."
)
Cell = fact(
    "cell(number: int, group: int, entry: int, move: int, manner: word)",
    "A choice that members of a group may make, numbered.",
)
Turned = fact(
    "turned(arms: int, before: int, after: int)",
    "Turning by `arms` carries what stands in cell `before` to cell `after`.",
)
