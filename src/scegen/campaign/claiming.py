"""Whose a folder is: one campaign's, that of its manifest, and one command's at a time."""

import fcntl
import platform
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from scegen import __version__
from scegen.campaign.order import Campaign
from scegen.campaign.store import Store
from scegen.campaign.table import Counted
from scegen.errors import InputError

FORMAT = 1
_LIBRARIES = ("clingo", "cmaes", "numba", "numpy", "pyarrow", "scenariogeneration", "shapely")


@dataclass(frozen=True, slots=True)
class Finished:
    """What a run has come to: rows counted, those made now, and in what time."""

    counted: Counted
    fresh: int
    seconds: float
    digest: str


def claim(store: Store, campaign: Campaign) -> None:
    """Begin a folder, or go on in one of the same campaign.

    Raises:
        InputError: something else lies there.
    """
    folder = store.folder
    if folder.exists() and not folder.is_dir():
        raise InputError("is a file, not a folder", where=str(folder), hint="choose another -o")
    manifest = store.manifest() if folder.exists() else {}
    if not manifest:
        if folder.exists() and any(p for p in folder.iterdir() if not p.name.startswith(".")):
            raise InputError(
                "is not empty and holds no campaign", where=str(folder), hint="choose another -o"
            )
        keep_manifest(store, campaign, [], None)
        return
    order = campaign.model_dump(mode="json", by_alias=True)
    earlier = manifest.get("campaign", {})
    differing = sorted(name for name in {*order, *earlier} if order.get(name) != earlier.get(name))
    if manifest.get("scegen") != __version__ or manifest.get("format") != FORMAT:
        differing.insert(0, f"version {manifest.get('scegen')}")
    if differing:
        raise InputError(
            f"holds another campaign: it differs in {', '.join(differing)}",
            where=str(folder),
            hint="choose another -o, or give the same order to go on",
        )


def keep_manifest(
    store: Store, campaign: Campaign, keys: list[str], finished: Finished | None
) -> None:
    """Write down what is made with which versions, and what came of it once it is finished."""
    manifest: dict[str, Any] = {
        "format": FORMAT,
        "scegen": __version__,
        "python": platform.python_version(),
        "libraries": {name: version(name) for name in _LIBRARIES},
        "campaign": campaign.model_dump(mode="json", by_alias=True),
        "plans": keys,
    }
    if finished is not None:
        manifest["finished"] = {**asdict(finished.counted), "digest": finished.digest}
    store.write_manifest(manifest)


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Nobody else works in the folder meanwhile; a process that ends, however, lets go of it."""
    with (folder / ".lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InputError("another command works here", where=str(folder)) from error
        yield
