"""Whoever says that nobody is touched does not ask for a contact, however it is said."""

import pytest

from scegen.understanding import read

CONTACTS = ("touches", "hits", "runs into", "collides with")
NOBODY = ("neither", "neither of them", "none of them", "nobody", "no one", "no car", "nothing")
BEFORE = "Two cars come towards the ego at a crossroads and go straight on."


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("nobody", NOBODY)
def test_who_touches_nobody_collides_with_nobody(contact, nobody):
    outcome = read(f"{BEFORE} The ego turns left and {contact} {nobody}.").outcome
    assert outcome is not None
    assert outcome.kind == "avoided"


@pytest.mark.parametrize(
    "ending", ["Nobody is hit.", "No one is touched.", "Nobody hits anybody.", "No car is hit."]
)
def test_nobody_is_touched_by_whom_nobody_touches(ending):
    outcome = read(f"{BEFORE} The ego turns left. {ending}").outcome
    assert outcome is not None
    assert outcome.kind == "avoided"


@pytest.mark.parametrize("contact", CONTACTS)
def test_who_is_named_is_hit(contact):
    outcome = read(f"{BEFORE} The ego turns left and {contact} one of them.").outcome
    assert outcome is not None
    assert outcome.kind == "collision"


def test_who_does_nothing_else_does_not_hit_nobody():
    text = (
        "The ego drives towards a standing car. Nobody brakes, and its front hits the car's rear."
    )
    outcome = read(text).outcome
    assert outcome is not None
    assert outcome.kind == "collision"
