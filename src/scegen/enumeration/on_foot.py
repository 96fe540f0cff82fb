"""Ways of those who are not in the traffic: over an arm, or along it, standing or walking."""

from typing import Any, NamedTuple

from clorm import Predicate

from scegen.enumeration import predicates as p
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.logical import Crossing, Heading, Standing, Walking
from scegen.scenario.vocabulary import Maneuver, Side

IN_LANE, AT_EDGE, NO_HEADING = "in_lane", "at_edge", "none"


class AlongWay(NamedTuple):
    """On a side of the road, in a lane there or at its edge, headed somewhere or standing."""

    side: Side
    in_lane: bool
    heading: Heading | None


CROSSINGS = {side.value: side for side in Side}
ALONG: dict[str, AlongWay] = (
    {f"stands_{side.value}": AlongWay(side, in_lane=True, heading=None) for side in Side}
    | {
        f"walks_{side.value}_{place}_{heading.value}": AlongWay(side, place == IN_LANE, heading)
        for side in Side
        for place in (IN_LANE, AT_EDGE)
        for heading in Heading
    }
    | {f"waits_{side.value}": AlongWay(side, in_lane=False, heading=None) for side in Side}
)


def way_facts() -> list[Predicate]:
    """What the names of the ways stand for."""
    facts: list[Predicate] = [p.Over(name, side.value) for name, side in CROSSINGS.items()]
    facts += [
        p.Along(
            name,
            way.side.value,
            IN_LANE if way.in_lane else AT_EDGE,
            NO_HEADING if way.heading is None else way.heading.value,
        )
        for name, way in ALONG.items()
    ]
    facts += [p.Nth(name, number) for number, name in enumerate((*CROSSINGS, *ALONG))]
    return facts


def ways_of(functional: FunctionalScenario, participant: Participant) -> list[str]:
    """The ways that are left to one by what is said: over the road if nothing is.

    One whom a danger or the outcome concerns, or of whom a lane is said, is in the lane; one who is
    on a strip is beside the lanes, and nobody else stands there.
    """
    said = participant.maneuvers or {Maneuver.CROSS}
    beside = participant.strip is not None
    in_lane = bool(participant.lanes) or participant.id in _concerned(functional)
    found = list(CROSSINGS) if said - {Maneuver.STAY, Maneuver.STRAIGHT} else []
    for name, way in ALONG.items():
        word = Maneuver.STAY if way.heading is None else Maneuver.STRAIGHT
        usual = way.in_lane or (not in_lane and way.heading is not None)
        if word in said and (not way.in_lane if beside else usual):
            found.append(name)
    return found


def _concerned(functional: FunctionalScenario) -> frozenset[str]:
    names = {name for hazard in functional.hazards for name in (*hazard.by, *hazard.to)}
    names |= {name for s in functional.spacings for name in (s.participant, s.reference)}
    if functional.outcome is not None:
        names |= {*functional.outcome.between} or {c.id for c in functional.crossers}
    return frozenset(names)


class Place(NamedTuple):
    """Rank, lane, and next to whom on which side, among those in the lanes of an arm."""

    rank: int
    lane: int | None
    beside: tuple[str, Side] | None

    def fields(self) -> dict[str, Any]:
        """As the fields of an assignment."""
        other, side = self.beside or (None, None)
        return {"rank": self.rank, "lane": self.lane, "beside": other, "beside_on": side}


def assignment_of(name: str, arm: int, way: str, place: Place) -> Crossing | Standing | Walking:
    """What somebody does who goes this way on an arm."""
    if way in CROSSINGS:
        return Crossing(participant=name, arm=arm, start=CROSSINGS[way])
    side, in_lane, heading = ALONG[way]
    known = {"participant": name, "arm": arm, "side": side, "in_lane": in_lane, **place.fields()}
    if heading is None:
        return Standing(**known)
    return Walking(heading=heading, **known)
