"""A law: what is told in other words, in other order or as a noun is read as the same.

Every way of telling (alike.yaml) is a sentence with alternatives; what is drawn of them by chance
must be read as the first sentence of its class is: who takes part, from where, how fast, who does
what to which side and how hard, how far apart, and how it ends.
"""

import re
from pathlib import Path

import numpy as np
import pytest
import yaml

from scegen.understanding import read

CLASSES = yaml.safe_load((Path(__file__).parent / "alike.yaml").read_text("utf-8"))
WAYS = 8
ALTERNATIVES = re.compile(r"\{([^{}]*)\}")


def _drawn(way, rng):
    """One of the ways to tell it."""
    words = ALTERNATIVES.sub(lambda m: rng.choice(m.group(1).split("|")), way)
    words = re.sub(r"\s+([.,;])", r"\1", re.sub(r" +", " ", words)).strip()
    return re.sub(r"(^|[.!?] )([a-z])", lambda m: m.group(1) + m.group(2).upper(), words)


def _low(amount, factor=1.0):
    return None if amount is None else round(amount.low * factor, 2)


def _told(text):
    """What is read, as far as words can say the same in other words."""
    scenario = read(text)
    names = {p.id: f"{p.kind} {p.role} {p.parked}" for p in scenario.participants}
    gaps = {(s.measure, _low(s.value)) for s in scenario.spacings}
    gaps |= {
        (a.when.measure, _low(a.when.value))
        for a in scenario.acts
        if a.when is not None and a.when.type == "measure"
    }
    outcome = scenario.outcome
    return {
        "participants": str(
            sorted(
                (
                    names[p.id],
                    tuple(sorted(p.approaches)),
                    tuple(sorted(p.maneuvers - {"straight"})),
                    p.crosses,
                    p.circulating,
                    str(_low(p.speed_mps, 3.6)),
                )
                for p in scenario.participants
            )
        ),
        "gaps": gaps,
        "acts": sorted(
            (
                names[a.participant],
                a.kind,
                str(a.side),
                str(_low(a.rate_mps2)),
                str(_low(a.target_speed_mps, 3.6)),
                str(_low(a.lateral_m)),
            )
            for a in scenario.acts
        ),
        "outcome": outcome and (outcome.kind, {names.get(n, n) for n in outcome.between}),
        "road": scenario.junction.kind,
    }


@pytest.mark.parametrize("alike", CLASSES, ids=lambda c: c["name"])
def test_other_words_say_the_same(alike):
    expected = _told(alike["as"])
    rng = np.random.default_rng(3)
    for way in alike["told"]:
        for text in dict.fromkeys(_drawn(way, rng) for _ in range(WAYS)):
            assert _told(text) == expected, text
