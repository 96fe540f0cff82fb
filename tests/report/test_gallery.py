"""The gallery: one tile per logical scenario, drawn the right way round, always valid XML."""

from collections import Counter
from itertools import pairwise
from math import atan2, pi

import pytest
from lxml import etree

from scegen.enumeration import enumerate_scenarios, plain_crossing
from scegen.errors import InputError
from scegen.report import gallery
from scegen.report.conflict_points import conflict_points
from scegen.report.gallery import PAGE, draw_tiles, gallery_svg
from scegen.report.plan import arrow_head, crossing_line, drive_line, make_plan, standing_box
from scegen.report.tile import moves_words, tile_svg
from scegen.scenario.arms import arm_angles_deg, exit_arm, turn_name
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.logical import (
    Certificate,
    Conflict,
    Crossing,
    Drive,
    LogicalScenario,
    LogicalSet,
    Standing,
)
from scegen.scenario.vocabulary import (
    ArmsMode,
    DrivingSide,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Reduction,
    Role,
    Side,
)

SVG = "{http://www.w3.org/2000/svg}"
ARMS = {JunctionKind.STRAIGHT: 2, JunctionKind.T: 3, JunctionKind.Y: 3, JunctionKind.MULTI_WAY: 6}


def junction(kind: JunctionKind = JunctionKind.FOUR_WAY, **fields) -> Junction:
    return Junction(kind=kind, arms=fields.pop("arms", ARMS.get(kind, 4)), **fields)


def drive(name: str, entry: int, move: int, at: Junction, **fields) -> Drive:
    turn = turn_name(arm_angles_deg(at), entry, move)
    leaves = exit_arm(entry, move, at.arms)
    fields = {"turn": turn, "maneuver": turn} | fields
    return Drive(participant=name, entry=entry, move=move, exit=leaves, **fields)


def logical_set(at: Junction, count: int = 3, description: str = "text") -> LogicalSet:
    functional = FunctionalScenario(
        description=description,
        junction=at,
        participants=(
            Participant(id="ego", role=Role.EGO),
            Participant(id="car_1"),
            Participant(id="walker", kind=ParticipantKind.PEDESTRIAN),
            Participant(id="van", kind=ParticipantKind.VAN, parked=True),
        ),
    )
    scenarios = tuple(
        LogicalScenario(
            index=i,
            slug=f"s{i}",
            pattern=(1, 1),
            class_size=1 + i % 2,
            assignments=(
                drive("ego", 0, 1, at),
                drive("car_1", 1, 1, at),
                Crossing(participant="walker", arm=0, start=Side.RIGHT),
                Standing(participant="van", arm=0, side=Side.LEFT),
            ),
        )
        for i in range(count)
    )
    certificate = Certificate(total=count + 5, count=count, complete=True, method="by <hand> & eye")
    return LogicalSet(
        functional=functional,
        reduction=Reduction.EXACT,
        arms=ArmsMode.DISTINCT,
        certificate=certificate,
        scenarios=scenarios,
    )


@pytest.mark.parametrize("side", list(DrivingSide))
@pytest.mark.parametrize("kind", list(JunctionKind))
def test_every_junction_gives_valid_and_stable_xml(kind, side):
    given = logical_set(junction(kind, driving_side=side))
    text = gallery_svg(given)
    assert text == gallery_svg(given)
    root = etree.fromstring(text.encode())
    assert root.find(f"{SVG}title").text == "3 logical scenarios"
    assert "8 assignments" in root.find(f"{SVG}desc").text
    assert len(root.findall(f"{SVG}g")) == 3
    assert "nan" not in text


def test_captions_say_number_moves_and_class_size():
    tile = tile_svg(logical_set(junction()).scenarios[1], logical_set(junction()).functional)
    words = " ".join(etree.fromstring(tile.encode()).itertext())
    assert "moves 1 1 ×2" in words
    assert "walker crosses 0 from right" in words
    assert "ego 0 → 1, right" in words


def cards(text):
    return etree.fromstring(text.encode()).findall(f"{SVG}g")


def words_of(card):
    return [text.text for text in card.findall(f"{SVG}text")]


def test_what_is_not_drawn_is_counted():
    text = gallery_svg(logical_set(junction(), count=57))
    assert "17 more not drawn" in text
    assert len(cards(text)) == PAGE


def test_many_are_folded_by_pattern_and_can_be_unfolded():
    listed = enumerate_scenarios(plain_crossing((0, 1, 2, 3, 0, 1), 4), arms=ArmsMode.EQUAL)
    text = gallery_svg(listed)
    assert len(text.encode()) < 300_000
    root = etree.fromstring(text.encode())
    assert float(root.get("height")) < 3_000
    headings = [": ".join(words_of(card)[:2]) for card in cards(text)]
    sizes = Counter()
    for scenario in listed.scenarios:
        sizes[scenario.pattern] += scenario.class_size
    assert len(headings) == len(sizes) == 28
    for heading, (pattern, size) in zip(headings, sorted(sizes.items()), strict=True):
        assert heading.startswith(f"Moves {moves_words(pattern)}: ")
        if "assignment" in heading:
            assert f" {size} assignment" in heading
    assert len(root.findall(f".//{SVG}use")) == 28  # the roads are drawn once
    unfolded = sum(
        len(cards(gallery_svg(listed, moves=pattern, page=page)))
        for pattern in sizes
        for page in range(1, -(-sum(s.pattern == pattern for s in listed.scenarios) // PAGE) + 1)
    )
    assert unfolded == 324


def test_pages_hold_every_group_once():
    listed = enumerate_scenarios(plain_crossing((0, 1, 2, 3, 0, 1, 2), 4), arms=ArmsMode.EQUAL)
    for one in (listed, logical_set(junction(), count=0)):
        with pytest.raises(InputError, match="no page 2"):
            gallery_svg(one, page=2)
    many = enumerate_scenarios(plain_crossing((0, 1, 2, 3, 0, 1, 2, 3, 0), 4), arms=ArmsMode.EQUAL)
    pages = [gallery_svg(many, page=n + 1) for n in range(2)]
    assert sum(len(cards(page)) for page in pages) == len({s.pattern for s in many.scenarios})
    for page in (0, len(pages) + 1):
        with pytest.raises(InputError):
            gallery_svg(many, page=page)
    with pytest.raises(InputError):
        gallery_svg(many, moves=(9, 9))


def test_a_report_that_grows_too_large_is_cut(monkeypatch):
    monkeypatch.setattr(gallery, "MOST_CHARACTERS", 9_000)
    drawn = draw_tiles(logical_set(junction(), count=40))
    assert 0 < len(drawn.bodies) == len(drawn.shown) < 40
    assert sum(map(len, drawn.bodies)) <= 9_000


def test_moves_are_counted_where_they_repeat():
    assert moves_words((1, 2, 2, 3)) == "1 2 2 3"
    assert moves_words((2,) * 10 + (3,)) == "10×2 3"
    assert moves_words(()) == "–"


def test_conflicts_are_marked_where_the_ways_meet():
    lines = {
        "a": [(-50.0, 0.0), (50.0, 0.0)],
        "b": [(10.0, -50.0), (10.0, 50.0)],
        "c": [(-50.0, 30.0), (20.0, 4.0), (50.0, 4.0)],
    }
    met = [
        Conflict(first="a", second="b", kind="crossing"),
        Conflict(first="c", second="a", kind="merging"),
        Conflict(first="a", second="nobody", kind="crossing"),
        Conflict(first="b", second="c", kind="diverging"),
    ]
    (ring, at), (diamond, where) = conflict_points(met, lines)
    assert (ring, at) == ("crossing", (10.0, 0.0))
    assert diamond == "merging"
    assert where == pytest.approx((50.0, 4.0)) or where == pytest.approx((20.0, 4.0))


def test_an_empty_set_is_a_picture_too():
    etree.fromstring(gallery_svg(logical_set(junction(), count=0)).encode())


@pytest.mark.parametrize(("side", "sign"), [(DrivingSide.RIGHT, 1), (DrivingSide.LEFT, -1)])
def test_arrows_keep_to_their_side_and_end_at_their_exit(side, sign):
    at = junction(driving_side=side)
    plan = make_plan(at)
    way = drive_line(plan, drive("ego", 0, 2, at), 0.0, 0)  # from the east to the west
    (x0, y0), (x1, y1) = way[0], way[-1]
    assert x0 > 50 > -50 > x1
    assert y0 * sign > 0  # who keeps right and heads west drives north of the centre line
    assert y1 * sign > 0
    tip, *_ = arrow_head(way, 8.0)
    assert tip[0] < x1


@pytest.mark.parametrize(("side", "sign"), [(DrivingSide.RIGHT, 1), (DrivingSide.LEFT, -1)])
@pytest.mark.parametrize("move", [0, 1, 2, 3])
def test_rings_are_driven_round_in_driving_direction(side, sign, move):
    at = junction(JunctionKind.ROUNDABOUT, driving_side=side)
    plan = make_plan(at)
    way = drive_line(plan, drive("ego", 0, move, at), 0.0, 0)
    angles = [atan2(y, x) for x, y in way]
    steps = [(b - a + pi) % (2 * pi) - pi for a, b in pairwise(angles)]
    assert min(step * sign for step in steps) > -0.01  # never back
    swept = sum(steps) * sign
    wanted = (sign * move * pi / 2) % (2 * pi) or 2 * pi
    assert swept == pytest.approx(wanted, abs=0.35)


def test_more_lanes_and_queues_stay_on_the_tile():
    at = junction(lanes=(3, 1, 2, 1))
    plan = make_plan(at)
    for behind in range(6):
        x, y = drive_line(plan, drive("a", 0, 1, at), 4.0, behind)[0]
        assert plan.inner <= abs(x) <= 120
        assert abs(y) <= plan.half(0) + 5


def test_pedestrians_start_on_their_side_and_cars_stand_on_theirs():
    plan = make_plan(junction())
    (_, y0), (_, y1) = crossing_line(plan, Crossing(participant="p", arm=0, start=Side.RIGHT), 0)
    assert y0 > plan.half(0) > -plan.half(0) > y1  # entering from the east, right is north
    box = standing_box(plan, Standing(participant="v", arm=0, side=Side.LEFT), 0)
    assert all(y < -plan.half(0) for _, y in box)
    blocking = standing_box(plan, Standing(participant="v", arm=0, in_lane=True), 0)
    assert all(0 < y < plan.half(0) + 1 for _, y in blocking)


def test_overtaking_swings_out_and_back():
    at = junction(JunctionKind.STRAIGHT)
    way = drive_line(make_plan(at), drive("ego", 0, 1, at, maneuver=Maneuver.OVERTAKE), 0.0, 0)
    ys = [y for _, y in way]
    assert ys[0] == pytest.approx(ys[-1])
    assert min(ys) < 0 < ys[0]
