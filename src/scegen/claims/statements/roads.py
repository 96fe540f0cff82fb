"""The road, its rules and the conditions: as described, so as made."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial

from scegen.claims.claim import Claim, ClaimKind, Judged, Test, always
from scegen.claims.told import KPH, Told, plain
from scegen.claims.view import View
from scegen.road.straight import curve_of
from scegen.scenario.bends import Bend
from scegen.scenario.control import controlled_arms, has_crosswalk
from scegen.scenario.road_parameters import RoadParameters
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.vocabulary import Side
from scegen.scenario.wording import counted

_AUXILIARY = {
    AuxiliaryLane.ON_RAMP: "a ramp joins the road",
    AuxiliaryLane.OFF_RAMP: "a ramp leaves the road",
    AuxiliaryLane.LANE_DROP: "the outermost lane ends",
}
_SAME_MPS = 0.5 / KPH
_SAME_DEG = 1.0
_SAME_M = 0.5
_SAME_WIDTH_M = 0.01
Agrees = Callable[[RoadParameters], bool]


def claims(told: Told) -> Iterator[Claim]:
    """Of the junction, who takes part, and the environment."""
    for part, says, agrees in _junction(told):
        yield _claim(part, says, f"junction.{part}", partial(_built, agrees))
    names = {person.id for person in told.people}
    there = f"there {'is' if len(names) == 1 else 'are'} {counted(len(names), 'participant')}"
    test = partial(_those, names | told.doors.keys())
    yield _claim("participants", f"{there} and no others", "participants", test)
    said = told.functional.environment.model_dump(mode="json", exclude_none=True)
    for name, value in said.items():
        field, test = f"environment.{name}", partial(_conditions, name, value)
        what = plain(value) if isinstance(value, str) else f"{value:g}"
        unit = " m" if name.endswith("_m") else ""
        yield _claim(field, f"{plain(name.removesuffix('_m'))}: {what}{unit}", field, test)


def _claim(name: str, statement: str, field: str, test: Test) -> Claim:
    return Claim(f"road.{name}", ClaimKind.ROAD, statement, field, "1", test, fixed=True)


def _junction(told: Told) -> Iterator[tuple[str, str, Agrees]]:
    """What the road must have: the field that says it, how it is told, how it is looked up."""
    junction = told.functional.junction
    kind, control, limit = junction.kind, junction.control, junction.speed_limit_mps
    yield "kind", f"the road is {plain(kind)}", lambda road: road.kind is kind
    arms = junction.arms
    yield "arms", f"it has {counted(arms, 'arm')}", lambda road: len(road.arms) == arms
    signs = controlled_arms(junction)
    where = f", at arms {_listed(signs)}" if signs else ""
    ruled: Agrees = lambda road: road.control is control and road.controlled_arms == signs  # noqa: E731
    yield "control", f"control: {plain(control)}{where}", ruled
    side = junction.driving_side
    yield "driving_side", f"traffic keeps {side}", lambda road: road.driving_side is side
    if limit is not None:
        yield "speed_limit_mps", f"the limit is {limit * KPH:.4g} km/h", partial(_limited, limit)
    lanes, width = junction.lanes, junction.lane_width_m
    if lanes:
        statement = f"lanes per direction: {', '.join(map(str, lanes))}"
        yield "lanes", statement, lambda road: _enough(road, lanes)
    if width is not None:
        yield "lane_width_m", f"its lanes are {width:g} m wide", partial(_as_wide, width)
    carriageway, strips = junction.carriageway, junction.strips
    if carriageway is not Carriageway.UNDIVIDED:
        statement = f"its carriageway is {plain(carriageway)}"
        yield "carriageway", statement, lambda road: road.carriageway is carriageway
    if junction.bend is not None:
        bend, ego = junction.bend, told.drive(told.ego)
        entry = 0 if ego is None else ego.entry
        course = "a bend" if bend.side is None else f"a bend to the {bend.side}"
        size = "" if bend.radius_m is None else f" of {bend.radius_m:g} m radius"
        yield "bend", f"the ego drives {course}{size}", partial(_bends, bend, entry)
    if strips:
        statement = f"beside its lanes: {', '.join(plain(x) for x in Strip if x in strips)}"
        yield "strips", statement, lambda road: road.strips >= strips
    auxiliary, length, angles = (
        junction.auxiliary, junction.auxiliary_length_m, junction.arm_angles_deg
    )  # fmt: skip
    if auxiliary is not None:
        yield "auxiliary", _AUXILIARY[auxiliary], partial(_has_auxiliary, auxiliary)
    if length is not None:
        statement = f"its lane beside the others is {length:g} m long"
        yield "auxiliary_length_m", statement, partial(_as_long, length)
    if angles:
        statement = f"its arms lie at {', '.join(f'{angle:g}' for angle in angles)} degrees"
        yield "arm_angles_deg", statement, partial(_at_angles, angles)
    ring, crossed = junction.ring_lanes, {c.arm for c in told.logical.crossings}
    if ring is not None:
        yield "ring_lanes", f"lanes in the ring: {ring}", lambda road: road.ring_lanes == ring
    walks = junction.crosswalks | {arm for arm in crossed if has_crosswalk(junction, arm)}
    if walks:
        statement = f"crosswalks over arms {_listed(walks)}"
        yield "crosswalks", statement, lambda road: road.crosswalks >= walks


def _listed(arms: Iterable[int]) -> str:
    return ", ".join(map(str, sorted(arms)))


def _built(agrees: Agrees, view: View) -> Judged:
    return always(view, holds=agrees(view.concrete.road))


def _limited(limit_mps: float, road: RoadParameters) -> bool:
    return all(abs(arm.speed_limit_mps - limit_mps) <= _SAME_MPS for arm in road.arms)


def _as_wide(width_m: float, road: RoadParameters) -> bool:
    return all(abs(arm.lane_width_m - width_m) <= _SAME_WIDTH_M for arm in road.arms)


def _has_auxiliary(kind: AuxiliaryLane, road: RoadParameters) -> bool:
    return road.auxiliary is not None and road.auxiliary.kind is kind


def _as_long(length_m: float, road: RoadParameters) -> bool:
    return road.auxiliary is not None and abs(road.auxiliary.length_m - length_m) <= _SAME_M


def _enough(road: RoadParameters, lanes: tuple[int, ...]) -> bool:
    """At least as many lanes in: where somebody turns back, one more may be needed.

    A one-way road has lanes in at one arm only, and at the other as many out.
    """
    one_way = road.carriageway is Carriageway.ONE_WAY
    found = [max(arm.lanes_in, arm.lanes_out) if one_way else arm.lanes_in for arm in road.arms]
    return all(have >= count for have, count in zip(found, lanes, strict=False))


def _bends(bend: Bend, entry: int, road: RoadParameters) -> bool:
    """To the side that is said, seen by who enters at that arm, as tightly as is said."""
    curve = curve_of(road)
    if curve is None:
        return False
    left = (curve.curvature_1pm > 0) == (entry == 0)
    sided = bend.side is None or left == (bend.side is Side.LEFT)
    return sided and (
        bend.radius_m is None or abs(abs(1 / curve.curvature_1pm) - bend.radius_m) < _SAME_M
    )


def _at_angles(angles_deg: tuple[float, ...], road: RoadParameters) -> bool:
    return all(
        abs((arm.angle_deg - angle + 180.0) % 360.0 - 180.0) <= _SAME_DEG
        for arm, angle in zip(road.arms, angles_deg, strict=False)
    )


def _those(names: set[str], view: View) -> Judged:
    found = {person.id for person in view.concrete.participants}
    return always(view, holds=found == names, measured=len(found))


def _conditions(name: str, value: str | float, view: View) -> Judged:
    return always(view, holds=getattr(view.concrete.environment, name) == value)
