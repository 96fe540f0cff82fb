"""Participants and objects as OpenSCENARIO entities: named blueprints with their true boxes."""

from scegen.export.library import xosc
from scegen.export.openscenario_text import xml_text
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.objects import StaticObject
from scegen.scenario.vocabulary import ANIMALS, ON_FOOT, ParticipantKind, Role

_CATEGORY = {ParticipantKind.MOTORCYCLE: "motorbike", ParticipantKind.EMERGENCY_VEHICLE: "van"}
"""What the standard calls otherwise, or has no word for."""
_WHEEL_DIAMETER_M = 0.6
_MAX_STEERING_RAD = 0.6


def entities(concrete: ConcreteScenario, *, external_ego: bool = False) -> xosc.Entities:
    """All participants and objects, named by their ids; standing vehicles are vehicles too.

    An ego that somebody else drives carries a property that says so.
    """
    result = xosc.Entities()
    for participant in concrete.ego_first:
        body = participant.body
        # esmini moves no MiscObject: a door goes as who gets out by it.
        if participant.kind in ON_FOOT | {ParticipantKind.DOOR}:
            entity = _on_foot(participant.kind, body)
        else:
            entity = _vehicle(participant, body)
        is_ego = participant.role is Role.EGO
        entity.add_property("type", "ego_vehicle" if is_ego else "simulation")
        if is_ego and external_ego:
            entity.add_property("driven_by", "external")
        result.add_scenario_object(participant.id, entity)
    for thing in concrete.objects:
        result.add_scenario_object(thing.id, _misc_object(thing))
    return result


def _misc_object(thing: StaticObject) -> xosc.MiscObject:
    """An object by the name of CARLA's prop, which is what scenario_runner looks at."""
    made = xosc.MiscObject(
        thing.blueprint,
        thing.mass_kg,
        getattr(xosc.MiscObjectCategory, thing.category),
        _box(thing.body),
    )
    made.add_property("type", "simulation")
    made.add_property("what", xml_text(thing.what))
    return made


def _box(body: Body) -> xosc.BoundingBox:
    return xosc.BoundingBox(
        body.width_m, body.length_m, body.height_m, body.centre_ahead_m, 0.0, body.height_m / 2
    )


def _on_foot(kind: ParticipantKind, body: Body) -> xosc.Pedestrian:
    category = xosc.PedestrianCategory
    return xosc.Pedestrian(
        body.blueprint,
        body.mass_kg,
        category.animal if kind in ANIMALS else category.pedestrian,
        _box(body),
        body.blueprint,
    )


def _vehicle(participant: ConcreteParticipant, body: Body) -> xosc.Vehicle:
    """A vehicle whose performance allows all that its program asks: players clip to it."""
    program = participant.speed_program
    rates = [phase.rate_mps2 for phase in program]
    rates += [participant.on_contact.rate_mps2] if participant.on_contact else []
    speeds = [participant.speed_mps, *(phase.target_speed_mps for phase in program)]
    track = round(0.8 * body.width_m, 3)
    radius = _WHEEL_DIAMETER_M / 2
    return xosc.Vehicle(
        body.blueprint,
        getattr(xosc.VehicleCategory, _CATEGORY.get(participant.kind, participant.kind)),
        _box(body),
        xosc.Axle(_MAX_STEERING_RAD, _WHEEL_DIAMETER_M, track, body.wheelbase_m, radius),
        xosc.Axle(0.0, _WHEEL_DIAMETER_M, track, 0.0, radius),
        max(body.top_speed_mps, *speeds),
        max([body.max_acceleration_mps2, *rates]),
        max([body.max_deceleration_mps2, *rates]),
    )
