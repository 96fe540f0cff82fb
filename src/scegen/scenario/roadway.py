"""What a road is like along its length: how its directions lie, and what lies beside its lanes."""

from __future__ import annotations

from scegen.scenario.definitions import Word


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
        "a median parts the two directions, and nobody crosses it",
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
        "the side of a street where vehicles are parked",
        "a motorway; on the hard shoulder; in the breakdown lane",
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
