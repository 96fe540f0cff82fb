"""Labelled descriptions: read from files, and how well a reading matches its label."""

import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from scegen.errors import InputError
from scegen.scenario.files import read_text
from scegen.scenario.functional import FunctionalScenario, Participant


@dataclass(frozen=True, slots=True)
class Score:
    """Which judged fields hold.

    Attributes:
        fields: judged field -> whether it holds; fields without a label are absent.
        problems: one sentence for each field that does not hold.
    """

    fields: Mapping[str, bool]
    problems: tuple[str, ...]

    @property
    def understood(self) -> bool:
        """Whether every judged field holds."""
        return all(self.fields.values())


def score(expect: Mapping[str, Any], scenario: FunctionalScenario) -> Score:
    """Judges a scenario.

    Args:
        expect: acceptable values: ``junction``, ``arms``, ``control`` (lists), ``actors``
            (kind -> [min, max]), ``ego`` and ``others`` (what they do and where they come
            from), ``hazards`` (``must`` and ``may``).
        scenario: the scenario to judge.
    """
    road = scenario.junction
    said = {"junction": road.kind.value, "arms": road.arms, "control": road.control.value}
    judges = {"actors": _actors, "ego": _ego, "others": _others, "hazards": _hazards}
    told = {name: (value, expect[name]) for name, value in said.items() if name in expect}
    judged = {
        name: None if value in wanted else f"{name} is {value}, expected one of {wanted}"
        for name, (value, wanted) in told.items()
    }
    judged |= {name: judge(expect, scenario) for name, judge in judges.items() if name in expect}
    problems = tuple(problem for problem in judged.values() if problem is not None)
    return Score({name: problem is None for name, problem in judged.items()}, problems)


def _actors(expect: Mapping[str, Any], scenario: FunctionalScenario) -> str | None:
    found = Counter(f"parked_{p.kind}" if p.parked else str(p.kind) for p in scenario.participants)
    wanted: Mapping[str, list[int]] = expect["actors"]
    for kind, (fewest, most) in wanted.items():
        if not fewest <= found[kind] <= most:
            return f"actors: {found[kind]} {kind}, expected {fewest} to {most}"
    unnamed = [kind for kind in found if kind not in wanted]
    return f"actors: unexpected {', '.join(unnamed)}" if unnamed else None


def _ego(expect: Mapping[str, Any], scenario: FunctionalScenario) -> str | None:
    wanted = expect["ego"].get("maneuver")
    found = {str(m) for m in scenario.ego.maneuvers}
    if wanted is None or (found and found <= set(wanted)):
        return None
    return f"ego: does {sorted(found) or 'nothing said'}, expected of {wanted}"


def _matches(entry: Mapping[str, Any], participant: Participant) -> bool:
    if "kind" in entry and participant.kind.value != entry["kind"]:
        return False
    for key, values in (("from", participant.approaches), ("maneuver", participant.maneuvers)):
        if key in entry:
            found = {str(v) for v in values}
            if not found or not found <= set(entry[key]):
                return False
    return True


def _shared_out(scenario: FunctionalScenario) -> list[Participant]:
    """The participants, with what so many of several do as the way of the first of them."""
    people = {p.id: p for p in scenario.participants}
    for group in scenario.groups:
        free = [people[m] for m in group.members if not people[m].maneuvers]
        for one in free[: group.number]:
            people[one.id] = one.model_copy(update={"maneuvers": group.maneuvers})
    return list(people.values())


def _others(expect: Mapping[str, Any], scenario: FunctionalScenario) -> str | None:
    candidates = [
        p for p in _shared_out(scenario) if not ("ego" in expect and p.id == scenario.ego.id)
    ]
    fitting = [
        [k for k, p in enumerate(candidates) if _matches(entry, p)] for entry in expect["others"]
    ]
    if _matched(fitting):
        return None
    return f"others: no different participant for each of {list(expect['others'])}"


def _matched(fitting: list[list[int]]) -> bool:
    """Whether every entry gets a participant of its own (augmenting paths)."""
    taken: dict[int, int] = {}

    def assign(entry: int, seen: set[int]) -> bool:
        for candidate in fitting[entry]:
            if candidate in seen:
                continue
            seen.add(candidate)
            if candidate not in taken or assign(taken[candidate], seen):
                taken[candidate] = entry
                return True
        return False

    return all(assign(entry, set()) for entry in range(len(fitting)))


def _hazards(expect: Mapping[str, Any], scenario: FunctionalScenario) -> str | None:
    found = {h.kind.value for h in scenario.hazards}
    must, may = set(expect["hazards"]["must"]), set(expect["hazards"]["may"])
    missing, surplus = sorted(must - found), sorted(found - must - may)
    if not missing and not surplus:
        return None
    return f"hazards: missing {missing}, unexpected {surplus}"


@dataclass(frozen=True, slots=True)
class Case:
    """A description with the label to judge its reading by.

    Attributes:
        id: name of the case.
        text: the description.
        expect: the label, see :func:`scegen.understanding.report.scoring.score`.
    """

    id: str
    text: str
    expect: Mapping[str, Any]


def _parse(content: str, where: str) -> tuple[Case, ...]:
    cases: list[Case] = []
    ids: set[str] = set()
    for number, line in enumerate(content.splitlines(), start=1):
        if not line.strip():
            continue
        try:
            record = json.loads(line)
            cases.append(Case(record["id"], record["text"], record["expect"]))
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            msg = "a line must be a JSON object with id, text and expect"
            raise InputError(msg, where=f"{where}:{number}") from error
        if cases[-1].id in ids:
            msg = f"another line has the id {cases[-1].id!r} too"
            raise InputError(msg, where=f"{where}:{number}", hint="give each line its own")
        ids.add(cases[-1].id)
    if not cases:
        raise InputError("holds no description", where=where)
    return tuple(cases)


@lru_cache(maxsize=1)
def paper_cases() -> tuple[Case, ...]:
    """The 11 sentences of the source paper, with labels."""
    content = files(__package__).joinpath("data/paper.jsonl").read_text(encoding="utf-8")
    return _parse(content, "paper.jsonl")


def load_cases(path: Path) -> tuple[Case, ...]:
    """Labelled descriptions from a file with one JSON object a line.

    Raises:
        InputError: if the file cannot be read or a line is not a labelled description.
    """
    return _parse(read_text(path), str(path))
