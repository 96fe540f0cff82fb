"""All checkers on scenario folders and files."""

from collections.abc import Collection, Iterable, Iterator
from functools import partial
from pathlib import Path

from scegen.checking import asam, opendrive, openscenario, parameters, replay, said, schema
from scegen.checking import esmini as player
from scegen.checking.esmini.playing import play_once
from scegen.checking.opendrive.network import Network
from scegen.checking.results import (
    CheckReport,
    CheckResult,
    CheckStatus,
    error,
    not_run,
    unchecked,
    verdict,
)
from scegen.checking.subject import File, Subject, find_subjects, read_folder
from scegen.errors import ScegenError
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network

CHECKERS = (
    opendrive.CHECKER,
    openscenario.CHECKER,
    schema.CHECKER,
    asam.OPENDRIVE,
    asam.OPENSCENARIO,
    player.CHECKER,
    said.CHECKER,
)
"""All checkers, in the order of the reports."""
REPLAY = replay.CHECKER
"""Asked for by name only: it plays the file once more and needs concrete.yaml."""
QUICK_CHECKERS = tuple(name for name in CHECKERS if not name.startswith("asam"))
"""Without ASAM's, which cost more than all the rest together."""
UNSOUND = "the file was not handed on: it is not XML that can be trusted"
_STALE = unchecked(
    "said.file",
    "weather, lights and roads",
    "judged by concrete.yaml, which does not give this scenario file; generate it anew",
)


def check_folder(folder: Path, checkers: Collection[str] = CHECKERS) -> CheckReport:
    """Check one scenario folder: road.xodr, scenario.xosc, concrete.yaml.

    Raises:
        InputError: a file is missing or cannot be read.
    """
    return check_subjects([read_folder(folder)], checkers)[0]


def check_files(paths: Iterable[Path], checkers: Collection[str] = CHECKERS) -> list[CheckReport]:
    """Check scenario folders, folders of ``scegen generate`` and files, ASAM's rules at once.

    Raises:
        InputError: there is nothing to check, or a file cannot be read.
    """
    subjects = [subject for path in paths for subject in find_subjects(path)]
    return check_subjects(subjects, checkers)


def check_subjects(subjects: list[Subject], checkers: Collection[str]) -> list[CheckReport]:
    """Check what was found and read; one report each."""
    found = [_own(subject, checkers) for subject in subjects]
    for results, more in zip(found, _asam(subjects, checkers), strict=True):
        results.extend(more)
    order = {name: number for number, name in enumerate((*CHECKERS, REPLAY))}
    return [
        CheckReport(str(subject.place), tuple(sorted(results, key=lambda r: order[r.checker])))
        for subject, results in zip(subjects, found, strict=True)
    ]


def _own(subject: Subject, checkers: Collection[str]) -> list[CheckResult]:
    results: list[CheckResult] = []
    road, scenario = subject.road, subject.scenario
    network = None
    if road is not None:
        checked = opendrive.check_opendrive(road.name, road.content, subject.concrete)
        network = checked.network
        results.append(checked.result)
    if scenario is not None:
        results.append(
            openscenario.check_openscenario(
                scenario.name,
                scenario.content,
                road_file=road.name if road else None,
                network=network,
                concrete=subject.concrete,
            )
        )
        results += _played(subject, scenario, network, checkers)
    if subject.values is not None and player.CHECKER in checkers:
        results.append(parameters.check_values(subject.values.path, subject.values.content))
    if schema.CHECKER in checkers:
        results.append(schema.check_schema({file.name: file.content for file in subject.files}))
    return [result for result in results if result.checker in checkers]


def _played(
    subject: Subject, scenario: File, network: Network | None, checkers: Collection[str]
) -> Iterator[CheckResult]:
    """What needs the player: the file must be XML that it can be given."""
    asked = [name for name in (player.CHECKER, REPLAY, said.CHECKER) if name in checkers]
    if not asked:
        return
    if not scenario.sound or not (subject.road is None or subject.road.sound):
        yield from (not_run(name, UNSOUND) for name in asked)
        return
    outside = openscenario.driven_from_outside(scenario.name, scenario.content)
    once = play_once(scenario.path)
    if player.CHECKER in asked:
        yield player.check_esmini(
            scenario.path, network, subject.concrete, driven_from_outside=outside, once=once
        )
    if REPLAY in asked:
        if subject.concrete is None:
            yield not_run(REPLAY, "there is no concrete.yaml to predict from")
        elif outside:
            yield not_run(REPLAY, f"{min(outside)} is driven from outside: nothing is predicted")
        else:
            yield replay.check_replay(scenario.path, subject.concrete, once)
    if said.CHECKER in asked:
        judged = said.check_said(subject, scenario.path, outside, once)
        stale = judged.status is CheckStatus.PASSED and scenario.content not in _given(subject)
        yield verdict(said.CHECKER, [_STALE], judged.detail) if stale else judged


def _asam(subjects: list[Subject], checkers: Collection[str]) -> list[list[CheckResult]]:
    if asam.OPENDRIVE not in checkers and asam.OPENSCENARIO not in checkers:
        return [[] for _ in subjects]
    prepared = [_prepare(subject, checkers) for subject in subjects]
    ran = asam.run_asam([job for job, _ in prepared])
    return [known + results for (_, known), results in zip(prepared, ran, strict=True)]


def _prepare(subject: Subject, checkers: Collection[str]) -> tuple[asam.Job, list[CheckResult]]:
    """What ASAM's checkers get, and what is known without them.

    They check 5 of their 17 rules of OpenSCENARIO 1.0: a 1.2 twin stands for a scenario that is
    what was written as 1.0.
    """
    given = ((asam.OPENDRIVE, subject.road), (asam.OPENSCENARIO, subject.scenario))
    asked = {name: file for name, file in given if file is not None and name in checkers}
    results = [not_run(checker, UNSOUND) for checker, file in asked.items() if not file.sound]
    road = subject.road if subject.road and subject.road.sound else None
    scenario = asked.get(asam.OPENSCENARIO)
    scenario = scenario if scenario and scenario.sound else None
    job = asam.Job(
        road=road.content if road else None,
        scenario=scenario.content if scenario else None,
        road_file=subject.road_name,
        check_road=asam.OPENDRIVE in asked,
    )
    if scenario is None or subject.concrete is None:
        return job, results
    try:
        played, twin = _given(subject)
    except ScegenError as problem:
        failed = error("asam.twin", "concrete.yaml", f"cannot be built: {problem.message}")
        return job._replace(scenario=None), [*results, verdict(asam.OPENSCENARIO, [failed])]
    if twin == scenario.content:
        return job, results
    if played != scenario.content:
        note = "scenario.xosc is not what concrete.yaml gives, so no 1.2 twin speaks for it"
        return job._replace(scenario_note=note), results
    return job._replace(scenario=twin, scenario_note="on the 1.2 twin"), results


def _given(subject: Subject) -> Iterator[bytes]:
    """The scenario file that concrete.yaml gives: of OpenSCENARIO 1.0, then of 1.2.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    concrete, scenario = subject.concrete, subject.scenario
    if concrete is None or scenario is None:
        return
    outside = openscenario.driven_from_outside(scenario.name, scenario.content)
    write = partial(
        write_openscenario,
        concrete,
        build_paths(concrete, build_network(concrete.road)),
        road_file=subject.road_name,
        external_ego=bool(outside),
    )
    yield write(version="1.0")
    yield write(version="1.2")
