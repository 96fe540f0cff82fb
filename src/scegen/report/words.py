"""Scenario values in words, for captions and tables."""

from scegen.scenario.concrete import (
    ArrivalBelow,
    AtTime,
    ConcreteParticipant,
    CrossingMotion,
    DriveMotion,
    LaneChange,
    SpeedPhase,
    StoodStill,
    SwingingMotion,
    Travelled,
)
from scegen.scenario.functional import Hazard
from scegen.scenario.logical import Conflict, Reverses, Rule
from scegen.scenario.objects import StaticObject
from scegen.scenario.reversing import BacksUp, Reversal
from scegen.scenario.vocabulary import Role

KMH = 3.6
_RULES: dict[Rule, str] = {
    Rule.ON_CALL: "siren and blue lights",
    Rule.SIGN: "sign at the minor road",
    Rule.PRIORITY_TO_RIGHT: "priority to the right",
    Rule.ONCOMING: "turns across oncoming traffic",
    Rule.RING: "the ring goes first",
    Rule.U_TURN: "turns round",
    Rule.SIGNAL: "the light decides who goes",
    Rule.FIRST_COME: "whoever is first on the ring goes first",
    Rule.CROSSWALK: "crosswalk",
    Rule.NO_CROSSWALK: "no crosswalk there",
    Rule.AHEAD: "the other is ahead",
    Rule.LANE_CHANGE: "changes lane",
}


REVERSES: dict[Reverses, str] = {
    Reverses.BACKS_UP: "backs up",
    Reverses.OUT_OF_ARM: "backs out",
    Reverses.FROM_RIGHT: "backs out from the right",
    Reverses.FROM_LEFT: "backs out from the left",
    Reverses.SQUARE: "backs straight out",
}


def plain(word: str) -> str:
    """A vocabulary word as people write it."""
    return word.replace("_", " ")


def speed_words(speed_mps: float) -> str:
    """A speed in m/s and km/h."""
    return f"{speed_mps:.1f} m/s ({speed_mps * KMH:.0f} km/h)"


def hazard_words(hazard: Hazard) -> str:
    """A hazard with those who cause and suffer it."""
    text = plain(hazard.kind)
    if hazard.by:
        text += f" by {' and '.join(hazard.by)}"
    if hazard.to:
        text += f", endangering {' and '.join(hazard.to)}"
    return text


def name_words(participant: ConcreteParticipant) -> str:
    """Its name; of the ego that it is the ego, if it is called otherwise."""
    is_ego = participant.role is Role.EGO and participant.id != "ego"
    return f"{participant.id} (ego)" if is_ego else participant.id


def participant_words(participant: ConcreteParticipant) -> str:
    """What a participant is, how fast it starts and where it goes."""
    kind, motion = plain(participant.kind), participant.motion
    if isinstance(motion, DriveMotion):
        return (
            f"{kind}, starts at {speed_words(participant.speed_mps)}, "
            f"arm {motion.entry} → arm {motion.exit}{reversal_words(motion.reversal)}"
        )
    if isinstance(motion, CrossingMotion):
        goes = participant.speed_mps > 0
        start = f"starts at {speed_words(participant.speed_mps)}" if goes else "waits at first"
        return f"{kind}, {start}, crosses arm {motion.arm} from the {motion.start_side}"
    if isinstance(motion, SwingingMotion):
        return f"{kind} of {motion.vehicle}, closed at first"
    place = "in the lane of" if motion.in_lane else f"on the {motion.side} of"
    return f"{kind}, stands {place} arm {motion.arm}"


def thing_words(thing: StaticObject) -> str:
    """What a thing is and how large."""
    size = f"{thing.length_m:g} × {thing.width_m:g} × {thing.height_m:g} m"
    kind = "" if thing.what == thing.category else f" ({thing.category})"
    return f"{thing.what}{kind}, {size}, does not move"


def reversal_words(reversal: Reversal | None) -> str:
    """How a vehicle reverses, to be put behind where it drives; nothing if it does not."""
    if reversal is None:
        return ""
    if isinstance(reversal, BacksUp):
        return f", goes {reversal.length_m:.1f} m back from {reversal.from_m:.1f} m"
    if reversal.straight_m is not None:
        return f", comes {reversal.straight_m:.1f} m straight back, square to the road"
    if reversal.arm is not None:
        return f", comes backwards out of arm {reversal.arm}"
    return f", comes out backwards from the {reversal.side}"


def phase_words(phase: SpeedPhase) -> str:
    """When a speed phase fires and what it does."""
    trigger = phase.trigger
    if isinstance(trigger, AtTime):
        when = f"at {trigger.time_s:.2f} s"
    elif isinstance(trigger, Travelled):
        when = f"once {trigger.participant} has travelled {trigger.distance_m:.1f} m"
    elif isinstance(trigger, StoodStill):
        when = f"once {trigger.participant} has stood for {trigger.duration_s:.1f} s"
    elif isinstance(trigger, ArrivalBelow):
        when = (
            f"once {trigger.participant} is {trigger.time_s:.2f} s short of the place "
            f"{trigger.place_m:.1f} m on its way"
        )
    else:
        when = f"once {trigger.participant} is nearer than {trigger.distance_m:.1f} m"
    text = f"{when}: to {speed_words(phase.target_speed_mps)} at {phase.rate_mps2:.2f} m/s²"
    return f"{text} — {plain(phase.hazard)}" if phase.hazard else text


def lane_change_words(change: LaneChange) -> str:
    """Where a lane change lies and where it leads."""
    lane = "the oncoming lane" if change.lane_after == 0 else f"lane {change.lane_after}"
    text = f"into {lane} from {change.position_m:.1f} m, over {change.length_m:.1f} m"
    return f"{text} — {plain(change.hazard)}" if change.hazard else text


def right_of_way_words(conflict: Conflict) -> str:
    """Who gives way to whom, and why."""
    why = _RULES[conflict.rule] if conflict.rule else "neither gives way"
    if conflict.yields is None:
        return why
    other = conflict.second if conflict.yields == conflict.first else conflict.first
    return f"{conflict.yields} yields to {other} ({why})"
