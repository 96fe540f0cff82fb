"""The report's files: the page, pages of the player, the tidy table for pandas and spreadsheets."""

import csv
import io
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa

from scegen.campaign.analysis.coverage import coverage
from scegen.campaign.report.page import campaign_page, outlook
from scegen.campaign.report.scenario import page, write_folder
from scegen.campaign.report.unmet import unmet
from scegen.campaign.rows import MADE, Row
from scegen.campaign.store import Store, parquet, write_whole
from scegen.campaign.table import query

PAGE_FILE, CSV_FILE, PARQUET_FILE = "index.html", "table.csv", "table.parquet"
SCENARIOS = "scenarios"


def write_report(store: Store, folder: Path, pages: int, progress: Callable[[str], None]) -> Path:
    """Write the report of a campaign; gives back its page.

    So many ``pages`` of the most critical, of the most different ones, and of examples of what is
    not met get the player.

    Raises:
        InputError: there are no rows, a file is broken, or the folder cannot be written.
    """
    manifest = store.told()
    progress("reading the rows")
    table = query(store, "SELECT * FROM rows ORDER BY description, logical_index, key")
    rows: list[Row] = table.to_pylist()
    covered = coverage(store, rows)
    found = outlook(rows, max(pages, 10))
    links: dict[int, str] = {}
    examples = (one.example for listed in unmet(rows).values() for one in listed[:pages])
    made = (number for number in examples if rows[number]["status"] == MADE)
    for number in dict.fromkeys((*found.critical[:pages], *found.different[:pages], *made)):
        row = rows[number]
        name = str(row["key"])[:16]
        progress(f"drawing {name}")
        write_folder(store, row, folder / SCENARIOS / name)
        write_whole(folder / f"{name}.html", page(store, row, f"{SCENARIOS}/{name}").encode())
        links[number] = f"{name}.html"
    progress("writing the page")
    html = campaign_page(rows, covered, found, links, manifest)
    write_whole(folder / CSV_FILE, csv_of(rows, table.schema).encode())
    write_whole(folder / PARQUET_FILE, parquet(table))
    write_whole(folder / PAGE_FILE, html.encode())
    return folder / PAGE_FILE


def csv_of(rows: list[Row], schema: pa.Schema) -> str:
    """The rows as CSV: lists are joined by semicolons, pairs of name and number by ``=``."""
    sink = io.StringIO()
    writer = csv.writer(sink, lineterminator="\n")
    writer.writerow(schema.names)
    for row in rows:
        writer.writerow(["" if v is None else _flat(v) for v in row.values()])
    return sink.getvalue()


def _flat(value: object) -> object:
    if not isinstance(value, list):
        return value
    parts = (f"{v[0]}={v[1]}" if isinstance(v, tuple) else str(v) for v in value)
    return "; ".join(parts)
