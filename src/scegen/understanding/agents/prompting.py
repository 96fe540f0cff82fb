"""Prompts: short files, with the vocabulary filled in from the code so that they never drift."""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache
from string import Template

from scegen.llm.prompting import data_rule, listed, prompt_file, version_of
from scegen.scenario.functional import ARM_COUNTS
from scegen.scenario.vocabulary import (
    Approach,
    Control,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    RoadSurface,
    TimeOfDay,
    Visibility,
    Weather,
)
from scegen.understanding.agents.result import Part

REVIEWER = "reviewer"
_PARTS = {
    Part.ROAD: ("the road", "junction.kind"),
    Part.PARTICIPANTS: ("the participants", "participants.car_1.maneuvers"),
    Part.HAZARDS: ("the dangers", "hazards.speeding"),
    Part.ENVIRONMENT: ("the conditions", "environment.weather"),
}


@lru_cache(maxsize=1)
def prompts() -> dict[str, str]:
    """Every agent's instructions by its name."""
    words = _vocabulary()
    texts = {
        str(part): _common(name, path) + _fill(part, words) for part, (name, path) in _PARTS.items()
    }
    rules = _common("the review", "junction.kind")
    # of the common rules, the reviewer needs all but those on how to fill fields
    texts[REVIEWER] = rules.split("\n- `basis`")[0] + "\n" + _fill(REVIEWER, words)
    return texts


@lru_cache(maxsize=1)
def prompts_version() -> str:
    """Changes whenever a prompt or the vocabulary does."""
    return version_of(prompts())


def _common(part: str, path: str) -> str:
    return _file("common").substitute(part=part, path=path, data_rule=data_rule())


def _fill(name: str, words: dict[str, str]) -> str:
    return "\n" + _file(name).substitute(words)


def _file(name: str) -> Template:
    return prompt_file(__package__, name)


def _vocabulary() -> dict[str, str]:
    lists: dict[str, type[StrEnum]] = {
        "junction_kinds": JunctionKind,
        "controls": Control,
        "participant_kinds": ParticipantKind,
        "approaches": Approach,
        "maneuvers": Maneuver,
        "hazard_kinds": HazardKind,
        "weathers": Weather,
        "times_of_day": TimeOfDay,
        "road_surfaces": RoadSurface,
        "visibilities": Visibility,
        "parts": Part,
    }
    words = {name: listed(members) for name, members in lists.items()}
    words["arm_counts"] = ", ".join(
        f"`{kind}` {low}" if low == high else f"`{kind}` {low} to {high}"
        for kind, (low, high) in ARM_COUNTS.items()
    )
    return words
