"""What proposals are worth: the search for danger without and with the offline rules.

    python benchmarks/proposals.py [SCENARIOS_PER_SENTENCE]

Over the source paper's sentences, several logical scenarios of each: how many are solved, and how
many candidates are simulated until then. Scenarios that are dangerous as first made are left out.
"""

import statistics
import sys
import time

from scegen.concretization import concretize
from scegen.criticality import OfflineProposer, raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.errors import ScegenError
from scegen.measures import warm_kernels
from scegen.pipeline.picking import pick
from scegen.understanding import paper_cases, read


def main() -> None:
    each = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    warm_kernels()
    found = []
    for case in paper_cases():
        functional = read(case.text)
        for logical in pick(enumerate_scenarios(functional), None)[:each]:
            try:
                concrete = concretize(functional, logical, seed=0)
            except ScegenError:
                continue
            runs = []
            for proposer in (None, OfflineProposer()):
                began = time.perf_counter()
                proof = raise_criticality(functional, concrete, proposer=proposer).proof
                runs.append((proof, time.perf_counter() - began))
            if runs[0][0].evaluations > 1:
                found.append((case.id, logical.index, *runs))
                show(*found[-1])
    report(found)


def show(case, index, plain, advised) -> None:
    led = advised[0].advice is not None and advised[0].advice.led
    print(
        f"{case} {index:3d}  without {plain[0].evaluations:5d} {plain[0].reached!s:5}  "
        f"with {advised[0].evaluations:5d} {advised[0].reached!s:5}  {'led' if led else ''}"
    )


def report(found) -> None:
    print(f"{len(found)} scenarios that need a search")
    for name, column in (("without", 2), ("with", 3)):
        proofs = [row[column][0] for row in found]
        evaluations = [p.evaluations for p in proofs if p.reached]
        print(
            f"{name:8} solved {len(evaluations)}, evaluations to success: median "
            f"{statistics.median(evaluations):.0f}, mean {statistics.mean(evaluations):.0f}; "
            f"{sum(row[column][1] for row in found):.1f} s in all"
        )
    led = sum(row[3][0].advice is not None and row[3][0].advice.led for row in found)
    worse = sum(row[2][0].reached > row[3][0].reached for row in found)
    print(f"led by the proposals: {led}; found without and lost with them: {worse}")


main()
