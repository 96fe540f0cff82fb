"""Overtakers: where the oncoming lane is free, past what is parked, and never of nobody."""

import numpy as np
import pytest

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError
from scegen.measures import build_tables, measure
from scegen.motion import build_paths, simulate
from scegen.motion.batch import stack_traces
from scegen.road import build_network
from scegen.scenario.concrete import StandingMotion
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import (
    Approach,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
)
from scegen.understanding import read


def on_a_road(people, hazards=()):
    """One lane each way; ``people``: entry and manoeuvre by name, the first is the ego."""
    return FunctionalScenario(
        description="by hand",
        junction=Junction(kind=JunctionKind.STRAIGHT, arms=2, lanes=(1, 1)),
        participants=tuple(
            Participant(
                id=name,
                role=Role.OTHER if n else Role.EGO,
                entries=frozenset({entry}),
                maneuvers=frozenset({maneuver}),
                approaches=frozenset({Approach.AHEAD}) if name == "ahead" else frozenset(),
            )
            for n, (name, (entry, maneuver)) in enumerate(people.items())
        ),
        hazards=hazards,
    )


def overtaking(functional, who):
    """The first listed scenario in which somebody is ahead of ``who``."""
    for logical in enumerate_scenarios(functional).scenarios:
        drive = next(d for d in logical.drives if d.participant == who)
        if drive.rank:
            return logical
    raise AssertionError("nobody is ever ahead")


def passing_m(concrete, first, second):
    """How near the reference points of two come, m."""
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=0.02)
    one, two = traces[first], traces[second]
    gaps = np.hypot(one.x_m - two.x_m, one.y_m - two.y_m)
    return float(gaps.min())


def touching(concrete):
    """Pairs that touch, as simulated."""
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=0.02)
    names = [p.id for p in concrete.participants]
    scene = build_tables([paths[n] for n in names], [p.body for p in concrete.participants])
    summary = measure(stack_traces([traces[n] for n in names]), scene)
    found = ~np.isnan(summary.contact_s[0])
    return {frozenset((names[a], names[b])) for a, b in scene.pairs[found]}


STRAIGHT, OVERTAKE = Maneuver.STRAIGHT, Maneuver.OVERTAKE


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "people",
    [
        {"ego": (0, STRAIGHT), "slow": (1, STRAIGHT), "quick": (1, OVERTAKE)},
        {
            "ego": (0, STRAIGHT),
            "slow": (0, STRAIGHT),
            "quick": (0, OVERTAKE),
            "else": (1, STRAIGHT),
        },
        {"ego": (1, OVERTAKE), "ahead": (1, STRAIGHT), "else": (0, STRAIGHT)},
    ],
    ids=["the ego comes towards them", "behind the ego", "the ego overtakes"],
)
def test_an_overtaker_meets_nobody_who_has_no_part_in_it(people, seed):
    functional = on_a_road(people)
    who = next(name for name, (_, maneuver) in people.items() if maneuver is OVERTAKE)
    concrete = concretize(functional, overtaking(functional, who), seed=seed)
    assert concrete.participant(who).motion.lane_changes[0].lane_after == 0
    assert not touching(concrete)


def test_the_ego_is_met_head_on_where_the_text_says_so():
    hazard = Hazard(kind=HazardKind.ONCOMING_LANE, by=("quick",), to=("ego",))
    people = {"ego": (0, STRAIGHT), "slow": (1, STRAIGHT), "quick": (1, OVERTAKE)}
    functional = on_a_road(people, (hazard,))
    concrete = concretize(functional, overtaking(functional, "quick"))
    # Less than a lane apart: the overtaker is on its way back when they pass each other.
    assert passing_m(concrete, "ego", "quick") < 3.4


def test_who_overtakes_nobody_is_told_so():
    functional = on_a_road({"ego": (0, OVERTAKE), "other": (1, STRAIGHT)})
    with pytest.raises(MotionInfeasibleError, match="nobody is ahead of it"):
        concretize(functional, enumerate_scenarios(functional).scenarios[0])


def test_past_a_parked_van_leads_no_lane_change():
    functional = read("A parked van stands on a straight road while the ego drives past at 10 m/s.")
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    van = next(p for p in concrete.participants if p.kind is ParticipantKind.VAN)
    assert isinstance(van.motion, StandingMotion)
    assert not van.motion.in_lane
    assert concrete.ego.speed_mps == 10.0
    assert not concrete.ego.motion.lane_changes
    assert not touching(concrete)


def test_one_who_blocks_the_lane_is_gone_round_through_the_oncoming_lane():
    functional = on_a_road({"ego": (0, OVERTAKE), "van": (0, STRAIGHT)})
    van = Participant(id="van", parked=True, maneuvers=frozenset({Maneuver.STAY}))
    functional = functional.model_copy(
        update={
            "participants": (functional.participants[0], van),
            "hazards": (Hazard(kind=HazardKind.OBSTACLE, by=("van",), to=("ego",)),),
        }
    )
    concrete = concretize(functional, enumerate_scenarios(functional).scenarios[0])
    assert [c.lane_after for c in concrete.ego.motion.lane_changes] == [0, 1]
    assert not touching(concrete)


@pytest.mark.parametrize(
    ("text", "who", "sense"),
    [
        ("A motorcycle overtakes the ego on the right.", "motorcycle_1", -1),
        ("The ego overtakes a lorry on the right on a motorway.", "ego", -1),
        ("A car overtakes the ego on a motorway.", "car_1", 1),
    ],
)
def test_who_passes_does_so_on_the_side_that_is_said(text, who, sense):
    functional = read(text)
    concrete = concretize(functional, overtaking_of(functional, who))
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=0.02)
    fast = traces[who]
    slow = next(trace for name, trace in traces.items() if name != who)
    dx, dy = fast.x_m - slow.x_m, fast.y_m - slow.y_m
    ahead = dx * np.cos(slow.heading_rad) + dy * np.sin(slow.heading_rad)
    left = dy * np.cos(slow.heading_rad) - dx * np.sin(slow.heading_rad)
    level = np.abs(ahead) < 2.0
    assert level.any()
    assert (sense * left[level] > 1.5).all()


def overtaking_of(functional, who):
    """The first listed scenario in which ``who`` overtakes."""
    scenarios = enumerate_scenarios(functional).scenarios
    return next(
        s
        for s in scenarios
        if any(d.participant == who and d.maneuver is OVERTAKE for d in s.drives)
    )
