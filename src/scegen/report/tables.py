"""A concrete scenario as the rows of the report's tables."""

from dataclasses import dataclass

from scegen.report.words import (
    lane_change_words,
    name_words,
    phase_words,
    plain,
    right_of_way_words,
    speed_words,
)
from scegen.scenario.concrete import (
    Change,
    ConcreteScenario,
    CrossingMotion,
    DriveMotion,
    StandingMotion,
)
from scegen.scenario.environment import Environment
from scegen.scenario.parameters import ParameterRange

Row = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """A table: its title, its column heads, its rows."""

    title: str
    heads: Row
    rows: tuple[Row, ...]


def tables(concrete: ConcreteScenario) -> list[Table]:
    """All parameters of a scenario; tables without rows are left out."""
    made = [
        _roads(concrete),
        _vehicles(concrete),
        _speed_programs(concrete),
        _lane_changes(concrete),
        _crossers(concrete),
        _standing(concrete),
        _things(concrete),
        _conflicts(concrete),
        _environment(concrete.environment),
        _parameters(concrete),
        _provenance(concrete),
    ]
    return [table for table in made if table.rows]


def _m(value: float) -> str:
    return f"{value:.1f} m"


def _roads(concrete: ConcreteScenario) -> Table:
    road = concrete.road
    rows = tuple(
        (
            str(arm.id),
            _m(arm.length_m),
            f"{arm.angle_deg:.1f}°",
            f"{arm.angle_to_previous_deg:.1f}°",
            str(arm.lanes_out),
            str(arm.lanes_in),
            f"{arm.lane_width_m:.2f} m",
            speed_words(arm.speed_limit_mps),
        )
        for arm in road.arms
    )
    # The road runs towards the junction: in right-hand traffic its left lanes lead away.
    left, right = ("Lanes left (out)", "Lanes right (in)")
    if road.driving_side == "left":
        left, right = ("Lanes right (out)", "Lanes left (in)")
    heads = ("Road", "Length", "Direction", "Angle to previous", left, right)
    title = f"Roads — {plain(road.kind)}, {plain(road.control)}, {road.driving_side}-hand traffic"
    return Table(title, (*heads, "Lane width", "Speed limit"), rows)


def _vehicles(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (
            name_words(p),
            plain(p.kind),
            speed_words(p.speed_mps),
            f"{motion.entry}",
            f"{motion.entry_lane}",
            _m(motion.start_m),
            _m(motion.turning_starts_m),
            _m(motion.turning_ends_m),
            f"{motion.exit}",
            f"{motion.exit_lane}",
            str(motion.ring_lane or "–"),
        )
        for p in concrete.participants
        if isinstance(motion := p.motion, DriveMotion)
    )
    way = "Road, Lane, Initial position, Turning starts, Turning ends, Final road, Final lane"
    heads = ("Name", "Type", "Initial speed", *way.split(", "), "Ring lane")
    return Table("Vehicles — positions count from the outer end of the entry road", heads, rows)


def _speed_programs(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (p.id, str(number), phase_words(phase))
        for p in concrete.participants
        for number, phase in enumerate(p.speed_program, start=1)
    )
    return Table("Accelerations and braking", ("Who", "Step", "What"), rows)


def _lane_changes(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (p.id, lane_change_words(change))
        for p in concrete.participants
        if isinstance(p.motion, DriveMotion)
        for change in p.motion.lane_changes
    )
    return Table("Lane changes", ("Who", "What"), rows)


def _crossers(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (
            p.id,
            plain(p.kind),
            speed_words(p.speed_mps) if p.speed_mps else "waits",
            str(motion.arm),
            motion.start_side.value,
            _m(motion.from_junction_m),
            _m(motion.setback_m),
            "–" if motion.stops_after_m is None else _m(motion.stops_after_m),
        )
        for p in concrete.participants
        if isinstance(motion := p.motion, CrossingMotion)
    )
    way = "Road, From side, Before the junction, Set back, Stops after"
    return Table("Crossing the road", ("Name", "Type", "Initial speed", *way.split(", ")), rows)


def _standing(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (
            p.id,
            plain(p.kind),
            str(motion.arm),
            motion.side.value,
            _m(motion.from_junction_m),
            "in the lane" if motion.in_lane else "beside the lanes",
        )
        for p in concrete.participants
        if isinstance(motion := p.motion, StandingMotion)
    )
    heads = ("Name", "Type", "Road", "Side", "Before the junction", "Where")
    return Table("Standing vehicles", heads, rows)


def _things(concrete: ConcreteScenario) -> Table:
    rows = tuple(
        (
            thing.id,
            thing.what,
            thing.category.value,
            f"{thing.x_m:.1f}, {thing.y_m:.1f} m",
            f"{thing.heading_deg:.0f}°",
            f"{thing.length_m:g} × {thing.width_m:g} × {thing.height_m:g} m",
            ", ".join(plain(h.kind) for h in concrete.hazards if thing.id in h.by) or "–",
        )
        for thing in concrete.objects
    )
    heads = ("Name", "What", "Category", "Middle (east, north)", "Heading", "Size", "Danger")
    return Table("Things that do not take part", heads, rows)


def _conflicts(concrete: ConcreteScenario) -> Table:
    logical = concrete.logical
    rows = tuple((c.first, c.second, c.kind, right_of_way_words(c)) for c in logical.conflicts)
    title = "Whose paths meet, and who gives way"
    if logical.deadlock:
        title += f" — deadlock: {', '.join(logical.deadlock)} wait for each other"
    return Table(title, ("One", "Other", "Conflict", "Right of way"), rows)


def _environment(environment: Environment) -> Table:
    said = environment.model_dump(mode="json", exclude_none=True)
    rows = tuple((plain(name), plain(str(value))) for name, value in said.items())
    return Table("Weather and light", ("Condition", "Value"), rows)


def _parameters(concrete: ConcreteScenario) -> Table:
    chosen = {c.parameter: c.after for c in concrete.provenance if c.after is not None}

    def row(item: ParameterRange) -> Row:
        value = chosen.get(item.name, item.default)
        bounds = f"{item.low:g} – {item.high:g}"
        return (item.name, bounds, f"{item.default:g}", f"{value:g}", item.reason)

    rows = tuple(row(item) for item in concrete.logical.parameters)
    return Table("Parameter ranges", ("Parameter", "Range", "Default", "Chosen", "From"), rows)


def change_row(change: Change) -> Row:
    """What became of one number, by whom and why."""
    values = ("–" if value is None else f"{value:g}" for value in (change.before, change.after))
    rejected = f"{change.rejected.value}: {change.rejected.why}" if change.rejected else ""
    return (change.parameter, *values, change.by, change.reason, rejected)


def _provenance(concrete: ConcreteScenario) -> Table:
    heads = ("Parameter", "Before", "After", "By", "Why", "Rejected")
    return Table("Who set what", heads, tuple(map(change_row, concrete.provenance)))
