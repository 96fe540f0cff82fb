"""One logical scenario as a picture: junction, arrows, number, symbolic moves."""

from __future__ import annotations

from html import escape
from math import cos, degrees, sin

from scegen.report.conflict_points import conflict_points
from scegen.report.plan import (
    REACH,
    Plan,
    Point,
    crossing_line,
    drive_line,
    make_plan,
    standing_box,
    walking_line,
)
from scegen.report.strokes import (
    MARK,
    MIDDLE,
    TEXT,
    arrow,
    box,
    conflict_mark,
    path_data,
    reverse_badge,
    walk,
)
from scegen.report.theme import LIGHT
from scegen.report.words import REVERSES
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Assignment, Crossing, Drive, LogicalScenario, Walking
from scegen.scenario.vocabulary import JunctionKind, Maneuver

TILE_WIDTH = 240
_PICTURE = 240
_LINE = 15
_NAME_CHARACTERS, _LINE_CHARACTERS = 16, 37
_ROAD, _KERB, _FAINT = "#d5d9df", "#a9b0ba", "#5b6675"


def tile_height(functional: FunctionalScenario) -> int:
    """Height of a tile: the picture, the caption, one line per participant."""
    picture = _PICTURE - 2 * _lift(make_plan(functional.junction))
    return picture + 30 + _LINE * len(functional.participants)


def _lift(plan: Plan) -> int:
    """What a road without a junction leaves free above and below it."""
    level = all(abs(sin(angle)) < 0.2 for angle in plan.angles)
    return 55 if plan.kind is JunctionKind.STRAIGHT and level else 0


def roads(functional: FunctionalScenario) -> str:
    """The junction alone: the same in every tile."""
    return _roads(make_plan(functional.junction), functional)


def tile_body(
    scenario: LogicalScenario, functional: FunctionalScenario, ground: str | None = None
) -> str:
    """The elements of a tile, in a frame of its own size with the origin at the top left.

    ``ground`` stands for the junction where many tiles refer to one drawing of it.
    """
    plan = make_plan(functional.junction)
    colour = LIGHT.colours((p.id for p in functional.participants), functional.ego.id)
    parts = [_roads(plan, functional) if ground is None else ground]
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
            line = lines[name] = drive_line(plan, assignment, spreads[name], behind)
            drawing = arrow(line, colour[name], ego=is_ego)
            if assignment.reverses is not None:
                badges.append(reverse_badge(line, colour[name]))
        elif isinstance(assignment, Crossing):
            line = lines[name] = crossing_line(plan, assignment, crossings)
            drawing = walk(line, colour[name])
            crossings += 1
        elif isinstance(assignment, Walking):
            line = lines[name] = walking_line(plan, assignment)
            drawing = walk(line, colour[name])
        else:
            drawing = box(standing_box(plan, assignment, standings), colour[name])
            standings += 1
        drawings.append((is_ego, drawing))
    parts += [d for is_ego, d in drawings if not is_ego]
    parts += [d for is_ego, d in drawings if is_ego]  # on top
    parts += badges
    parts += [conflict_mark(kind, at) for kind, at in conflict_points(scenario.conflicts, lines)]
    lift = _lift(plan)
    caption = _caption(scenario, functional, colour, _PICTURE - 2 * lift)
    return f'<g transform="translate(0 {-lift})">{"".join(parts)}</g>{caption}'


def tile_svg(
    scenario: LogicalScenario, functional: FunctionalScenario, body: str | None = None
) -> str:
    """A tile as a complete SVG element; ``body`` if it is drawn already."""
    height = tile_height(functional)
    label = escape(describe(scenario))
    drawn = tile_body(scenario, functional) if body is None else body
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {TILE_WIDTH} {height}" '
        f'role="img" aria-label="{label}" font-family="system-ui, sans-serif">'
        f"<title>{label}</title>{drawn}</svg>"
    )


def describe(scenario: LogicalScenario) -> str:
    """A scenario in one line of words."""
    ways = "; ".join(f"{a.participant} {way(a)}" for a in scenario.assignments)
    return f"Scenario {scenario.index}: {ways}"


def way(assignment: Assignment) -> str:
    """What one participant does, in a few words."""
    if isinstance(assignment, Drive):
        words = _words(assignment.turn)
        if assignment.maneuver is not assignment.turn:
            words = f"{_words(assignment.maneuver)}, {words}"
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


def _words(maneuver: Maneuver) -> str:
    return maneuver.replace("_", " ")


def _spreads(drives: tuple[Drive, ...]) -> dict[str, float]:
    """Sideways shifts that keep arrows on the same arm apart."""
    shared: dict[str, float] = {}
    for drive in drives:
        mates = [d.participant for d in drives if {d.entry, d.exit} & {drive.entry, drive.exit}]
        at, count = mates.index(drive.participant), len(mates)
        shared[drive.participant] = (at - (count - 1) / 2) * min(4.4, 9.0 / max(count - 1, 1))
    return shared


def _roads(plan: Plan, functional: FunctionalScenario) -> str:
    arms = range(len(plan.angles))
    layers = []
    for width, paint in ((3.0, _KERB), (0.0, _ROAD)):
        for arm in arms:
            half = plan.half(arm) + width / 2
            corners = [
                plan.at(arm, 0.0, half),
                plan.at(arm, REACH, half),
                plan.at(arm, REACH, -half),
                plan.at(arm, 0.0, -half),
            ]
            layers.append(f'<path d="{path_data(corners, closed=True)}" fill="{paint}"/>')
        if plan.kind is not JunctionKind.STRAIGHT:
            radius = plan.ring + plan.lane if plan.is_ring else _core(plan)
            layers.append(
                f'<circle cx="{MIDDLE}" cy="{MIDDLE}" r="{radius + width / 2:.1f}" '
                f'fill="{paint}"/>'
                f'fill="{paint}"/>'
            )
    if plan.is_ring:
        island = plan.ring - plan.lane
        layers.append(
            f'<circle cx="{MIDDLE}" cy="{MIDDLE}" r="{island:.1f}" fill="#eef1e6" '
            f'stroke="{_KERB}" stroke-width="1.5"/>'
        )
    for arm in arms:
        layers.append(_marks(plan, arm, crosswalk=arm in functional.junction.crosswalks))
        a = plan.angles[arm]
        x, y = (REACH + 9) * cos(a), (REACH + 9) * sin(a)
        layers.append(
            f'<text x="{x + MIDDLE:.1f}" y="{MIDDLE - y + 4:.1f}" text-anchor="middle" '
            f'font-size="11" fill="{_FAINT}">{arm}</text>'
        )
    return "".join(layers)


def _core(plan: Plan) -> float:
    return max(plan.half(arm) for arm in range(len(plan.angles)))


def _marks(plan: Plan, arm: int, *, crosswalk: bool) -> str:
    """The centre line, lane lines and crosswalk of an arm."""
    begin = plan.inner + (14.0 if crosswalk else 0.0)
    lines = [
        (
            f'<path d="{path_data([plan.at(arm, begin), plan.at(arm, REACH)])}" stroke="{MARK}" '
            'stroke-width="1.6" fill="none"/>'
        )
    ]
    for lane in range(1, plan.lanes[arm]):
        for sign in (-1, 1):
            ends = [plan.at(arm, d, sign * lane * plan.lane) for d in (begin, REACH)]
            lines.append(
                f'<path d="{path_data(ends)}" stroke="{MARK}" stroke-width="1" '
                'stroke-dasharray="5 5" fill="none"/>'
            )
    if crosswalk:
        middle = plan.inner + 10.0
        ends = [plan.at(arm, middle, sign * (plan.half(arm) - 1)) for sign in (-1, 1)]
        lines.append(
            f'<path d="{path_data(ends)}" stroke="{MARK}" stroke-width="9" '
            'stroke-dasharray="3 2.5" fill="none"/>'
        )
    return "".join(lines)


def _caption(
    scenario: LogicalScenario, functional: FunctionalScenario, colour: dict[str, str], top: int
) -> str:
    moves = " ".join(str(move) for move in scenario.pattern) or "–"
    size = f"  ×{scenario.class_size}" if scenario.class_size > 1 else ""
    y = top + 14
    lines = [
        (
            f'<text x="10" y="{y}" font-size="13" font-weight="700" fill="{TEXT}">'
            f"{scenario.index}</text>"
            f'<text x="{TILE_WIDTH - 10}" y="{y}" text-anchor="end" font-size="13" fill="{TEXT}">'
            f"moves {moves}{size}</text>"
        )
    ]
    for number, assignment in enumerate(scenario.assignments, start=1):
        name = assignment.participant
        at = y + number * _LINE + 2
        shown = _short(name, _NAME_CHARACTERS)
        did = _short(way(assignment), _LINE_CHARACTERS - len(shown))
        weight = "700" if name == functional.ego.id else "400"
        lines.append(
            f'<rect x="10" y="{at - 8}" width="9" height="9" rx="2" fill="{colour[name]}"/>'
            f'<text x="24" y="{at}" font-size="11.5" fill="{TEXT}">'
            f'<tspan font-weight="{weight}">{escape(shown)}</tspan> '
            f'<tspan fill="{_FAINT}">{escape(did)}</tspan></text>'
        )
    return "".join(lines)


def _short(text: str, longest: int) -> str:
    return text if len(text) <= longest else text[: longest - 1] + "…"


def arm_legend(functional: FunctionalScenario) -> str:
    """Which way the arms point, in words."""
    plan = make_plan(functional.junction)
    return ", ".join(f"{i} at {degrees(a):.0f}°" for i, a in enumerate(plan.angles))
