"""A law: a contact that is said not to come about is none, in whatever words it is denied."""

from itertools import product

import pytest

from scegen.scenario.outcome import OutcomeKind
from scegen.understanding import read

SCENE = "The ego follows a car at 50 km/h. The car brakes at 4 m/s²"
NOUNS = ["contact", "a contact", "a collision", "the collision", "a crash", "any impact"]
DENIED = [
    "{} does not occur", "{} does not happen", "{} does not take place", "{} does not result",
    "{} does not ensue", "{} does not follow", "{} is avoided", "{} is averted",
    "{} is prevented by the ego's own braking", "{} must not occur", "{} is ruled out",
    "{} can be avoided", "{} never occurs", "{} is not allowed",
]  # fmt: skip
BEHIND = [
    "early enough for {} to be avoided", "so that {} is avoided", "in time to avoid {}",
    "avoiding {}", "thus preventing {}", "thereby averting {}", "without {}",
    "so that {} does not occur", "and it does not come to {}", "and avoids {}",
    "and manages to avoid {}", "and {} is not made",
]  # fmt: skip
VERBS = [("hit", "hits", "hitting"), ("touch", "touches", "touching"),
         ("collide with", "collides with", "colliding with"), ("strike", "strikes", "striking"),
         ("run into", "runs into", "running into")]  # fmt: skip
UNDONE = [
    "and the ego does not {0} it", "and the ego never {1} it", "without the ego {2} it",
    "and the ego stops before {2} it", "and the ego avoids {2} it", "and the ego must not {0} it",
    "and the ego stops short of {2} it", "and at no time does the ego {0} it",
    "and the ego is not to {0} it", "and the ego manages not to {0} it",
]  # fmt: skip


def _ends(text):
    outcome = read(text).outcome
    return outcome.kind if outcome is not None else None


@pytest.mark.parametrize("noun", NOUNS)
def test_a_noun_that_is_denied(noun):
    for denied in DENIED:
        text = f"{SCENE}. {denied.format(noun).capitalize()}."
        assert _ends(text) is OutcomeKind.AVOIDED, text
    for denied in BEHIND:
        text = f"{SCENE} and the ego brakes, {denied.format(noun)}."
        assert _ends(text) is OutcomeKind.AVOIDED, text


@pytest.mark.parametrize("verb", VERBS, ids=lambda v: v[0])
def test_a_verb_that_is_denied(verb):
    for undone in UNDONE:
        text = f"{SCENE} {undone.format(*verb)}."
        assert _ends(text) is OutcomeKind.AVOIDED, text


@pytest.mark.parametrize(
    ("noun", "verb"), list(product(NOUNS[1:5], ["occurs", "results", "follows"]))
)
def test_the_same_words_without_a_denial(noun, verb):
    assert _ends(f"{SCENE}. {noun.capitalize()} {verb}.") is OutcomeKind.COLLISION
