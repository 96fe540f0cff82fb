"""ASAM's own checkers, run in their own environment; a rule that did not run is no pass.

No version of either standard is one for which all rules run. Of OpenSCENARIO 1.0, which the
players want, 5 of 17 run: a 1.2 twin of the scenario stands in. Of OpenDRIVE 1.7, 22 of 23
run, of 1.8 another 22: the same file is checked a second time with 1.8 in its header, for the
one rule that begins there.
"""

import subprocess
import tempfile
from collections.abc import Sequence
from copy import deepcopy
from importlib.resources import as_file, files
from pathlib import Path
from typing import NamedTuple

from lxml import etree

from scegen.checking.asam.xqar import merged, read_xqar
from scegen.checking.documents import parse_document
from scegen.checking.environment import ASAM_HINT, asam_python
from scegen.checking.results import CheckResult, error, not_run, verdict

OPENDRIVE, OPENSCENARIO = "asam-opendrive", "asam-openscenario"
TIMEOUT_S = 60.0
"""For starting; each file gets ``TIMEOUT_PER_FILE_S`` on top."""
TIMEOUT_PER_FILE_S = 20.0
RULES = {OPENDRIVE: 23, OPENSCENARIO: 17}
"""How many rules the pinned versions have: fewer in a result mean that it broke off."""
NEXT_MINOR = {"7": "8"}
"""OpenDRIVE files of this minor version are checked a second time as of that one."""


class Job(NamedTuple):
    """Files to check together: a road, and a scenario on it.

    ``scenario_note`` says what stands for the scenario (its 1.2 twin), or why nothing does.
    Without ``check_road`` the road only lies beside the scenario.
    """

    road: bytes | None = None
    scenario: bytes | None = None
    road_file: str = "road.xodr"
    scenario_note: str = ""
    check_road: bool = True


def run_asam(jobs: Sequence[Job]) -> list[list[CheckResult]]:
    """Check all jobs in one process; for each, the results of the checkers it has files for."""
    python = asam_python()
    if python is None:
        reason = f"the ASAM checkers are not installed; {ASAM_HINT}"
        return [[not_run(checker, reason) for checker in _checkers(job)] for job in jobs]
    with tempfile.TemporaryDirectory(prefix="scegen-asam-") as folder:
        places = [Path(folder, str(number)) for number in range(len(jobs))]
        lines = [line for job, place in zip(jobs, places, strict=True) for line in _lay(job, place)]
        problem = _run(python, lines) if lines else ""
        return [
            [_result(checker, place, job, problem) for checker in _checkers(job)]
            for job, place in zip(jobs, places, strict=True)
        ]


def _checkers(job: Job) -> list[str]:
    road = job.road if job.check_road else None
    given = ((OPENDRIVE, road), (OPENSCENARIO, job.scenario))
    return [checker for checker, content in given if content is not None]


def _lay(job: Job, place: Path) -> list[str]:
    place.mkdir()
    lines = []
    if job.road is not None:
        # The scenario names its road file; a path in that name is not followed.
        path = place / Path(job.road_file).name
        path.write_bytes(job.road)
        if job.check_road:
            lines.append(f"opendrive\t{path}\t{place / OPENDRIVE}.xqar")
            if later := _as_next_version(job.road):
                path = place / "later.xodr"
                path.write_bytes(later)
                lines.append(f"opendrive\t{path}\t{place / 'later'}.xqar")
    if job.scenario is not None:
        path = place / "scenario.xosc"
        path.write_bytes(job.scenario)
        lines.append(f"openscenario\t{path}\t{place / OPENSCENARIO}.xqar")
    return lines


def _as_next_version(road: bytes) -> bytes | None:
    root = deepcopy(parse_document("road", road, "OpenDRIVE").root)
    header = root.find("header")
    if header is None or header.get("revMinor", "") not in NEXT_MINOR:
        return None
    header.set("revMinor", NEXT_MINOR[header.get("revMinor", "")])
    return etree.tostring(root, xml_declaration=True, encoding="UTF-8")


def _run(python: Path, lines: list[str]) -> str:
    runner = files("scegen.checking").joinpath("data", "asam_runner.py")
    with as_file(runner) as script:
        try:
            done = subprocess.run(
                [str(python), "-I", str(script)],
                input="".join(f"{line}\n" for line in lines),
                capture_output=True,
                text=True,
                check=False,
                timeout=TIMEOUT_S + TIMEOUT_PER_FILE_S * len(lines),
            )
        except (OSError, subprocess.TimeoutExpired) as failure:
            return f"the ASAM checkers did not finish: {failure}"
    return done.stderr.strip().rsplit("\n", 1)[-1] if done.returncode else ""


def _result(checker: str, place: Path, job: Job, problem: str) -> CheckResult:
    first = read_xqar(place / f"{checker}.xqar")
    if not first:
        return verdict(checker, [error("asam.run", checker, problem or "wrote no result")])
    later = read_xqar(place / "later.xqar") if checker == OPENDRIVE else {}
    outcomes = merged(first, later)
    findings = [finding for outcome in outcomes for finding in outcome.findings()]
    if len(outcomes) < RULES[checker]:
        message = f"{len(outcomes)} rules instead of {RULES[checker]}"
        findings.append(error("asam.run", checker, message))
    note = f", {job.scenario_note}" if checker == OPENSCENARIO and job.scenario_note else ""
    completed = sum(outcome.completed for outcome in outcomes)
    detail = f"{completed} of {len(outcomes)} rules completed{note}"
    # A rule for other versions says nothing of this file: not its fault, but no pass.
    return verdict(checker, findings, detail)
