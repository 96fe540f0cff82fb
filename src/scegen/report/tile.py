"""One logical scenario as a picture: junction, arrows, number, symbolic moves."""

from itertools import groupby
from math import cos, degrees, sin

from scegen.report.conflict_points import conflict_points
from scegen.report.drawing import area, box, circle, element, group, letters, line, told
from scegen.report.plan import (
    REACH,
    RING,
    Plan,
    Point,
    auxiliary_area,
    crossing_line,
    drive_line,
    make_plan,
    standing_box,
    walking_line,
)
from scegen.report.raster import text_width
from scegen.report.strokes import (
    MIDDLE,
    arrow,
    conflict_mark,
    in_tile,
    reverse_badge,
    standing,
    walk,
)
from scegen.report.theme import LIGHT, Theme
from scegen.report.words import REVERSES, plain
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Assignment, Crossing, Drive, LogicalScenario, Walking
from scegen.scenario.roadway import AuxiliaryLane, Carriageway
from scegen.scenario.vocabulary import JunctionKind

TILE_WIDTH = 240
_PICTURE = 240
_LINE = 15
_NAME_WIDTH, _ROW_WIDTH = 96.0, 206.0
_CAPTION, _NUMBER, _MANY = 11.5, 13.0, 3
_BESIDE, _NUMBERED, _NUMBER_AT = 32.0, 16.0, 9.0
"""Room for who walks or stands beside a road, and for the number at its end; where that is."""
_SHOULDER = 9.0
_CORNERS = ((0.0, -1), (REACH, -1), (REACH, 1), (0.0, 1))


def tile_height(functional: FunctionalScenario) -> int:
    """Height of a tile: the picture, the caption, one line per participant."""
    above, below = _empty(make_plan(functional.junction))
    return _PICTURE - above - below + 30 + _LINE * len(functional.participants)


def _empty(plan: Plan) -> tuple[int, int]:
    """What the roads leave free at the top and at the bottom of the picture."""
    beside = max(plan.half(arm) for arm in range(len(plan.angles))) + _BESIDE
    if plan.is_ring:
        beside = max(beside, RING + plan.lane + _BESIDE / 2)
    up, down = (
        max(beside, *(_height(plan, arm, up=up) for arm in range(len(plan.angles))))
        for up in (True, False)
    )
    return int(max(MIDDLE - up, 0.0)), int(max(MIDDLE - down, 0.0))


def _height(plan: Plan, arm: int, *, up: bool) -> float:
    """How far an arm with its number reaches up, or down, from the middle."""
    angle = plan.angles[arm]
    along = sin(angle) if up else -sin(angle)
    corner = REACH * along + (plan.half(arm) + 2.0) * abs(cos(angle))
    return max(corner, (REACH + _NUMBER_AT) * along + _NUMBERED - _NUMBER_AT)


def roads(functional: FunctionalScenario, theme: Theme = LIGHT) -> str:
    """The junction alone: the same in every tile."""
    plan = make_plan(functional.junction)
    arms = range(len(plan.angles))
    layers = []
    beside = [(2 * _SHOULDER, theme.parking)] if plan.shoulder else []
    for wider, paint in (*beside, (3.0, theme.kerb), (0.0, theme.road)):
        for arm in arms:
            half = plan.half(arm) + wider / 2
            ends = ((0.0, half), (REACH, half), (REACH, -half), (0.0, -half))
            layers.append(area(in_tile(plan.at(arm, *end) for end in ends), paint))
        if plan.kind is not JunctionKind.STRAIGHT or plan.bends:
            radius = RING + plan.lane if plan.is_ring else max(plan.half(arm) for arm in arms)
            layers.append(circle(MIDDLE, MIDDLE, radius + wider / 2, paint))
    if aside := auxiliary_area(plan):
        layers.append(area(in_tile(aside), theme.road))
    if plan.is_ring:
        island = RING - plan.lane
        layers.append(
            circle(MIDDLE, MIDDLE, island, theme.ground, stroke=theme.kerb, stroke_width=1.5)
        )
    for arm in arms:
        layers.append(_marks(plan, arm, theme, crosswalk=arm in functional.junction.crosswalks))
        a = plan.angles[arm]
        ((x, y),) = in_tile([((REACH + _NUMBER_AT) * cos(a), (REACH + _NUMBER_AT) * sin(a))])
        layers.append(letters(str(arm), x, y + 4, 11, theme.text_soft, text_anchor="middle"))
    return "".join(layers)


def tile_body(
    scenario: LogicalScenario,
    functional: FunctionalScenario,
    ground: str | None = None,
    theme: Theme = LIGHT,
) -> str:
    """The elements of a tile, in a frame of its own size with the origin at the top left.

    ``ground`` stands for the junction where many tiles refer to one drawing of it.
    """
    plan = make_plan(functional.junction)
    colour = theme.colours((p.id for p in functional.participants), functional.ego.id)
    parts = [roads(functional, theme) if ground is None else ground]
    lines: dict[str, list[Point]] = {}
    crossings = standings = 0
    drawings: list[tuple[bool, str]] = []
    badges: list[str] = []
    drives = scenario.drives
    spreads = _spreads(drives)
    for assignment in scenario.assignments:
        name = assignment.participant
        is_ego = name == functional.ego.id
        if isinstance(assignment, Drive):
            behind = sum(d.entry == assignment.entry and d.rank > assignment.rank for d in drives)
            way_ = drive_line(plan, assignment, spreads[name], behind)
            lines[name] = way_
            drawing = arrow(way_, colour[name], theme, ego=is_ego)
            if assignment.reverses is not None:
                badges.append(reverse_badge(way_, colour[name], theme))
        elif isinstance(assignment, Crossing):
            way_ = lines[name] = crossing_line(plan, assignment, crossings)
            drawing = walk(way_, colour[name], theme)
            crossings += 1
        elif isinstance(assignment, Walking):
            way_ = lines[name] = walking_line(plan, assignment)
            drawing = walk(way_, colour[name], theme)
        else:
            drawing = standing(standing_box(plan, assignment, standings), colour[name], theme)
            standings += 1
        drawings.append((is_ego, drawing))
    parts += [drawn for _, drawn in sorted(drawings, key=lambda d: d[0])]  # the ego on top
    parts += badges
    parts += [
        conflict_mark(kind, at, theme) for kind, at in conflict_points(scenario.conflicts, lines)
    ]
    above, below = _empty(plan)
    caption = _caption(scenario, functional, colour, _PICTURE - above - below, theme)
    return group("".join(parts), transform=f"translate(0 {-above})") + caption


def tile_svg(
    scenario: LogicalScenario, functional: FunctionalScenario, body: str | None = None
) -> str:
    """A tile as a complete SVG element; ``body`` if it is drawn already."""
    label = describe(scenario)
    drawn = tile_body(scenario, functional) if body is None else body
    return element(
        "svg",
        element("title", told(label)) + drawn,
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {TILE_WIDTH} {tile_height(functional)}",
        role="img",
        aria_label=label,
        font_family="system-ui, sans-serif",
    )


def describe(scenario: LogicalScenario) -> str:
    """A scenario in one line of words."""
    ways = "; ".join(f"{a.participant} {way(a)}" for a in scenario.assignments)
    return f"Scenario {scenario.index}: {ways}"


def moves_words(pattern: tuple[int, ...]) -> str:
    """Moves as numbers; the same one many times in a row is counted."""
    runs = [(move, len(list(same))) for move, same in groupby(pattern)]
    words = [f"{n}×{move}" if n > _MANY else " ".join([str(move)] * n) for move, n in runs]
    return " ".join(words) or "–"


def way(assignment: Assignment) -> str:
    """What one participant does, in a few words."""
    if isinstance(assignment, Drive):
        words = plain(assignment.turn)
        if assignment.maneuver is not assignment.turn:
            words = f"{plain(assignment.maneuver)}, {words}"
        if assignment.reverses is not None:
            words = f"{REVERSES[assignment.reverses]}, {words}"
        return f"{assignment.entry} → {assignment.exit}, {words}"
    if isinstance(assignment, Crossing):
        return f"crosses {assignment.arm} from {assignment.start}"
    if isinstance(assignment, Walking):
        return f"walks along {assignment.arm}, {assignment.side}, {assignment.heading}"
    if assignment.in_lane:
        return f"blocks arm {assignment.arm}"
    return f"stands at {assignment.arm}, {assignment.side}"


def _spreads(drives: tuple[Drive, ...]) -> dict[str, float]:
    """Sideways shifts that keep arrows on the same arm apart."""
    shared: dict[str, float] = {}
    for drive in drives:
        mates = [d.participant for d in drives if {d.entry, d.exit} & {drive.entry, drive.exit}]
        at, count = mates.index(drive.participant), len(mates)
        shared[drive.participant] = (at - (count - 1) / 2) * min(4.4, 9.0 / max(count - 1, 1))
    return shared


def _marks(plan: Plan, arm: int, theme: Theme, *, crosswalk: bool) -> str:
    """The centre line, lane lines and crosswalk of an arm."""
    begin = plan.inner + (14.0 if crosswalk else 0.0)

    def along(aside: float, width: float, dashes: str | None) -> str:
        ends = in_tile(plan.at(arm, d, aside) for d in (begin, REACH))
        return line(ends, theme.mark, width, stroke_dasharray=dashes)

    one_way = plan.carriageway is Carriageway.ONE_WAY
    marks = [] if one_way else [along(0.0, 1.6, None)]
    if plan.median:
        ends = [plan.at(arm, d, a * plan.median) for d, a in _CORNERS]
        marks = [area(in_tile(ends), theme.ground)]
    for lane in range(1, plan.lanes[arm]):
        aside = plan.aside(arm, lane) + plan.lane / 2
        marks += [along(sign * aside, 1.0, "5 5") for sign in ((1,) if one_way else (-1, 1))]
    if plan.auxiliary is not None and arm == 0:
        far = REACH if plan.auxiliary is AuxiliaryLane.LANE_DROP else 0.3 * REACH
        sense = -1.0 if plan.auxiliary is AuxiliaryLane.OFF_RAMP else 1.0
        ends = [plan.at(0, sense * d, plan.side * plan.half(0)) for d in (far, -0.45 * REACH)]
        marks.append(line(in_tile(ends), theme.mark, 1.0, stroke_dasharray="3 3"))
    if crosswalk:
        half = plan.half(arm) - 1
        ends = in_tile(plan.at(arm, plan.inner + 10.0, aside) for aside in (-half, half))
        marks.append(line(ends, theme.mark, 9, stroke_dasharray="3 2.5"))
    return "".join(marks)


def _caption(
    scenario: LogicalScenario,
    functional: FunctionalScenario,
    colour: dict[str, str],
    top: int,
    theme: Theme,
) -> str:
    size = f" ×{scenario.class_size}" if scenario.class_size > 1 else ""
    moves = f"moves {moves_words(scenario.pattern)}{size}"
    y = top + 14
    right = TILE_WIDTH - 10
    drawn = [
        letters(str(scenario.index), 10, y, _NUMBER, theme.text, bold=True),
        letters(moves, right, y, _NUMBER, theme.text, text_anchor="end"),
    ]
    for row, assignment in enumerate(scenario.assignments, start=1):
        name = assignment.participant
        at, bold = y + row * _LINE + 2, name == functional.ego.id
        shown = _short(name, _NAME_WIDTH, bold=bold)
        room = _ROW_WIDTH - text_width(f"{shown} ", _CAPTION, bold=bold)
        drawn.append(box(10, at - 8, 9, 9, colour[name], rx=2))
        drawn.append(letters(shown, 24, at, _CAPTION, theme.text, bold=bold))
        did = _short(way(assignment), room)
        drawn.append(letters(did, 24 + _ROW_WIDTH - room, at, _CAPTION, theme.text_soft))
    return "".join(drawn)


def _short(text: str, room: float, *, bold: bool = False) -> str:
    """As much of a text as fits."""
    shown = text
    while text_width(shown, _CAPTION, bold=bold) > room:
        shown = shown.removesuffix("…")[:-1] + "…"
    return shown


def arm_legend(functional: FunctionalScenario) -> str:
    """Which way the arms point, in words."""
    plan = make_plan(functional.junction)
    return ", ".join(f"{i} at {degrees(a):.0f}°" for i, a in enumerate(plan.angles))
