"""What would help is said of a quantity only where the field holds one."""

from __future__ import annotations

import pytest

from scegen.scenario.proof import ClaimProof


@pytest.mark.parametrize(
    ("field", "helps"),
    [
        ("acts.act_1.rate_mps2", "4.2 m/s in acts.act_1.rate_mps2"),
        ("junction.control", "leave junction.control out"),
        ("outcome", "give more room (start farther away"),
    ],
)
def test_what_would_help(field, helps):
    missed = ClaimProof(
        id="claim_1", kind="rule", statement="said", field=field, holds=False, measured=4.2,
        unit="m/s",
    )  # fmt: skip
    assert missed.helps.startswith(helps)


def test_what_would_help_names_the_words():
    missed = ClaimProof(
        id="claim_1", kind="spacing", statement="said", field="spacings.0", words="20 m ahead",
        holds=False, measured=76.75, unit="m",
    )  # fmt: skip
    assert missed.helps.startswith('76.75 m instead of "20 m ahead" (spacings.0)')
