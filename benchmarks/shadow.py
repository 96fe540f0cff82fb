"""What two checkouts of the offline reader make of the same texts, where it differs.

    python benchmarks/shadow.py OLD NEW FILE… [--evidence] [--brief]

OLD and NEW are checkouts (folders with ``src/scegen``). A FILE is JSON lines with a description
under ``text``, or Python, whose strings that read like sentences count. Printed is, text by text,
every field of the functional scenario that differs; exit code 1 if any does. Evidence is compared
with ``--evidence`` only.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from support import sentences

_READ = """
import json, sys
from scegen.errors import ScegenError
from scegen.understanding.reader import read
for line in sys.stdin:
    text = json.loads(line)
    try:
        found = read(text).model_dump(mode="json", exclude={"description"})
    except ScegenError as error:
        found = {"refused": f"{type(error).__name__}: {error}"}
    except Exception as error:
        found = {"crash": f"{type(error).__name__}: {error}"}
    print(json.dumps(found, sort_keys=True))
"""


def texts(paths: Sequence[Path]) -> list[str]:
    """All texts of the files, each once."""
    found: dict[str, None] = {}
    for path in paths:
        if path.suffix == ".py":
            found.update(dict.fromkeys(sentences(path)))
            continue
        lines = path.read_text(encoding="utf-8").splitlines()
        found.update(dict.fromkeys(json.loads(line)["text"] for line in lines if line.strip()))
    return list(found)


def readings(checkout: Path, of: Sequence[str]) -> list[dict[str, Any]]:
    """What the reader of a checkout gives for each text."""
    done = subprocess.run(
        [sys.executable, "-c", _READ],
        input="".join(json.dumps(text) + "\n" for text in of),
        env={**os.environ, "PYTHONPATH": str((checkout / "src").resolve())},
        capture_output=True,
        text=True,
        check=True,
        encoding="utf-8",
    )
    return [json.loads(line) for line in done.stdout.splitlines()]


def differences(old: Any, new: Any, at: str = "") -> Iterator[str]:
    """Every value that differs, with the way to it."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() | new.keys()):
            yield from differences(old.get(key), new.get(key), f"{at}.{key}" if at else key)
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for i, (a, b) in enumerate(zip(old, new, strict=True)):
            yield from differences(a, b, f"{at}[{i}]")
    elif old != new:
        yield f"{at}: {json.dumps(old)} -> {json.dumps(new)}"


def main() -> int:
    """Print what differs; exit code 1 if anything does."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--evidence", action="store_true", help="compare evidence as well")
    parser.add_argument("--brief", action="store_true", help="the texts alone")
    args = parser.parse_args()
    for checkout in (args.old, args.new):
        if not (checkout / "src" / "scegen").is_dir():
            parser.error(f"{checkout}: no checkout, it has no src/scegen")
    of = texts(args.files)
    changed = 0
    for text, old, new in zip(of, readings(args.old, of), readings(args.new, of), strict=True):
        if not args.evidence:
            old.pop("evidence", None)
            new.pop("evidence", None)
        found = list(differences(old, new))
        if found:
            changed += 1
            print(f"## {text}")
            for line in found if not args.brief else ():
                print(f"   {line}")
    print(f"{changed} of {len(of)} texts read differently")
    return int(changed > 0)


if __name__ == "__main__":
    sys.exit(main())
