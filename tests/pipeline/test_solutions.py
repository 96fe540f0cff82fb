"""Several different ways to the same danger, side by side."""

import itertools
import json

import yaml

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.pipeline.raising import raise_danger
from scegen.understanding import read

SENTENCE = "The ego turns left at a four-way intersection while an oncoming car goes straight."


def test_each_solution_has_a_folder_of_its_own_and_reaches_the_target(tmp_path):
    options = Options(solutions=3, depth=CheckDepth.QUICK)
    result = generate(read(SENTENCE), tmp_path / "out", options)
    names = [path.name for path in sorted((tmp_path / "out" / "scenarios").iterdir())]
    first = names[0]
    assert names == [first, f"{first}-2", f"{first}-3"]
    assert result.ok
    assert all(result.proofs[name].reached for name in names)
    programs = []
    for name in names:
        concrete = yaml.safe_load((tmp_path / "out/scenarios" / name / "concrete.yaml").read_text())
        assert concrete["name"] == name
        programs.append(concrete["participants"])
    assert all(a != b for a, b in itertools.combinations(programs, 2))
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert [s["name"] for s in summary["scenarios"]] == names


def test_what_was_not_found_is_said():
    functional = read("The ego follows a car on a straight road.")
    logical = enumerate_scenarios(functional).scenarios[0]
    concrete = concretize(functional, logical, seed=0)
    found = raise_danger(functional, concrete, "headway=0.5..0.51", 0, lambda _: None, solutions=60)
    assert 1 < len(found.concretes) < 60
    assert all(proof.reached for proof in found.proofs.values())
    number = len(found.concretes)
    assert found.skipped == {
        f"{concrete.name}, solution {number + 1}": f"no more than {number} that differ were found"
    }
