"""Stop signs: who must stop, and what a stop is.

A full stop at the line, then on by right of way: US Uniform Vehicle Code 11-403(b), StVO sign 206.
Neither says for how long; a second at rest is what driving examiners look for (this program's own
choice, as is where "at the line" begins).
"""

from scegen.motion.rules.breaches import breaks
from scegen.scenario.control import STOPS, controlled_arms
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.hazards import RoadRule
from scegen.scenario.logical import Drive, LogicalScenario
from scegen.scenario.vocabulary import JunctionKind, Maneuver

STOPPED_MPS = 0.1
"""Who is slower stands."""
STOPPED_S = 1.0
"""So long at least is a stop."""
AT_LINE_M = 3.0
"""A front that stands no farther before the line than this stands at the line."""
OVER_LINE_M = 0.3


def enters_at_sign(functional: FunctionalScenario, drive: Drive) -> bool:
    """Whether one drives forwards past the sign or light of its entry arm."""
    return (
        functional.junction.kind is not JunctionKind.STRAIGHT
        and drive.entry in controlled_arms(functional.junction)
        and drive.maneuver is not Maneuver.STAY
        and drive.reverses is None
        and not drive.circulating
    )


def must_stop(functional: FunctionalScenario, logical: LogicalScenario) -> frozenset[str]:
    """Those who must stop at the line of a stop sign, whoever else is there.

    Who is said to fail to yield ignores the sign: stopping is part of giving way there. Who is on
    call need not (VC 34.2).
    """
    if functional.junction.control not in STOPS:
        return frozenset()
    drivers = frozenset(d.participant for d in logical.drives if enters_at_sign(functional, d))
    return drivers - breaks(functional, logical, RoadRule.RIGHT_OF_WAY) - functional.on_call
