"""The offline default: proposals by rules, without a model and without chance.

Concretization brings those in conflict to one place at one time. So the rules are mostly about
time: the pair that the danger is about meets as far apart as the target asks, all others keep out
of each other's way; and what a danger still lacks gets more (or less) of what makes it.
"""

from collections.abc import Iterator

from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.proposals.proposal import Check, Encounter, Proposal, Proposed, Situation
from scegen.scenario.hazards import HAZARDS
from scegen.scenario.vocabulary import HazardKind

OFFLINE = "offline rules"
_CLEAR_S = 1.0
"""Those whom the danger is not about keep this far apart in time."""
_CLOSEST_S = 0.2
"""Who catches up with somebody does not come closer than this, in time."""
_TOUCHES_S = -0.5
_WORTH_S = 0.02
_SHARE = 0.5


class OfflineProposer:
    """Proposes by rules; the same situation gives the same proposals."""

    def propose(self, situation: Situation, check: Check) -> Proposed:
        """Changes that should bring the dangers about; those that cannot be driven are left out."""
        strengthened = list(_strengthened(situation))
        taken = {proposal.parameter for proposal in strengthened}
        timed = [p for p in _timed(situation) if p.parameter not in taken]
        wanted = [*strengthened, *timed]
        judged = zip(wanted, check(wanted), strict=True)
        return Proposed(OFFLINE, tuple(proposal for proposal, why in judged if why is None))


def _strengthened(situation: Situation) -> Iterator[Proposal]:
    """More of what makes a danger that does not happen yet."""
    for proof in situation.hazards:
        more_of = HAZARDS[proof.kind].more_of
        if proof.happened or more_of is None:
            continue
        quantity, sign = more_of
        for who in proof.by:
            parameter = _of_hazard(situation, who, proof.kind, quantity)
            if parameter is None:
                continue
            end = parameter.high if sign > 0 else parameter.low
            value = parameter.inside(parameter.value + _SHARE * (end - parameter.value))
            if value == parameter.value:
                continue
            short = "" if proof.margin is None else f" is {-proof.margin:.2f} {proof.unit} short"
            reason = f"{proof.kind.replace('_', ' ')} by {who}{short or ' does not happen'}"
            yield Proposal(parameter=parameter.name, value=value, reason=reason)


def _of_hazard(situation: Situation, who: str, kind: HazardKind, quantity: str) -> Parameter | None:
    """The parameter by which somebody makes a danger, its own before the general one."""
    own = (p for p in situation.parameters if p.name.startswith(f"{who}.{kind}_"))
    general = situation.parameter(f"{who}.{quantity}")
    return next((p for p in own if p.name.endswith(quantity)), general)


def _timed(situation: Situation) -> Iterator[Proposal]:
    """Starts at which those in conflict meet as far apart in time as they should."""
    starts = {
        p.name.removesuffix(".start_m"): p
        for p in situation.parameters
        if p.name.endswith(".start_m")
    }
    later, why = _delays(situation, starts)
    speeds = {name: max(situation.concrete.participant(name).speed_mps, 1.0) for name in starts}
    shift = _common_shift(later, starts, speeds, later.get(situation.concrete.ego.id, 0.0))
    for name, parameter in starts.items():
        delay = later[name] - shift
        value = parameter.inside(parameter.value - delay * speeds[name])
        if abs(value - parameter.value) > _WORTH_S * speeds[name]:
            moved = "later" if delay > 0 else "earlier"
            reason = (
                f"comes {abs(delay):.2f} s {moved}: {why.get(name, 'so that the other gaps stay')}"
            )
            yield Proposal(parameter=parameter.name, value=value, reason=reason)


def _delays(
    situation: Situation, starts: dict[str, Parameter]
) -> tuple[dict[str, float], dict[str, str]]:
    """How much later everybody should come, s, and why.

    Gap after gap in the order of time, as often as there are people: a delay moves on to those
    behind.
    """
    later, why = dict.fromkeys(starts, 0.0), {}
    for _ in starts:
        settled = True
        for encounter in situation.encounters:
            first, second = encounter.first, encounter.second
            shifted = later.get(second, 0.0) - later.get(first, 0.0)
            wanted, exact = _wanted(situation, encounter)
            if wanted is None:
                continue
            missing = wanted - encounter.gap_s - shifted
            if not (exact and situation.target.contact):
                missing = max(missing, _CLOSEST_S - encounter.least_s - shifted)
            if abs(missing) <= _WORTH_S or (missing < 0.0 and not exact):
                continue
            mover, sign = (second, 1) if second in starts else (first, -1)
            if mover not in starts:
                continue
            later[mover] += sign * missing
            about = "as the target wants" if exact else "out of the other's way"
            gap = encounter.gap_s + shifted + missing
            aim = f"so that {second} enters {gap:.2f} s after {first} has left, {about}"
            why[mover] = aim
            if exact:
                why[first] = why[second] = aim
            settled = False
        if settled:
            break
    return later, why


def _wanted(situation: Situation, encounter: Encounter) -> tuple[float | None, bool]:
    """The gap that two should have, s, and whether it is exact; None: whatever it is."""
    if {encounter.first, encounter.second} == set(situation.pair):
        return _target_gap(situation, encounter), True
    return _CLEAR_S, False


def _target_gap(situation: Situation, encounter: Encounter) -> float | None:
    target = situation.target
    if target.contact:
        return None if encounter.gap_s < 0.0 else _TOUCHES_S
    for choice in target.choices:
        for band in choice:
            middle = (band.low + band.high) / 2
            if band.measure == "pet":
                return middle
            if band.measure == "distance":
                second = situation.concrete.participant(encounter.second)
                return middle / max(second.speed_mps, 1.0)
    return None


def _common_shift(
    later: dict[str, float], starts: dict[str, Parameter], speeds: dict[str, float], wish: float
) -> float:
    """What is taken off every delay, s: it keeps the gaps, and everybody within its bounds.

    As near to ``wish`` as the bounds allow.
    """
    least, most = -float("inf"), float("inf")
    for name, p in starts.items():
        least = max(least, later[name] - (p.value - p.low) / speeds[name])
        most = min(most, later[name] + (p.high - p.value) / speeds[name])
    return min(max(wish, least), most) if least <= most else (least + most) / 2
