"""The table of hazards is complete and says nothing twice."""

from __future__ import annotations

import pytest

from scegen.claims.hazards import thresholds
from scegen.scenario.hazards import HAZARDS, Case, Party
from scegen.scenario.vocabulary import HazardKind


def test_every_kind_has_its_row() -> None:
    assert list(HAZARDS) == list(HazardKind)


@pytest.mark.parametrize("kind", HazardKind)
def test_a_row_is_whole(kind: HazardKind) -> None:
    row = HAZARDS[kind]
    assert row.meaning.text
    assert row.meaning.is_not
    assert row.meaning.example
    assert row.causes
    assert row.suffers
    assert len(set(row.causes)) == len(row.causes)


@pytest.mark.parametrize("kind", HazardKind)
def test_somebody_is_always_found_to_suffer(kind: HazardKind) -> None:
    assert HAZARDS[kind].suffers[-2:] == (Party.EGO, Party.OTHERS)


@pytest.mark.parametrize("kind", HazardKind)
def test_cases_of_one_row_leave_no_gap_between_them(kind: HazardKind) -> None:
    cases = set(HAZARDS[kind].needs)
    assert Case.PLAIN_ROAD not in cases or cases & {Case.ANYWHERE, Case.ONE_ARM}
    assert Case.ANYWHERE not in cases or not cases & {Case.ONE_ARM, Case.APART}


@pytest.mark.parametrize("kind", HazardKind)
def test_definitions_name_only_words_that_exist(kind: HazardKind) -> None:
    named = HAZARDS[kind].meaning.is_not.split("`")[1::2]
    assert set(named) <= set(HazardKind) - {kind}


def test_definitions_give_the_numbers_that_the_predicates_use() -> None:
    braking, cut_in = HAZARDS[HazardKind.HARD_BRAKING], HAZARDS[HazardKind.CUT_IN]
    assert f"at least {thresholds.HARD_BRAKING.value:g} m/s2" in braking.meaning.text
    assert f"{thresholds.CUT_IN_GAP.value:g} s or more ahead" in cut_in.meaning.is_not
