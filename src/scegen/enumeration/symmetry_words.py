"""The symmetry by which a listing was reduced, in words: who counts as whom, which way it turns."""

from __future__ import annotations

from scegen.enumeration.problem import Problem
from scegen.enumeration.symmetry import Group, Symmetry, like_but_for_role
from scegen.scenario.vocabulary import ArmsMode


def symmetry_in_words(problem: Problem, symmetry: Symmetry, arms: ArmsMode) -> str:
    """Which rotations and swaps make no other scenario, and why the ego is told apart if it is."""
    alike = [_either(group) for group in symmetry.groups if not group.alone]
    swaps = f"interchangeable: {'; '.join(alike)}" if alike else "no two are interchangeable"
    return ", ".join([_rotations(symmetry, arms), swaps]) + _ego(problem, symmetry, arms)


def _rotations(symmetry: Symmetry, arms: ArmsMode) -> str:
    turns = len(symmetry.rotations)
    if turns > 1:
        return f"the junction turns onto itself in {turns} ways"
    if arms is ArmsMode.EQUAL:
        return "no turn of the junction carries what is said onto itself"
    return "no turn of the junction carries the road and what is said onto itself"


def _either(group: Group) -> str:
    names = group.members
    few = len(names) < 5
    shown = ", ".join(names) if few else f"{names[0]}, {names[1]} … {names[-1]} ({len(names)})"
    if group.entries is not None and len(group.entries) == 1:
        shown += f" at arm {group.entries[0]}"
    return shown


def _ego(problem: Problem, symmetry: Symmetry, arms: ArmsMode) -> str:
    """Why the ego is nobody's like, where its role alone makes it so."""
    ego = problem.functional.ego
    alone = any(group.members == (ego.id,) for group in symmetry.groups)
    if not alone or not like_but_for_role(problem, ego):
        return ""
    if arms is ArmsMode.EQUAL:
        return f"; the ego {ego.id} is told apart: the others are described as it meets them"
    return f"; the ego {ego.id} is told apart as the vehicle under test (--arms equal does not)"
