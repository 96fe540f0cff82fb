"""Which lights are red: the same in still and moving pictures."""

from __future__ import annotations

from scegen.scenario.concrete import ConcreteScenario, DriveMotion
from scegen.scenario.control import signal_phases
from scegen.scenario.functional import Junction
from scegen.scenario.vocabulary import HazardKind


def red_arms(concrete: ConcreteScenario) -> frozenset[int]:
    """Arms with red: those of who is said to run it, else those that wait for the ego."""
    road = concrete.road
    angles = tuple(arm.angle_deg for arm in road.arms)
    phases = signal_phases(Junction(kind=road.kind, arms=len(angles), arm_angles_deg=angles))
    entries = {
        p.id: p.motion.entry for p in concrete.participants if isinstance(p.motion, DriveMotion)
    }
    run = {
        phases[entries[name]]
        for hazard in concrete.hazards
        if hazard.kind is HazardKind.RED_LIGHT_RUNNING
        for name in hazard.by
        if name in entries
    }
    stopped = run or {*phases} - {phases[entries.get(concrete.ego.id, 0)]}
    return frozenset(arm for arm, phase in enumerate(phases) if phase in stopped)
