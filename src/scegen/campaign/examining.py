"""What is wrong in a campaign's folder: anything twice, missing, or not as it was written."""

from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from scegen.campaign.rows import OBJECT_COLUMNS, SCHEMA, row_digest
from scegen.campaign.store import Store, column, sound


@dataclass
class Examined:
    """Keys that are done and planned, and everything that is wrong, in words.

    ``bad`` are files to be made again: broken ones, and batches that rest on broken ones.
    ``plans_whole``: no plan is missing or broken. ``stray`` counts objects that nothing names.
    """

    done: set[str] = field(default_factory=set)
    planned: set[str] = field(default_factory=set)
    digests: dict[str, str] = field(default_factory=dict)
    bad: dict[Path, str] = field(default_factory=dict)
    plans_whole: bool = True
    stray: int = 0

    @property
    def missing(self) -> set[str]:
        """Planned and not done."""
        return self.planned - self.done

    def in_words(self) -> list[str]:
        """What is wrong, a line each."""
        return [f"{path}: {reason}" for path, reason in sorted(self.bad.items())]

    def remove(self) -> None:
        """Take away what is bad, so that the next run makes it again."""
        for path in self.bad:
            with suppress(FileNotFoundError):
                path.unlink()


def examine(store: Store, plans: Sequence[str], *, rows: bool = False) -> Examined:
    """Look at every file of a campaign; with ``rows``, hold all rows against their digests."""
    found = Examined()
    _plans(store, plans, found)
    present = _objects(store, found)
    used: set[str] = set()
    for path in store.batches():
        _batch(path, present, used, found, rows=rows)
    found.stray = len(present - used - _functionals(store, plans, found))
    return found


def _plans(store: Store, plans: Sequence[str], found: Examined) -> None:
    existing = store.plans()
    for key in plans:
        path = existing.get(key)
        if path is not None and sound(path):
            found.planned.update(column(path, "key"))
            continue
        found.plans_whole = False
        if path is not None:
            found.bad[path] = "is not what was written: the plan is made again"


def _functionals(store: Store, plans: Sequence[str], found: Examined) -> set[str]:
    """The objects that plans rest on."""
    good = (path for key, path in store.plans().items() if key in plans and path not in found.bad)
    return {name for path in good for name in column(path, "functional")}


def _objects(store: Store, found: Examined) -> set[str]:
    """The names of the objects that are as they were written."""
    present: set[str] = set()
    for name in store.objects():
        path = store.object_path(name)
        if sound(path):
            present.add(name)
        else:
            found.bad[path] = "is not what was written: what rests on it is made again"
    return present


def _batch(path: Path, present: set[str], used: set[str], found: Examined, *, rows: bool) -> None:
    if not sound(path):
        found.bad[path] = "is not what was written: it is made again"
        return
    try:
        table = pq.read_table(path)
    except (OSError, pa.ArrowInvalid) as error:
        found.bad[path] = f"cannot be read ({error}): it is made again"
        return
    if table.schema.names != SCHEMA.names:
        found.bad[path] = "has other columns: it is made again"
        return
    keys = table.column("key").to_pylist()
    named = {name for own in OBJECT_COLUMNS for name in table.column(own).to_pylist() if name}
    twice = [key for key, times in Counter(keys).items() if times > 1 or key in found.done]
    strange = [key for key in keys if key not in found.planned and found.plans_whole]
    if twice:
        found.bad[path] = f"holds {len(twice)} scenarios that are there already, such as {twice[0]}"
    elif strange:
        found.bad[path] = f"holds {len(strange)} scenarios that no plan asks for"
    elif lacking := named - present:
        found.bad[path] = f"rests on {len(lacking)} files that are not there or broken"
    elif rows and any(row_digest(row) != row["row_digest"] for row in table.to_pylist()):
        found.bad[path] = "holds a row that is not what was made"
    else:
        used |= named
        found.done.update(keys)
        found.digests.update(zip(keys, table.column("row_digest").to_pylist(), strict=True))
