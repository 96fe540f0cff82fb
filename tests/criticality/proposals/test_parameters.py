"""Every number that may change says in words what it means."""

import pytest

from scegen.criticality.proposals.parameters import parameters_of

SENTENCES = {
    "waits": "A distracted driver delays braking at a Y-intersection while another car merges "
    "unexpectedly from the right.",
    "follows": "A vehicle tailgating another car at a four-way stop, leading to a sudden braking "
    "event as a pedestrian steps into the crosswalk.",
    "speeds up": "Two speeding vehicles approach a T-intersection simultaneously from opposite "
    "directions, one trying to make an unprotected left turn.",
}


@pytest.mark.parametrize("sentence", SENTENCES.values(), ids=SENTENCES)
def test_names_are_put_into_words(ready_for, sentence):
    stage = ready_for(sentence).stage
    found = parameters_of(stage.concrete, stage.problem().space)
    assert found
    for parameter in found:
        who, name = parameter.name.split(".", 1)
        assert who in parameter.meaning
        assert name.rsplit(".", maxsplit=1)[-1] not in parameter.meaning, "a name, not words"
        assert parameter.low <= parameter.value <= parameter.high
        assert parameter.unit in {"m", "m/s", "m/s2", "s"}
