"""Random traffic keeps the rules, but for a breach that is said: judged on what is played."""

from __future__ import annotations

from pathlib import Path

import pytest
from judging_rules import broken
from random_traffic import RULES, contradicts, traffic

from scegen.checking.esmini.layout import simulated_csv
from scegen.checking.recording import record
from scegen.concretization import concretize
from scegen.criticality import raise_criticality
from scegen.enumeration import enumerate_scenarios
from scegen.pipeline.export import SCENARIO_FILE, export_scenario
from scegen.pipeline.picking import pick
from scegen.scenario.concrete import DriveMotion

BREAKS = {"signals": {"red", "way"}}


def drawn(rule, seed, *, breach):
    """The first text from this seed on that does not contradict itself, and a scenario of it."""
    while True:
        functional = traffic(rule, seed, breach=breach)
        listed = enumerate_scenarios(functional, limit=50)
        logical = pick(listed, None)[seed % len(listed.scenarios)]
        if not contradicts(rule, functional, logical):
            return functional, logical
        seed += 100


def made(rule, seed, *, breach):
    functional, logical = drawn(rule, seed, breach=breach)
    target = "near-miss" if breach else "avoided"
    laid = concretize(functional, logical, seed=seed)
    raised = raise_criticality(functional, laid, target=target, seed=seed)
    return functional, raised


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(("seed", "breach"), [(2, False), (3, False), (2, True)])
def test_nobody_breaks_a_rule_but_who_is_said_to(rule, seed, breach, tmp_path):
    functional, raised = made(rule, seed, breach=breach)
    files = export_scenario(raised.concrete)
    for name, content in files.items():
        (Path(tmp_path) / name).write_bytes(content)
    log = record(tmp_path / SCENARIO_FILE, raised.concrete).csv
    by = {name for hazard in functional.hazards for name in hazard.by}
    found = broken(rule, raised.concrete.logical, files, log, by)
    allowed = BREAKS.get(rule, {"way", "stop"})
    assert not {item for item in found if item[1] not in by or item[0] not in allowed}
    assert not [claim.id for claim in raised.proof.missed if claim.kind == "rule"]
    if breach:
        assert raised.proof.in_band
    if breach and rule == "signals":
        assert ("red", *by, None) in found


def sooner(concrete, name, seconds):
    """The same where somebody starts so much farther on, as fast as it is there."""
    people = []
    for p in concrete.participants:
        if p.id == name and isinstance(p.motion, DriveMotion):
            start = max(3.0, p.motion.start_m + seconds * p.speed_mps)
            p = p.model_copy(  # noqa: PLW2901
                update={"motion": p.motion.model_copy(update={"start_m": start})}
            )
        people.append(p)
    return concrete.model_copy(update={"participants": tuple(people)})


@pytest.mark.parametrize("rule", ["yield", "priority_to_right"])
def test_the_judge_sees_who_takes_anothers_way(rule):
    taken = 0
    for seed in range(12):
        _, raised = made(rule, seed, breach=False)
        files = export_scenario(raised.concrete)
        for conflict in raised.concrete.logical.conflicts:
            if conflict.yields is None or conflict.kind.value != "crossing":
                continue
            for seconds in (-2.0, -1.0, 1.0, 2.0):
                log = simulated_csv(sooner(raised.concrete, conflict.yields, seconds))
                found = broken(rule, raised.concrete.logical, files, log)
                taken += any(item[:2] == ("way", conflict.yields) for item in found)
        if taken:
            return
    pytest.fail("nobody who came at another time took anybody's way")


@pytest.mark.parametrize(("rule", "kind"), [("all_way_stop", "stop"), ("signals", "red")])
def test_the_judge_sees_who_does_not_stop(rule, kind):
    for seed in range(8):
        _, raised = made(rule, seed, breach=False)
        files = export_scenario(raised.concrete)
        waiting = [p for p in raised.concrete.participants if p.speed_program[:1]]
        for person in waiting:
            if person.speed_program[0].target_speed_mps > 0.0:
                continue
            rolls = person.model_copy(update={"speed_program": ()})
            people = tuple(rolls if p is person else p for p in raised.concrete.participants)
            log = simulated_csv(raised.concrete.model_copy(update={"participants": people}))
            found = broken(rule, raised.concrete.logical, files, log)
            assert (kind, person.id, None) in found
            return
    pytest.fail("nobody had to stop")


def test_the_road_does_not_end_as_the_scenario_does():
    """A simulator with finer steps comes to the end a little sooner."""
    _, raised = made("all_way_stop", 21, breach=False)
    assert not raised.proof.missed
