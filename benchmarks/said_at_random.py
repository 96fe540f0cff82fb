"""Random functional scenarios from the numbers to the player: what is said, and whether it holds.

    python benchmarks/said_at_random.py [--number N] [--save FOLDER] [--json]

Every kind of junction and of danger, with and without numbers (tests/helpers/random_said.py). Each
is made, its danger raised, its files played in esmini (where it is on PATH), and every claim judged
on our own traces and on the recording. Ends with 1 if one of them is judged
otherwise there, or if anything crashes.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
from playing import Played, play
from random_said import situation

from scegen.scenario.files import to_yaml

CRASH = "crash: "


def played(number: int) -> Iterator[Played]:
    """So many situations, each made and played; the same each time."""
    for seed in range(number):
        begin = perf_counter()
        try:
            row = play(situation(seed), seed)
        except Exception as error:  # noqa: BLE001 - told, and looked at later
            row = Played(situation(seed), refused=f"{CRASH}{type(error).__name__}: {error}")
        words = row.refused or f"{len(row.missed)} missed, {len(row.disagreeing)} judged otherwise"
        kinds = ", ".join(h.kind for h in row.functional.hazards) or "no danger"
        print(
            f"{seed:3} {row.functional.junction.kind}, {kinds}: {words.splitlines()[0][:90]} "
            f"({perf_counter() - begin:.1f} s)",
            file=sys.stderr,
            flush=True,
        )
        yield row


def main() -> int:
    """Print what holds, what does not, and what the player shows otherwise."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--number", type=int, default=200)
    parser.add_argument("--save", type=Path)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    rows = list(played(options.number))
    missed: Counter[str] = Counter()
    otherwise: list[str] = []
    for number, row in enumerate(rows):
        missed.update({claim.id.partition(".")[0] for claim in row.missed})
        otherwise += [
            f"{number}: {ours.statement}: {ours.found} / {theirs.found}"
            for ours, theirs in row.disagreeing
        ]
        if options.save and (row.missed or row.disagreeing or row.refused):
            options.save.mkdir(parents=True, exist_ok=True)
            said = [f"# refused: {row.refused}"] if row.refused else []
            said += [f"# missed: {c.id}: {c.statement}: {c.found}" for c in row.missed]
            said += [f"# otherwise: {o.id}: {o.found} / {t.found}" for o, t in row.disagreeing]
            if row.proof and row.proof.blocked_by:
                said.append(f"# {row.proof.blocked_by}")
            text = "\n".join([*said, to_yaml(row.functional)])
            (options.save / f"{number:03}.yaml").write_text(text)
    made = [row for row in rows if row.proof]
    crashed = sum(row.refused.startswith(CRASH) for row in rows)
    claims = sum(len(row.recorded) for row in made)
    data = {
        "scenarios": len(rows),
        "refused": len(rows) - len(made) - crashed,
        "crashed": crashed,
        "everything holds": sum(not row.missed for row in made),
        "missed, and told": dict(missed.most_common()),
        "judged twice": claims,
        "judged otherwise": otherwise,
    }
    if options.json:
        print(json.dumps(data, indent=2))
    else:
        print("\n".join(f"{name}: {value}" for name, value in data.items()))
    return int(bool(otherwise or crashed))


if __name__ == "__main__":
    sys.exit(main())
