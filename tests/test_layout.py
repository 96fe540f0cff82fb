"""Tests stand where what they test stands."""

from pathlib import Path

TESTS = Path(__file__).parent
SOURCE = TESTS.parent / "src" / "scegen"
SHARED = "helpers"


def folders(root):
    found = {f.relative_to(root) for f in root.rglob("*") if f.is_dir() and any(f.glob("*.py"))}
    return {f for f in found if f.parts}


def test_every_folder_of_tests_is_one_of_the_source():
    assert folders(TESTS) - {Path(SHARED)} <= folders(SOURCE)


def test_every_package_has_tests():
    packages = {f.parts[0] for f in folders(SOURCE)}
    assert packages == {f.parts[0] for f in folders(TESTS)} - {SHARED}
