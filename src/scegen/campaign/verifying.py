"""Whether a campaign's folder holds what its manifest tells, every row as it was made."""

from pathlib import Path

import pyarrow.parquet as pq

from scegen.campaign.examining import Examined, examine
from scegen.campaign.store import Store
from scegen.pipeline.folder import digest


def verify(folder: Path) -> tuple[Examined, list[str]]:
    """Look at every file of a campaign, and hold every row against its digest; changes nothing.

    The second part says what is wrong beside single files.

    Raises:
        InputError: there is no campaign.
    """
    store = Store(folder)
    manifest = store.told()
    keys = [str(key) for key in manifest.get("plans", ())]
    found = examine(store, keys, rows=True)
    problems = []
    if not keys:
        problems.append("the plan is not finished")
    if not found.plans_whole:
        problems.append("a plan is missing or broken: what there is to make is not known")
    if found.missing:
        problems.append(f"{len(found.missing):,} of {len(found.planned):,} scenarios are missing")
    finished = manifest.get("finished")
    if finished and not found.bad and not problems and finished["digest"] != digest_of(found):
        problems.append("the rows are not those of which the manifest tells")
    if finished and not _table_sound(store, found):
        problems.append(f"{store.table.name} does not hold the rows of the batches")
    return found, problems


def _table_sound(store: Store, found: Examined) -> bool:
    """Whether the table has every row once."""
    try:
        table = pq.read_table(store.table, columns=["key", "row_digest"])
    except (OSError, ValueError):
        return False
    keys, digests = (table.column(name).to_pylist() for name in ("key", "row_digest"))
    return (
        len(keys) == len(found.digests) and dict(zip(keys, digests, strict=True)) == found.digests
    )


def digest_of(found: Examined) -> str:
    """One digest for all rows, whatever their order."""
    return digest("".join(f"{k}{v}" for k, v in sorted(found.digests.items())).encode())
