"""The report: one HTML file that opens offline, the moving picture first, every step behind it."""

from collections.abc import Iterator
from math import isfinite
from urllib.parse import quote

from markupsafe import Markup

from scegen.report.contents import ConcreteEntry, ReportInput
from scegen.report.danger import danger_tables, target_words
from scegen.report.evidence import STANDS_FOR, field_rows, field_words, left_out, spans
from scegen.report.gallery import Tiles, draw_tiles, groups, summary
from scegen.report.judgement import judgement_tables
from scegen.report.one_file import as_json, asset, page
from scegen.report.player.bundle import player_css, player_js
from scegen.report.tables import tables
from scegen.report.theme import css
from scegen.report.tile import tile_body, tile_svg
from scegen.report.words import hazard_words, plain
from scegen.scenario.logical import LogicalSet
from scegen.scenario.wording import counted

MOST_TILES_BYTES = 700_000
"""So much of the gallery lies in the report; ``scegen gallery`` pages through the rest."""


def report_html(report: ReportInput) -> str:
    """The report as an HTML document; the same input gives the same text."""
    functional = report.functional
    disagreements = report.voice.disagreements if report.voice else ()
    descriptions = [entry.concrete.description for entry in report.concretes]
    claims = [c for e in report.concretes[:1] if e.proof is not None for c in e.proof.claims]
    content: dict[str, object] = {
        "functional": functional,
        "description": functional.description if functional else (descriptions or [""])[0],
        "spans": spans(functional, disagreements, claims) if functional else [],
        "left": left_out(functional) if functional else [],
        "fields": field_rows(functional) if functional else [],
        "field": field_words,
        "legend": {str(kind): words for kind, words in STANDS_FOR.items()},
        "gallery": _gallery(report, report.logical_set) if report.logical_set else None,
        "concretes": [_concrete(entry) for entry in report.concretes],
        "skipped": report.skipped,
        "voice": report.voice,
    }
    style = css() + player_css() + asset(__package__, "templates/report.css")
    script = player_js() + asset(__package__, "templates/report.js")
    return page(__package__, "report.html.j2", style, script, content)


def _gallery(report: ReportInput, logical_set: LogicalSet) -> dict[str, object]:
    """The logical scenarios for the template: those that were made, then all in groups."""
    drawn = report.tiles or draw_tiles(logical_set)
    count = max(len(logical_set.scenarios), logical_set.certificate.count)
    pictures = _pictures(logical_set, drawn)
    functional = logical_set.functional
    made = {entry.concrete.logical.index: entry.concrete.logical for entry in report.concretes}
    return {
        "title": counted(count, "logical scenario"),
        "summary": summary(logical_set),
        "method": logical_set.certificate.method,
        "notes": logical_set.notes,
        # The tiles escape what comes from outside themselves.
        "junction": Markup(drawn.junction),  # noqa: S704
        "made": [
            Markup(tile_svg(s, functional, tile_body(s, functional, '<use href="#junction"/>')))  # noqa: S704
            for s in made.values()
        ],
        "groups": [
            {"title": title or "All", "tiles": [pictures[place] for place in members]}
            for title, places in groups(drawn.shown)
            if (members := [place for place in places if place < len(pictures)])
        ],
        "missing": count - len(pictures),
    }


def _pictures(logical_set: LogicalSet, drawn: Tiles) -> list[Markup]:
    """As many tiles as find room."""
    pictures: list[Markup] = []
    room = MOST_TILES_BYTES
    for scenario, body in zip(drawn.shown, drawn.bodies, strict=True):
        picture = Markup(tile_svg(scenario, logical_set.functional, body))  # noqa: S704
        room -= len(picture)
        if room < 0 and pictures:
            break
        pictures.append(picture)
    return pictures


def _concrete(entry: ConcreteEntry) -> dict[str, object]:
    """A concrete scenario for the template."""
    concrete = entry.concrete
    about = f"logical scenario {concrete.logical.index}, {concrete.duration_s:g} s, "
    return {
        "name": concrete.name,
        "anchor": f"scenario-{concrete.name}",
        "about": f"{about}seed {concrete.seed}",
        "facts": [{"verdict": verdict, "words": words} for verdict, words in _facts(entry)],
        "hazards": [hazard_words(hazard) for hazard in concrete.hazards],
        "scenes": as_json([entry.scene, entry.before]),
        "tables": tables(concrete),
        "files": [(name, quote(f"{entry.folder}/{name}")) for name in entry.files],
        "checks": [(row, row.verdict) for row in entry.checks],
        "judgement": danger_tables(entry.proof)
        + judgement_tables(entry.verdict, entry.sensitivity),
    }


def _facts(entry: ConcreteEntry) -> Iterator[tuple[str, str]]:
    """What anybody asks first: how it came out (held, failed, open), in words."""
    if (proof := entry.proof) is not None:
        if proof.claims:
            yield "failed" if proof.missed else "held", proof.held
        yield "held" if proof.in_band else "failed", target_words(proof)
    if entry.verdict is not None and isfinite(entry.verdict.distance_m):  # somebody decides it
        yield "open", f"a careful driver: {plain(entry.verdict.outcome)}"
    failed = [row.checker for row in entry.checks if row.verdict == "failed"]
    passed = [row for row in entry.checks if row.verdict == "held"]
    if failed:
        yield "failed", f"checks failed: {', '.join(failed)}"
    elif passed:
        yield "held", f"{counted(len(passed), 'check')} passed"
