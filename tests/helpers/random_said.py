"""Random functional scenarios: every kind of junction and danger, with and without numbers."""

from __future__ import annotations

from random import Random

from saying import KMH, person, said

from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.vocabulary import Control, DrivingSide, HazardKind, JunctionKind

FOUR_WHEELS = ["car", "car", "van", "truck", "bus", "emergency_vehicle"]
AHEAD, BEHIND, ACROSS = [["ahead"]], [["behind"]], [["left"], ["right"]]
BESIDE = [["adjacent", "left"], ["adjacent", "right"], ["adjacent"]]
TOWARDS = [["opposite"]]
ALONE = {
    HazardKind.SPEEDING: BEHIND + ACROSS + TOWARDS,
    HazardKind.SUDDEN_ACCELERATION: BEHIND + ACROSS,
    HazardKind.HARD_BRAKING: AHEAD,
    HazardKind.DELAYED_BRAKING: BEHIND + ACROSS,
    HazardKind.STOPPING: AHEAD,
    HazardKind.SLOW_DRIVING: AHEAD,
    HazardKind.CUT_IN: BESIDE,
    HazardKind.SWERVING: BESIDE + TOWARDS,
    HazardKind.TAILGATING: BEHIND,
    HazardKind.MERGING_CONFLICT: ACROSS,
    HazardKind.OVERTAKING: BEHIND,
    HazardKind.ONCOMING_LANE: TOWARDS,
    HazardKind.UNPROTECTED_LEFT_TURN: TOWARDS,
    HazardKind.CROSSING_PEDESTRIAN: ACROSS,
    HazardKind.CROSSING_CYCLIST: ACROSS,
    HazardKind.CROSSING_ANIMAL: ACROSS,
    HazardKind.OCCLUSION: ACROSS,
    HazardKind.OBSTACLE: AHEAD,
    HazardKind.RED_LIGHT_RUNNING: ACROSS,
    HazardKind.FAILURE_TO_YIELD: ACROSS,
    HazardKind.REVERSING: AHEAD + ACROSS,
    HazardKind.SUDDEN_TURN: AHEAD + TOWARDS,
    HazardKind.LOSS_OF_CONTROL: BESIDE + TOWARDS + AHEAD,
}
"""Where whoever causes a danger comes from, as the ego sees it."""
_PLAIN = JunctionKind.STRAIGHT
_ONLY_AT_JUNCTIONS = {
    HazardKind.RED_LIGHT_RUNNING,
    HazardKind.UNPROTECTED_LEFT_TURN,
    HazardKind.SUDDEN_TURN,
}
_WALKS = {HazardKind.CROSSING_PEDESTRIAN, HazardKind.OCCLUSION}
_MOVES = {
    HazardKind.OVERTAKING: "overtake",
    HazardKind.UNPROTECTED_LEFT_TURN: "left",
    HazardKind.CROSSING_PEDESTRIAN: "cross",
    HazardKind.CROSSING_CYCLIST: "cross",
    HazardKind.CROSSING_ANIMAL: "cross",
    HazardKind.OCCLUSION: "cross",
}
_BRAKES = {HazardKind.HARD_BRAKING, HazardKind.STOPPING}
_ASIDE = {HazardKind.CUT_IN, HazardKind.SWERVING}


def situation(seed):
    """One danger (or none) of the ego and another, and what a text may say beside it.

    Seeds in a row go through all dangers, and then through all junctions with each.
    """
    rng = Random(seed)  # noqa: S311 - the same each time is what is wanted
    hazards = [None, *HazardKind]
    hazard = hazards[seed % len(hazards)]
    kinds = [k for k in JunctionKind if k is not _PLAIN or hazard not in _ONLY_AT_JUNCTIONS]
    kind = kinds[seed // len(hazards) % len(kinds)]
    numbers = rng.random() < 0.5
    ego, other = _ego(rng, kind, numbers), _other(rng, kind, hazard, numbers)
    fields = _happening(rng, hazard, numbers, ego, other) if hazard else {}
    people = [ego, other]
    dangers = [] if hazard is None else [{"kind": hazard, "by": ["other"], "to": ["ego"]}]
    if hazard is HazardKind.OCCLUSION:
        people.append(person("van", "van", parked=True, approaches=other["approaches"]))
        dangers = [
            {"kind": "occlusion", "by": ["van"], "to": ["ego"]},
            {"kind": "crossing_pedestrian", "by": ["other"], "to": ["ego"]},
        ]
    if hazard is not None:
        dangers[0]["kind"] = str(dangers[0]["kind"])
    outcome = rng.choice([None, None, "near_miss", "collision", "avoided"])
    if outcome is not None:
        fields["outcome"] = {"kind": outcome, "between": ["ego", "other"]}
    junction = _junction(rng, kind, hazard)
    ego["unresponsive"] = rng.random() < 0.2
    return said(kind, *people, junction=junction, hazards=dangers, **fields)


def _junction(rng, kind, hazard):
    arms = rng.randint(*ARM_COUNTS[kind])
    beside = hazard is not None and ALONE[hazard] == BESIDE
    lanes = 2 if beside or kind is _PLAIN else (rng.choice([1, 1, 2]))
    if hazard is HazardKind.RED_LIGHT_RUNNING:
        control = Control.SIGNALS
    elif kind in {_PLAIN, JunctionKind.ROUNDABOUT}:
        control = Control.UNCONTROLLED
    else:
        control = rng.choice(list(Control))
    side = rng.choice([DrivingSide.RIGHT] * 3 + [DrivingSide.LEFT])
    return {
        "arms": arms,
        "lanes": [lanes] * arms,
        "control": str(control),
        "driving_side": str(side),
    }


def _ego(rng, kind, numbers):
    turns = [[]] if kind is _PLAIN else [[], ["straight"], ["left"], ["right"]]
    speed = (rng.randint(3, 5 if kind is not _PLAIN else 11)) * 10 if numbers else None
    return person("ego", speed=speed, maneuvers=(rng.choice(turns)))


def _other(rng, kind, hazard, numbers):
    places = [[], *ACROSS, *TOWARDS, *AHEAD, *BEHIND] if hazard is None else ALONE[hazard]
    body = rng.choice(FOUR_WHEELS)
    if hazard in _WALKS:
        body = "pedestrian"
    elif hazard is HazardKind.CROSSING_CYCLIST:
        body = "bicycle"
    elif hazard is HazardKind.CROSSING_ANIMAL:
        body = rng.choice(["animal", "large_animal"])
    approaches = rng.choice(places)
    moves = [_MOVES[hazard]] if hazard in _MOVES else []
    if hazard is HazardKind.OBSTACLE:
        moves = ["stay"]
    speed = None
    if numbers and (rng.random() < 0.5) and hazard is not HazardKind.OBSTACLE:
        slowest, fastest = (3, 6) if body == "pedestrian" else (12, 20)
        if body in FOUR_WHEELS:
            slowest, fastest = 30, 50 if kind is not _PLAIN else 90
        speed = rng.randint(slowest, fastest)
        if hazard in {HazardKind.SPEEDING, HazardKind.SLOW_DRIVING, HazardKind.REVERSING}:
            speed = None
    return person("other", body, speed=speed, approaches=approaches, maneuvers=moves)


def _happening(rng, hazard, numbers, ego, other):
    """Acts and spacings that go with a danger."""
    if not numbers or not (rng.random() < 0.5):
        return {}
    act = {"id": "act", "participant": "other"}
    spacing = {"participant": "other", "reference": "ego"}
    if hazard in _BRAKES and "speed_mps" in other:
        other["speed_mps"] = ego["speed_mps"]
        act |= {"kind": "stop" if hazard is HazardKind.STOPPING else "brake"}
        act["rate_mps2"] = rng.randint(3, 7)
        if act["kind"] == "brake" and (rng.random() < 0.5):
            act["target_speed_mps"] = 10 * KMH
        gap = rng.choice(["gap_m", "headway_s"])
        spacing |= {"measure": gap, "value": (rng.randint(1, 2)) * (12 if gap == "gap_m" else 1)}
        return {"acts": [act], "spacings": [spacing | {"at": (rng.choice(["act", "start"]))}]}
    if hazard is HazardKind.CUT_IN:
        act |= {"kind": "change_lane", "into": "ego"}
        spacing |= {"measure": "gap_m", "value": (rng.randint(5, 20)), "at": "act"}
        return {"acts": [act], "spacings": [spacing]}
    if hazard is HazardKind.SWERVING:
        return {"acts": [act | {"kind": "swerve", "lateral_m": (rng.choice([0.6, 1.0]))}]}
    if other["maneuvers"] == ["cross"]:
        measure = rng.choice(["ttc_s", "gap_m"])
        value = (rng.randint(2, 3)) * (1 if measure == "ttc_s" else 12)
        when = {"type": "measure", "measure": measure, "value": value}
        when |= {"participant": "ego", "reference": "other"}
        return {"acts": [act | {"kind": "cross", "when": when}]}
    if hazard is HazardKind.SUDDEN_ACCELERATION:
        act |= {"kind": "accelerate", "rate_mps2": 3}
        return {"acts": [act | {"when": {"type": "start", "delay_s": (rng.randint(1, 3))}}]}
    return {}
