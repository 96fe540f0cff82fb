"""One scenario of a campaign from its objects: read back, as a folder, as a page of the player."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from scegen.campaign.rows import FILE_COLUMNS
from scegen.campaign.store import Store, write_whole
from scegen.errors import InputError
from scegen.pipeline.folder import digest
from scegen.pipeline.judging import judge
from scegen.report.contents import CheckRow, ConcreteEntry, ReportInput
from scegen.report.html import report_html
from scegen.report.player.scene import scene_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import from_text
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof


def files_of(store: Store, row: Mapping[str, Any]) -> dict[str, bytes]:
    """The files of a scenario folder by name, each as it was made.

    Raises:
        InputError: one of them is missing or broken.
    """
    return {file: _sound(store, row[name]) for file, name in FILE_COLUMNS.items() if row[name]}


def _sound(store: Store, name: str) -> bytes:
    content = store.get(name)
    if digest(content) != name.partition(".")[0]:
        raise InputError(
            "is not what was written",
            where=str(store.object_path(name)),
            hint="run the campaign again: it is made anew",
        )
    return content


def page(store: Store, row: Mapping[str, Any], folder: str) -> str:
    """A page with the player; ``folder`` is where its files lie, seen from the page.

    Raises:
        InputError: a file is missing or broken.
    """
    functional = FunctionalScenario.model_validate_json(_sound(store, row["functional"]))
    text = _sound(store, row["concrete"]).decode()
    concrete = from_text(text, where=str(store.object_path(row["concrete"])))
    if not isinstance(concrete, ConcreteScenario):
        raise InputError("is no concrete scenario", where=str(row["concrete"]))
    proof = Proof.model_validate_json(_sound(store, row["proof"])) if row["proof"] else None
    findings = "\n".join(row["check_findings"] or ())
    judged = judge(concrete, proof)
    entry = ConcreteEntry(
        concrete=concrete,
        folder=folder,
        scene=scene_of(concrete, proof),
        checks=tuple(
            CheckRow(checker, status, findings if status == "failed" else "")
            for checker, status in sorted(dict(row["checks"] or ()).items())
        ),
        verdict=judged.verdict,
        sensitivity=judged.sensitivity,
        proof=proof,
        files=tuple(file for file, name in FILE_COLUMNS.items() if row[name]),
    )
    return report_html(ReportInput(functional, None, (entry,)))


def write_folder(store: Store, row: Mapping[str, Any], folder: Path) -> None:
    """Write the files of a scenario into a folder.

    Raises:
        InputError: a file is missing or broken, or the folder cannot be written.
    """
    for name, content in files_of(store, row).items():
        write_whole(folder / name, content, lasting=False)
