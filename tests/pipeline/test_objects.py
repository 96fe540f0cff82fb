"""From words to files: dangers that nobody in traffic causes happen."""

import pytest

from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load
from scegen.understanding import read

SENTENCES = {
    "mattress": "On a straight road the ego brakes hard because a mattress lies in its lane.",
    "roadworks": "The ego changes lanes on a two-lane road because of roadworks.",
    "line": "A van ahead of the ego brakes hard for a fallen tree on a straight road.",
    "kiosk": "A pedestrian runs out from behind a kiosk on the left of a straight road and the ego "
    "brakes hard.",
    "trolley": "The ego reverses at 4 km/h and its rear hits a shopping trolley behind it.",
    "hedge": "The ego comes to a T-intersection; a hedge hides a speeding car from the right.",
}


@pytest.mark.parametrize("name", SENTENCES)
def test_every_danger_happens_and_the_files_are_sound(tmp_path, name):
    result = generate(read(SENTENCES[name]), tmp_path, Options(depth=CheckDepth.QUICK))
    assert result.ok
    ((made, proof),) = result.proofs.items()
    assert proof.reached, proof.blocked_by
    concrete = load(tmp_path / "scenarios" / made / "concrete.yaml", ConcreteScenario)
    (thing,) = concrete.objects
    assert thing.id in {who for hazard in proof.hazards for who in hazard.by}
    assert thing.id in (tmp_path / "report.html").read_text()


def test_the_same_words_give_the_same_bytes(tmp_path):
    for folder in ("one", "two"):
        generate(read(SENTENCES["hedge"]), tmp_path / folder, Options(depth=CheckDepth.NONE))
    one, two = (
        {p.relative_to(tmp_path / f): p.read_bytes() for p in (tmp_path / f).rglob("*.*")}
        for f in ("one", "two")
    )
    assert one == two
