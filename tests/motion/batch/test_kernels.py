"""Compiled kernels and their cache."""

import ast
from pathlib import Path

from scegen.motion.batch import kernels


def test_an_edited_kernel_file_gives_another_cache_folder(tmp_path):
    source = tmp_path / "callee.py"
    source.write_text("@kernel\ndef one():\n    return 1\n")
    before = kernels._fingerprint(tmp_path)
    kernels._fingerprint.cache_clear()
    assert kernels._fingerprint(tmp_path) == before
    source.write_text("@kernel\ndef one():\n    return 2\n")
    kernels._fingerprint.cache_clear()
    assert kernels._fingerprint(tmp_path) != before


def test_numba_is_decorated_with_in_one_place_only():
    package = Path(kernels.__file__).parents[2]
    importers = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if any(
            "numba" in (alias.name for alias in node.names)
            for node in ast.walk(ast.parse(path.read_text()))
            if isinstance(node, ast.Import)
        )
    ]
    assert importers == ["motion/batch/kernels.py"]
