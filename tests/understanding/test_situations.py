"""A law: a basic situation is read as such, in whatever ordinary words it is told.

Templates are crossed with fillers (situations.yaml); what is right follows from the template.
"""

import re
from pathlib import Path

import numpy as np
import pytest
import yaml

from scegen.understanding import read

GRID = yaml.safe_load((Path(__file__).parent / "situations.yaml").read_text("utf-8"))
WAYS = 40
REACHED = 0.9


def _upper(words):
    return words[:1].upper() + words[1:]


def _filled(template, slots, rng, chosen):
    """One of the ways to tell it; which filler each slot took is noted in ``chosen``."""

    def filler(match):
        slot = match.group(1).lower()
        if slot not in chosen:
            words = slots[slot][rng.integers(len(slots[slot]))]
            chosen[slot] = _filled(words, slots, rng, chosen)
        return _upper(chosen[slot]) if match.group(1)[0].isupper() else chosen[slot]

    return re.sub(r"\{(\w+)\}", filler, template)


def _text(words):
    words = re.sub(r" +", " ", words.strip())
    words = re.sub(r"\b([Aa]) (?=[aeio]|SUV|EPT|EBT)", r"\1n ", words)
    return _upper(re.sub(r"(?<=\. )[a-z]", lambda m: m.group().upper(), words))


def _told(situation):
    rng = np.random.default_rng(7)
    slots = {**GRID["slots"], **situation.get("slots", {})}
    for _ in range(WAYS):
        chosen = {}
        template = situation["templates"][rng.integers(len(situation["templates"]))]
        yield _text(_filled(template, slots, rng, chosen)), chosen


def _values(members):
    return {m.value for m in members}


def _others_wrong(scenario, wanted, chosen):
    left = [p for p in scenario.participants if p.role.value != "ego"]
    if len(left) != len(wanted):
        yield f"{len(left)} others"
    for approaches, maneuvers in wanted:
        where = {a.format(**chosen) for a in approaches}
        fits = [
            p
            for p in left
            if (not where or (p.approaches and _values(p.approaches) <= where))
            and (not maneuvers or (p.maneuvers and _values(p.maneuvers) <= set(maneuvers)))
        ]
        if fits:
            left.remove(fits[0])
        else:
            yield f"nobody {sorted(where)} {maneuvers}"


def _wrong(scenario, situation, chosen):
    """What of a reading is not as the template says."""
    if "others" in situation:
        yield from _others_wrong(scenario, situation["others"], chosen)
    found = {h.kind.value for h in scenario.hazards}
    yield from (f"no {h}" for h in situation.get("hazards", ()) if not set(h.split("|")) & found)
    yield from (h for h in situation.get("not", ()) if h in found)
    ego = next(p for p in scenario.participants if p.role.value == "ego")
    if not _values(ego.maneuvers) <= set(situation.get("ego", _values(ego.maneuvers))):
        yield "what the ego does"
    outcome = scenario.outcome.kind.value if scenario.outcome else None
    if outcome != situation.get("outcome", outcome):
        yield "outcome"
    kinds = {p.id: p.kind.value if p is not ego else "ego" for p in scenario.participants}
    between = {kinds[name] for name in scenario.outcome.between} if scenario.outcome else set()
    if between != set(situation.get("between", between)):
        yield "between whom"


@pytest.mark.parametrize("situation", GRID["situations"], ids=lambda s: s["name"])
def test_a_basic_situation_is_read_however_it_is_told(situation):
    wrong = {t: w for t, c in _told(situation) if (w := list(_wrong(read(t), situation, c)))}
    assert len(wrong) <= (1 - REACHED) * WAYS, wrong
