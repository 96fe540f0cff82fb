"""The project folder: one folder for each piece of work, as ``scegen generate`` makes them.

What lies there may come from the command line, and goes back to it. Names that a browser sends are
only ever compared with the names that are there.
"""

import io
import re
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from scegen.checking.subject import FUNCTIONAL_FILE
from scegen.errors import InputError
from scegen.pipeline.folder import SUMMARY_FILE, digest, made_files, summary_of

_WORDS_IN_NAME = 5
_LONGEST_NAME = 48
_EPOCH = (1980, 1, 1, 0, 0, 0)
"""Zip files know no earlier time; with the same one in all, the same files give the same bytes."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A folder of the project, for a list."""

    name: str
    description: str
    scenarios: int


class Project:
    """The folder that a server works in; it is made when something is first kept."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()

    def entries(self) -> list[Entry]:
        """What can be opened, the newest first."""
        if not self.root.is_dir():
            return []
        folders = [
            folder
            for folder in self.root.iterdir()
            if any((folder / name).is_file() for name in (FUNCTIONAL_FILE, SUMMARY_FILE))
        ]
        folders.sort(key=lambda folder: (-folder.stat().st_mtime, folder.name))
        return [_entry(folder) for folder in folders if not folder.is_symlink()]

    def folder(self, name: str) -> Path:
        """The folder that an entry names.

        Raises:
            InputError: there is none of this name.
        """
        if name not in {entry.name for entry in self.entries()}:
            raise InputError("there is no such work in the project", where=name[:_LONGEST_NAME])
        return self.root / name

    def new_folder(self, description: str) -> Path:
        """A folder of its own for new work, named after its first words; made here."""
        words = re.findall(r"[a-z0-9]+", description.lower())[:_WORDS_IN_NAME]
        stem = "-".join(words)[:_LONGEST_NAME].strip("-") or "scenario"
        number = 1
        while True:
            folder = self.root / (stem if number == 1 else f"{stem}-{number}")
            try:
                folder.mkdir(parents=True)
            except FileExistsError:
                number += 1
            except OSError as error:
                raise InputError(
                    f"the project folder cannot be written: {error.strerror}",
                    hint="start scegen serve with another folder",
                ) from error
            else:
                return folder


def keep(folder: Path, name: str, content: bytes) -> None:
    """Write a file of a piece of work, whole or not at all."""
    with tempfile.NamedTemporaryFile(dir=folder, prefix=".scegen-", delete=False) as file:
        file.write(content)
    Path(file.name).replace(folder / name)


def changed_outside(folder: Path, kept: str | None) -> bool:
    """Whether somebody else wrote to a folder since.

    ``kept`` is the digest of the functional scenario as it was last written or read here.
    """
    functional = folder / FUNCTIONAL_FILE
    if kept is not None and functional.is_file() and digest(functional.read_bytes()) != kept:
        return True
    own = {FUNCTIONAL_FILE, SUMMARY_FILE}
    made = made_files(folder)
    others = {p.relative_to(folder).as_posix(): p for p in folder.rglob("*") if p.is_file()}
    return any(
        made.get(name) != digest(p.read_bytes()) for name, p in others.items() if name not in own
    )


def zipped(folder: Path, readme: str) -> bytes:
    """What was made in a folder as a zip file, with a README; the same bytes for the same files."""
    content = io.BytesIO()
    files = {name: folder / name for name in [*sorted(made_files(folder)), SUMMARY_FILE]}
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, path in files.items():
            if path.is_file() and path.resolve().is_relative_to(folder.resolve()):
                archive.writestr(_info(f"{folder.name}/{name}"), path.read_bytes())
        archive.writestr(_info(f"{folder.name}/README.md"), readme)
    return content.getvalue()


def _info(name: str) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(name, _EPOCH)
    info.compress_type = zipfile.ZIP_DEFLATED
    info.external_attr = 0o644 << 16
    return info


def _entry(folder: Path) -> Entry:
    description, scenarios = "", 0
    try:
        summary = summary_of(folder)
        description, scenarios = str(summary["description"]), len(summary["scenarios"])
    except (InputError, KeyError, TypeError):
        description = _first_words(folder / FUNCTIONAL_FILE)
    return Entry(folder.name, description, scenarios)


def _first_words(file: Path) -> str:
    """The description in a functional scenario, as far as its line shows it."""
    with file.open(encoding="utf-8", errors="replace") as lines:
        for _, line in zip(range(5), lines, strict=False):
            if line.startswith("description:"):
                return line.removeprefix("description:").strip(" '\"\n")
    return ""
