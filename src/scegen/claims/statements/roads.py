"""The road, its rules and the conditions: as described, so as made."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from scegen.claims.claim import Claim, ClaimKind, Judged, always
from scegen.claims.told import KPH, Told, plain
from scegen.claims.view import View
from scegen.road.straight import curve_of
from scegen.scenario.bends import Bend
from scegen.scenario.concrete import RoadParameters
from scegen.scenario.control import controlled_arms, has_crosswalk
from scegen.scenario.functional import Junction
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
    """Of the junction and the environment."""
    junction = told.functional.junction
    kind, control, limit = junction.kind, junction.control, junction.speed_limit_mps
    yield _road("kind", f"the road is {plain(kind)}", lambda road: road.kind is kind)
    arms = junction.arms
    yield _road("arms", f"it has {counted(arms, 'arm')}", lambda road: len(road.arms) == arms)
    signs = controlled_arms(junction)
    where = f", at arms {', '.join(map(str, sorted(signs)))}" if signs else ""
    yield _road(
        "control",
        f"control: {plain(control)}{where}",
        lambda road: road.control is control and road.controlled_arms == signs,
    )
    side = junction.driving_side
    yield _road("driving_side", f"traffic keeps {side}", lambda road: road.driving_side is side)
    if limit is not None:
        statement = f"the limit is {limit * KPH:.4g} km/h"
        yield _road("speed_limit_mps", statement, partial(_limited, limit))
    yield from _lanes(junction)
    carriageway, strips = junction.carriageway, junction.strips
    if carriageway is not Carriageway.UNDIVIDED:
        statement = f"its carriageway is {plain(carriageway)}"
        yield _road("carriageway", statement, lambda road: road.carriageway is carriageway)
    if junction.bend is not None:
        bend, ego = junction.bend, told.drive(told.ego)
        entry = 0 if ego is None else ego.entry
        course = "a bend" if bend.side is None else f"a bend to the {bend.side}"
        size = "" if bend.radius_m is None else f" of {bend.radius_m:g} m radius"
        yield _road("bend", f"the ego drives {course}{size}", partial(_bends, bend, entry))
    if strips:
        statement = f"beside its lanes: {', '.join(plain(x) for x in Strip if x in strips)}"
        yield _road("strips", statement, lambda road: road.strips >= strips)
    if junction.auxiliary is not None:
        auxiliary = junction.auxiliary
        yield _road("auxiliary", _AUXILIARY[auxiliary], partial(_has_auxiliary, auxiliary))
    if junction.auxiliary_length_m is not None:
        length = junction.auxiliary_length_m
        statement = f"its lane beside the others is {length:g} m long"
        yield _road("auxiliary_length_m", statement, partial(_as_long, length))
    if junction.arm_angles_deg:
        angles = junction.arm_angles_deg
        statement = f"its arms lie at {', '.join(f'{angle:g}' for angle in angles)} degrees"
        yield _road("arm_angles_deg", statement, partial(_at_angles, angles))
    if junction.ring_lanes is not None:
        ring = junction.ring_lanes
        yield _road(
            "ring_lanes", f"lanes in the ring: {ring}", lambda road: road.ring_lanes == ring
        )
    walks = junction.crosswalks | {
        c.arm for c in told.logical.crossings if has_crosswalk(junction, c.arm)
    }
    if walks:
        statement = f"crosswalks over arms {', '.join(map(str, sorted(walks)))}"
        yield _road("crosswalks", statement, lambda road: road.crosswalks >= walks)
    names = {person.id for person in told.people}
    yield Claim(
        id="road.participants",
        kind=ClaimKind.ROAD,
        statement=f"{_there_are(len(names))} and no others",
        field="participants",
        unit="1",
        test=partial(_those, names | told.doors.keys()),
        fixed=True,
    )
    said = told.functional.environment.model_dump(mode="json", exclude_none=True)
    for name, value in said.items():
        yield Claim(
            id=f"road.environment.{name}",
            kind=ClaimKind.ROAD,
            statement=f"{plain(name)}: {plain(str(value))}",
            field=f"environment.{name}",
            unit="1",
            test=partial(_conditions, name, str(value)),
            fixed=True,
        )


def _lanes(junction: Junction) -> Iterator[Claim]:
    if junction.lanes:
        lanes = junction.lanes
        statement = f"lanes per direction: {', '.join(map(str, lanes))}"
        yield _road("lanes", statement, lambda road: _enough(road, lanes))
    if junction.lane_width_m is not None:
        width = junction.lane_width_m
        yield _road("lane_width_m", f"its lanes are {width:g} m wide", partial(_as_wide, width))


def _there_are(number: int) -> str:
    return f"there {'is' if number == 1 else 'are'} {counted(number, 'participant')}"


def _road(part: str, statement: str, agrees: Agrees) -> Claim:
    return Claim(
        id=f"road.{part}",
        kind=ClaimKind.ROAD,
        statement=statement,
        field=f"junction.{part}",
        unit="1",
        test=partial(_built, agrees),
        fixed=True,
    )


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


def _conditions(name: str, value: str, view: View) -> Judged:
    return always(view, holds=getattr(view.concrete.environment, name) == value)
