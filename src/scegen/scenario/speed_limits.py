"""The speed limit that a description implies where it names none."""

from math import ceil, inf, sqrt

from scegen.scenario.acts import GAINING, SLOWING, ActKind
from scegen.scenario.arms import URBAN_LIMIT_MPS
from scegen.scenario.bends import COMFORTABLE_LATERAL_MPS2
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.junction import Junction
from scegen.scenario.roadway import Carriageway, Strip
from scegen.scenario.vocabulary import HazardKind, JunctionKind, ParticipantKind

ROUNDABOUT_LIMIT_MPS = 30 / 3.6
DIVIDED_LIMIT_MPS = 100 / 3.6
MOTORWAY_LIMIT_MPS = 130 / 3.6
"""The limit of most of the EU's motorways, and the speed that Germany advises there; on other roads
with a median out of town limits are mostly 90 to 110 km/h."""
_STEP_MPS = 10 / 3.6
_CLEARLY = 1.02
_HELD = 0.75
"""The limit of a bend that one who speeds still gets round, as a share of that one's speed."""
_HIGHEST_MPS = 130 / 3.6
_CHANGE_MPS = 20 / 3.6
"""What one changes its speed by, where only the speed is said that it comes to."""
_MOVES_MPS = 1.0


FAST_FOR_KIND_MPS = {ParticipantKind.BICYCLE: 25 / 3.6}
"""What counts as the limit for kinds that no road's limit holds back: beyond 25 km/h no electric
bicycle of the EU's Regulation 168/2013 may help its rider, and few riders go faster."""


def limit_for_kind_mps(kind: ParticipantKind, limit_mps: float) -> float:
    """The speed beyond which one of this kind is speeding."""
    return min(limit_mps, FAST_FOR_KIND_MPS.get(kind, limit_mps))


def driven_before_mps(functional: FunctionalScenario, name: str) -> tuple[float, float]:
    """Between which speeds one drives of whom only is said what it slows down or speeds up to."""
    own = (a for a in functional.acts if a.participant == name and a.kind in SLOWING | GAINING)
    first = next(own, None)
    to = first.target_speed_mps if first is not None else None
    if first is None or to is None or first.kind is ActKind.SET_OFF or not to.high:
        return 0.0, inf
    if first.kind in SLOWING:
        return to.high + _CHANGE_MPS, inf
    return 0.0, max(to.low - _CHANGE_MPS, min(to.low, _MOVES_MPS))


def usual_limit_mps(junction: Junction) -> float:
    """The limit in a town where nothing is said."""
    ring = junction.kind is JunctionKind.ROUNDABOUT
    return ROUNDABOUT_LIMIT_MPS if ring else URBAN_LIMIT_MPS


def implied_limit_mps(functional: FunctionalScenario) -> float:
    """The limit said; else the usual one, or one that allows the speeds said.

    Who is said to go 100 km/h, and not to be speeding, is on a road for it, and so is everybody
    else there; so it is with speeds that somebody comes to. A bend holds those who speed, too.
    """
    junction = functional.junction
    if junction.speed_limit_mps is not None:
        return junction.speed_limit_mps
    usual = usual_limit_mps(junction)
    speeding = {
        name
        for hazard in functional.hazards
        if hazard.kind is HazardKind.SPEEDING
        for name in hazard.by
    }
    held = _HELD if junction.bend is not None else 0.0
    bound = [p for p in functional.vehicles if p.kind is not ParticipantKind.EMERGENCY_VEHICLE]
    said = [
        (p.speed_mps.high if p.speed_mps is not None else driven_before_mps(functional, p.id)[0])
        * (held if p.id in speeding else 1.0)
        for p in bound
    ]
    names = {p.id for p in bound}
    gained = [a for a in functional.acts if a.kind is ActKind.ACCELERATE and a.participant in names]
    said += [a.target_speed_mps.high for a in gained if a.target_speed_mps is not None]
    fastest = max(said, default=0.0)
    if not fastest and junction.carriageway is Carriageway.DIVIDED:
        usual = MOTORWAY_LIMIT_MPS if Strip.HARD_SHOULDER in junction.strips else DIVIDED_LIMIT_MPS
    if fastest <= usual * _CLEARLY:
        return usual
    return max(min(ceil(round(fastest / _STEP_MPS, 1)) * _STEP_MPS, _HIGHEST_MPS), usual)


def comfortable_mps(functional: FunctionalScenario) -> float:
    """The speed at which the road's bend is driven in comfort; inf where there is none."""
    bend = functional.junction.bend
    if bend is None:
        return inf
    return sqrt(COMFORTABLE_LATERAL_MPS2 * bend.radius_at_m(implied_limit_mps(functional)))
