"""What a campaign covers, of what it planned, and why it does not cover the rest.

A cell is something that a scenario can show: how two movements meet on a kind of junction, in
which conflict and under which rule; a danger there; a band of speed of the ego or of who meets it.
It is covered by a scenario that shows it, in which all that is said holds and no check fails. So
is a part of a parameter's range: that of one concretization, or a point of a sweep.
"""

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import pyarrow.parquet as pq

from scegen.campaign.planning import LEFT_OUT
from scegen.campaign.rows import FAILED, MADE, Row, speed_cells
from scegen.campaign.store import Store


@dataclass(frozen=True, slots=True)
class Ranged:
    """One parameter of a description's scenarios: where it lies, and in how many parts of that."""

    described: str
    parameter: str
    low: float
    high: float
    parts: int
    covered: int


@dataclass(frozen=True)
class Coverage:
    """Cells with the rows that show them (by number), and why others are not covered.

    ``held`` has the cells of every row; none for one that is not good enough. ``left_out`` are
    cells of logical scenarios that were not picked, with how many scenarios show them. ``ranges``
    are parameters that take more than one value, those first of which most is left.
    """

    held: tuple[frozenset[str], ...]
    counts: Counter[str]
    why_not: dict[str, str]
    left_out: dict[str, int]
    ranges: tuple[Ranged, ...]


def coverage(store: Store, rows: Sequence[Row]) -> Coverage:
    """The coverage of the rows of a campaign."""
    held = tuple(
        frozenset({*(row["covered"] or ()), *speed_cells(row)} if good(row) else ()) for row in rows
    )
    counts = Counter(cell for cells in held for cell in cells)
    reasons: dict[str, Counter[str]] = {}
    for row in rows:
        for cell in row["cells"] or ():
            if cell not in counts:
                reasons.setdefault(cell, Counter())[_why(row, cell)] += 1
    why_not = {
        cell: f"{told.most_common(1)[0][0]} (in {told.most_common(1)[0][1]} of {told.total()})"
        for cell, told in sorted(reasons.items())
    }
    left_out: Counter[str] = Counter()
    for path in store.plans().values():
        metadata = pq.read_schema(path).metadata or {}
        left_out.update(json.loads(metadata.get(LEFT_OUT, b"{}")))
    beyond = {c: n for c, n in sorted(left_out.items()) if c not in counts and c not in why_not}
    return Coverage(held, counts, why_not, beyond, _ranges(rows))


def _ranges(rows: Sequence[Row]) -> tuple[Ranged, ...]:
    """What there is of every parameter in any row, and what in a good one."""
    every: dict[tuple[str, str], dict[tuple[float, float], bool]] = {}
    for row in rows:
        shown = good(row)
        for name, (low, high) in row["ranges"] or ():
            parts = every.setdefault((row["description"], name), {})
            parts[low, high] = parts.get((low, high), False) or shown
    found = [
        Ranged(
            *named, min(parts)[0], max(high for _, high in parts), len(parts), sum(parts.values())
        )
        for named, parts in every.items()
    ]
    varied = (ranged for ranged in found if ranged.high > ranged.low)
    return tuple(sorted(varied, key=lambda r: (r.covered / r.parts, r.described, r.parameter)))


def good(row: Row) -> bool:
    """Whether a scenario is what was said, and no check of it failed."""
    return (
        row["status"] == MADE
        and row["claims"] == row["claims_held"]
        and "failed" not in dict(row["checks"] or ()).values()
        and row["confirmed"] != "failed"
    )


def _why(row: Row, cell: str) -> str:
    """Why a row does not cover a cell that it was to show."""
    if row["status"] == FAILED:
        return f"it cannot be made: {str(row['reason']).partition(chr(10))[0]}"
    if cell not in (row["covered"] or ()):
        return f"the danger does not happen: {row['blocked_by'] or 'no numbers do it'}"
    if row["claims_missed"]:
        return f"not as it is said: {row['claims_missed'][0]}"
    return f"a check fails: {(row['check_findings'] or ['in the player'])[0]}"
