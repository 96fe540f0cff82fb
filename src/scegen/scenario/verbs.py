"""Who does what, as people say it."""

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import ANIMALS, ON_FOOT, ParticipantKind

_DOES = {
    ActKind.CHANGE_LANE: ("changes lane", "changed lane"),
    ActKind.CROSS: ("crosses", "crossed"),
    ActKind.ENTER: ("enters", "entered"),
    ActKind.GIVE_WAY: ("gives way", "given way"),
    ActKind.OPEN_DOOR: ("opens a door", "opened a door"),
    ActKind.OVERTAKE: ("overtakes", "overtaken"),
    ActKind.SET_OFF: ("sets off", "set off"),
    ActKind.STOP: ("stops", "stopped"),
}
"""What one does, and has done, where that is not regular."""


def does(act: ActKind) -> str:
    """``brakes``, ``changes lane``."""
    return _DOES[act][0] if act in _DOES else f"{act.value}s"


def has_done(act: ActKind) -> str:
    """``has braked``, ``has changed lane``."""
    done = _DOES[act][1] if act in _DOES else f"{act.value.removesuffix('e')}ed"
    return f"has {done}"


def goes(kind: ParticipantKind) -> str:
    """How one of a kind moves: ``walks``, ``rides``, ``drives``."""
    if kind in ON_FOOT:
        return "runs" if kind in ANIMALS else "walks"
    return "rides" if kind in {ParticipantKind.BICYCLE, ParticipantKind.MOTORCYCLE} else "drives"
