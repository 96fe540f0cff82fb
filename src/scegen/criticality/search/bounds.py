"""Which numbers a search may vary and how far: realism as bounds.

Speeds keep to the ranges of the logical scenario (or what concretization chose beyond them),
rates to what bodies and tyres allow, starts to the arm and to a few seconds.
"""

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
    AtTime,
    ConcreteParticipant,
    ConcreteScenario,
    DistanceBelow,
    DriveMotion,
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

    def __init__(
        self, concrete: ConcreteScenario, ways: Mapping[str, Way], friction: float, stated: Stated
    ) -> None:
        self.concrete, self.ways, self.friction, self.stated = concrete, ways, friction, stated
        self.index = {p.id: i for i, p in enumerate(concrete.participants)}
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

    def start(self, participant: ConcreteParticipant, start_m: float, *, full: bool) -> Quantity:
        """Where a drive starts on its arm."""
        motion, way = participant.motion, self.ways[participant.id]
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
        return self.quantity(f"{participant.id}.start_m", start_m, (low, high), speed)

    def speeds(
        self, participant: ConcreteParticipant, limit_mps: float, speed_mps: float
    ) -> tuple[float, float]:
        """How fast somebody may go: as is said, widened to what was chosen, or as is realistic."""
        said = self.stated.speeds.get(participant.id)
        if said is not None:
            return min(said.low, speed_mps), max(said.high, speed_mps)
        return speed_range(self.concrete, participant, limit_mps, speed_mps)

    def cruise(self, participant: ConcreteParticipant) -> Quantity:
        """The speed at which a drive begins."""
        speed = participant.speed_mps
        if speed == 0.0:
            return Quantity(0.0)
        bounds = self.speeds(participant, self.ways[participant.id].limit_mps, speed)
        return self.quantity(f"{participant.id}.speed_mps", speed, bounds, 0.1 * max(speed, 1.0))

    def level(
        self,
        participant: ConcreteParticipant,
        n: int,
        levels: dict[float, Quantity],
        before: Quantity,
        *,
        varies: bool,
    ) -> Quantity:
        """The target speed of a phase; equal speeds stay equal."""
        phase = participant.speed_program[n]
        speed = phase.target_speed_mps
        said = self.stated.speeds.get(participant.id)
        its_own = said is not None and said.low == said.high and abs(said.low - speed) < _SAME_MPS
        # Who sets off gains the speed that is said.
        if self.stated.fixes_target(phase.act) or its_own:
            return Quantity(speed)
        for known, quantity in levels.items():
            if abs(known - speed) < _SAME_MPS:
                return quantity
        if speed == 0.0:
            return Quantity(0.0)
        name = f"{participant.id}.{'to' if phase.hazard else 'bend'}_mps"
        if not isinstance(participant.motion, DriveMotion):
            bounds = self.speeds(participant, speed, speed)
            name = f"{participant.id}.speed_mps"
        elif not varies:
            bounds = (speed, speed)
        else:
            least, most = _QUICKER if speed > before.base else _BEND
            bounds = (least * speed, most * speed)
        levels[speed] = self.quantity(name, speed, bounds, 0.1 * speed)
        return levels[speed]

    def recipe(
        self,
        participant: ConcreteParticipant,
        n: int,
        phase: int,
        before: Quantity,
        target: Quantity,
        *,
        full: bool,
        free: bool,
    ) -> PhaseRecipe:
        """How phase ``n`` of somebody is made; it is number ``phase`` of all."""
        item, owner = participant.speed_program[n], self.index[participant.id]
        trigger = item.trigger
        name = f"{participant.id}.{item.hazard or 'phase'}_{n}"
        body = participant.body
        slows = target.base < before.base
        best = body.max_deceleration_mps2 if slows else body.max_acceleration_mps2
        most = min(max(best, item.rate_mps2), self.friction * GRAVITY_MPS2)
        least = min(item.rate_mps2, most)
        varies = full and free and (item.hazard is not None or item.act is not None)
        bounds = (_RATE[0] * least, min(_RATE[1] * least, most)) if varies else (least, least)
        if self.stated.fixes_rate(item.act):
            bounds = (item.rate_mps2, item.rate_mps2)
        rate = self.quantity(f"{name}.rate_mps2", item.rate_mps2, bounds, 0.15 * item.rate_mps2)
        fixed = item.act in self.stated.moments
        subject, shift = owner, Quantity(0.0)
        value = float(getattr(trigger, trigger.measured))
        if not isinstance(trigger, Travelled):
            place = Place.AS_IS
            if full and not fixed and not isinstance(trigger, AtTime):
                near = isinstance(trigger, DistanceBelow)
                reach, scale = (_NEAR_M, 1.0) if near else (_SHIFT_S, 0.3)
                wide = min(reach, 0.4 * value)
                shift = self.quantity(f"{name}.{trigger.measured}", 0.0, (-wide, wide), scale)
        elif trigger.participant != participant.id:
            place, subject = Place.OTHER, self.index[trigger.participant]
            other = self.ways[trigger.participant].participant
            reach = _WALKER_SHIFT_S * max(other.speed_mps, 1.0)
            if full and not fixed:
                wide = min(reach, value)
                shift = self.quantity(f"{name}.distance_m", 0.0, (-wide, reach), reach / 4)
        elif not isinstance(participant.motion, DriveMotion):
            place = Place.FAR_SIDE
        else:
            place = Place.SLOWED if slows and not fixed else Place.HERE
            if varies and not fixed:
                reach = _SHIFT_S * max(participant.speed_mps, 1.0)
                shift = self.quantity(f"{name}.place_m", 0.0, (-reach, reach), reach / 4)
        length = self.ways[participant.id].path.length_m
        return PhaseRecipe(
            phase, owner, subject, place, value, before, target, rate, shift, item.rate_mps2, length
        )


def build_space(
    concrete: ConcreteScenario,
    ways: Mapping[str, Way],
    base: Candidates,
    *,
    involved: Collection[str],
    friction: float,
    stated: Stated,
) -> Space:
    """The search space of a scenario.

    ``concrete`` has drives that start at the outer end of their arms, ``base`` the starts that it
    really has. Only those ``involved`` take part in what is wanted; the others only start
    elsewhere. ``stated`` is what the description fixes, ``friction`` the coefficient between tyre
    and road.
    """
    maker = _Maker(concrete, ways, friction, stated)
    starts, speeds, recipes = [], [], list[PhaseRecipe]()
    for i, participant in enumerate(concrete.participants):
        full, motion = participant.id in involved, participant.motion
        start, speed = Quantity(float(base.start_m[0, i])), Quantity(participant.speed_mps)
        levels: dict[float, Quantity] = {}
        # Where one that reverses changes direction is fixed: so is how it gets there.
        free = isinstance(motion, DriveMotion) and motion.reversal is None
        if free:
            if participant.id not in stated.placed:
                start = maker.start(participant, start.base, full=full)
            speed = levels[participant.speed_mps] = maker.cruise(participant)
        starts.append(start)
        speeds.append(speed)
        for n in range(len(participant.speed_program)):
            target = maker.level(participant, n, levels, speed, varies=full and free)
            recipes.append(
                maker.recipe(participant, n, len(recipes), speed, target, full=full, free=free)
            )
            speed = target
    return Space(base, maker.variables, starts, speeds, recipes)


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
