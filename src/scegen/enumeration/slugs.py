"""Short names of scenarios, for directories: legible, not unique (the index is)."""

from __future__ import annotations

from collections import Counter

from scegen.scenario.arms import ring_move
from scegen.scenario.junction import Junction
from scegen.scenario.logical import Assignment, Crossing, Drive
from scegen.scenario.vocabulary import JunctionKind, Maneuver

MAX_LENGTH = 40
MOST_SPELT_OUT = 4


def slug_of(junction: Junction, assignments: tuple[Assignment, ...]) -> str:
    """Such as ``0left-2straight``: who enters at arm 0 turns left, who enters at 2 goes straight.

    With more than four drivers, or too long, the pattern: ``moves-1x3-2x7`` (three make move 1,
    seven move 2).
    """
    drives = [a for a in assignments if isinstance(a, Drive)]
    words = [_word(junction, drive) for drive in drives]
    words += [f"{a.arm}cross{a.start[0]}" for a in assignments if isinstance(a, Crossing)]
    spelt = "-".join(words)
    if len(drives) <= MOST_SPELT_OUT and len(spelt) <= MAX_LENGTH:
        return spelt
    counts = sorted(Counter(drive.move for drive in drives).items())
    return "moves-" + "-".join(f"{move}x{times}" for move, times in counts)


def _word(junction: Junction, drive: Drive) -> str:
    beside = "" if drive.maneuver is drive.turn else drive.maneuver.value.replace("_", "")
    if drive.reverses is not None:
        beside = drive.reverses.value.replace("_", "")
    return f"{drive.entry}{beside}{_way(junction, drive)}"


def _way(junction: Junction, drive: Drive) -> str:
    if junction.kind is JunctionKind.ROUNDABOUT:
        return f"exit{ring_move(junction, drive.move) or junction.arms}"
    return "uturn" if drive.turn is Maneuver.U_TURN else drive.turn.value
