"""Large libraries that nothing here needs are not loaded along with those that are used."""

import subprocess
import sys

import pytest


@pytest.mark.parametrize(
    ("module", "large"),
    [
        ("scegen.export.opendrive, scegen.export.openscenario", ("scipy.integrate", "xmlschema")),
        ("scegen.criticality.search.optimize", ("scipy.stats", "scipy.linalg")),
        ("scegen.motion.batch.kernels", ("scipy.linalg", "cffi")),
    ],
)
def test_what_nothing_needs_is_not_loaded_and_can_be_later(module, large):
    code = f"import sys, {module}; print([n for n in {large} if n in sys.modules])"
    later = f"\nimport {', '.join(name for name in large if name != 'cffi')}"
    done = subprocess.run(
        [sys.executable, "-c", code + later], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
