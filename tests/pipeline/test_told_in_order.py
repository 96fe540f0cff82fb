"""One thing after another, in texts composed of parts: all that is said happens, when it is said.

From the words to the motion, every claim judged.
"""

import numpy as np
import pytest

from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.attempts import make_some
from scegen.pipeline.options import Options
from scegen.pipeline.picking import pick
from scegen.pipeline.raising import chosen_target
from scegen.understanding import read

FIRST = {
    "brakes with 3 m/s²": ("brake", "left"),
    "slows down to 40 km/h": ("brake", "right"),
    "changes to the right lane": ("change_lane", "left"),
    "cuts in from the left in front of the ego": ("change_lane", "left"),
}
THEN = {
    "changes to the {side} lane": "change_lane",
    "accelerates to 80 km/h": "accelerate",
    "brakes to a standstill": "brake",
}
ORDER = {
    "{who} {first} and then {second}.": None,
    "{who} {first}, after which it {second}.": None,
    "{who} {first}. Then it {second}.": None,
    "{who} {first} and {delay} s later {second}.": "delay",
    "{who} {first}, and after {delay} s {second}.": "delay",
    "{who} {first}. After {delay} s {who} {second}.": "delay",
}


def _drawn(seed):
    rng = np.random.default_rng(seed)
    one = lambda of: of[int(rng.integers(len(of)))]  # noqa: E731
    kind, first, second, way = (
        one([*each]) for each in (["car", "van", "truck", "bus"], FIRST, THEN, ORDER)
    )
    begin, side = FIRST[first]
    if (begin, THEN[second]) == ("brake", "brake"):
        second = "changes to the {side} lane"
    delay = int(one([3, 4, 6]))
    parts = {"who": f"the {kind}", "first": first, "second": second.format(side=side)}
    told = way.format(**parts, delay=delay)
    ahead = "" if "cuts in" in first else f"A {kind} drives ahead of the ego. "
    who = told.replace(f"the {kind}", f"a {kind}", 1) if not ahead else told
    text = f"The ego drives at 60 km/h. {ahead}{who[0].upper()}{who[1:]}"
    return text, kind, (begin, THEN[second]), delay if ORDER[way] else None


@pytest.mark.parametrize("seed", range(16))
def test_what_is_told_in_order_happens_in_order(seed):
    text, kind, kinds, delay_s = _drawn(seed)
    functional = read(text)
    assert tuple(str(act.kind) for act in functional.acts) == kinds, text
    assert {act.participant for act in functional.acts} == {f"{kind}_1"}, text
    first, second = functional.acts
    assert second.when.act == first.id, text
    told = second.when.delay_s
    assert told is None if delay_s is None else told.low == told.high == delay_s, text
    options = Options()
    picked = pick(enumerate_scenarios(functional, limit=50), None)
    target = chosen_target(options.target, functional)
    made = make_some(functional, picked, target, options, lambda _: None)
    proof = next(iter(made.proofs.values()))
    assert not [claim.statement for claim in proof.missed], text
