"""Provenance: who changed what, also as older files tell it."""

import pytest
from pydantic import ValidationError

from scegen.scenario.concrete import Change, Rejected
from scegen.scenario.proof import Advice, Proof


def test_changes_of_older_files_still_load():
    old = {"parameter": "car_1.speed_mps", "by": "search", "before": 9.0, "after": 10.0}
    change = Change.model_validate({**old, "reason": "near-miss"})
    assert change.rejected is None


def test_proofs_of_older_files_still_load():
    proof = Proof.model_validate({"target": "near-miss", "in_band": True, "in_band_before": False})
    assert proof.advice is None


def test_what_became_of_proposals_is_counted():
    rejected = Rejected(by="x", value="500", why="lies outside 0 to 60 m/s")

    def change(after, why=None):
        return Change(parameter="a", by="x", after=after, reason="y", rejected=why)

    advice = Advice(
        speaker="x", changes=(change(1.0), change(2.0, rejected), change(None, rejected))
    )
    assert (advice.accepted, advice.replaced, advice.dropped) == (1, 1, 1)


def test_a_rejection_says_why():
    with pytest.raises(ValidationError):
        Rejected(by="x", value="500")
