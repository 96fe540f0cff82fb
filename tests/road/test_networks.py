"""Properties of every network: joined, aligned, complete, nowhere too tight."""

from itertools import combinations, product
from math import degrees, hypot, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon

from scegen.errors import RoadInfeasibleError
from scegen.road import build_network
from scegen.road.crossing import MIN_RADIUS_M
from scegen.road.fillet import smallest_radius_m, wrapped
from scegen.road.model import ContactPoint, LaneType
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.road_parameters import ArmRoad, RoadParameters
from scegen.scenario.vocabulary import DrivingSide, JunctionKind

GAP_M = 0.01
GAP_DEG = 0.5


def parameters(kind, angles, lanes, **more):
    """Parameters with these arm angles and (in, out) lanes."""
    arms = tuple(
        ArmRoad(
            id=i,
            length_m=more.get("length_m", 80.0),
            angle_deg=angle,
            angle_to_previous_deg=(angle - angles[i - 1]) % 360,
            lanes_in=lanes[i][0],
            lanes_out=lanes[i][1],
            lane_width_m=more.get("lane_width_m", 3.5),
            speed_limit_mps=13.9,
        )
        for i, angle in enumerate(angles)
    )
    fields = {k: v for k, v in more.items() if k in RoadParameters.model_fields}
    return RoadParameters(kind=kind, arms=arms, **fields)


@st.composite
def any_parameters(draw):
    kind = draw(st.sampled_from(list(JunctionKind)))
    count = draw(st.integers(*ARM_COUNTS[kind]))
    if kind is JunctionKind.STRAIGHT:
        first = draw(st.floats(0, 179))
        angles = [first, first + 180 + draw(st.sampled_from([0, 0, -60, -20]))]
        ahead, back = draw(st.tuples(st.integers(1, 3), st.integers(1, 3)))
        lanes = [(ahead, back), (back, ahead)]
    else:
        weights = draw(st.lists(st.floats(1, 4), min_size=count, max_size=count))
        turned = draw(st.floats(0, 0.99)) * weights[-1] / sum(weights) * 360
        steps = [360 * sum(weights[:i]) / sum(weights) for i in range(count)]
        angles = [step + turned for step in steps]
        lane = st.integers(1, 3)
        lanes = [(draw(lane), draw(lane)) for _ in range(count)]
    arms = st.frozensets(st.integers(0, count - 1))
    return parameters(
        kind,
        [round(angle, 2) for angle in angles],
        lanes,
        lane_width_m=draw(st.sampled_from([2.75, 3.5, 4.0])),
        driving_side=draw(st.sampled_from(list(DrivingSide))),
        ring_lanes=draw(st.integers(1, 2)),
        crosswalks=draw(arms),
        parking_lanes=draw(arms),
        u_turns=frozenset() if kind is JunctionKind.STRAIGHT else draw(arms),
    )


def built(wanted):
    """The network, or None where it is refused with a message that has numbers."""
    try:
        return build_network(wanted)
    except RoadInfeasibleError as error:
        refusal = error
    assert any(character.isdigit() for character in refusal.message)
    return None


def step_ends(network, step):
    """Poses of a lane's centre where driving on it begins and ends."""
    length = network.road(step.road).length_m
    return network.pose_at(step, 0.0), network.pose_at(step, length)


def assert_meet(first, second):
    assert hypot(second.x_m - first.x_m, second.y_m - first.y_m) < GAP_M
    assert abs(degrees(wrapped(second.heading_rad - first.heading_rad))) < GAP_DEG


def check_joined(network):
    """Lines have no steps, lanes of successive roads of a route meet."""
    for road in network.roads:
        for before, after in zip(road.line.segments, road.line.segments[1:], strict=False):
            assert_meet(before.end, after.start)
    for routes in network.routes.values():
        for route in routes:
            for before, after in zip(route.steps, route.steps[1:], strict=False):
                assert_meet(step_ends(network, before)[1], step_ends(network, after)[0])


def check_links(network):
    """Links of roads and lanes say what the connections say, and are mutual."""
    incoming = {c.connecting_road: c for area in network.junctions for c in area.connections}
    areas = {c.connecting_road: area.id for area in network.junctions for c in area.connections}
    for road in network.roads:
        if road.junction is None:
            continue
        (lane,) = road.lanes
        connection = incoming[road.id]
        assert areas[road.id] == road.junction
        assert connection.incoming_road == road.predecessor.id
        assert (connection.from_lane, connection.to_lane) == (lane.predecessor, lane.id)
        for link, linked_lane in (
            (road.predecessor, lane.predecessor),
            (road.successor, lane.successor),
        ):
            other = network.road(link.id)
            assert other.lane(linked_lane).type is LaneType.DRIVING
            back = other.successor if link.contact is ContactPoint.END else other.predecessor
            assert (back.element, back.id) == ("junction", road.junction)
        assert road.lane_centre_t_m(lane.id) == pytest.approx(0.0, abs=1e-9)


def check_complete(network, wanted):
    """All pairs have routes, exactly the asked U-turns, each lane of each arm is on a route."""
    arms = range(len(wanted.arms))
    pairs = {(e, x) for e, x in product(arms, arms) if e != x or e in wanted.u_turns}
    assert set(network.routes) == pairs
    assert all(network.routes.values())
    used = {
        (step.road, step.lane)
        for routes in network.routes.values()
        for route in routes
        for step in (route.steps[0], route.steps[-1])
    }
    driving = {
        (road, lane.id)
        for road in network.arm_roads
        for lane in network.road(road).lanes
        if lane.type is LaneType.DRIVING
    }
    assert used == driving
    on_routes = {s.road for routes in network.routes.values() for r in routes for s in r.steps}
    if wanted.u_turns or wanted.kind is not JunctionKind.ROUNDABOUT:
        assert on_routes == {road.id for road in network.roads}


def outline(road, from_m=0.0):
    """The area of all strips of an arm road."""
    t_max = sum(lane.width_m for lane in road.lanes if lane.id > 0)
    t_min = -sum(lane.width_m for lane in road.lanes if lane.id < 0)
    corners = [(from_m, t_min), (road.length_m, t_min), (road.length_m, t_max), (from_m, t_max)]
    poses = [road.line.pose(s, t) for s, t in corners]
    return Polygon([(pose.x_m, pose.y_m) for pose in poses])


def polyline(road):
    count = max(2, round(road.length_m / 0.5))
    poses = [road.line.pose(road.length_m * k / count) for k in range(count + 1)]
    return LineString([(pose.x_m, pose.y_m) for pose in poses])


def check_apart(network):
    """Arm roads do not overlap; ways from one arm, of different lanes, do not cross."""
    for first, second in combinations(network.arm_roads, 2):
        overlap = outline(network.road(first)).intersection(outline(network.road(second)))
        assert overlap.area < 1e-3
    connecting = [road for road in network.roads if road.junction is not None]
    for a, b in combinations(connecting, 2):
        # Leaving the inner lane of a ring crosses the outer one; arms have no such excuse.
        if a.predecessor != b.predecessor or network.road(a.predecessor.id).arm is None:
            continue
        if a.predecessor == a.successor:
            continue
        if b.predecessor == b.successor or a.lanes[0].predecessor == b.lanes[0].predecessor:
            continue
        if (a.successor, a.lanes[0].successor) != (b.successor, b.lanes[0].successor):
            assert not polyline(a).crosses(polyline(b)), (a.name, b.name)


@settings(max_examples=150, derandomize=True)
@given(any_parameters())
def test_every_network_is_sound(wanted):
    network = built(wanted)
    if network is None:
        return
    check_joined(network)
    check_links(network)
    check_complete(network, wanted)
    if wanted.kind is not JunctionKind.STRAIGHT:
        check_apart(network)
    for road in network.roads:
        assert smallest_radius_m(road.line) >= MIN_RADIUS_M - 1e-9
    assert build_network(wanted) == network
    for arm, road_id in zip(wanted.arms, network.arm_roads, strict=True):
        assert network.road(road_id).length_m == pytest.approx(arm.length_m)
        assert bool(network.road(road_id).crosswalks) == (arm.id in wanted.crosswalks)


def mirrored(wanted):
    """The parameters seen in a mirror (y to -y): arms in opposite order, other driving side."""
    order = [0, *range(len(wanted.arms) - 1, 0, -1)]
    angles = [(-wanted.arms[i].angle_deg) % 360 for i in order]
    while angles[0] > angles[1]:
        angles, order = angles[1:] + angles[:1], order[1:] + order[:1]
    new = {old: number for number, old in enumerate(order)}
    lanes = [(wanted.arms[i].lanes_in, wanted.arms[i].lanes_out) for i in order]
    left = wanted.driving_side is DrivingSide.LEFT
    swapped = parameters(
        wanted.kind,
        angles,
        lanes,
        lane_width_m=wanted.arms[0].lane_width_m,
        driving_side=DrivingSide.RIGHT if left else DrivingSide.LEFT,
        ring_lanes=wanted.ring_lanes,
        u_turns=frozenset(new[arm] for arm in wanted.u_turns),
    )
    return swapped, new


@settings(max_examples=40, derandomize=True)
@given(any_parameters())
def test_left_hand_traffic_is_the_mirror_image(wanted):
    plain = wanted.model_copy(update={"parking_lanes": frozenset(), "crosswalks": frozenset()})
    network = built(plain)
    swapped, new = mirrored(plain)
    image = built(swapped)
    assert (network is None) == (image is None)
    if network is None or image is None:
        return
    for (entry, leaving), routes in network.routes.items():
        reflected = image.routes[new[entry], new[leaving]]
        key = [(r.entry_lane, r.exit_lane, r.ring_lane) for r in routes]
        assert key == [(r.entry_lane, r.exit_lane, r.ring_lane) for r in reflected]
        for ours, theirs in zip(routes, reflected, strict=True):
            for step, other in zip(ours.steps, theirs.steps, strict=True):
                assert step.lane == -other.lane
                half = network.road(step.road).length_m / 2
                here, there = network.pose_at(step, half), image.pose_at(other, half)
                assert (here.x_m, here.y_m) == pytest.approx((there.x_m, -there.y_m), abs=1e-6)


def test_arms_keep_their_directions_and_face_the_centre():
    network = build_network(
        parameters(JunctionKind.FOUR_WAY, [10.0, 100.0, 190.0, 280.0], [(1, 1)] * 4)
    )
    for arm, angle in enumerate((10.0, 100.0, 190.0, 280.0)):
        end = network.arm_road(arm).line.end
        assert degrees(wrapped(end.heading_rad - pi)) % 360 == pytest.approx(angle)
        assert hypot(end.x_m, end.y_m) == pytest.approx(11.5)
