"""Descriptions from the text to checked files: every statement, every danger, and the target.

    python benchmarks/end_to_end.py FILE.jsonl [--only ID …] [--seed N] [--json]

FILE has one JSON object a line with ``id`` and ``text``. Each is generated offline with quick
checks. It counts where every claim holds, the target is in its band, every danger that was asked
for happens and no check fails. Ends with 1 below nine of ten.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from time import perf_counter

from scegen.errors import ScegenError
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.understanding import read

GOAL = 0.9


@dataclass(frozen=True, slots=True)
class Row:
    """One description, and what is left to wish for; nothing where all is as said."""

    id: str
    text: str
    scenario: str
    claims: int
    wanting: tuple[str, ...]
    seconds: float


def made(item: dict[str, str], seed: int) -> Row:
    """Generate one description, and judge what came of it."""
    begin = perf_counter()
    scenario, claims, wanting = "", 0, []
    with tempfile.TemporaryDirectory(prefix="scegen-end-") as folder:
        try:
            options = Options(seed=seed, depth=CheckDepth.QUICK)
            result = generate(read(item["text"]), Path(folder) / "made", options)
        except ScegenError as error:
            wanting.append(error.render())
        else:
            ((scenario, proof),) = result.proofs.items()
            claims = len(proof.claims)
            wanting += [f"claim: {c.statement}: {c.found}" for c in proof.missed]
            wanting += [f"danger: no {h.kind}" for h in proof.hazards if not h.happened]
            if not proof.in_band:
                wanting.append(f"target: {proof.target} not met: {proof.blocked_by or '-'}")
            wanting += [
                f"check: {done.checker}: {done.findings[0].message if done.findings else '-'}"
                for done in result.checks[scenario].results
                if done.status == "failed"
            ]
    seconds = round(perf_counter() - begin, 1)
    return Row(item["id"], item["text"], scenario, claims, tuple(wanting), seconds)


def rows(file: Path, only: list[str], seed: int) -> Iterator[Row]:
    """Every description of the file, told as it is done."""
    for line in file.read_text(encoding="utf-8").splitlines():
        item = json.loads(line)
        if only and item["id"] not in only:
            continue
        row = made(item, seed)
        words = f"no: {row.text}" if row.wanting else "yes"
        told = [f"{row.id}: {words} ({row.claims} claims, {row.seconds} s)"]
        told += [f"    {w}" for w in row.wanting]
        print("\n".join(told), file=sys.stderr, flush=True)
        yield row


def main() -> int:
    """Print how many are made as they are said."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=Path)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    done = list(rows(options.file, options.only, options.seed))
    right = sum(not row.wanting for row in done)
    if options.json:
        data = {"right": right, "descriptions": len(done), "rows": [asdict(r) for r in done]}
        print(json.dumps(data, indent=2))
    else:
        print(f"made as said: {right} of {len(done)}")
    return int(right < GOAL * len(done))


if __name__ == "__main__":
    sys.exit(main())
