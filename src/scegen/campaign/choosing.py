"""A suite taken out of a campaign: which scenarios, why, and their files."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scegen.campaign.analysis.coverage import Coverage, coverage
from scegen.campaign.analysis.suite import Suite, suite_of
from scegen.campaign.report.scenario import write_folder
from scegen.campaign.rows import Row
from scegen.campaign.store import Store, write_whole
from scegen.campaign.table import query
from scegen.checking.subject import FUNCTIONAL_FILE
from scegen.errors import InputError
from scegen.scenario.files import to_yaml
from scegen.scenario.functional import FunctionalScenario

SUITE_FILE = "suite.json"


@dataclass(frozen=True)
class Selected:
    """A suite with the rows that it is of, and the coverage of the whole campaign."""

    suite: Suite
    rows: list[Row]
    covered: Coverage

    def to_data(self) -> dict[str, Any]:
        """The suite as JSON-able data."""
        return {
            "size": len(self.suite.chosen),
            "covered": len(self.covered.counts) - len(self.suite.uncovered),
            "coverable": len(self.covered.counts),
            "needed_to_cover": self.suite.needed,
            "proved_fewest": self.suite.proved,
            "no_room_for": list(self.suite.uncovered),
            "cannot_be_covered": self.covered.why_not,
            "not_in_the_campaign": self.covered.left_out,
            "scenarios": [
                {
                    "key": row["key"],
                    "description": row["description"],
                    "logical": row["logical_name"],
                    "folder": self.folder(chosen.row),
                    "reason": chosen.reason,
                    "brings": list(chosen.brings),
                }
                for chosen in self.suite.chosen
                for row in [self.rows[chosen.row]]
            ],
        }

    def folder(self, row: int) -> str:
        """Where a scenario of the suite lies, seen from the suite.

        Those of one description, at one point of a sweep, share what they were made from.
        """
        found = self.rows[row]
        made_from = f"{found['description']}-{found['functional'][:8]}"
        return f"{made_from}/scenarios/{found['logical_name'][:60]}-{found['key'][:8]}"


def select(store: Store, size: int) -> Selected:
    """A suite of at most so many of a campaign's scenarios.

    Raises:
        InputError: there are no rows, or none that is good enough.
    """
    rows: list[Row] = query(store, "SELECT * FROM rows ORDER BY key").to_pylist()
    covered = coverage(store, rows)
    return Selected(suite_of(rows, covered, size), rows, covered)


def write_suite(store: Store, selected: Selected, folder: Path) -> None:
    """Write a suite: a folder of scenarios for every description, and suite.json.

    Raises:
        InputError: the folder is not empty or cannot be written, or a file is broken.
    """
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError("is not empty", where=str(folder), hint="choose another -o")
    for chosen in selected.suite.chosen:
        row = selected.rows[chosen.row]
        place = folder / selected.folder(chosen.row)
        write_folder(store, row, place)
        functional = FunctionalScenario.model_validate_json(store.get(row["functional"]))
        told = to_yaml(functional).encode()
        write_whole(place.parent.parent / FUNCTIONAL_FILE, told, lasting=False)
    text = json.dumps(selected.to_data(), indent=2, ensure_ascii=False) + "\n"
    write_whole(folder / SUITE_FILE, text.encode())
