"""Which numbers a search may vary and how far: realism as bounds.

Speeds keep to the ranges of the logical scenario (or what concretization chose beyond them),
rates to what bodies and tyres allow, starts to the arm and to a few seconds.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from scegen.claims.ways import Way
from scegen.criticality.search.stated import Stated
from scegen.criticality.search.variables import (
    LEAD_IN_S,
    PhaseRecipe,
    Place,
    Quantity,
    Space,
    Variable,
)
from scegen.motion.batch.arrays import Candidates
from scegen.motion.friction import GRAVITY_MPS2
from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    DistanceBelow,
    DriveMotion,
    SpeedPhase,
    StoodStill,
    Travelled,
)
from scegen.scenario.vocabulary import HazardKind

_START_WITHIN_S = 3.0
_BYSTANDER_WITHIN_S = 6.0
_ARM_MARGIN_M = 1.0
_BEFORE_CHANGE_M = 3.0
_BEFORE_JUNCTION_M = 8.0
_BEND = (0.6, 1.1)
_QUICKER = (0.7, 1.25)
_RATE = (0.7, 1.25)
_SPEEDING = 1.5
_SHIFT_S = 1.5
_WALKER_SHIFT_S = 2.5
_NEAR_M = 4.0
_SAME_MPS = 1e-3


class _Maker:
    """Collects variables while the recipes are written."""

    def __init__(self) -> None:
        self.variables: list[Variable] = []

    def quantity(
        self, name: str, base: float, bounds: tuple[float, float], scale: float
    ) -> Quantity:
        """A variable, or a fixed value where the bounds leave no room."""
        low, high = bounds
        if high - low < 1e-6:
            return Quantity(min(max(base, low), high))
        self.variables.append(Variable(name, base, low, high, scale))
        return Quantity(base, len(self.variables) - 1)


def build_space(
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    base: Candidates,
    *,
    involved: Collection[str],
    friction: float,
    stated: Stated = Stated(),  # noqa: B008 - frozen
) -> Space:
    """The search space of a scenario.

    Args:
        concrete: the scenario, with drives that start at the outer end of their arms.
        ways: its ways.
        base: its numbers, with the starts that it really has.
        involved: those who take part in what is wanted; the others only start elsewhere.
        friction: coefficient between tyre and road.
        stated: what the description fixes.
    """
    maker = _Maker()
    index = {p.id: i for i, p in enumerate(concrete.participants)}
    starts, speeds, recipes = [], [], []
    phase = 0
    for i, participant in enumerate(concrete.participants):
        full = participant.id in involved
        start = float(base.start_m[0, i])
        way = ways[participant.id]
        levels: dict[float, Quantity] = {}
        reverses = isinstance(participant.motion, DriveMotion) and participant.motion.reversal
        if isinstance(participant.motion, DriveMotion) and not reverses:
            if participant.id in stated.placed:
                starts.append(Quantity(start))
            else:
                starts.append(_start(maker, participant, way, start, full=full))
            cruise = _cruise(maker, concrete, participant, way, stated)
            speeds.append(cruise)
            levels[participant.speed_mps] = cruise
        else:
            # Where one that reverses changes direction is fixed: so is how it gets there.
            starts.append(Quantity(start))
            speeds.append(Quantity(participant.speed_mps))
        before = speeds[-1]
        for n, item in enumerate(participant.speed_program):
            target = _level(
                maker,
                concrete,
                participant,
                item,
                levels,
                before,
                stated,
                full=full and not reverses,
            )
            recipes.append(
                _recipe(
                    maker,
                    participant,
                    n,
                    phase + n,
                    index,
                    ways,
                    before,
                    target,
                    friction,
                    full,
                    stated,
                    reverses=bool(reverses),
                )
            )
            before = target
        phase += len(participant.speed_program)
    return Space(base, maker.variables, starts, speeds, recipes)


def _start(
    maker: _Maker, participant: ConcreteParticipant, way: Way, start_m: float, *, full: bool
) -> Quantity:
    """Where a drive starts on its arm."""
    motion = participant.motion
    if isinstance(motion, DriveMotion) and motion.entry_lane > way.lanes_in:
        return Quantity(start_m)
    speed = max(participant.speed_mps, 1.0)
    within = speed * (_START_WITHIN_S if full else _BYSTANDER_WITHIN_S)
    places = [way.turn_start_m - _BEFORE_JUNCTION_M]
    places += [change.start_m - _BEFORE_CHANGE_M for change in way.changes]
    places += [
        phase.trigger.distance_m + start_m - speed * LEAD_IN_S
        for phase in participant.speed_program
        if isinstance(phase.trigger, Travelled) and phase.trigger.participant == participant.id
    ]
    rear = participant.body.rear_m + _ARM_MARGIN_M
    low = min(start_m, max(rear, start_m - within))
    high = max(start_m, min([start_m + within, *places]))
    return maker.quantity(f"{participant.id}.start_m", start_m, (low, high), speed)


def speed_range(
    concrete: ConcreteScenario, participant: ConcreteParticipant, limit_mps: float, speed_mps: float
) -> tuple[float, float]:
    """How fast somebody may go: the logical scenario's range, widened to what was chosen."""
    low = high = speed_mps
    for parameter in concrete.logical.parameters:
        if parameter.name == f"{participant.id}.speed_mps":
            low, high = min(low, parameter.low), max(high, parameter.high)
    speeds = any(h.kind is HazardKind.SPEEDING and participant.id in h.by for h in concrete.hazards)
    if speeds:
        high = max(speed_mps, min(high, _SPEEDING * limit_mps))
    return low, min(high, max(speed_mps, participant.body.top_speed_mps))


def _cruise(
    maker: _Maker,
    concrete: ConcreteScenario,
    participant: ConcreteParticipant,
    way: Way,
    stated: Stated,
) -> Quantity:
    speed = participant.speed_mps
    if speed == 0.0:
        return Quantity(0.0)
    if participant.id in stated.speeds:
        said = stated.speeds[participant.id]
        bounds = (min(said.low, speed), max(said.high, speed))
        return maker.quantity(f"{participant.id}.speed_mps", speed, bounds, 0.1 * max(speed, 1.0))
    bounds = speed_range(concrete, participant, way.limit_mps, speed)
    return maker.quantity(f"{participant.id}.speed_mps", speed, bounds, 0.1 * max(speed, 1.0))


def _level(
    maker: _Maker,
    concrete: ConcreteScenario,
    participant: ConcreteParticipant,
    phase: SpeedPhase,
    levels: dict[float, Quantity],
    before: Quantity,
    stated: Stated,
    *,
    full: bool,
) -> Quantity:
    """The target speed of a phase; equal speeds stay equal."""
    speed = phase.target_speed_mps
    said = stated.speeds.get(participant.id)
    its_own = said is not None and said.low == said.high and abs(said.low - speed) < _SAME_MPS
    if stated.fixes_target(phase.act) or its_own:  # who sets off gains the speed that is said
        return Quantity(speed)
    for known, quantity in levels.items():
        if abs(known - speed) < _SAME_MPS:
            return quantity
    name = f"{participant.id}.{'to' if phase.hazard else 'bend'}_mps"
    if speed == 0.0:
        return Quantity(0.0)
    if not isinstance(participant.motion, DriveMotion):
        bounds = speed_range(concrete, participant, speed, speed)
        if said is not None:
            bounds = (min(said.low, speed), max(said.high, speed))
        name = f"{participant.id}.speed_mps"
    elif not full:
        bounds = (speed, speed)
    elif speed > before.base:
        bounds = (_QUICKER[0] * speed, _QUICKER[1] * speed)
    else:
        bounds = (_BEND[0] * speed, _BEND[1] * speed)
    levels[speed] = maker.quantity(name, speed, bounds, 0.1 * speed)
    return levels[speed]


def _recipe(
    maker: _Maker,
    participant: ConcreteParticipant,
    n: int,
    phase: int,
    index: Mapping[str, int],
    ways: Mapping[str, Way],
    before: Quantity,
    target: Quantity,
    friction: float,
    full: bool,
    stated: Stated,
    *,
    reverses: bool,
) -> PhaseRecipe:
    item = participant.speed_program[n]
    trigger, owner = item.trigger, index[participant.id]
    name = f"{participant.id}.{item.hazard or 'phase'}_{n}"
    body = participant.body
    slows = target.base < before.base
    best = body.max_deceleration_mps2 if slows else body.max_acceleration_mps2
    most = min(max(best, item.rate_mps2), friction * GRAVITY_MPS2)
    drives = isinstance(participant.motion, DriveMotion)
    varies = full and item.hazard is not None and drives and not reverses
    least = min(item.rate_mps2, most)
    bounds = (_RATE[0] * least, min(_RATE[1] * least, most)) if varies else (least, least)
    if stated.fixes_rate(item.act):
        bounds = (item.rate_mps2, item.rate_mps2)
    rate = maker.quantity(f"{name}.rate_mps2", item.rate_mps2, bounds, 0.15 * item.rate_mps2)
    subject, length = owner, ways[participant.id].path.length_m
    shift = Quantity(0.0)
    if isinstance(trigger, AtTime | DistanceBelow | ArrivalBelow | StoodStill):
        place, value = Place.AS_IS, getattr(trigger, trigger.measured)
        if full and not isinstance(trigger, AtTime) and item.act not in stated.moments:
            near, scale = (_NEAR_M, 1.0) if isinstance(trigger, DistanceBelow) else (_SHIFT_S, 0.3)
            wide = min(near, 0.4 * value)
            shift = maker.quantity(f"{name}.{trigger.measured}", 0.0, (-wide, wide), scale)
    elif trigger.participant != participant.id:
        place, value = Place.OTHER, trigger.distance_m
        subject = index[trigger.participant]
        reach = _WALKER_SHIFT_S * max(ways[trigger.participant].participant.speed_mps, 1.0)
        if full and item.act not in stated.moments:
            shift = maker.quantity(
                f"{name}.distance_m", 0.0, (-min(reach, value), reach), reach / 4
            )
    else:
        fixed = item.act in stated.moments
        place = Place.SLOWED if slows and not fixed else Place.HERE
        value = trigger.distance_m
        if not drives:
            place = Place.FAR_SIDE
        elif varies and item.act not in stated.moments:
            reach = _SHIFT_S * max(participant.speed_mps, 1.0)
            shift = maker.quantity(f"{name}.place_m", 0.0, (-reach, reach), reach / 4)
    return PhaseRecipe(
        phase, owner, subject, place, value, before, target, rate, shift, item.rate_mps2, length
    )
