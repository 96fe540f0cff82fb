"""Every example runs from start to end, and its files pass our own checks."""

from pathlib import Path

import pytest

from scegen.pipeline.generate import generate
from scegen.pipeline.options import Options
from scegen.pipeline.source import resolve_source

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("example", sorted(p.name for p in EXAMPLES.iterdir() if p.suffix != ".py"))
def test_example(example, tmp_path):
    result = generate(resolve_source(str(EXAMPLES / example)), tmp_path / "out", Options(count=2))
    assert result.checks
    for report in result.checks.values():
        assert report.ok, [f for r in report.results for f in r.errors]
        assert report.result("opendrive").status == "passed"
        assert report.result("openscenario").status == "passed"
