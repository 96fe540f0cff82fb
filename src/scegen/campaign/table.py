"""The rows of a campaign, asked in SQL: DuckDB over Parquet."""

import os
from dataclasses import dataclass
from pathlib import Path

import duckdb
import pyarrow as pa

from scegen.campaign.store import BATCHES, Store, StoreError
from scegen.errors import InputError

ROWS = "rows"
"""The name of the table in queries."""


def _connected(source: Path) -> duckdb.DuckDBPyConnection:
    """A connection in which ``rows`` are all rows of a file, or of several by a pattern."""
    connection = duckdb.connect()
    connection.execute("SET enable_progress_bar = false")
    connection.from_parquet(str(source)).create_view(ROWS)
    return connection


def query(store: Store, sql: str) -> pa.Table:
    """What a query gives back; ``rows`` are those of the table, or of the batches so far.

    Raises:
        InputError: there are no rows, or it is no query.
    """
    source = store.table if store.table.exists() else store.folder / BATCHES / "*.parquet"
    if not store.table.exists() and not store.batches():
        raise InputError("holds no rows", where=str(store.folder), hint="run scegen campaign first")
    with _connected(source) as connection:
        try:
            return connection.sql(sql).to_arrow_table()
        except duckdb.Error as error:
            raise InputError(f"the query fails: {error}") from error


@dataclass(frozen=True, slots=True)
class Counted:
    """Rows in all; of these, that could not be made, do not hold all that is said, fail a check."""

    rows: int
    failed: int
    unheld: int
    unsound: int


def write_table(store: Store) -> Counted:
    """Put all batches together in one file, and count what came of them.

    Raises:
        StoreError: it cannot be written.
    """
    if not store.batches():
        return Counted(0, 0, 0, 0)
    part = store.folder / f"{store.table.name}.{os.getpid()}.part"
    with _connected(store.folder / BATCHES / "*.parquet") as connection:
        connection.execute("SET memory_limit = '1GB'")
        try:
            connection.execute(
                f"COPY (SELECT * FROM {ROWS} ORDER BY key) TO {_quoted(part)} "  # noqa: S608
                "(FORMAT parquet, COMPRESSION zstd)"
            )
            with part.open("rb") as file:
                os.fsync(file.fileno())
            part.replace(store.table)
        except (duckdb.Error, OSError) as error:
            part.unlink(missing_ok=True)
            raise StoreError(f"cannot be written: {error}", where=str(store.table)) from error
        (counted,) = connection.execute(
            "SELECT count(*), count(*) FILTER (status = 'failed'), "  # noqa: S608
            "count(*) FILTER (claims_held < claims), "
            f"count(*) FILTER (list_contains(map_values(checks), 'failed')) FROM {ROWS}"
        ).fetchall()
    return Counted(*map(int, counted))


def _quoted(path: Path) -> str:
    return "'" + str(path).replace("'", "''") + "'"
