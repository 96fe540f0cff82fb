"""The page of a campaign: numbers, plots, coverage, what stands out, and every row to look up."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from markupsafe import Markup

from scegen.campaign.analysis.coverage import Coverage, good
from scegen.campaign.analysis.features import (
    CRITICAL_DISTANCE_M,
    CRITICAL_DRAC_MPS2,
    CRITICAL_PET_S,
    CRITICAL_TTC_S,
    Features,
    criticality,
    numbers_of,
)
from scegen.campaign.report.charts import bars, histogram
from scegen.campaign.report.unmet import unmet
from scegen.campaign.rows import MADE, MEASURES, SECONDS, Row
from scegen.report.one_file import as_json, asset, page
from scegen.report.theme import css
from scegen.units import parted

MOST_GROUPS = 10
_LISTED = ("description", "logical_name", "sweep", "junction", "movements", "conflict",
           "right_of_way", "ego_speed_mps", "pet_s", "distance_m", "ttc_s", "drac_mps2",
           "avoidable")  # fmt: skip
_DISTRIBUTIONS = (
    ("Post-encroachment time", "s", "pet_s", CRITICAL_PET_S),
    ("Smallest distance", "m", "distance_m", CRITICAL_DISTANCE_M),
    ("Time to collision", "s", "ttc_s", CRITICAL_TTC_S),
    ("Deceleration rate to avoid a crash", "m/s²", "drac_mps2", CRITICAL_DRAC_MPS2),
    ("Headway", "s", "headway_s", None),
    ("Speed of the ego at the start", "m/s", "ego_speed_mps", None),
    ("Speed of the other", "m/s", "other_speed_mps", None),
    ("Computing time", "s", SECONDS, None),
)


@dataclass(frozen=True)
class Outlook:
    """What stands out among good scenarios: rows by number."""

    critical: tuple[int, ...]
    different: tuple[int, ...]
    alike: tuple[tuple[int, ...], ...]


def outlook(rows: Sequence[Row], count: int) -> Outlook:
    """The most critical, the most different ones, and groups that are nearly the same.

    Of a logical scenario only the most critical one stands out, as long as there are others.
    """
    sound = [number for number, row in enumerate(rows) if good(row)]
    if not sound:
        return Outlook((), (), ())
    part = [rows[number] for number in sound]
    danger, features = criticality(part), Features.of(part)
    impact = np.nan_to_num(numbers_of(part, "impact_mps"))
    order = [sound[int(n)] for n in np.lexsort((np.arange(len(sound)), -impact, -danger))]
    worst: dict[tuple[str, str], int] = {}
    for number in order:
        worst.setdefault((rows[number]["description"], rows[number]["logical_name"]), number)
    different = features.most_different(count, sound.index(order[0]))
    return Outlook(
        tuple(dict.fromkeys([*worst.values(), *order]))[:count],
        tuple(sound[n] for n in different),
        tuple(tuple(sound[n] for n in group) for group in features.alike()),
    )


def campaign_page(
    rows: Sequence[Row],
    covered: Coverage,
    found: Outlook,
    links: Mapping[int, str],
    manifest: Mapping[str, Any],
) -> str:
    """The page as an HTML document; ``links`` are pages of the player by number of row."""
    danger = criticality(rows)
    content: dict[str, object] = {
        "facts": _facts(rows, covered, found),
        "plots": [
            # Our own drawings; what comes from outside is escaped there.
            Markup(plot)  # noqa: S704
            for title, unit, name, critical in _DISTRIBUTIONS
            if (plot := histogram(title, unit, numbers_of(rows, name), critical))
        ],
        "charts": [Markup(chart) for chart in _charts(rows) if chart],  # noqa: S704
        "cells": sorted(covered.counts.items()),
        "why_not": covered.why_not,
        "left_out": covered.left_out,
        **{
            name: [
                (_name(rows[n]), f"{danger[n]:.2f}", _measured(rows[n]), links.get(n))
                for n in numbers
            ]
            for name, numbers in (("critical", found.critical), ("different", found.different))
        },
        "alike": [
            (len(group), _name(rows[group[0]]), _measured(rows[group[0]]))
            for group in found.alike[:MOST_GROUPS]
        ],
        "ranges": covered.ranges,
        "unmet": [
            (heading, [(one, _name(rows[one.example]), links.get(one.example)) for one in listed])
            for heading, listed in unmet(rows).items()
        ],
        "manifest": manifest,
        "data": _data(rows, links),
    }
    style = css() + asset("scegen.report", "templates/report.css")
    style += asset(__package__, "templates/campaign.css")
    script = asset(__package__, "templates/campaign.js")
    return page(__package__, "campaign.html.j2", style, script, content)


def _facts(rows: Sequence[Row], covered: Coverage, found: Outlook) -> list[tuple[str, str]]:
    made = [row for row in rows if row["status"] == MADE]
    reached = sum(bool(row["reached"]) for row in made)
    said = sum(row["claims"] == row["claims_held"] for row in made)
    played = Counter(row["confirmed"] for row in made if row["confirmed"])
    cells = len(covered.counts) + len(covered.why_not)
    doubled = sum(len(group) - 1 for group in found.alike)
    parts = sum(ranged.covered for ranged in covered.ranges)
    facts = [
        ("descriptions", f"{len({row['description'] for row in rows}):,}"),
        ("scenarios made", f"{len(made):,} of {len(rows):,}"),
        ("all that is said holds", _share(said, len(made))),
        ("danger reached", _share(reached, len(made))),
        ("good (said, and no check fails)", _share(sum(map(good, made)), len(made))),
        ("covered", f"{len(covered.counts):,} of {cells:,} cells"),
        ("parts of parameters' ranges", _share(parts, sum(r.parts for r in covered.ranges))),
        ("nearly the same as another", _share(doubled, len(made))),
        ("computing time", f"{sum(row[SECONDS] or 0.0 for row in rows):,.0f} s"),
    ]
    if played:
        told = ", ".join(f"{count:,} {status}" for status, count in sorted(played.items()))
        facts.append(("played in esmini", told.replace("_", " ")))
    return facts


def _share(part: int, whole: int) -> str:
    return f"{part:,} of {whole:,} ({part / whole:.0%})" if whole else "none"


def _charts(rows: Sequence[Row]) -> list[str]:
    made = [row for row in rows if row["status"] == MADE]
    verdicts = ("avoidable", "unavoidable")
    by_junction = {
        str(kind).replace("_", " "): [
            sum(row["junction"] == kind and row["avoidable"] == verdict for row in made)
            for verdict in verdicts
        ]
        for kind in sorted({row["junction"] for row in made})
    }
    conflicts = Counter(
        f"{row['conflict'] or 'none'}: {row['right_of_way'] or '-'}" for row in made
    )
    dangers: dict[str, list[int]] = {}
    for row in made:
        missing = {hazard.partition("(")[0] for hazard in row["hazards_missing"] or ()}
        for kind in {hazard.partition("(")[0] for hazard in row["hazards"] or ()}:
            dangers.setdefault(kind.replace("_", " "), [0, 0])[kind in missing] += 1
    return [
        bars("A careful driver could have avoided it", by_junction, verdicts),
        bars("Conflict and rule of the pair", {n: [c] for n, c in conflicts.most_common(16)}, ()),
        bars(
            "Dangers", dict(sorted(dangers.items(), key=lambda d: -sum(d[1]))),
            ("happens", "does not"),
        ),
    ]  # fmt: skip


def _name(row: Row) -> str:
    point = ", ".join(f"{name}={value:g}" for name, value in row["sweep"] or ())
    told = str(row["description"])
    if row["logical_name"] is not None:
        told += f" {row['logical_name']} #{row['concretization']}"
    return told + (f" ({point})" if point else "")


def _measured(row: Row) -> str:
    """The measures that a row has, in words."""
    return ", ".join(
        f"{name.replace('_', ' ')} {row[column]:.2f} {parted(column)[1]}"
        for name, column in MEASURES.items()
        if row[column] is not None
    )


def _data(rows: Sequence[Row], links: Mapping[int, str]) -> Markup:
    """What the table of all rows shows, as JSON that ends no element."""
    listed = [
        [_shown(row[name]) for name in _LISTED]
        + [row["claims"] == row["claims_held"] and bool(row["reached"]), row["key"], links.get(n)]
        for n, row in enumerate(rows)
        if row["status"] == MADE
    ]
    heads = [name.replace("_mps2", ", m/s²").replace("_mps", ", m/s").replace("_", " ")
             for name in _LISTED]  # fmt: skip
    return as_json({"heads": heads, "rows": listed})


def _shown(value: object) -> object:
    if isinstance(value, list):
        return ", ".join(f"{name}={number:g}" for name, number in value)
    return round(value, 2) if isinstance(value, float) else value
