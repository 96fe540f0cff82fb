"""The report: one HTML file that opens offline, the moving picture first, every step behind it."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Iterator
from hashlib import sha256
from importlib.resources import files
from urllib.parse import quote

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from scegen.report.contents import CheckRow, ConcreteEntry, ReportInput
from scegen.report.danger import danger_tables, target_words
from scegen.report.evidence import field_rows, field_words, left_out, spans
from scegen.report.gallery import Tiles, draw_tiles, groups, summary
from scegen.report.judgement import judgement_tables
from scegen.report.player.bundle import player_css, player_js
from scegen.report.tables import tables
from scegen.report.theme import css
from scegen.report.tile import tile_body, tile_svg
from scegen.report.words import hazard_words, plain
from scegen.scenario.logical import LogicalSet
from scegen.scenario.wording import counted
from scegen.understanding import Standing

__all__ = ["CheckRow", "ConcreteEntry", "ReportInput", "report_html"]

MOST_TILES_BYTES = 700_000
"""So much of the gallery lies in the report; ``scegen gallery`` pages through the rest."""
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
    script = player_js() + _asset("report.js")
    claims = [c for e in report.concretes[:1] if e.proof is not None for c in e.proof.claims]
    return environment.get_template("report.html.j2").render(
        functional=functional,
        description=functional.description if functional else (descriptions or [""])[0],
        spans=spans(functional, disagreements, claims) if functional else [],
        left=left_out(functional) if functional else [],
        fields=field_rows(functional) if functional else [],
        legend={str(kind): words for kind, words in _LEGEND.items()},
        gallery=_gallery(report) if report.logical_set else None,
        concretes=[_concrete(entry) for entry in report.concretes],
        skipped=report.skipped,
        voice=report.voice,
        # All three are our own; what comes from outside reaches the script as data only.
        style=Markup(css() + player_css() + _asset("report.css")),  # noqa: S704
        script=Markup(script),  # noqa: S704
        digest=b64encode(sha256(f"\n{script}".encode()).digest()).decode(),
    )


def _asset(name: str) -> str:
    return files("scegen.report").joinpath("templates", name).read_text(encoding="utf-8")


def _gallery(report: ReportInput) -> dict[str, object] | None:
    """The logical scenarios for the template: those that were made, then all in groups."""
    logical_set = report.logical_set
    if logical_set is None:
        return None
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
    return {
        "name": concrete.name,
        "anchor": f"scenario-{concrete.name}",
        "about": (
            f"logical scenario {concrete.logical.index}, {concrete.duration_s:g} s, "
            f"seed {concrete.seed}"
        ),
        "facts": [{"verdict": verdict, "words": words} for verdict, words in _facts(entry)],
        "hazards": [hazard_words(hazard) for hazard in concrete.hazards],
        "scenes": _data([entry.scene, entry.before]),
        "tables": tables(concrete),
        "files": [(name, quote(f"{entry.folder}/{name}")) for name in entry.files],
        "checks": [(row, _verdict(row.status)) for row in entry.checks],
        "judgement": [
            *danger_tables(entry.proof),
            *judgement_tables(entry.verdict, entry.sensitivity),
        ],
    }


def _facts(entry: ConcreteEntry) -> Iterator[tuple[str, str]]:
    """What anybody asks first: how it came out (held, failed, open), in words."""
    if (proof := entry.proof) is not None:
        if proof.claims:
            yield "failed" if proof.missed else "held", proof.held
        yield "held" if proof.in_band else "failed", target_words(proof)
    if entry.verdict is not None:
        yield "open", f"a careful driver: {plain(entry.verdict.outcome)}"
    failed = [row.checker for row in entry.checks if _verdict(row.status) == "failed"]
    passed = [row for row in entry.checks if _verdict(row.status) == "held"]
    if failed:
        yield "failed", f"checks failed: {', '.join(failed)}"
    elif passed:
        yield "held", f"{counted(len(passed), 'check')} passed"


def _data(value: object) -> Markup:
    """JSON that ends no element, whatever words it holds."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    for sign in "<>&\u2028\u2029":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return Markup(text)  # noqa: S704 - no markup is left in it


def _verdict(status: str) -> str:
    word = status.lower()
    if word in _GOOD:
        return "held"
    return "failed" if word in _BAD else "open"
