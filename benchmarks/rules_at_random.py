"""Random traffic under every rule of the road, with and without a breach that is said.

    python benchmarks/rules_at_random.py [--number N] [--rule RULE] [--json]

Each situation (tests/helpers/random_traffic.py) is made, its danger raised where there is one, its
files played in esmini, and judged on the recording by code that knows nothing of how it was made
(tests/helpers/judging_rules.py). Without a breach nobody breaks a rule and nobody waits for ever;
with one, whoever is said to breaks exactly that rule; and either way every claim holds. Texts that
contradict themselves (one who is said to fail to yield has right of way wherever the words let it
be) are refused and counted apart.
Ends with 1 where that is not so.
"""

from __future__ import annotations

import argparse
import itertools
import json
import sys
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
from judging_rules import broken
from random_traffic import RULES, contradicts, traffic

from scegen.checking.recording import record
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError
from scegen.pipeline.export import SCENARIO_FILE, export_scenario
from scegen.pipeline.picking import pick

_MOST_DRAWN = 4
"""Situations drawn for one that is made, at most: others contradict themselves."""


def played(rule: str, seed: int, *, breach: bool) -> tuple[set, set, tuple[str, ...], bool]:
    """What is broken and what was said to be, the claims that are missed, whether it is reached."""
    functional = traffic(rule, seed, breach=breach)
    listed = enumerate_scenarios(functional, limit=50)
    logical = pick(listed, None)[seed % len(listed.scenarios)]
    if contradicts(rule, functional, logical):
        raise InfeasibleError("who is said to break the rule has right of way")
    concrete = concretize(functional, logical, seed=seed)
    target = "near-miss" if breach else "avoided"
    raised = raise_criticality(functional, concrete, target=target, seed=seed)
    files = export_scenario(raised.concrete)
    by = {name for hazard in functional.hazards for name in hazard.by}
    with TemporaryDirectory() as folder:
        for name, content in files.items():
            (Path(folder) / name).write_bytes(content)
        log = record(Path(folder) / SCENARIO_FILE, raised.concrete).csv
    found = broken(rule, raised.concrete.logical, files, log, by)
    missed = tuple(claim.id for claim in raised.proof.missed)
    return found, by, missed, raised.proof.in_band


def wrong(rule: str, found: set, by: set) -> set:
    """What is broken by those who are not said to break it, or otherwise than is said."""
    allowed = {"signals": {"red", "way"}}.get(rule, {"way", "stop"})
    return {item for item in found if item[1] not in by or item[0] not in allowed}


def main() -> int:
    """Print how many keep the rules, and who does not."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--number", type=int, default=50, help="made for each rule")
    parser.add_argument("--rule", choices=list(RULES))
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    rows: dict[str, Counter[str]] = {}
    for rule in [options.rule] if options.rule else RULES:
        for breach in (False, True):
            count = rows.setdefault(f"{rule}, {'breach' if breach else 'no breach'}", Counter())
            for seed in itertools.count():
                if count["made"] == options.number or seed == _MOST_DRAWN * options.number:
                    break
                begin = perf_counter()
                try:
                    found, by, missed, reached = played(rule, seed, breach=breach)
                except InfeasibleError as error:
                    count["contradictory"] += 1
                    print(f"{rule} {seed} refused: {error}".splitlines()[0], file=sys.stderr)
                    continue
                bad = wrong(rule, found, by)
                seen = rule != "signals" or not by or ("red", *by, None) in found
                count["made"] += 1
                count["as said" if seen and not (bad or missed) else "not as said"] += 1
                count["a rule broken"] += bool(bad)
                count["a claim missed"] += bool(missed)
                count["danger not reached"] += bool(by) and not reached
                words = f"{sorted(map(str, bad))} {missed or ''}" if bad or missed else "as said"
                took = perf_counter() - begin
                print(f"{rule} {seed} {breach}: {words} ({took:.1f} s)", file=sys.stderr)
    if options.json:
        print(json.dumps(rows, indent=2))
    else:
        print("\n".join(f"{name}: {dict(count)}" for name, count in rows.items()))
    return int(any(count["not as said"] for count in rows.values()))


if __name__ == "__main__":
    sys.exit(main())
