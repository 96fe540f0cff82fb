"""The folder of a campaign: every file of it is whole or not there, and named by its content.

DIR/manifest.json              what is made, with which versions; what came of it
DIR/plan/KEY.SHA256.parquet    the work on one description, one row an item
DIR/batches/SHA256.parquet     finished work, one row a concrete scenario
DIR/objects/ab/cdef….xosc      files of scenarios, equal ones once
"""

import json
import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from scegen.errors import InputError
from scegen.pipeline.folder import digest

MANIFEST_FILE = "manifest.json"
TABLE_FILE = "table.parquet"
PLAN, BATCHES, OBJECTS = "plan", "batches", "objects"
_PARQUET = ".parquet"
_UNFINISHED = ".part"


class StoreError(InputError):
    """The folder cannot be written; all that was finished stays."""


def write_whole(path: Path, content: bytes, *, lasting: bool = True) -> None:
    """Write a file so that, whatever happens, it has all of its content or is not there.

    ``lasting``: it survives a power failure from then on.

    Raises:
        StoreError: it cannot be written; nothing of it is left.
    """
    part = path.with_name(f"{path.name}.{os.getpid()}{_UNFINISHED}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with part.open("wb") as file:
            file.write(content)
            if lasting:
                file.flush()
                os.fsync(file.fileno())
        part.replace(path)
        if lasting:
            _sync_folder(path.parent)
    except OSError as error:
        with suppress(OSError):
            part.unlink(missing_ok=True)
        hint = "what is finished is kept: make room, and the same command goes on"
        raise StoreError.unwritable(error, path, hint) from error


def _sync_folder(folder: Path) -> None:
    """Make a new name in a folder last."""
    place = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(place)
    finally:
        os.close(place)


@dataclass(frozen=True, slots=True)
class Store:
    """The folder of a campaign, read and written by every worker alike."""

    folder: Path

    @property
    def table(self) -> Path:
        """All rows in one file, in the order of their keys; made when all is done."""
        return self.folder / TABLE_FILE

    def manifest(self) -> dict[str, Any]:
        """What the manifest says; empty if there is none.

        Raises:
            InputError: it cannot be read.
        """
        path = self.folder / MANIFEST_FILE
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return {}
        except (OSError, ValueError) as error:
            raise InputError("is no manifest of a campaign", where=str(path)) from error
        if not isinstance(data, dict):
            raise InputError("is no manifest of a campaign", where=str(path))
        return data

    def told(self) -> dict[str, Any]:
        """What the manifest says.

        Raises:
            InputError: it cannot be read, or there is none.
        """
        manifest = self.manifest()
        if not manifest:
            raise InputError("holds no campaign", where=str(self.folder))
        return manifest

    def write_manifest(self, data: dict[str, Any]) -> None:
        """Write the manifest."""
        text = json.dumps(data, indent=2, ensure_ascii=False) + "\n"
        write_whole(self.folder / MANIFEST_FILE, text.encode())

    def object_path(self, name: str) -> Path:
        """Where an object lies; ``name`` is its digest with its ending."""
        return self.folder / OBJECTS / name[:2] / name[2:]

    def put(self, content: bytes, ending: str) -> str:
        """Keep a content and give it back its name; equal contents are kept once.

        It lasts only after :meth:`settle`.
        """
        name = f"{digest(content)}.{ending}"
        path = self.object_path(name)
        if not path.exists():
            write_whole(path, content, lasting=False)
        return name

    def settle(self, names: Iterable[str]) -> None:
        """Make objects last, before anything that names them does."""
        folders = set[Path]()
        try:
            for name in sorted(set(names)):
                path = self.object_path(name)
                with path.open("rb") as file:
                    os.fsync(file.fileno())
                folders.add(path.parent)
            for folder in sorted(folders):
                _sync_folder(folder)
        except OSError as error:
            raise StoreError.unwritable(error, self.folder / OBJECTS) from error

    def get(self, name: str) -> bytes:
        """An object's content.

        Raises:
            InputError: it is not there.
        """
        try:
            return self.object_path(name).read_bytes()
        except OSError as error:
            raise InputError(
                f"cannot be read: {error.strerror}",
                where=str(self.object_path(name)),
                hint="scegen campaign --verify says what is missing",
            ) from error

    def objects(self) -> Iterator[str]:
        """The names of all objects, in order."""
        for path in sorted((self.folder / OBJECTS).glob("??/*")):
            if not path.name.endswith(_UNFINISHED):
                yield path.parent.name + path.name

    def write_plan(self, key: str, table: pa.Table) -> None:
        """Keep the work on one description."""
        content = parquet(table)
        write_whole(self.folder / PLAN / f"{key}.{digest(content)}{_PARQUET}", content)

    def plans(self) -> dict[str, Path]:
        """The files with the work on descriptions, by their keys."""
        found = sorted((self.folder / PLAN).glob(f"*{_PARQUET}"))
        return {path.name.partition(".")[0]: path for path in found}

    def write_batch(self, table: pa.Table) -> Path:
        """Keep a finished batch, named after its content."""
        content = parquet(table)
        path = self.folder / BATCHES / f"{digest(content)}{_PARQUET}"
        write_whole(path, content)
        return path

    def batches(self) -> list[Path]:
        """The files of finished batches, in order."""
        return sorted((self.folder / BATCHES).glob(f"*{_PARQUET}"))

    def tidy(self) -> None:
        """Remove what writers that were stopped have left unfinished."""
        for part in self.folder.rglob(f"*{_UNFINISHED}"):
            with suppress(OSError):
                part.unlink()


def parquet(table: pa.Table) -> bytes:
    """A table as a Parquet file; the same table gives the same bytes."""
    sink = pa.BufferOutputStream()
    pq.write_table(table, sink, compression="zstd")
    return bytes(sink.getvalue())


def column(path: Path, name: str) -> list[Any]:
    """One column of a Parquet file."""
    found: list[Any] = pq.read_table(path, columns=[name]).column(name).to_pylist()
    return found


def sound(path: Path) -> bool:
    """Whether a file that is named after its content still has it.

    The digest is all of the name, or its last part before the ending; that of an object begins in
    the name of its folder.
    """
    name = path.name.removesuffix(_PARQUET)
    named = name.rpartition(".")[2] if path.name.endswith(_PARQUET) else name.partition(".")[0]
    if path.parent.parent.name == OBJECTS:
        named = path.parent.name + named
    try:
        return digest(path.read_bytes()) == named
    except OSError:
        return False
