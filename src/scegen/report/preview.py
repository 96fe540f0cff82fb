"""A picture of one concrete scenario: real roads, real boxes, the moment that matters.

Where traffic goes along a road, panels as wide as the picture lie one below the other: the whole
stretch, the start, the closest approach. Elsewhere the closest approach stands beside the whole.
"""

from collections.abc import Iterable, Mapping

import numpy as np

from scegen.criticality.encounter import Encounter, closest_encounter
from scegen.motion import simulate
from scegen.motion.model import Array, Path, Trace
from scegen.report.drawing import box, document, letters
from scegen.report.raster import wrapped
from scegen.report.stage import Stage, make_stage, moment, overview
from scegen.report.theme import LIGHT
from scegen.report.words import hazard_words, name_words, participant_words, thing_words
from scegen.report.world import View, thing_corners
from scegen.road.model import RoadNetwork
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.vocabulary import HazardKind, JunctionKind

WIDTH = 900.0
_GAP = 8.0
_LINE, _SIZE, _ONE_COLUMN = 18.0, 12.0, 5
_ALONG = 2.4
"""Traffic so many times as long as wide goes along a road."""
_MARGIN_M, _MARGIN, _VERGE_M, _SMALLEST_M, _AFTER_S = 8.0, 0.05, 2.0, 40.0, 2.5
_BAND_PX = (64.0, 300.0)
_CLEAR_PX_PER_M = 9.0
"""Drawn larger than this, a picture needs no close-up."""
_MOMENT_M, _START_M, _STRIP_PX = 70.0, 170.0, 260.0
_COLUMN, _WHOLE_PX, _LONGER_PX = 290.0, (300.0, 560.0), 120.0
_CLOSE_M = 20.0
_FAR_M = 45.0
"""Two farther apart than this at their closest have nothing to be enlarged."""


def preview_svg(
    concrete: ConcreteScenario,
    network: RoadNetwork,
    paths: Mapping[str, Path],
    traces: Mapping[str, Trace] | None = None,
) -> str:
    """The scenario as an SVG document, simulated here if need be; equal input gives equal text."""
    stage = make_stage(concrete, network, paths, traces or simulate(concrete, paths), LIGHT)
    encounter = closest_encounter(concrete, stage.traces)
    low, high = extent(stage, encounter)
    size = high - low
    layout = _along if size[0] > _ALONG * size[1] else _beside
    picture, height = layout(stage, encounter, (low + high) / 2, size)
    ground = box(0, 0, WIDTH, height, LIGHT.panel)
    who = ", ".join(p.id for p in concrete.participants)
    return document(WIDTH, height, ground + picture, title=f"Plan of the ways of {who}")


def extent(stage: Stage, encounter: Encounter | None) -> tuple[Array, Array]:
    """South-west and north-east corner (m) of where something happens, with a margin.

    What follows long after the closest approach is cut off. A plain road is shown from kerb to
    kerb.
    """
    traces = [stage.traces[p.id] for p in stage.concrete.participants]
    last = None if encounter is None else encounter.step + round(_AFTER_S / traces[0].step_s)
    points = [np.column_stack((t.x_m[:last], t.y_m[:last])) for t in traces]
    points += [thing_corners(thing) for thing in stage.concrete.objects]
    everything = np.concatenate(points)
    low, high = everything.min(axis=0), everything.max(axis=0)
    margin = max(_MARGIN_M, _MARGIN * float((high - low).max()))
    low, high = low - margin, high + margin
    if stage.concrete.road.kind is JunctionKind.STRAIGHT:
        south, north = stage.surroundings.across(float(low[0]), float(high[0]))
        low[1] = min(low[1] + margin, south) - _VERGE_M
        high[1] = max(high[1] - margin, north) + _VERGE_M
    return low, high


def _along(
    stage: Stage, encounter: Encounter | None, middle: Array, size: Array
) -> tuple[str, float]:
    """Panels below one another, notes at the end; with the height of it all."""
    width_m = float(max(size[0], _SMALLEST_M))
    scale = WIDTH / width_m
    height = float(np.clip(size[1] * scale, *_BAND_PX))
    whole = View(float(middle[0]), float(middle[1]), width_m, 0, 0, WIDTH, height)
    below = height + _GAP
    band = (float(middle[1]), float(size[1]))
    parts, framed = [], None
    if scale < _CLEAR_PX_PER_M:
        starts = [stage.box_of(p.id, 0) for p in stage.concrete.participants if not p.parked]
        if np.ptp(np.concatenate(starts)[:, 0]) < _START_M - 10:
            strip = _strip(np.concatenate(starts), band, below)
            if strip.scale > 1.5 * scale:
                parts.append(moment(stage, strip, 0, "start", None))
                below += strip.height + _GAP
        both = _pair(stage, encounter)
        if encounter is not None and both is not None:
            framed = _strip(both, band, below)
            parts.append(moment(stage, framed, encounter.step, _title(encounter), encounter))
            below += framed.height + _GAP
    parts.insert(0, overview(stage, whole, encounter, framed))
    notes, ends = _notes(stage, encounter, 14.0, below + 12, WIDTH - 28)
    return "".join([*parts, notes]), ends


def _strip(points: Array, band: tuple[float, float], top: float) -> View:
    """A view as wide as the picture of these points, on a band of so much north and south (m)."""
    low, high = points.min(axis=0), points.max(axis=0)
    width_m = max(float(high[0] - low[0]) + 24.0, _MOMENT_M)
    scale = WIDTH / width_m
    height = min(band[1] * scale, _STRIP_PX)
    reach = max(band[1] - height / scale, 0.0) / 2
    wanted = float(low[1] + high[1]) / 2
    y = min(max(wanted, band[0] - reach), band[0] + reach)
    return View(float(low[0] + high[0]) / 2, y, width_m, 0, top, WIDTH, height)


def _beside(
    stage: Stage, encounter: Encounter | None, middle: Array, size: Array
) -> tuple[str, float]:
    """The whole on the left, close-up and notes in a column on the right."""
    width = WIDTH - _COLUMN - _GAP
    height = float(np.clip(width * size[1] / size[0], *_WHOLE_PX))
    width_m = float(max(size[0], size[1] * width / height, _SMALLEST_M))
    x = WIDTH - _COLUMN
    close, framed, below = "", None, 0.0
    both = _pair(stage, encounter)
    if encounter is not None and both is not None:
        low, high = both.min(axis=0), both.max(axis=0)
        x_m, y_m = ((low + high) / 2).tolist()
        span = max(float((high - low).max()) + 6.0, _CLOSE_M)
        framed = View(x_m, y_m, span, x, 0, _COLUMN, _COLUMN)
        close = moment(stage, framed, encounter.step, _title(encounter), encounter)
        below = _COLUMN + _GAP
    notes, ends = _notes(stage, encounter, x + 4, below + 12, _COLUMN - 8)
    height = max(height, below - _GAP)
    if ends > height + _LONGER_PX:
        notes, ends = _notes(stage, encounter, 14.0, height + _GAP + 12, WIDTH - 28)
    whole = View(float(middle[0]), float(middle[1]), width_m, 0, 0, width, height)
    frame = framed if framed is not None and whole.scale < _CLEAR_PX_PER_M else None
    return overview(stage, whole, encounter, frame) + close + notes, max(ends, height)


def _pair(stage: Stage, encounter: Encounter | None) -> Array | None:
    """The corners of the ego and whom it meets; None where they never come close."""
    if encounter is None or encounter.distance_m > _FAR_M:
        return None
    names = (stage.concrete.ego.id, encounter.other)
    return np.concatenate([stage.box_of(name, encounter.step) for name in names])


def _title(encounter: Encounter) -> str:
    what = "contact" if encounter.distance_m <= 0.0 else "closest approach"
    return f"{what}, {encounter.time_s:.1f} s"


def _notes(
    stage: Stage, encounter: Encounter | None, x: float, y: float, width: float
) -> tuple[str, float]:
    """Who everybody is, what is dangerous, and where the notes end."""
    concrete, theme = stage.concrete, stage.theme
    parts: list[str] = []
    people = concrete.participants
    columns = 2 if len(people) > _ONE_COLUMN and width > _COLUMN * 2 else 1
    room, per_column = width / columns, -(-len(people) // columns)
    lowest = y
    for first in range(0, len(people), per_column):
        left, at = x + room * (first // per_column), y
        for participant in people[first : first + per_column]:
            who = f"{name_words(participant)}: {participant_words(participant)}"
            rows = wrapped(who, _SIZE, room - 24, 3)
            swatch = stage.colour[participant.id]
            parts.append(box(left, at - 9, 10, 10, swatch, rx=2, stroke=theme.outline))
            parts += _rows(rows, left + 18, at, theme.text)
            at += _LINE * len(rows)
        lowest = max(lowest, at)
    y = lowest
    lines = [(f"{thing.id}: {thing_words(thing)}", theme.text) for thing in concrete.objects]
    lines += [(note, theme.text_soft) for note in _remarks(concrete, encounter)]
    for words, ink in lines:
        rows = wrapped(words, _SIZE, width, 4)
        parts += _rows(rows, x, y, ink)
        y += _LINE * len(rows)
    return "".join(parts), y - 4


def _rows(rows: Iterable[str], x: float, y: float, ink: str) -> list[str]:
    return [letters(row, x, y + _LINE * n, _SIZE, ink) for n, row in enumerate(rows)]


def _remarks(concrete: ConcreteScenario, encounter: Encounter | None) -> list[str]:
    remarks = []
    if concrete.hazards:
        said = "Hazards: " + "; ".join(hazard_words(h) for h in concrete.hazards)
        kinds = {h.kind for h in concrete.hazards}
        remarks.append(f"{said} (dotted: backwards)" if HazardKind.REVERSING in kinds else said)
    if encounter is not None:
        apart = encounter.distance_m > 0
        how = f"is {encounter.distance_m:.1f} m from" if apart else "touches"
        when = f"at {encounter.time_s:.1f} s the ego {how} {encounter.other}"
        remarks.append(f"Closest approach (dashed boxes): {when}")
    return remarks
