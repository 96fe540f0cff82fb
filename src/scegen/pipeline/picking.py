"""Choosing logical scenarios: by number, by name, or the ones with most conflicts."""

import re

from scegen.enumeration.choosing.ranking import richest_first
from scegen.errors import InputError
from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.logical import LogicalScenario, LogicalSet
from scegen.scenario.vocabulary import Approach, HazardKind

MOST_RUNS = 12
"""Ranges of numbers that a message names."""


def pick(
    logical: LogicalSet, expression: str | None, *, option: str = "--pick"
) -> tuple[LogicalScenario, ...]:
    """The scenarios that ``expression`` names, in its order; by conflict richness if None.

    Of all, those come first in which the text's occluders can hide somebody.

    An expression is ``all``, or a comma-separated list of numbers (``3``), ranges (``0-4``)
    and names (``000-ego-left`` or its slug).

    Raises:
        InputError: a part names no scenario.
    """
    if expression is None:
        richest = sorted(logical.scenarios, key=lambda s: richest_first(s, logical.functional))
        return tuple(sorted(richest, key=lambda s: -_hidden(s, logical)))
    if expression.strip() == "all":
        return logical.scenarios
    by_index = {s.index: s for s in logical.scenarios}
    by_name = {s.slug: s for s in reversed(logical.scenarios)}
    by_name |= {s.name: s for s in logical.scenarios}
    chosen: dict[int, LogicalScenario] = {}
    for part in (p.strip() for p in expression.split(",")):
        bounds = re.fullmatch(r"(\d{1,9})(?:-(\d{1,9}))?", part)
        if bounds:
            first = int(bounds[1])
            last = int(bounds[2] or first)
            if last < first or last not in by_index or first not in by_index:
                raise _unknown(part, logical, option)
            chosen |= {i: by_index[i] for i in range(first, last + 1) if i in by_index}
        elif part in by_name:
            chosen[by_name[part].index] = by_name[part]
        else:
            raise _unknown(part, logical, option)
    return tuple(chosen.values())


def _hidden(scenario: LogicalScenario, logical: LogicalSet) -> int:
    """Where the text asks for occlusion: how many come from the side that is parked on.

    One who stands on the right of the observer's arm hides traffic from the right.
    """
    angles = arm_angles_deg(logical.functional.junction)
    count = 0
    for hazard in logical.functional.hazards:
        if hazard.kind is not HazardKind.OCCLUSION:
            continue
        observers = hazard.to or (logical.functional.ego.id,)
        for observer in (d for d in scenario.drives if d.participant in observers):
            sides = {
                Approach(stand.side.value)
                for stand in scenario.standings
                if stand.arm == observer.entry and stand.participant in hazard.by
            }
            count += sum(
                bool(sides & seen_from(angles, observer.entry, other.entry))
                for other in scenario.drives
                if other.participant not in observers
            )
    return count


def _unknown(part: str, logical: LogicalSet, option: str) -> InputError:
    return InputError(
        f"{part!r} names no logical scenario; {_numbers([s.index for s in logical.scenarios])}",
        where=option,
        hint="use 'all', numbers (3), ranges (0-4) or names as in logical.json"
        if option == "--pick"
        else None,
    )


def _numbers(indices: list[int]) -> str:
    """Which numbers there are: ranges, as a narrowed set has gaps."""
    runs: list[list[int]] = []
    for index in sorted(indices):
        if runs and index == runs[-1][-1] + 1:
            runs[-1].append(index)
        else:
            runs.append([index])
    told = [str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs]
    if len(told) > MOST_RUNS:
        told = [*told[: MOST_RUNS - 1], "…", told[-1]]
    return f"there is only {told[0]}" if len(indices) == 1 else f"there are {', '.join(told)}"
