"""What is checked: a scenario folder, or single files, found and read."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from pydantic import ValidationError

from scegen.checking.documents import BrokenXmlError, parse_document
from scegen.criticality.target import asks_for_measure, parse_target
from scegen.errors import InputError
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load_if_there, read_bytes
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.proof import Proof

ROAD_FILE, SCENARIO_FILE, CONCRETE_FILE = "road.xodr", "scenario.xosc", "concrete.yaml"
FUNCTIONAL_FILE, PROOF_FILE = "functional.yaml", "proof.json"
SUFFIXES = {".xodr": "OpenDRIVE", ".xosc": "OpenSCENARIO"}
HINT = "name a folder made by scegen generate, an .xodr or an .xosc file"


@dataclass(frozen=True)
class File:
    """A file as read; ``sound`` says that it is XML that other programs may be given."""

    path: Path
    content: bytes
    sound: bool

    @property
    def name(self) -> str:
        """The file name."""
        return self.path.name


@dataclass(frozen=True)
class Subject:
    """A road, a scenario, or both, and what they were made from, as far as it is there.

    ``touching`` are two of whom a contact was asked for, None where no danger was sought;
    ``brought_together`` of whom a measure was asked for. ``values`` is a file of values for a
    scenario's parameters, which is no scenario itself.
    """

    place: Path
    road: File | None
    scenario: File | None
    concrete: ConcreteScenario | None
    functional: FunctionalScenario | None = None
    touching: tuple[str, ...] | None = None
    values: File | None = None
    brought_together: tuple[str, ...] = ()

    @property
    def road_name(self) -> str:
        """What its road is called, or would be."""
        return self.road.name if self.road else ROAD_FILE

    @property
    def files(self) -> tuple[File, ...]:
        """The files that are there."""
        return tuple(file for file in (self.road, self.scenario, self.values) if file is not None)


def find_subjects(path: Path) -> list[Subject]:
    """Everything to check under a path, in the order of names.

    Raises:
        InputError: nothing there, or a file that cannot be read.
    """
    if path.is_file():
        return [_single(path)]
    if not path.is_dir():
        raise InputError("does not exist", where=str(path), hint=HINT)
    # One of them alone may be anybody's, and of two the third is missed.
    if sum((path / name).exists() for name in (ROAD_FILE, SCENARIO_FILE, CONCRETE_FILE)) > 1:
        return [read_folder(path)]
    folders = [p for p in path.glob("scenarios/*/") if p.is_dir()]  # whatever they lack
    folders = folders or [p for p in path.glob("*/scenarios/*/") if p.is_dir()]
    folders = sorted(folders or (p.parent for p in path.glob(f"*/{SCENARIO_FILE}")))
    if folders:
        return [read_folder(folder) for folder in folders]
    files = sorted(p for p in path.iterdir() if p.suffix.lower() in SUFFIXES)
    if files:
        return [_single(file) for file in files]
    raise InputError("holds nothing to check", where=str(path), hint=HINT)


def read_folder(folder: Path) -> Subject:
    """One scenario folder: road.xodr and scenario.xosc, with concrete.yaml if it is there.

    Raises:
        InputError: a file is missing or cannot be read.
    """
    files = {name: read_bytes(folder / name) for name in (ROAD_FILE, SCENARIO_FILE)}
    concrete = load_if_there(folder / CONCRETE_FILE, ConcreteScenario)
    # Made by generate, the folder lies two levels below what it was made from.
    functional = folder.absolute().parent.parent / FUNCTIONAL_FILE
    said = load_if_there(functional, FunctionalScenario)
    return subject_of(folder, files, concrete, said, read_proof(folder))


def subject_of(
    place: Path,
    files: Mapping[str, bytes],
    concrete: ConcreteScenario | None,
    functional: FunctionalScenario | None = None,
    proof: Proof | None = None,
) -> Subject:
    """A scenario in memory; only the player needs its files to lie in the folder ``place``.

    A search that proves itself was asked, or allowed, to bring two together and into contact.
    """
    road, scenario = (_file(place / name, files[name]) for name in (ROAD_FILE, SCENARIO_FILE))
    found = Subject(place, road, scenario, concrete, functional)
    if proof is None:
        return found
    target = parse_target(proof.target)
    return replace(
        found,
        touching=proof.pair if target.contact is not False else (),
        brought_together=proof.pair if asks_for_measure(target) else (),
    )


def read_proof(folder: Path) -> Proof | None:
    """The proof of a scenario folder; None where no danger was sought.

    Raises:
        InputError: its file holds none.
    """
    file = folder / PROOF_FILE
    if not file.is_file():
        return None
    try:
        return Proof.model_validate_json(read_bytes(file))
    except ValidationError as problem:
        raise InputError("is no proof of a search", where=str(file)) from problem


def _single(path: Path) -> Subject:
    suffix = path.suffix.lower()
    if suffix == ".xodr":
        return Subject(path, _read(path), None, None)
    if suffix == ".xosc":
        scenario = _read(path)
        if _holds_values(scenario):
            return Subject(path, None, None, None, values=scenario)
        return Subject(path, _named_road(scenario), scenario, None)
    raise InputError("is neither an .xodr nor an .xosc file", where=str(path), hint=HINT)


def _read(path: Path) -> File:
    return _file(path, read_bytes(path))


def _file(path: Path, content: bytes) -> File:
    try:
        parse_document(path.name, content, SUFFIXES[path.suffix.lower()])
    except BrokenXmlError:
        return File(path, content, sound=False)
    return File(path, content, sound=True)


def _holds_values(file: File) -> bool:
    """Whether an .xosc file gives values to the parameters of another."""
    if not file.sound:
        return False
    root = parse_document(file.name, file.content, "OpenSCENARIO").root
    return root.find("ParameterValueDistribution") is not None


def _named_road(scenario: File) -> File | None:
    """The road file that a scenario names, seen from where it lies."""
    if not scenario.sound:
        return None
    document = parse_document(scenario.name, scenario.content, "OpenSCENARIO")
    logic = document.root.find("RoadNetwork/LogicFile")
    said = logic.get("filepath", "") if logic is not None else ""
    named = document.declared().get(said, said)
    path = scenario.path.parent / named if named else None
    if path is None or path.suffix.lower() != ".xodr" or not path.is_file():
        return None
    return _read(path)
