"""Brute force, written without the package's encodings: every assignment, and its class.

Reads the semantics from the functional scenario with plain loops and real geometry (points and
segments), so that it can disagree with the encodings.
"""

from __future__ import annotations

import itertools
import math
from collections import Counter
from types import SimpleNamespace

import pytest

from scegen.scenario.arms import arm_angles_deg, seen_from, turn_deg, turn_name
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import Junction
from scegen.scenario.vocabulary import (
    Approach,
    ArmsMode,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
    Reduction,
)


@pytest.fixture(scope="session")
def oracle():
    """The brute force, as a namespace: ways_meet, assignments, classes."""
    return SimpleNamespace(ways_meet=ways_meet, assignments=assignments, classes=classes)


@pytest.fixture(scope="session")
def describe():
    """Make a functional scenario from plain data: kind, arms, participants, hazards, relations."""
    return _describe


def _describe(kind, arms, participants, hazards=(), relations=(), more=None, **junction):
    return FunctionalScenario.model_validate(
        {
            "description": "made for a test",
            "junction": {"kind": kind, "arms": arms, **junction},
            "participants": participants,
            "hazards": hazards,
            "relations": relations,
            **(more or {}),
        }
    )


SAME_ARM = {Approach.AHEAD, Approach.BEHIND, Approach.ADJACENT}

Assignment = tuple[tuple[int, int, str, str], ...]
"""(entry, move, manner, place seen from the ego) of every vehicle."""


def ways_meet(junction: Junction, first: tuple[int, int], second: tuple[int, int]) -> str:
    """Conflict of two ways (entry, exit) from coordinates."""
    if first[0] == second[0]:
        return "following" if first[1] == second[1] else "diverging"
    if junction.kind is JunctionKind.ROUNDABOUT:
        return "merging" if _stretches(junction, first) & _stretches(junction, second) else "none"
    if first[1] == second[1]:
        return "merging"
    return "crossing" if _cross(_segment(junction, first), _segment(junction, second)) else "none"


def _stretches(junction: Junction, way: tuple[int, int]) -> set[frozenset[int]]:
    step = 1 if junction.driving_side is DrivingSide.RIGHT else -1
    here, found = way[0], set()
    while True:
        following = (here + step) % junction.arms
        found.add(frozenset({here, following}))
        here = following
        if here == way[1]:
            return found


def _segment(junction: Junction, way: tuple[int, int]):
    """From where traffic comes in on one arm to where it goes out on another.

    Arms spread evenly on a circle: whether chords cross depends on their order alone.
    """
    lane = 0.1 if junction.driving_side is DrivingSide.RIGHT else -0.1
    # Seen from the centre, incoming right-hand traffic keeps left of the arm's axis.
    angles = (
        2 * math.pi * way[0] / junction.arms + lane,
        2 * math.pi * way[1] / junction.arms - lane,
    )
    return tuple((math.cos(a), math.sin(a)) for a in angles)


def _cross(one, two) -> bool:
    def side(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0

    return side(*one, two[0]) != side(*one, two[1]) and side(*two, one[0]) != side(*two, one[1])


def assignments(functional: FunctionalScenario) -> list[Assignment]:
    """Every assignment of the vehicles (no crossers), as the brief of the package puts it."""
    vehicles, arms = functional.vehicles, functional.junction.arms
    ego = next(i for i, v in enumerate(vehicles) if v.id == functional.ego.id)
    entry_sets = [sorted(v.entries) or range(arms) for v in vehicles]
    found: list[Assignment] = []
    for entries in itertools.product(*entry_sets):
        for places in itertools.product(
            *(_places(functional, i, entries, ego) for i in range(len(vehicles)))
        ):
            if not _in_order(functional, entries, places, ego):
                continue
            choices = [_choices(functional, v, e) for v, e in zip(vehicles, entries, strict=True)]
            for moves in itertools.product(*choices):
                made = tuple(
                    (e, d, m, w) for e, (d, m), w in zip(entries, moves, places, strict=True)
                )
                if _hazards_hold(functional, made) and _groups_hold(functional, made):
                    found.append(made)
    return [made for made in found if _owes_way(functional, made)] or found


def _owes_way(functional, made: Assignment) -> bool:
    """On a ring, who is said to fail to yield is not one for whom the other has to wait."""
    junction, arms = functional.junction, functional.junction.arms
    names = [v.id for v in functional.vehicles]
    if junction.kind is not JunctionKind.ROUNDABOUT:
        return True

    def passes(i, arm):
        own = _stretches(junction, (made[i][0], (made[i][0] + made[i][1]) % arms))
        beside = {frozenset({arm, (arm + 1) % arms}), frozenset({arm, (arm - 1) % arms})}
        return beside <= own

    for hazard in functional.hazards:
        if hazard.kind is HazardKind.FAILURE_TO_YIELD and hazard.by and hazard.to:
            by, to = names.index(hazard.by[0]), names.index(hazard.to[0])
            if made[by][0] != made[to][0] and passes(by, made[to][0]) > passes(to, made[by][0]):
                return False
    return True


def _groups_hold(functional, made: Assignment) -> bool:
    """As many of each group make one of its turns as are said."""
    angles = arm_angles_deg(functional.junction)
    names = [v.id for v in functional.vehicles]
    return all(
        group.number
        == sum(
            turn_name(angles, e, d) in group.maneuvers and m == "plain"
            for name, (e, d, m, _) in zip(names, made, strict=True)
            if name in group.members
        )
        for group in functional.groups
    )


def _choices(functional, vehicle, entry):
    junction = functional.junction
    angles = arm_angles_deg(junction)
    moves = range(1, junction.arms)
    if not vehicle.maneuvers:
        return [(d, "plain") for d in moves]
    found = set()
    for word in vehicle.maneuvers:
        if word is Maneuver.OVERTAKE:
            found |= {(d, word.value) for d in moves}
        elif word is Maneuver.LANE_CHANGE:
            found |= {(d, f"lane_change_{side}") for d in moves for side in ("left", "right")}
        elif word.startswith("exit_"):
            count = int(word[-1])
            step = count if junction.driving_side is DrivingSide.RIGHT else -count
            if count <= junction.arms:
                found.add((step % junction.arms, "plain"))
        else:
            found |= {
                (d, "plain") for d in range(junction.arms) if turn_name(angles, entry, d) is word
            }
            if word is Maneuver.STRAIGHT and not _leads_straight(angles):
                bends = [(abs(turn_deg(angles, entry, d)), d) for d in moves]
                found.add((min(bends)[1], "plain"))
    return sorted(found)


def _leads_straight(angles) -> bool:
    """Whether from any arm a way goes straight on."""
    arms = range(len(angles))
    return any(turn_name(angles, e, d) is Maneuver.STRAIGHT for e in arms for d in arms if d)


def _places(functional, index, entries, ego):
    """Words for where a vehicle is, seen from the ego; none fits: no place."""
    vehicle = functional.vehicles[index]
    if not vehicle.approaches:
        return ["unsaid"]
    sides = vehicle.approaches & {Approach.LEFT, Approach.RIGHT}
    # On a road without a junction nobody comes from the side but out of the next lane.
    open_road = functional.junction.kind is JunctionKind.STRAIGHT
    if entries[index] == entries[ego]:
        found = [word.value for word in vehicle.approaches & SAME_ARM - {Approach.ADJACENT}]
        if Approach.ADJACENT in vehicle.approaches:
            lanes = sides if len(sides) == 1 else {Approach.LEFT, Approach.RIGHT}
        else:
            lanes = sides if open_road else set()
        return sorted([*found, *(f"adjacent_{side.value}" for side in lanes)])
    words = seen_from(arm_angles_deg(functional.junction), entries[ego], entries[index])
    return ["elsewhere"] if words & vehicle.approaches else []


def _in_order(functional, entries, places, ego):
    """Whether who tailgates can be behind, on one arm."""
    index = {v.id: i for i, v in enumerate(functional.vehicles)}
    for hazard in functional.hazards:
        if hazard.kind is HazardKind.TAILGATING:
            by, to = index[hazard.by[0]], index[hazard.to[0]]
            if entries[by] != entries[to] or not _may_follow(places, by, to, ego):
                return False
    return True


def _may_follow(places, by, to, ego) -> bool:
    """Whether ``by`` can be behind ``to``, given where both are, seen from the ego."""
    position = {"ahead": 1, "adjacent_left": 0, "adjacent_right": 0, "behind": -1}
    back = 0 if by == ego else position.get(places[by])
    front = 0 if to == ego else position.get(places[to])
    if back is None or front is None:
        return True
    return back < front or (back == front != 0)


def _hazards_hold(functional, made: Assignment) -> bool:
    index = {v.id: i for i, v in enumerate(functional.vehicles)}
    junction = functional.junction
    angles, arms = arm_angles_deg(junction), junction.arms

    def way(i):
        return made[i][0], (made[i][0] + made[i][1]) % arms

    for hazard in functional.hazards:
        if not (hazard.by and hazard.to):
            continue
        by, to = index[hazard.by[0]], index[hazard.to[0]]
        met = ways_meet(junction, way(by), way(to))
        if _turn_behind_each_other(functional, hazard, angles, made[by], made[to]):
            met = "crossing"
        beside = _beside(functional, hazard)
        if beside and hazard.kind in {
            HazardKind.FAILURE_TO_YIELD,
            HazardKind.UNPROTECTED_LEFT_TURN,
        }:
            turns = {turn_name(angles, *made[n][:2]) for n in (by, to)}
            ring = junction.kind is JunctionKind.ROUNDABOUT
            across = made[by][0] == made[to][0] and turns != {Maneuver.STRAIGHT} and not ring
            met = "crossing" if across else met
        if hazard.kind is HazardKind.MERGING_CONFLICT and met != "merging":
            return False
        if hazard.kind is HazardKind.FAILURE_TO_YIELD and met not in {"merging", "crossing"}:
            return False
        if hazard.kind is HazardKind.UNPROTECTED_LEFT_TURN:
            opposite = _faces(angles, made[by][0], made[to][0])
            turns = turn_name(angles, *made[by][:2]) is _across(functional)
            if not ((opposite or beside) and turns and met in {"merging", "crossing"}):
                return False
    return True


def _beside(functional, hazard) -> bool:
    """Whether one of the two is said to be beside the other, which is the ego."""
    pair = {hazard.by[0], hazard.to[0]}
    others = [functional.participant(name) for name in pair - {functional.ego.id}]
    return len(others) == 1 and others[0].approaches == frozenset({Approach.ADJACENT})


def _across(functional) -> Maneuver:
    """The turn over the oncoming lane."""
    left_hand = functional.junction.driving_side is DrivingSide.LEFT
    return Maneuver.RIGHT if left_hand else Maneuver.LEFT


def _turn_behind_each_other(functional, hazard, angles, by, to) -> bool:
    """Both are said to turn across the oncoming lane, from opposite arms."""
    across = _across(functional)
    said = [across in functional.participant(n).maneuvers for n in (hazard.by[0], hazard.to[0])]
    if hazard.kind is HazardKind.UNPROTECTED_LEFT_TURN:
        said[0] = True
    turns = [turn_name(angles, *made[:2]) is across for made in (by, to)]
    return (
        hazard.kind is not HazardKind.MERGING_CONFLICT
        and all(said)
        and all(turns)
        and _faces(angles, by[0], to[0])
    )


def _faces(angles, arm, other) -> bool:
    """Whether traffic from ``other`` comes towards ``arm``; if none does, any other arm's will."""
    facing = {
        one
        for one in range(len(angles))
        if one != arm and Approach.OPPOSITE in seen_from(angles, arm, one)
    }
    return other in facing if facing else other != arm


def classes(functional: FunctionalScenario, reduction: Reduction, arms: ArmsMode) -> Counter:
    """Class representative -> number of assignments in it."""
    every = assignments(functional)
    if reduction is Reduction.NONE:
        return Counter(every)
    if reduction is Reduction.PATTERN:
        return Counter(tuple(sorted(d for _, d, _, _ in made)) for made in every)
    labels = [_label(functional, v, arms) for v in functional.vehicles]
    number = functional.junction.arms
    turns = [r for r in range(number) if _turn_allowed(functional, labels, r, arms)]
    out: Counter = Counter()
    for made in every:
        copies = []
        for turn in turns:
            turned = (((e + turn) % number, d, m, w) for e, d, m, w in made)
            # Interchangeable vehicles with the same arms to choose from trade places, so what
            # tells scenarios apart is the multiset of choices under each label.
            targets = _targets(functional, labels, turn)
            chosen = Counter(zip(targets, turned, strict=True))
            copies.append(tuple(sorted(chosen.items(), key=repr)))
        out[min(copies, key=repr)] += 1
    return out


def _targets(functional, labels, turn):
    arms = functional.junction.arms
    sets = [tuple(sorted(v.entries)) for v in functional.vehicles]
    return [
        (label, tuple(sorted((e + turn) % arms for e in entries)))
        for label, entries in zip(labels, sets, strict=True)
    ]


def _label(functional, vehicle, arms: ArmsMode):
    role = vehicle.role.value
    if arms is ArmsMode.EQUAL and not any(p.approaches for p in functional.participants):
        role = "any"
    named = [(i, vehicle.id in h.by, vehicle.id in h.to) for i, h in enumerate(functional.hazards)]
    named += [(i, vehicle.id in group.members) for i, group in enumerate(functional.groups)]
    return repr(
        (vehicle.kind.value, role, sorted(vehicle.maneuvers), sorted(vehicle.approaches), named)
    )


def _turn_allowed(functional, labels, turn, arms: ArmsMode) -> bool:
    junction = functional.junction
    n = junction.arms
    angles = arm_angles_deg(junction)
    before = Counter(_targets(functional, labels, 0))
    if before != Counter(_targets(functional, labels, turn)):
        return False
    if arms is ArmsMode.DISTINCT:
        steps = {round((angles[(i + turn) % n] - angles[i]) % 360, 6) for i in range(n)}
        return len(steps) == 1
    said = any(v.maneuvers or v.approaches for v in functional.vehicles)
    if not said and not functional.hazards and not functional.groups:
        return True
    views = [
        [(turn_name(angles, e, d), seen_from(angles, e, (e + d) % n)) for d in range(n)]
        for e in range(n)
    ]
    return all(views[e] == views[(e + turn) % n] for e in range(n))
