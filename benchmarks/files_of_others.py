"""What `scegen check` says of files that others made: verdicts per checker, findings per rule.

    python benchmarks/files_of_others.py FILE|DIR… [--asam]

Nothing of theirs lies here: fetch what you want to look at (esmini's ``resources``, Euro NCAP's and
UN R157's OpenSCENARIO files) and name it. A file that cannot be looked at at all is listed with the
reason; a traceback would end the run, and is what this is run for.
"""

from __future__ import annotations

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

from scegen.checking import CheckReport, check_files
from scegen.checking.check import CHECKERS, QUICK_CHECKERS
from scegen.errors import ScegenError


def files(places: list[Path]) -> Iterator[Path]:
    """The OpenDRIVE and OpenSCENARIO files below some places; catalogs are no scenarios."""
    for place in places:
        found = sorted(place.rglob("*.xo*")) if place.is_dir() else [place]
        for path in found:
            if path.suffix in {".xodr", ".xosc"} and b"<Catalog " not in path.read_bytes():
                yield path


def main() -> None:
    """Check everything, and print both tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("places", nargs="+", type=Path)
    parser.add_argument("--asam", action="store_true", help="ASAM's rules too (slower)")
    asked = parser.parse_args()
    checkers = CHECKERS if asked.asam else QUICK_CHECKERS
    reports: list[CheckReport] = []
    for path in files(asked.places):
        try:
            reports += check_files([path], checkers)
        except ScegenError as problem:
            print(f"{path.name}: {problem.message}")
    verdicts = Counter((r.checker, r.status.value) for report in reports for r in report.results)
    for (checker, status), number in sorted(verdicts.items()):
        print(f"{checker:18} {status:8} {number}")
    where: dict[tuple[str, str], set[str]] = defaultdict(set)
    for report in reports:
        for finding in (f for result in report.results for f in result.findings):
            where[finding.severity.value, finding.rule].add(Path(report.folder).name)
    for (severity, rule), names in sorted(where.items()):
        print(f"{severity:10} {rule:24} {len(names):4} files, as {min(names)}")


if __name__ == "__main__":
    main()
