"""Plain data as YAML: the same text as the library's own way."""

from __future__ import annotations

import yaml
from hypothesis import given
from hypothesis import strategies as st

from scegen.scenario.yaml_text import yaml_text

WORDS = st.sampled_from(("yes", "null", "1", "1.5", "~", "a: b", "# c", "car_1", "", "-", "1e3"))
SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(allow_nan=False, allow_infinity=False),
    WORDS,
    st.text(max_size=200),
)
DATA = st.recursive(
    SCALARS,
    lambda inside: st.lists(inside, max_size=5) | st.dictionaries(st.text(), inside, max_size=5),
    max_leaves=30,
)


@given(DATA)
def test_as_the_library_writes_it(data: object) -> None:
    written = yaml.dump(
        data, Dumper=yaml.CSafeDumper, sort_keys=False, allow_unicode=True, width=100
    )
    assert yaml_text(data) == written


def test_equal_numbers_of_other_kinds_are_told_apart() -> None:
    assert yaml_text([1, True, 1.0, 0, False, -0.0, 0.0]) == (
        "- 1\n- true\n- 1.0\n- 0\n- false\n- -0.0\n- 0.0\n"
    )
