"""Traffic lights: who must obey them, who runs them, and which arms have green together."""

from collections.abc import Iterator
from itertools import product

from scegen.motion.rules.breaches import breaks, endangered
from scegen.motion.rules.stopping import enters_at_sign
from scegen.scenario.control import signal_phases
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import RoadRule
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.signals import AtLight
from scegen.scenario.vocabulary import Control

RED_FOR_S = 0.5
"""Who goes over the line so long after amber has ended runs the light, and did not just hurry."""


def at_lights(
    functional: FunctionalScenario, logical: LogicalScenario, control: Control = Control.SIGNALS
) -> dict[str, Drive]:
    """The drives that pass a light that works, or is off (``control``), by participant."""
    if functional.junction.control is not control:
        return {}
    return {d.participant: d for d in logical.drives if enters_at_sign(functional, d)}


def light_runners(functional: FunctionalScenario, logical: LogicalScenario) -> frozenset[str]:
    """Those who are said to run a red light, or to drive on at red."""
    told = breaks(functional, logical, RoadRule.SIGNAL)
    told |= {p.id for p in functional.participants if p.light is AtLight.RED}
    return told & at_lights(functional, logical).keys()


def green_phases(functional: FunctionalScenario, logical: LogicalScenario) -> tuple[int, ...]:
    """The phase in which each arm has green.

    Where somebody runs a light before one who would have green with it, every arm has its own.
    """
    phases = signal_phases(functional.junction)
    drives, runners = at_lights(functional, logical), light_runners(functional, logical)
    green = [p.id for p in functional.participants if p.light is AtLight.GREEN]
    for by, to in (*endangered(functional, logical), *product(runners, green)):
        if by in runners and to in drives and to not in runners:
            one, other = drives[by].entry, drives[to].entry
            if one != other and phases[one] == phases[other]:
                return tuple(range(len(phases)))
    return phases


def must_obey(functional: FunctionalScenario, logical: LogicalScenario) -> frozenset[str]:
    """Those who must not go over the line at red.

    Not who runs the light, or is on call (VC 34.2); nor who is said to endanger or to hit one who
    has green when it has red: what is stated wins over what nobody is said to break.
    """
    drives = at_lights(functional, logical)
    phases = green_phases(functional, logical) if drives else ()
    excused = set(light_runners(functional, logical)) | functional.on_call
    for by, to in (*endangered(functional, logical), *_struck(functional)):
        pair = {by, to}
        apart = pair <= drives.keys() and phases[drives[by].entry] != phases[drives[to].entry]
        if apart and not pair & excused:
            excused.add(by)
    return frozenset(drives.keys() - excused)


def _struck(functional: FunctionalScenario) -> Iterator[tuple[str, str]]:
    """Two who are said to meet in the end: the one who is not the ego, and the other."""
    outcome = functional.outcome
    if outcome is not None and outcome.kind is not OutcomeKind.AVOIDED and len(outcome.between) > 1:
        one, other = outcome.between[:2]
        yield (other, one) if one == functional.ego.id else (one, other)
