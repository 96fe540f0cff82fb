"""Amounts that no body reaches, told before anything is laid out."""

from collections.abc import Iterator

from scegen.errors import MotionInfeasibleError
from scegen.scenario.concrete import MOST_RATE_MPS2
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.wording import with_article


def require_possible(functional: FunctionalScenario) -> None:
    """Refuse what nobody's body can do, whatever else is told.

    Raises:
        MotionInfeasibleError: says who, in which field, and what would be possible.
    """
    for where, complaint, hint in _impossible(functional):
        raise MotionInfeasibleError(complaint, where=where, hint=hint)


def _impossible(functional: FunctionalScenario) -> Iterator[tuple[str, str, str]]:
    for participant in functional.participants:
        who, top_mps = participant.id, participant.body.top_speed_mps
        own = [a for a in functional.acts if a.participant == who]
        speeds = [(f"acts.{a.id}.target_speed_mps", a.target_speed_mps) for a in own]
        for where, speed in [(f"participants.{who}.speed_mps", participant.speed_mps), *speeds]:
            if speed is not None and speed.low > top_mps:
                reaches = f"{with_article(participant.kind)} reaches {top_mps:g} m/s"
                yield where, f"{who} is to go {speed.low:g} m/s; {reaches}", "Give a lower speed."
    for act in functional.acts:
        rate = act.rate_mps2
        if rate is None or (rate.high > 0.0 and rate.low <= MOST_RATE_MPS2):
            continue
        told = f"{act.participant} is to {act.kind.replace('_', ' ')} with {rate} m/s2"
        hint = f"Give more than 0 and at most {MOST_RATE_MPS2:g} m/s2."
        yield f"acts.{act.id}.rate_mps2", f"{told}, which nobody can", hint
