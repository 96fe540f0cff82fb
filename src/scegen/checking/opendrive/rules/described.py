"""The road network is the one that the concrete scenario describes."""

from collections.abc import Iterator

from scegen.checking.opendrive.arms import Arm, match_arms
from scegen.checking.opendrive.lanes import lane_width, section_at
from scegen.checking.opendrive.network import START, Network
from scegen.checking.opendrive.routing import lane_graph, outer_node, reach
from scegen.checking.opendrive.tolerances import GAP_M
from scegen.checking.results import Finding, error
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.logical import Drive
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import DrivingSide

_BUILT_AS = {
    Strip.HARD_SHOULDER: "shoulder",
    Strip.CYCLE_LANE: "biking",
    Strip.PARKING: "parking",
    Strip.BUS_STOP: "parking",
    Strip.PAVEMENT: "sidewalk",
}
SPEED_MPS = 0.01
"""How far a speed limit may be rounded."""
_INSIDE_M = 1.0


def check_described(network: Network, concrete: ConcreteScenario) -> Iterator[Finding]:
    """``xodr.described``: what the arms have; ``xodr.drive``: every drive has a way."""
    matched = match_arms(network, concrete)
    yield from matched.findings
    if not matched.arms:
        return
    rule = "RHT" if concrete.road.driving_side is DrivingSide.RIGHT else "LHT"
    for wanted in concrete.road.arms:
        arm = matched.arms[wanted.id]
        place = f"arm {wanted.id} ({arm.place})"
        if arm.road.rule != rule:
            yield error("xodr.described", place, f"has rule {arm.road.rule} instead of {rule}")
        yield from _lanes(arm, wanted, concrete.road, place)
        yield from _auxiliary(arm, wanted, concrete.road, place)
        yield from _lengthwise(arm, concrete.road, place)
        yield from _furniture(arm, wanted, place, crossed=wanted.id in concrete.road.crosswalks)
    yield from _drives(network, concrete, matched.arms)


def _lanes(arm: Arm, wanted: ArmRoad, road: RoadParameters, place: str) -> Iterator[Finding]:
    found = (len(arm.inward), len(arm.outward))
    drops = road.auxiliary is not None and road.auxiliary.kind is AuxiliaryLane.LANE_DROP
    lanes_in = wanted.lanes_in + (1 if drops and wanted.id == 0 else 0)
    if found != (lanes_in, wanted.lanes_out):
        message = (
            f"has {found[0]} lanes in and {found[1]} out "
            f"instead of {lanes_in} and {wanted.lanes_out}"
        )
        yield error("xodr.described", place, message)
    section, s = arm.road.section(arm.contact), arm.road.s_at(arm.contact)
    for lane in (*arm.inward, *arm.outward):
        width = lane_width(section, lane, s)
        if abs(width - wanted.lane_width_m) > GAP_M:
            message = f"lane {lane} is {width:.2f} m wide instead of {wanted.lane_width_m:g} m"
            yield error("xodr.described", place, message)


def _auxiliary(arm: Arm, wanted: ArmRoad, road: RoadParameters, place: str) -> Iterator[Finding]:
    """The auxiliary lane has its full width as far as it should, and nowhere is there one more."""
    auxiliary = road.auxiliary
    if auxiliary is None:
        return
    exit_lane = auxiliary.kind is AuxiliaryLane.OFF_RAMP
    has_it = wanted.id == (0 if exit_lane else 1)
    lanes = arm.inward if wanted.id == 0 else arm.outward
    sign = 1 if lanes[0] > 0 else -1
    number = lanes[-1] + (sign if has_it else 0)
    inner, step = arm.road.s_at(arm.inner), 1 if arm.inner == START else -1
    ends = auxiliary.length_m + auxiliary.taper_m
    for away, there in (
        (_INSIDE_M, has_it),
        (auxiliary.length_m - _INSIDE_M, has_it),
        (ends + _INSIDE_M, False),
    ):
        s = inner + step * min(away, arm.road.length - _INSIDE_M)
        section = section_at(arm.road, s)
        lane = section.lanes.get(lanes[-1] + sign)
        width = lane_width(section, lane.id, s) if lane and lane.type == "driving" else 0.0
        if abs(width - (wanted.lane_width_m if there else 0.0)) > GAP_M:
            message = f"its auxiliary lane is {width:.2f} m wide {away:.0f} m from the inner end"
            yield error("xodr.described", f"{place} lane {number}", message)


def _lengthwise(arm: Arm, road: RoadParameters, place: str) -> Iterator[Finding]:
    """A median lies between the directions if there is to be one, a shoulder beside the lanes."""
    lanes = arm.road.section(arm.contact).lanes
    for side in (arm.inward, arm.outward):
        if not side:
            continue
        sign = 1 if side[0] > 0 else -1
        inside = [lanes[sign * n].type for n in range(1, abs(side[0]))]
        wanted = ["median"] if road.carriageway is Carriageway.DIVIDED else []
        if inside != wanted:
            message = f"has {inside or 'nothing'} inside lane {side[0]}, not {wanted or 'nothing'}"
            yield error("xodr.described", place, message)
        beyond = {x.type for n, x in lanes.items() if n * sign > abs(side[-1])}
        for missing in sorted({_BUILT_AS[s] for s in road.strips} - beyond):
            yield error("xodr.described", place, f"has no {missing} beyond lane {side[-1]}")


def _furniture(arm: Arm, wanted: ArmRoad, place: str, *, crossed: bool) -> Iterator[Finding]:
    limit = arm.road.speed_limit
    if limit is None or abs(limit - wanted.speed_limit_mps) > SPEED_MPS:
        said = "no speed limit" if limit is None else f"speed limit {limit:.2f} m/s"
        message = f"has {said} instead of {wanted.speed_limit_mps:.2f} m/s"
        yield error("xodr.described", place, message)
    if crossed != bool(arm.road.crosswalks):
        message = "has no crosswalk" if crossed else "has a crosswalk that nobody asked for"
        yield error("xodr.described", place, message)
    for s in arm.road.crosswalks:
        if not 0 <= s <= arm.road.length:
            message = f"its crosswalk lies at s = {s:.2f} m, outside the road"
            yield error("xodr.described", place, message)


def _drives(
    network: Network, concrete: ConcreteScenario, arms: dict[int, Arm]
) -> Iterator[Finding]:
    graph = lane_graph(network)
    wanted = {(a.entry, a.exit) for a in concrete.logical.assignments if isinstance(a, Drive)}
    turning = {(arm, arm) for arm in concrete.road.u_turns}
    for entry, leave in sorted(wanted | turning):
        if entry not in arms or leave not in arms:
            continue
        reached = reach(graph, [outer_node(arms[entry], lane) for lane in arms[entry].inward])
        if not any(outer_node(arms[leave], lane) in reached for lane in arms[leave].outward):
            message = f"no way leads from arm {entry} to arm {leave}, as the scenario needs"
            yield error("xodr.drive", f"arm {entry}", message)
