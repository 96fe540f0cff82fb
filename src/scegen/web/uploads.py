"""Files from a browser: small, of known kinds, and read as data alone."""

import io
import zipfile
from pathlib import PurePosixPath

from scegen.errors import InputError
from scegen.pipeline.source import Source, recounted
from scegen.scenario.files import from_text, text_of
from scegen.scenario.logical import LogicalSet

LARGEST_FILE = 2_000_000
"""Bytes; what the list of two thousand scenarios takes."""
MOST_MEMBERS = 10_000
_LEVELS = (".yaml", ".yml", ".json")
_TEXTS = (".txt", ".md")
_WANTED = ("functional.yaml", "logical.json", "concrete.yaml")


def read_upload(name: str, content: bytes) -> Source | str:
    """The scenario that a file holds, or its text if it is a description.

    A zip file is looked into for the first file of a level; nothing is unpacked to disk, and its
    own names are only compared.

    Raises:
        InputError: the file is too large, of another kind, or does not follow its schema.
    """
    shown = PurePosixPath(name.replace("\\", "/")).name[-80:] or "file"
    ending = PurePosixPath(shown).suffix.lower()
    if len(content) > LARGEST_FILE:
        raise InputError(f"is larger than {LARGEST_FILE / 1e6:.0f} MB", where=shown)
    if ending == ".zip":
        inner, content = _from_zip(shown, content)
        ending, shown = PurePosixPath(inner).suffix, f"{shown}: {inner}"
    if ending in _TEXTS:
        return text_of(content, where=shown)
    if ending not in _LEVELS:
        raise InputError(
            "is neither a scenario file nor a text",
            where=shown,
            hint="functional.yaml, logical.json, concrete.yaml, a .txt, or a zip that holds one",
        )
    found = from_text(text_of(content, where=shown), where=shown)
    return recounted(found) if isinstance(found, LogicalSet) else found


def _from_zip(shown: str, content: bytes) -> tuple[str, bytes]:
    """The highest level in a zip file, read no further than a file may be large."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            members = archive.infolist()
            if len(members) > MOST_MEMBERS:
                raise InputError(f"holds more than {MOST_MEMBERS:,} files", where=shown)
            by_name = {PurePosixPath(m.filename).name: m for m in reversed(members)}
            for wanted in _WANTED:
                if wanted in by_name:
                    with archive.open(by_name[wanted]) as file:
                        data = file.read(LARGEST_FILE + 1)
                    if len(data) > LARGEST_FILE:
                        raise InputError(
                            f"its {wanted} unpacks to more than {LARGEST_FILE / 1e6:.0f} MB",
                            where=shown,
                        )
                    return wanted, data
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError, EOFError) as error:
        raise InputError("is no zip file that can be read", where=shown) from error
    raise InputError(f"holds none of {', '.join(_WANTED)}", where=shown)
