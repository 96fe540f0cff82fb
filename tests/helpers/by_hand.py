"""Concrete scenarios made by hand: a straight road, and whoever a test puts on it."""

from __future__ import annotations

from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.vocabulary import JunctionKind


def straight_road(length_m: float = 200.0) -> RoadParameters:
    """Two arms of this length, one lane each way, 14 m/s."""
    arms = tuple(
        ArmRoad(
            id=i,
            length_m=length_m,
            angle_deg=180 * i,
            angle_to_previous_deg=180,
            lanes_in=1,
            lanes_out=1,
            speed_limit_mps=14,
        )
        for i in (0, 1)
    )
    return RoadParameters(kind=JunctionKind.STRAIGHT, arms=arms)


def by_hand(*people: ConcreteParticipant, **fields: object) -> ConcreteScenario:
    """A scenario of these participants on a straight road; ``fields`` are set as they are."""
    usual: dict[str, object] = {
        "name": "case",
        "description": "by hand",
        "seed": 0,
        "logical": LogicalScenario(index=0, slug="x", pattern=(1,), assignments=()),
        "road": straight_road(),
        "participants": people,
        "duration_s": 10.0,
    }
    return ConcreteScenario.model_validate(usual | fields)
