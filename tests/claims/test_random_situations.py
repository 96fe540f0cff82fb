"""Random situations: what does not hold is told, and the player shows the same as our own traces.

`python benchmarks/said_at_random.py` plays 200 of them.
"""

import pytest
from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st
from playing import play
from random_said import situation

from scegen.checking.environment import esmini
from scegen.claims import claims_of
from scegen.enumeration import enumerate_scenarios
from scegen.errors import InfeasibleError

SEEDS = st.integers(0, 999)
SOME = {"deadline": None, "derandomize": True, "suppress_health_check": list(HealthCheck)}


def twice(seed, *, files):
    """Played, or refused with a reason; nothing is judged otherwise the second time."""
    found = play(situation(seed), seed, files=files)
    event(found.refused or f"{len(found.missed)} missed")
    if found.refused:
        return
    assert [(ours.statement, theirs.found) for ours, theirs in found.disagreeing] == []
    assert all(claim.statement and claim.field for claim in found.missed)


@settings(max_examples=10, **SOME)
@given(SEEDS)
def test_our_own_simulation_shows_what_is_told(seed):
    twice(seed, files=False)


@pytest.mark.esmini
@pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
@settings(max_examples=10, **SOME)
@given(SEEDS)
def test_the_player_shows_what_is_told(seed):
    twice(seed, files=True)


@settings(max_examples=60, **SOME)
@given(SEEDS)
def test_no_two_claims_have_one_name(seed):
    functional = situation(seed)
    logical = next(iter(_listed(functional)), None)
    if logical is not None:
        names = [claim.id for claim in claims_of(functional, logical)]
        assert len(names) == len(set(names))


def _listed(functional):
    try:
        return enumerate_scenarios(functional, limit=1).scenarios
    except InfeasibleError:
        return []
