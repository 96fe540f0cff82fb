"""Whichever of its scenarios one picks: what the description says happens in it."""

import pytest

from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.understanding import read

TEXTS = {
    "a lane change in the ring to either side": "A roundabout with multiple exits, where one "
    "vehicle changes lanes abruptly to exit, causing potential conflict with another vehicle "
    "entering at high speed.",
    "a stop in the turn": "The ego approaches an intersection. A car from the right suddenly "
    "accelerates, enters the intersection first and suddenly stops.",
    "a pavement opposite": "The ego turns left at an intersection; a pedestrian on the opposite "
    "sidewalk suddenly crosses the road from the right.",
    "a side road behind parked cars": "At a T-junction two parked cars block the ego's "
    "view. The ego goes straight on while a car turns left out of the side road.",
    "backwards over the middle of the road": "The ego reverses straight back at 4 km/h. Behind "
    "it a pedestrian crosses at 5 km/h from the ego's right and is hit by its rear.",
}


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_all_that_is_said_holds_in_each(text, tmp_path):
    made = generate(read(text), tmp_path / "made", Options(count=4, depth=CheckDepth.QUICK))
    assert len(made.checks) > 1
    missed = {n: [c.statement for c in p.missed] for n, p in made.proofs.items() if p.missed}
    assert not missed
    assert all(report.ok for report in made.checks.values())
