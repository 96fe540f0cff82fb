"""The report: one HTML file that opens offline and shows every step from words to files."""

from __future__ import annotations

from base64 import b64encode
from dataclasses import dataclass
from urllib.parse import quote

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from scegen.report.contents import CheckRow, ConcreteEntry, ReportInput
from scegen.report.danger import danger_tables
from scegen.report.evidence import field_rows, field_words, left_out, spans
from scegen.report.gallery import Tiles, counted, draw_tiles, summary
from scegen.report.judgement import judgement_tables
from scegen.report.tables import Table, tables
from scegen.report.tile import tile_svg
from scegen.report.words import hazard_words
from scegen.scenario.logical import LogicalSet
from scegen.understanding import Standing

__all__ = ["CheckRow", "ConcreteEntry", "ReportInput", "report_html"]

_LEGEND = {
    Standing.UNDERSTOOD: "said in the text",
    Standing.INFERRED: "concluded from the text",
    Standing.ASSUMED: "not said: a default",
    Standing.CONTRADICTED: "said or read in two ways",
    Standing.UNSUPPORTED: "understood, but not expressible",
}
_GOOD, _BAD = frozenset({"passed", "ok"}), frozenset({"failed", "error"})


def report_html(report: ReportInput) -> str:
    """The report as an HTML document; the same input gives the same text."""
    environment = Environment(
        loader=PackageLoader("scegen.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["field"] = field_words
    functional = report.functional
    disagreements = report.voice.disagreements if report.voice else ()
    descriptions = [entry.concrete.description for entry in report.concretes]
    return environment.get_template("report.html.j2").render(
        functional=functional,
        description=functional.description if functional else (descriptions or [""])[0],
        spans=spans(functional, disagreements) if functional else [],
        left=left_out(functional) if functional else [],
        fields=field_rows(functional) if functional else [],
        legend={str(kind): words for kind, words in _LEGEND.items()},
        gallery=_gallery(report.logical_set, report.tiles) if report.logical_set else None,
        concretes=[_concrete(entry) for entry in report.concretes],
        skipped=report.skipped,
        voice=report.voice,
    )


@dataclass(frozen=True, slots=True)
class _Gallery:
    title: str
    summary: str
    method: str
    notes: tuple[str, ...]
    junction: Markup
    tiles: tuple[Markup, ...]
    missing: int


def _gallery(logical_set: LogicalSet, tiles: Tiles | None) -> _Gallery:
    tiles = tiles or draw_tiles(logical_set)
    functional = logical_set.functional
    count = max(len(logical_set.scenarios), logical_set.certificate.count)
    pairs = zip(tiles.shown, tiles.bodies, strict=True)
    return _Gallery(
        counted(count, "logical scenario"),
        summary(logical_set),
        logical_set.certificate.method,
        logical_set.notes,
        # The tiles escape what comes from outside themselves.
        Markup(tiles.junction),  # noqa: S704
        tuple(Markup(tile_svg(s, functional, body)) for s, body in pairs),  # noqa: S704
        count - len(tiles.shown),
    )


@dataclass(frozen=True, slots=True)
class _Concrete:
    name: str
    anchor: str
    facts: str
    image: str
    alt: str
    hazards: tuple[str, ...]
    tables: tuple[Table, ...]
    files: tuple[tuple[str, str], ...]
    checks: tuple[tuple[CheckRow, str], ...]
    plots: Markup
    judgement: tuple[Table, ...]


def _concrete(entry: ConcreteEntry) -> _Concrete:
    concrete = entry.concrete
    who = ", ".join(p.id for p in concrete.participants)
    names = ["road.xodr", "scenario.xosc", "concrete.yaml", "preview.png"]
    if entry.proof is not None:
        names.append("proof.json")
    return _Concrete(
        name=concrete.name,
        anchor=f"scenario-{concrete.name}",
        facts=(
            f"logical scenario {concrete.logical.index}, {concrete.duration_s:g} s, "
            f"seed {concrete.seed}"
        ),
        image=f"data:image/png;base64,{b64encode(entry.preview_png).decode()}",
        alt=f"Plan of the roads with the ways of {who}",
        hazards=tuple(hazard_words(hazard) for hazard in concrete.hazards),
        tables=tuple(tables(concrete)),
        files=tuple((name, quote(f"{entry.folder}/{name}")) for name in names),
        checks=tuple((row, _verdict(row.status)) for row in entry.checks),
        plots=Markup(entry.plots_svg),  # noqa: S704 - escapes what comes from outside itself
        judgement=(
            *danger_tables(entry.proof),
            *judgement_tables(entry.verdict, entry.sensitivity),
        ),
    )


def _verdict(status: str) -> str:
    word = status.lower()
    if word in _GOOD:
        return "good"
    return "bad" if word in _BAD else "open"
