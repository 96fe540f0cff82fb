"""Static objects: what stands or lies about without taking part in traffic.

A box on the ground: debris in a lane, a hedge at a corner. Its pose is that of its centre in the
world: x to the east, y to the north (m), heading counter-clockwise from east; its length lies
along the heading.
"""

from enum import StrEnum

from pydantic import Field

from scegen.scenario.bodies import Body
from scegen.scenario.model import FrozenModel, Identifier


class ObjectCategory(StrEnum):
    """What an object is, in the words of OpenSCENARIO's MiscObjectCategory."""

    OBSTACLE = "obstacle"
    BARRIER = "barrier"
    BUILDING = "building"
    POLE = "pole"
    TREE = "tree"
    VEGETATION = "vegetation"


class StaticObject(FrozenModel):
    """An object that never moves; ``what`` is what people call it.

    ``blueprint`` is the prop that CARLA shows for it; players without it show the box.
    """

    id: Identifier
    category: ObjectCategory
    what: str = Field(min_length=1, max_length=60)
    x_m: float
    y_m: float
    heading_deg: float = Field(ge=-180, le=360)
    length_m: float = Field(gt=0, le=100)
    width_m: float = Field(gt=0, le=100)
    height_m: float = Field(gt=0, le=100)
    mass_kg: float = Field(default=50.0, gt=0)
    blueprint: str = Field(
        default="static.prop.streetbarrier", pattern=r"^static\.prop\.[a-z0-9_]+$"
    )

    @property
    def body(self) -> Body:
        """Its box; the reference point is the centre, and it goes nowhere."""
        return Body(
            length_m=self.length_m,
            width_m=self.width_m,
            height_m=self.height_m,
            centre_ahead_m=0.0,
            wheelbase_m=0.0,
            blueprint=self.blueprint,
            top_speed_mps=0.0,
            max_acceleration_mps2=0.0,
            max_deceleration_mps2=0.0,
            mass_kg=self.mass_kg,
        )
