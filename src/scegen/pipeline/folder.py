"""The output folder: written whole or not at all, and never over somebody's own edits."""

import hashlib
import json
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from scegen.errors import InputError

SUMMARY_FILE = "summary.json"
_DEEPEST = 3
"""Files lie in the folder, or in ``scenarios/NAME/`` of it."""


def digest(content: bytes) -> str:
    """SHA-256 of a file's content, in hexadecimal."""
    return hashlib.sha256(content).hexdigest()


def require_usable(folder: Path, *, force: bool) -> None:
    """Refuse a folder that cannot be written, or whose content would be lost.

    Files made here and not changed since are replaced; a file that somebody edited, or a
    folder that something else filled, is only touched with ``force``.

    Raises:
        InputError: says which file or folder is in the way, and what to do.
    """
    if folder.exists() and not folder.is_dir():
        raise InputError("is a file, not a folder", where=str(folder), hint="choose another -o")
    existing = next(p for p in (folder, *folder.absolute().parents) if p.exists())
    try:
        with tempfile.TemporaryDirectory(prefix=".scegen-", dir=existing):
            pass
    except OSError as error:
        raise InputError.unwritable(error, folder, "choose another -o") from error
    if force or not folder.exists() or not any(folder.iterdir()):
        return
    for name, reason in _in_the_way(folder):
        raise InputError(
            f"{name} {reason}",
            where=str(folder),
            hint="choose another -o, or --force to replace what is there",
        )


def _in_the_way(folder: Path) -> Iterator[tuple[str, str]]:
    made = made_files(folder)
    if not made:
        yield "the folder", "is not empty and was not made by scegen generate"
        return
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and p != folder / SUMMARY_FILE):
        name = path.relative_to(folder).as_posix()
        if name not in made:
            yield name, "was not made by scegen generate"
        elif digest(path.read_bytes()) != made[name]:
            yield name, "was changed since it was made"


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files by name into a folder, which is made if need be.

    Raises:
        InputError: it cannot be written to.
    """
    try:
        for name, content in files.items():
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
    except OSError as error:
        raise InputError.unwritable(error, folder) from error


def summary_of(folder: Path) -> dict[str, Any]:
    """What a folder's summary says; nothing where there is none.

    Raises:
        InputError: it cannot be read.
    """
    file = folder / SUMMARY_FILE
    if not file.is_file():
        return {}
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise InputError("cannot be read", where=SUMMARY_FILE) from error
    if not isinstance(found, dict):
        raise InputError("is no summary", where=SUMMARY_FILE)
    return found


def made_files(folder: Path) -> dict[str, str]:
    """The files that the summary says were made here, and the digest of each."""
    try:
        listed = dict(summary_of(folder)["files"])
        return {str(name): str(content) for name, content in listed.items()}
    except (InputError, ValueError, KeyError, TypeError):
        return {}


def record(file: Path) -> None:
    """Tell the summary of the folder in which a file was made, if generate made it, of the file.

    It is then ours: the next run may replace or remove it, unless somebody has changed it.
    """
    place = file.absolute()
    for folder in place.parents[:_DEEPEST]:
        made = made_files(folder)
        if not made:
            continue
        summary = folder / SUMMARY_FILE
        made[place.relative_to(folder).as_posix()] = digest(place.read_bytes())
        told = summary_of(folder) | {"files": dict(sorted(made.items()))}
        text = json.dumps(told, indent=2, ensure_ascii=False) + "\n"
        summary.write_text(text, encoding="utf-8")
        return


def replace_content(folder: Path, staged: Path) -> None:
    """Move everything in ``staged`` into ``folder``, in place of what was made there before.

    What else lies there stays. What is replaced is kept aside until all is in place, and put back
    if anything fails.

    Raises:
        InputError: the folder cannot be written; it is as it was before.
    """
    made_here = not folder.exists()
    earlier = {name.split("/")[0] for name in made_files(folder)} - {".", "..", ""}
    stale = sorted(n for n in earlier if (folder / n).exists() and not (staged / n).exists())
    moved: list[tuple[Path, Path | None]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".scegen-", dir=folder) as work:
            fresh, old = Path(work, "new"), Path(work, "old")
            shutil.copytree(staged, fresh)
            old.mkdir()
            try:
                for source in sorted(fresh.iterdir()):
                    target = folder / source.name
                    kept = target.rename(old / source.name) if target.exists() else None
                    moved.append((target, kept))
                    source.rename(target)
                for name in stale:
                    target = folder / name
                    moved.append((target, target.rename(old / name)))
            except OSError:
                _put_back(moved)
                raise
    except OSError as error:
        if made_here:
            shutil.rmtree(folder, ignore_errors=True)
        raise InputError.unwritable(error, folder, "choose another -o") from error


def _put_back(moved: list[tuple[Path, Path | None]]) -> None:
    for target, kept in reversed(moved):
        if target.is_dir():
            shutil.rmtree(target, ignore_errors=True)
        else:
            target.unlink(missing_ok=True)
        if kept is not None:
            kept.rename(target)
