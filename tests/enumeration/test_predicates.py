"""Each predicate that the solver is told of is one that the encodings ask for."""

import re
from importlib.resources import files

import pytest

from scegen.enumeration import predicates

FOR_USERS = {"kind"}
"""Told for the rules that a user writes."""
NAMES = sorted({p.meta.name for p in vars(predicates).values() if hasattr(p, "meta")} - FOR_USERS)


@pytest.fixture(scope="module")
def asked():
    encodings = files("scegen.enumeration") / "encodings"
    rules = "\n".join(f.read_text() for f in encodings.iterdir() if f.name.endswith(".lp"))
    return set(re.findall(r"\b[a-z]\w*", re.sub(r"%.*", "", rules)))


@pytest.mark.parametrize("name", NAMES)
def test_what_is_told_is_asked_for(name, asked):
    assert name in asked
