"""What the solver is told: facts about the junction, the words, and symmetry, as clorm types.

A type's name in lower case is its predicate: ``Arms(3)`` is ``arms(3)``.
"""

# mypy does not follow clorm: it knows neither the base class nor its argument ``name``.
# mypy: allow-subclassing-any, disable-error-code=call-arg

from __future__ import annotations

from clorm import ConstantStr, Predicate

# --- the junction -------------------------------------------------------------------------


class Arms(Predicate):
    """The junction has the arms 0..number-1."""

    number: int


class Turn(Predicate):
    """Who enters at ``entry`` and makes ``move`` turns ``word``."""

    entry: int
    move: int
    word: ConstantStr


class Straightest(Predicate):
    """The move that bends least."""

    entry: int
    move: int


class Sees(Predicate):
    """Who enters at ``reference`` says that one entering at ``other`` comes from ``word``."""

    reference: int
    other: int
    word: ConstantStr


class Lanes(Predicate):
    """Lanes of an arm in the entering direction, where the text gives them."""

    arm: int
    number: int


class Ring(Predicate):
    """The junction is a roundabout."""


class LeftHand(Predicate, name="left_hand"):
    """Traffic keeps left."""


# --- who takes part -----------------------------------------------------------------------


class Vehicle(Predicate):
    """One who enters and leaves the junction."""

    id: ConstantStr


class Crosser(Predicate):
    """One who crosses an arm."""

    id: ConstantStr


class OnStrip(Predicate):
    """A vehicle on a strip beside the lanes at first."""

    id: ConstantStr


class SquareToRoad(Predicate, name="square_to_road"):
    """A vehicle that goes straight back, square to the road, if it backs out."""

    id: ConstantStr


class Ego(Predicate):
    """The vehicle under test."""

    id: ConstantStr


class Kind(Predicate):
    """What a participant is; for users' rules."""

    id: ConstantStr
    word: ConstantStr


class VehicleCount(Predicate, name="vehicle_count"):
    """Number of vehicles."""

    number: int


class Position(Predicate):
    """Place of a participant in the listing order, from 1; vehicles come first."""

    id: ConstantStr
    number: int


class Decides(Predicate):
    """The move of this vehicle is chosen by the solver, not counted outside."""

    id: ConstantStr


# --- statements: numbered, so that a contradiction can be told in words ----------------------


class Statement(Predicate):
    """Number of something that the functional scenario says."""

    number: int


class Entries(Predicate):
    """A statement limits the arms of a participant."""

    statement: int
    id: ConstantStr


class Entry(Predicate):
    """An arm that is allowed."""

    id: ConstantStr
    arm: int


class Maneuvers(Predicate):
    """A statement limits what a vehicle does."""

    statement: int
    id: ConstantStr


class Wants(Predicate):
    """A word that is allowed."""

    id: ConstantStr
    word: ConstantStr


class WantsMove(Predicate, name="wants_move"):
    """A symbolic move that is allowed."""

    id: ConstantStr
    move: int


class Approach(Predicate):
    """A statement says where a participant comes from, seen from a reference."""

    statement: int
    id: ConstantStr
    reference: ConstantStr


class Says(Predicate):
    """A word that is allowed for where it comes from."""

    id: ConstantStr
    reference: ConstantStr
    word: ConstantStr


class Hazard(Predicate):
    """A hazard."""

    statement: int
    kind: ConstantStr


class By(Predicate):
    """Who causes it."""

    statement: int
    id: ConstantStr


class To(Predicate):
    """Who suffers it."""

    statement: int
    id: ConstantStr


class Row(Predicate):
    """A hazard of a kind needs something of the ways of both, in a case of scenario.hazards."""

    kind: ConstantStr
    case: int
    what: ConstantStr


class LeavesLane(Predicate, name="leaves_lane"):
    """Who causes a hazard of this kind leaves its lane."""

    kind: ConstantStr


class MustMeet(Predicate, name="must_meet"):
    """A hazard that needs nothing by its kind: the ways of the two that are named meet."""

    statement: int


class OwesWay(Predicate, name="owes_way"):
    """Who causes this hazard does not have right of way before who suffers it."""

    statement: int


class GoesFirst(Predicate, name="goes_first"):
    """Who drives ``entry`` -> ``exit`` goes before the other one, by the rules of the junction."""

    entry: int
    exit: int
    other_entry: int
    other_exit: int


class Outcome(Predicate):
    """A statement says how it ends."""

    statement: int


class MayMeet(Predicate, name="may_meet"):
    """Between these two an outcome may come about, a vehicle first."""

    statement: int
    id: ConstantStr
    other: ConstantStr


class ComesBeside(Predicate, name="comes_beside"):
    """Who comes into another's lane starts beside it, where both enter by one arm."""

    statement: int
    id: ConstantStr
    reference: ConstantStr


class ComesInto(Predicate, name="comes_into"):
    """Somebody comes into another's lane from beside it."""

    statement: int
    id: ConstantStr
    reference: ConstantStr


class Changes(Predicate):
    """Somebody changes lane, by an act."""

    id: ConstantStr


class Goes(Predicate):
    """The side to which somebody changes lane."""

    id: ConstantStr
    side: ConstantStr


class InLanes(Predicate, name="in_lanes"):
    """A statement says in which lanes somebody may be."""

    statement: int
    id: ConstantStr


class Lane(Predicate):
    """A lane in which somebody may be, counted from the centre line."""

    id: ConstantStr
    number: int


class SomeOf(Predicate, name="some_of"):
    """A statement says how many of a group do something."""

    statement: int
    group: int
    number: int
    members: int


class InGroup(Predicate, name="in_group"):
    """Somebody is one of a group."""

    group: int
    id: ConstantStr


class GroupWay(Predicate, name="group_way"):
    """Of who does this, it counts as what the group says."""

    group: int
    entry: int
    move: int
    manner: ConstantStr


class OnFoot(Predicate, name="on_foot"):
    """A way that the words allow one who is not in the traffic."""

    id: ConstantStr
    way: ConstantStr


class Over(Predicate, name="crossing"):
    """A way over an arm, from a side."""

    way: ConstantStr
    side: ConstantStr


class Along(Predicate):
    """A way along an arm: on which side, in a lane or at the edge, headed inward or outward."""

    way: ConstantStr
    side: ConstantStr
    lane: ConstantStr
    heading: ConstantStr


class Nth(Predicate):
    """Ways on foot in the order of the listing."""

    way: ConstantStr
    number: int


class DefaultPlace(Predicate, name="default_place"):
    """Nothing else being said, a crosser crosses where the ego drives."""

    statement: int
    id: ConstantStr


class SaysArm(Predicate, name="says_arm"):
    """A statement says which arm a crosser crosses: the ``entry`` or ``exit`` of whom it meets."""

    statement: int
    id: ConstantStr
    which: ConstantStr


class QueueLimit(Predicate, name="queue_limit"):
    """So many vehicles fit on one approach road."""

    statement: int
    vehicles: int


# --- symmetry -------------------------------------------------------------------------------


class Member(Predicate):
    """A vehicle belongs to a group of interchangeable ones."""

    id: ConstantStr
    group: int


class Size(Predicate):
    """Members of a group."""

    group: int
    number: int


class Next(Predicate):
    """Two members of a group, the second right after the first."""

    first: ConstantStr
    second: ConstantStr


class OpenPlace(Predicate, name="open_place"):
    """On one arm with its reference, a vehicle has more than one place to choose from."""

    id: ConstantStr
    reference: ConstantStr


class Trades(Predicate):
    """Two vehicles that may trade their moves without changing a pattern."""

    first: ConstantStr
    second: ConstantStr


class Rotation(Predicate):
    """Turning the junction by so many arms maps it and its facts onto themselves."""

    arms: int


class Anchor(Predicate):
    """One of a kind: it turns along, so it shows how far the junction is turned."""

    id: ConstantStr


class Cell(Predicate):
    """A choice that members of a group may make, numbered."""

    number: int
    group: int
    entry: int
    move: int
    manner: ConstantStr


class Turned(Predicate):
    """Turning by ``arms`` carries what stands in cell ``before`` to cell ``after``."""

    arms: int
    before: int
    after: int


# --- reading ------------------------------------------------------------------------------


class Pair(Predicate):
    """Two vehicles whose drives are shown as one atom."""

    first: ConstantStr
    second: ConstantStr
