"""One row for each concrete scenario: what its columns are, and how it is told from what was made.

Columns whose names begin with ``seconds`` say how long it took; all others are the same whoever
made the row, in whatever order. Quantities have their unit at the end of their names, SI.
"""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import pyarrow as pa

from scegen.checking.subject import CONCRETE_FILE, PROOF_FILE, ROAD_FILE, SCENARIO_FILE
from scegen.enumeration.choosing.coverage import Meeting, meeting_of, meetings
from scegen.pipeline.export import LAMPS_FILE, PREVIEW_FILE
from scegen.pipeline.folder import digest
from scegen.pipeline.judging import Judged
from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.logical import Conflict, LogicalScenario
from scegen.scenario.proof import Proof

MADE, FAILED = "made", "failed"
SECONDS = "seconds"
Row = dict[str, Any]

_TEXT, _NUMBER, _WHOLE, _YES = pa.string(), pa.float64(), pa.int64(), pa.bool_()
_TEXTS = pa.list_(_TEXT)
_NUMBERS = pa.map_(_TEXT, _NUMBER)
FILE_COLUMNS = {
    ROAD_FILE: "road",
    SCENARIO_FILE: "scenario",
    LAMPS_FILE: "lamps",
    CONCRETE_FILE: "concrete",
    PROOF_FILE: "proof",
    PREVIEW_FILE: "preview",
}
"""In which column a file of a scenario folder is named."""
STEPS = ("concretize", "search", "judge", "write", "check", "confirm")
"""What is timed."""
MEASURES = {
    "pet": "pet_s",
    "distance": "distance_m",
    "ttc": "ttc_s",
    "headway": "headway_s",
    "drac": "drac_mps2",
    "contact_time": "contact_s",
    "impact_speed": "impact_mps",
}
"""Columns of the measures that a proof holds, of the pair that the target is about."""

_COLUMNS: tuple[tuple[str, pa.DataType], ...] = (
    ("key row_digest description status stage reason functional", _TEXT),
    ("logical_index", _WHOLE),
    ("logical_name", _TEXT),
    ("sweep", _NUMBERS),
    ("concretization seed", _WHOLE),
    ("junction", _TEXT),
    ("arms", _WHOLE),
    ("control driving_side", _TEXT),
    ("participants", _WHOLE),
    ("kinds pair", _TEXTS),
    ("movements seen conflict yields right_of_way", _TEXT),
    ("meetings hazards hazards_missing", _TEXTS),
    ("ranges", pa.map_(_TEXT, pa.list_(_NUMBER))),
    ("parameters", _NUMBERS),
    ("ego_speed_mps other_speed_mps duration_s", _NUMBER),
    ("target measure", _TEXT),
    ("reached reached_at_first", _YES),
    ("blocked_by", _TEXT),
    ("evaluations", _WHOLE),
    (" ".join(MEASURES.values()), _NUMBER),
    ("avoidable", _TEXT),
    ("spare_s", _NUMBER),
    ("reactive", _YES),
    ("claims claims_held", _WHOLE),
    ("claims_missed", _TEXTS),
    ("checks", pa.map_(_TEXT, _TEXT)),
    ("check_findings", _TEXTS),
    ("confirmed", _TEXT),
    ("cells covered", _TEXTS),
    (" ".join(FILE_COLUMNS.values()), _TEXT),
    (" ".join(f"{SECONDS}_{step}" for step in STEPS), _NUMBER),
    (SECONDS, _NUMBER),
)
SCHEMA = pa.schema([(name, kind) for names, kind in _COLUMNS for name in names.split()])
OBJECT_COLUMNS = ("functional", *FILE_COLUMNS.values())
"""Columns that name objects of the store."""
_BAND_KPH = 20


def table_of(rows: Sequence[Row]) -> pa.Table:
    """Rows as a table, each with the digest of all that is the same whoever makes it."""
    table = pa.Table.from_pylist([row | {"row_digest": None} for row in rows], SCHEMA)
    digests = pa.array([row_digest(row) for row in table.to_pylist()], pa.string())
    return table.set_column(SCHEMA.get_field_index("row_digest"), "row_digest", digests)


def row_digest(row: Row) -> str:
    """The digest of a row as a table gives it back, without times."""
    plain = {
        field.name: _plain(row[field.name], field.type)
        for field in SCHEMA
        if not field.name.startswith(SECONDS) and field.name != "row_digest"
    }
    return digest(json.dumps(plain, sort_keys=True).encode())


def _plain(value: Any, kind: pa.DataType) -> Any:  # noqa: ANN401 - whatever a column holds
    return sorted(value) if value is not None and pa.types.is_map(kind) else value


def planned(functional: FunctionalScenario, logical: LogicalScenario) -> Row:
    """What is known before anything is made."""
    junction = functional.junction
    hazards = logical.hazards or functional.hazards
    return {
        "logical_index": logical.index,
        "logical_name": logical.name,
        "junction": str(junction.kind),
        "arms": junction.arms,
        "control": str(junction.control),
        "driving_side": str(junction.driving_side),
        "participants": len(functional.participants),
        "kinds": sorted(
            f"parked {p.kind}" if p.parked else str(p.kind) for p in functional.participants
        ),
        "meetings": [m.in_words() for m in sorted(meetings(functional, logical))],
        "hazards": [_hazard(hazard) for hazard in hazards],
        "cells": cells(functional, logical),
    }


def cells(functional: FunctionalScenario, logical: LogicalScenario) -> list[str]:
    """What a logical scenario can show: how movements meet under which rule, and which dangers."""
    found = {_meeting(functional, logical, conflict) for conflict in logical.conflicts}
    for hazard in logical.hazards or functional.hazards:
        found |= _dangers(functional, logical, hazard)
    return sorted(found)


def _meeting(functional: FunctionalScenario, logical: LogicalScenario, conflict: Conflict) -> str:
    met = meeting_of(functional, logical, conflict).in_words()
    return f"{_where(functional)}: {met} ({_rule(conflict)})"


def _dangers(functional: FunctionalScenario, logical: LogicalScenario, hazard: Hazard) -> set[str]:
    """A danger between two whose ways meet, with how they meet; any other on such a road."""
    both = {*hazard.by, *hazard.to}
    met = [c for c in logical.conflicts if {c.first, c.second} <= both]
    places = {_meeting(functional, logical, c) for c in met} or {_where(functional)}
    told = str(hazard.kind).replace("_", " ")
    return {f"{place}: {told}" for place in places}


def _where(functional: FunctionalScenario) -> str:
    return str(functional.junction.kind).replace("_", " ")


def _rule(conflict: Conflict) -> str:
    return "no rule" if conflict.rule is None else str(conflict.rule).replace("_", " ")


def _hazard(hazard: Hazard) -> str:
    return f"{hazard.kind}({' '.join(hazard.by)} > {' '.join(hazard.to)})"


def shown(
    functional: FunctionalScenario, concrete: ConcreteScenario, proof: Proof | None, judged: Judged
) -> Row:
    """What a concrete scenario shows."""
    row = {
        "parameters": _parameters(concrete),
        "ego_speed_mps": concrete.ego.speed_mps,
        "duration_s": concrete.duration_s,
        "avoidable": str(judged.verdict.outcome),
        "spare_s": judged.verdict.spare_s,
        "reactive": None if judged.sensitivity is None else judged.sensitivity.reactive,
    }
    if proof is None:
        return row | {"covered": cells(functional, concrete.logical)}
    return row | _pair(functional, concrete, proof.pair) | _proved(functional, concrete, proof)


def _parameters(concrete: ConcreteScenario) -> dict[str, float]:
    """The numbers of everybody, by the names that a search gives them."""
    found: dict[str, float] = {}
    for participant in concrete.participants:
        found[f"{participant.id}.speed_mps"] = participant.speed_mps
        if isinstance(participant.motion, DriveMotion):
            found[f"{participant.id}.start_m"] = participant.motion.start_m
        for number, phase in enumerate(participant.speed_program):
            for place, value in phase.numbers.items():
                name = place.removeprefix("trigger.")
                found[f"{participant.id}.phase_{number}.{name}"] = value
    return found


def _pair(functional: FunctionalScenario, concrete: ConcreteScenario, pair: tuple[str, ...]) -> Row:
    """How the two that the target is about meet."""
    if not pair:
        return {}
    speeds = {p.id: p.speed_mps for p in concrete.participants}
    others = [name for name in pair if name != concrete.ego.id]
    row: Row = {"pair": list(pair), "other_speed_mps": speeds.get(others[0]) if others else None}
    for conflict in concrete.logical.conflicts:
        if {conflict.first, conflict.second} == {*pair}:
            met: Meeting = meeting_of(functional, concrete.logical, conflict)
            row |= {
                "movements": f"{met.first} × {met.second}",
                "seen": met.seen,
                "conflict": str(conflict.kind),
                "yields": conflict.yields,
                "right_of_way": _rule(conflict),
            }
    return row


def _proved(functional: FunctionalScenario, concrete: ConcreteScenario, proof: Proof) -> Row:
    measured = {column: proof.of(name) for name, column in MEASURES.items()}
    hazards = concrete.logical.hazards or functional.hazards
    happened = [told.happened for told in proof.hazards]
    missing = [h for h, there in zip(hazards, happened, strict=True) if not there]
    dangers: dict[bool, set[str]] = {True: set(), False: set()}
    for hazard, there in zip(hazards, happened, strict=True):
        dangers[there] |= _dangers(functional, concrete.logical, hazard)
    return {
        "hazards_missing": [_hazard(hazard) for hazard in missing],
        "target": proof.target,
        "measure": proof.measure,
        "reached": proof.reached,
        "reached_at_first": proof.in_band_before,
        "blocked_by": proof.blocked_by,
        "evaluations": proof.evaluations,
        **{name: found.after if found else None for name, found in measured.items()},
        "claims": len(proof.claims),
        "claims_held": len(proof.claims) - len(proof.missed),
        "claims_missed": [f"{claim.statement}: {claim.found}" for claim in proof.missed],
        "covered": sorted(
            {*cells(functional, concrete.logical)} - (dangers[False] - dangers[True])
        ),
    }


def speed_cells(row: Mapping[str, Any]) -> list[str]:
    """The speeds of the ego and of the other of the pair, in bands, as cells of their own."""
    found = []
    for who in ("ego", "other"):
        speed = row.get(f"{who}_speed_mps")
        if speed is not None:
            # Numbers of files are rounded: who is to drive 60 km/h may drive 59.9999.
            band = int(round(speed * 3.6, 1) // _BAND_KPH) * _BAND_KPH
            where = str(row["junction"]).replace("_", " ")
            found.append(f"{where}: {who} at {band} to {band + _BAND_KPH} km/h")
    return found
