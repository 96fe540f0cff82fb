"""These tests take minutes of other programs' time: they run only when asked for by marker."""

from __future__ import annotations

import pytest


def pytest_collection_modifyitems(config, items):
    if "interop" not in (config.option.markexpr or ""):
        for item in items:
            if item.get_closest_marker("interop"):
                item.add_marker(pytest.mark.skip(reason="run: make interop (pytest -m interop)"))
