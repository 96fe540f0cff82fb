"""When there is something to see: statements, dangers, the closest approach."""

import re
from collections.abc import Mapping, Sequence

import numpy as np

from scegen.motion.model import Trace
from scegen.report.player.meetings import Meetings
from scegen.report.player.series import Data
from scegen.scenario.concrete import ConcreteScenario, CrossingMotion, DriveMotion
from scegen.scenario.proof import ClaimProof, Proof

_LASTING = frozenset({"road", "body", "entry", "order", "approach", "beside", "lane", "stands"})
"""Kinds of statements that are so from the start: no moment of the time line."""
_OF_WAYS = frozenset({"exit", "maneuver"})
"""Kinds that are judged when all is over, and seen on the way."""
_OVER_S = 0.1


def claim_data(claim: ClaimProof, concrete: ConcreteScenario, traces: Mapping[str, Trace]) -> Data:
    """A statement; ``shown_s`` is when to look."""
    who = _named(claim, concrete)
    return {
        "id": claim.id,
        "kind": claim.kind,
        "statement": claim.statement,
        "words": claim.words,
        "holds": claim.holds,
        "measured": claim.measured,
        "unit": claim.unit,
        "time_s": claim.time_s,
        "shown_s": _shown_s(claim, who, concrete, traces),
        "who": who,
    }


def moments(
    concrete: ConcreteScenario, traces: Mapping[str, Trace], proof: Proof | None, meetings: Meetings
) -> list[Data]:
    """What is marked on the time line, in its order."""
    found: list[Data] = []

    def mark(time_s: float, kind: str, label: str, holds: bool, who: Sequence[str]) -> Data:
        data: Data = {"time_s": time_s, "kind": kind, "label": label, "holds": holds}
        found.append(data | {"who": list(who)})
        return found[-1]

    for hazard in proof.hazards if proof else ():
        if hazard.time_s is not None:
            label, who = hazard.kind.replace("_", " "), (*hazard.by, *hazard.to)
            mark(round(hazard.time_s, 2), "danger", label, hazard.happened, who)
    for claim in proof.claims if proof else ():
        data = claim_data(claim, concrete, traces)
        lasts = claim.kind in _LASTING or data["shown_s"] == 0.0
        if data["shown_s"] is None or (lasts and claim.holds):
            continue
        marked = mark(data["shown_s"], "claim", claim.statement, claim.holds, data["who"])
        marked["claim"] = claim.id
    if meetings.moment_s is not None:
        kind = "contact" if meetings.touches else "closest"
        mark(round(meetings.moment_s, 2), kind, meetings.moment, True, meetings.pair)
    return sorted(found, key=lambda moment: moment["time_s"])


def _named(claim: ClaimProof, concrete: ConcreteScenario) -> list[str]:
    """Whom a statement is about: the ids that stand in it as whole words, in their order there."""
    words = re.findall(r"\w+", f"{claim.field} {claim.statement}")
    known = {entity.id for entity in concrete.entities}
    return [word for word in dict.fromkeys(words) if word in known]


def _shown_s(
    claim: ClaimProof, who: list[str], concrete: ConcreteScenario, traces: Mapping[str, Trace]
) -> float | None:
    """The moment of a statement; of one about a way, when it is half through junction or road."""
    if claim.time_s is None or not who or claim.kind not in _OF_WAYS or who[0] not in traces:
        return None if claim.time_s is None else round(claim.time_s, 2)
    trace = traces[who[0]]
    if claim.time_s < trace.time_s[-1] - _OVER_S:
        return round(claim.time_s, 2)
    motion = concrete.participant(who[0]).motion
    if isinstance(motion, DriveMotion):
        middle = (motion.turning_starts_m + motion.turning_ends_m) / 2 - motion.start_m
    elif isinstance(motion, CrossingMotion):
        middle = float(trace.s_m[-1]) / 2
    else:
        return round(claim.time_s, 2)
    place = int(np.searchsorted(trace.s_m, middle))
    return round(float(trace.time_s[min(place, len(trace.time_s) - 1)]), 2)
