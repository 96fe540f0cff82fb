"""Signs and lights at the entries of a junction, as OpenDRIVE signals."""

from __future__ import annotations

from scegen.export.library import xodr
from scegen.road.model import LaneType, Road
from scegen.scenario.vocabulary import Control

_STVO: dict[Control, tuple[str, str]] = {
    Control.YIELD: ("205", "yield"),
    Control.STOP: ("206", "stop"),
    Control.ALL_WAY_STOP: ("206", "stop"),
    Control.SIGNALS: ("1000001", "traffic_light"),
}
"""Type and name by control, numbers of the German catalogue (StVO; 1000001 as in OpenDRIVE)."""
_BESIDE_M = 0.5
_HEIGHT_M = 2.3


def entry_sign(road: Road, control: Control) -> xodr.Signal | None:
    """What stands beside the inner end of an arm road, for traffic towards the junction."""
    if control not in _STVO:
        return None
    kind, name = _STVO[control]
    sign = -1 if road.driving_side == "right" else 1
    inward = [lane for lane in road.lanes if lane.id * sign > 0]
    kerb = sum(lane.width_m for lane in inward if lane.type is not LaneType.SIDEWALK)
    signal = xodr.Signal(
        s=round(road.length_m, 9),
        t=round(sign * (kerb + _BESIDE_M), 9),
        country="DE",
        Type=kind,
        id=str(road.id),
        name=f"{name}_{road.id}",
        dynamic=xodr.Dynamic.yes if control is Control.SIGNALS else xodr.Dynamic.no,
        zOffset=_HEIGHT_M,
        orientation=xodr.Orientation.positive,
        width=0.6,
        height=0.6,
    )
    driving = [lane.id for lane in inward if lane.type is LaneType.DRIVING]
    signal.add_validity(min(driving), max(driving))
    return signal
