"""What a road is like along its length: how its directions lie, and what lies beside its lanes."""

from scegen.scenario.definitions import Word

LANE_WIDTH_M = 3.5
"""The usual width of a lane."""
LANE_WIDTHS_M = (2.0, 6.0)
"""The narrowest and the widest lane."""
AUXILIARY_LENGTHS_M = (20.0, 500.0)
"""The shortest and the longest lane for a part of the road."""


class Carriageway(Word):
    """How the two directions of a road lie to each other."""

    UNDIVIDED = (
        "undivided",
        "the two directions lie side by side",
        "`divided`, where something stands between them",
        "a country road; a two-lane highway; not said",
    )
    DIVIDED = (
        "divided",
        "a median parts the two directions, and nobody crosses it; so with ramps",
        "`one_way`, which has no other direction",
        "a motorway; a dual carriageway",
    )
    ONE_WAY = (
        "one_way",
        "all traffic goes the same way, in at arm 0 and out at arm 1",
        "`divided`, whose other direction lies beyond a median",
        "a one-way street",
    )


class Strip(Word):
    """What lies beside the lanes all along a road."""

    HARD_SHOULDER = (
        "hard_shoulder",
        "a paved strip beside the outermost lane on which nobody drives, but may break down",
        "`parking`, at the side of a street",
        "a motorway; on the hard shoulder; in the breakdown lane",
    )
    CYCLE_LANE = (
        "cycle_lane",
        "a lane for bicycles beside the outermost lane",
        "a bicycle in a lane of the road, which is on no strip",
        "on the cycle lane; in the bike lane",
    )
    PARKING = (
        "parking",
        "a strip with bays along the kerb, in which one or more vehicles are parked",
        "`bus_stop`; `hard_shoulder`; one that blocks a lane",
        "in a parking bay; a row of parked cars",
    )
    BUS_STOP = (
        "bus_stop",
        "a bay along the kerb in which buses stand",
        "`parking`; a bus that stands in the lane",
        "at a bus stop",
    )
    PAVEMENT = (
        "pavement",
        "the raised strip along the kerb on which people walk",
        "`hard_shoulder`; the edge of a road without a pavement",
        "on the pavement; along the sidewalk",
    )


class AuxiliaryLane(Word):
    """A lane beside the outermost one, for a part of the road only, in the ego's direction."""

    ON_RAMP = (
        "on_ramp",
        "a ramp joins: its lane runs on beside the others for a while and ends",
        "a side road, which joins at a junction",
        "merges from the slip road; in the acceleration lane",
    )
    OFF_RAMP = (
        "off_ramp",
        "an exit: a lane begins beside the others and leads off by a ramp",
        "an exit of a roundabout",
        "leaves the motorway",
    )
    LANE_DROP = (
        "lane_drop",
        "the outermost lane ends, and who is in it must change",
        "`on_ramp`, whose lane comes from another road",
        "the right lane ends",
    )


PLAIN_ROAD_STRIPS = frozenset({Strip.HARD_SHOULDER, Strip.CYCLE_LANE})
"""Strips that no junction interrupts: only a road without one has them."""
BAYS = frozenset({Strip.PARKING, Strip.BUS_STOP})
"""Strips that are built as the one for standing vehicles."""
BESIDE_AN_AUXILIARY_LANE = frozenset({Strip.HARD_SHOULDER})
NOT_BESIDE_A_SHOULDER = frozenset({Strip.CYCLE_LANE, Strip.PARKING, Strip.BUS_STOP})
