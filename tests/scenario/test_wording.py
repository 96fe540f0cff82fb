"""Counts, articles and verbs, as people write them."""

import pytest

from scegen.scenario.acts import ActKind
from scegen.scenario.verbs import does, goes, has_done
from scegen.scenario.vocabulary import ParticipantKind
from scegen.scenario.wording import change, counted, covering, with_article


def test_one_is_one():
    assert [counted(n, "scenario") for n in (0, 1, 1024)] == [
        "0 scenarios", "1 scenario", "1,024 scenarios",
    ]  # fmt: skip
    assert covering(1) == "1 scenario covers every meeting"
    assert covering(2) == "2 scenarios cover every meeting"


@pytest.mark.parametrize("noun", ["an animal", "an emergency vehicle", "a car", "a van"])
def test_articles(noun):
    assert with_article(noun.split(" ", 1)[1]) == noun


def test_an_arrow_lies_between_two_figures_only():
    assert (change("40", "40"), change("–", "40")) == ("40", "– → 40")


def test_every_act_is_done_and_has_been_done():
    assert {does(kind) for kind in ActKind} == {
        "brakes", "accelerates", "stops", "waits", "gives way", "sets off", "changes lane",
        "swerves", "turns", "enters", "crosses", "reverses", "opens a door", "overtakes",
    }  # fmt: skip
    assert {has_done(kind).removeprefix("has ") for kind in ActKind} == {
        "braked", "accelerated", "stopped", "waited", "given way", "set off", "changed lane",
        "swerved", "turned", "entered", "crossed", "reversed", "opened a door", "overtaken",
    }  # fmt: skip


def test_nobody_on_foot_drives():
    kinds = (ParticipantKind.PEDESTRIAN, ParticipantKind.BICYCLE, ParticipantKind.VAN)
    assert [goes(kind) for kind in kinds] == ["walks", "rides", "drives"]
