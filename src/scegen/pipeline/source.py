"""What the user hands in: a sentence, or a file of any level."""

import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from scegen.checking.subject import CONCRETE_FILE, FUNCTIONAL_FILE, read_proof
from scegen.enumeration import count_scenarios
from scegen.errors import InputError
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import ENDINGS, from_text, is_scenario, load_if_there, read_text, text_of
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.scenario.wording import counted
from scegen.understanding import read

Source = FunctionalScenario | LogicalSet | ConcreteScenario
Understand = Callable[[str], FunctionalScenario]
_FILE_ENDINGS = (*ENDINGS, ".txt", ".md")
_LONGEST_PATH = 1024
_STDIN = "-"
LOGICAL_FILE = "logical.json"
GIVEN_FILE = "given.json"
"""The numbers that a search began from, where they were given."""


def resolve_source(text_or_path: str, understand: Understand = read) -> Source:
    """The scenario that an argument stands for.

    A path stands for what is in that file, ``-`` for what comes on standard input. A scenario is
    loaded at its level; all else is a description and left to ``understand``, the offline reader
    unless said otherwise.

    Raises:
        InputError: the text is empty, not traffic, or the file cannot be used.
    """
    path = _as_path(text_or_path)
    where, text = "description", text_or_path
    if text_or_path == _STDIN:
        where = "standard input"
        text = text_of(sys.stdin.buffer.read(), where=where)
    elif path is not None:
        where, text = str(path), read_text(path)
    scenario = is_scenario(text, where)
    found = from_text(text, where=where) if scenario else understand(text.strip())
    return recounted(found) if isinstance(found, LogicalSet) else found


def functional_of(text_or_path: str, understand: Understand = read) -> FunctionalScenario:
    """The functional scenario that an argument names or tells.

    Raises:
        InputError: it names one of another level, or cannot be used.
    """
    source = resolve_source(text_or_path, understand)
    if not isinstance(source, FunctionalScenario):
        raise InputError(
            f"is a {source.level} scenario, not a description or a functional one",
            where=text_or_path,
            hint="name the functional.yaml from which it was made",
        )
    return source


@dataclass(frozen=True, slots=True)
class Origin:
    """What a concrete.yaml was made from, and to which target; None where that is not there."""

    functional: FunctionalScenario | None = None
    logical: LogicalSet | None = None
    target: str | None = None


def origin_of(text_or_path: str) -> Origin:
    """What lies around given numbers in a folder made by generate; nothing around all else.

    Raises:
        InputError: a file there cannot be used.
    """
    path = _as_path(text_or_path)
    if path is None or path.name not in {CONCRETE_FILE, GIVEN_FILE}:
        return Origin()
    place = path.absolute().parent
    top = place if path.name == GIVEN_FILE else place.parent.parent
    functional = load_if_there(top / FUNCTIONAL_FILE, FunctionalScenario)
    if functional is None:
        return Origin()
    logical, proof = load_if_there(top / LOGICAL_FILE, LogicalSet), read_proof(place)
    return Origin(functional, logical and recounted(logical), proof.target if proof else None)


def recounted(logical: LogicalSet) -> LogicalSet:
    """The set with what its own functional scenario says of numbers: files may claim anything.

    Raises:
        InputError: the functional scenario has no logical one, or too many to count.
    """
    claimed = logical.certificate
    again = count_scenarios(logical.functional, reduction=logical.reduction, arms=logical.arms)
    listed, sizes = len(logical.scenarios), sum(s.class_size for s in logical.scenarios)
    misfit = sizes > again.total or (listed == again.count and sizes != again.total)
    matching = None if claimed.matching is None else min(claimed.matching, again.count)
    certificate = again.but(
        matching=matching,
        complete=claimed.complete and not misfit and listed == (matching or again.count),
        looked_at=claimed.looked_at and min(claimed.looked_at, again.total),
    )
    notes = list(logical.notes)
    if (claimed.total, claimed.count) == (again.total, again.count):
        certificate = certificate.but(method=claimed.method)
    else:
        notes.append(
            f"The file claims {counted(claimed.count, 'scenario')} of "
            f"{counted(claimed.total, 'assignment')}; "
            f"counted again there are {again.count:,} of {again.total:,}."
        )
    if misfit:
        notes.append(
            f"The class sizes in the file add up to {sizes:,}; there are {again.total:,} "
            "assignments."
        )
    return logical.but(certificate=certificate, notes=tuple(notes))


def _as_path(argument: str) -> Path | None:
    """The path that an argument means, None if it is a description."""
    stripped = argument.strip()
    if not stripped or "\n" in stripped or len(stripped) > _LONGEST_PATH or "\0" in stripped:
        return None
    path = Path(stripped)
    try:
        exists = path.exists()
    except OSError:
        return None
    if exists:
        if path.is_dir():
            raise InputError(
                "is a folder, not a description or a scenario file",
                where=stripped,
                hint="name a file in it, such as functional.yaml or scenarios/…/concrete.yaml",
            )
        return path
    if stripped.lower().endswith(_FILE_ENDINGS) and " " not in stripped:
        raise InputError("there is no such file", where=stripped, hint="check the path")
    return None
