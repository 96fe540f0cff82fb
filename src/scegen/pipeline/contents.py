"""What lies in an output folder beside the scenarios: the levels, pictures, report, summary."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING

from scegen import __version__
from scegen.checking import CheckReport, CheckResult
from scegen.checking.subject import FUNCTIONAL_FILE
from scegen.pipeline.command import Recipe
from scegen.pipeline.folder import SUMMARY_FILE, digest
from scegen.pipeline.judging import Judged
from scegen.pipeline.raising import proof_summary
from scegen.pipeline.source import LOGICAL_FILE
from scegen.report.contents import CheckRow, ConcreteEntry, ReportInput
from scegen.report.gallery import Tiles, draw_tiles, gallery_svg
from scegen.report.html import report_html
from scegen.report.player.scene import scene_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import to_json, to_yaml
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.scenario.proof import Proof

if TYPE_CHECKING:  # what speaks to language models takes a tenth of a short run to load
    from scegen.llm import Usage
    from scegen.understanding.agents import Understanding


@dataclass(frozen=True, slots=True)
class Made:
    """A concrete scenario with its files, checks, judgement and proof, and its first timing."""

    concrete: ConcreteScenario
    files: dict[str, bytes]
    checks: CheckReport
    judged: Judged
    proof: Proof | None = None
    first: ConcreteScenario | None = None


def folder_files(
    functional: FunctionalScenario | None,
    logical: LogicalSet | None,
    made: list[Made],
    skipped: dict[str, str],
    seed: int,
    how: Recipe,
    understanding: Understanding | None = None,
    usage: Usage | None = None,
) -> dict[str, bytes]:
    """The files at the top of the output folder by name, the summary last.

    ``how`` makes the folder again; ``usage`` is what all stages took of language models together.
    """
    files: dict[str, bytes] = dict(how.kept)
    tiles: Tiles | None = None
    if functional is not None:
        files[FUNCTIONAL_FILE] = to_yaml(functional).encode()
    if logical is not None:
        files[LOGICAL_FILE] = to_json(logical).encode()
        tiles = draw_tiles(logical)
        files["gallery.svg"] = gallery_svg(logical).encode()
    told = tuple(skipped.items())
    report = ReportInput(functional, logical, _entries(made), told, understanding, tiles)
    files["report.html"] = report_html(report).encode()
    files[SUMMARY_FILE] = _summary(
        logical, made, skipped, seed, how, files, _models(understanding, usage)
    )
    return files


def _entries(made: list[Made]) -> tuple[ConcreteEntry, ...]:
    return tuple(
        ConcreteEntry(
            concrete=item.concrete,
            folder=f"scenarios/{item.concrete.name}",
            scene=scene_of(item.concrete, item.proof),
            before=None if item.first is None else scene_of(item.first, item.proof, first=True),
            checks=tuple(
                CheckRow(result.checker, result.status.value, _findings(result))
                for result in item.checks.results
            ),
            verdict=item.judged.verdict,
            sensitivity=item.judged.sensitivity,
            proof=item.proof,
            files=tuple(item.files),
        )
        for item in made
    )


def _models(understanding: Understanding | None, usage: Usage | None) -> dict[str, object]:
    """What ``summary.json`` says of language models; nothing where none were to be asked."""
    if understanding is None and usage is None:
        return {}
    said = {} if understanding is None else understanding.to_data()
    return {"llm": {**said, **(usage.to_data() if usage is not None else {})}}


def _findings(result: CheckResult) -> str:
    """What the checker says, in a line each."""
    lines = [result.detail] if result.detail else []
    lines += [f"{f.severity} {f.rule} at {f.place}: {f.message}" for f in result.findings]
    return "\n".join(lines)


def _summary(
    logical: LogicalSet | None,
    made: list[Made],
    skipped: dict[str, str],
    seed: int,
    how: Recipe,
    top: dict[str, bytes],
    models: dict[str, object],
) -> bytes:
    """No times and no paths: the same run gives the same bytes."""
    hashes = {name: digest(content) for name, content in top.items()}
    for item in made:
        folder = f"scenarios/{item.concrete.name}"
        hashes |= {f"{folder}/{name}": digest(content) for name, content in item.files.items()}
    summary = {
        "scegen": __version__,
        "seed": seed,
        "source": how.source,
        "options": how.options,
        "description": made[0].concrete.description,
        **models,
        "enumeration": logical
        and {
            "reduction": logical.reduction,
            "arms": logical.arms,
            **logical.certificate.model_dump(mode="json"),
        },
        "scenarios": [
            {
                "name": item.concrete.name,
                "folder": f"scenarios/{item.concrete.name}",
                "logical_index": item.concrete.logical.index,
                "checks": {r.checker: str(r.status) for r in item.checks.results},
                **proof_summary(item.proof),
                **item.judged.to_data(),
            }
            for item in made
        ],
        "skipped": skipped,
        "files": dict(sorted(hashes.items())),
    }
    return (json.dumps(summary, indent=2, ensure_ascii=False) + "\n").encode()
