"""Prompts: short files, with the definitions filled in from the code so that they never drift."""

from collections.abc import Callable, Iterable, Mapping
from enum import StrEnum
from functools import lru_cache
from textwrap import indent

from scegen.llm.prompting import data_rule, listed, prompt_file, version_of
from scegen.scenario.acts import ActKind
from scegen.scenario.environment import RoadSurface, TimeOfDay, Visibility, Weather
from scegen.scenario.glossary import defined
from scegen.scenario.junction import ARM_COUNTS
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.roadway import AuxiliaryLane, Carriageway, Strip
from scegen.scenario.spacings import Measure
from scegen.scenario.things import ThingKind
from scegen.scenario.vocabulary import (
    DESCRIBED,
    Approach,
    Control,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.agents.result import Part

REVIEWER = "reviewer"
_PARTS = {
    Part.ROAD: ("the road", "junction.kind"),
    Part.PARTICIPANTS: ("the participants", "participants.car_1.maneuvers`, `relations.0"),
    Part.HAZARDS: ("the dangers", "hazards.speeding"),
    Part.ACTS: ("what happens", "acts.brake_1.rate_mps2`, `spacings.0`, `outcome.kind"),
}
_EXITS = [word for word in Maneuver if word.startswith("exit_")]
_DEFINED: dict[str, Iterable[StrEnum]] = {
    "junction_kinds": JunctionKind,
    "controls": Control,
    "carriageways": Carriageway,
    "strips": Strip,
    "auxiliary_lanes": AuxiliaryLane,
    "participant_kinds": DESCRIBED,
    "approaches": Approach,
    "maneuvers": [word for word in Maneuver if word not in _EXITS[1:]],
    "hazard_kinds": HazardKind,
    "acts": ActKind,
    "measures": Measure,
    "outcomes": OutcomeKind,
}
"""Words that a prompt defines."""
_NAMED: dict[str, Iterable[StrEnum]] = {
    "exits": _EXITS,
    "things": ThingKind,
    "weathers": Weather,
    "times_of_day": TimeOfDay,
    "road_surfaces": RoadSurface,
    "visibilities": Visibility,
    "parts": Part,
}
"""Words that speak for themselves."""


@lru_cache(maxsize=1)
def prompts() -> dict[str, str]:
    """Every agent's instructions by its name."""
    words = _words(defined)
    texts = {
        str(part): _common(name, path) + _fill(part, words) for part, (name, path) in _PARTS.items()
    }
    # The reviewer needs all rules, and learns with each question what the words in it mean.
    common = _common("the review", "").split("\n- `basis`")[0]
    names = _words(lambda words: f"- {listed(words)}")
    rules = [_fill(part, names) for part in _PARTS]
    texts[REVIEWER] = "\n".join(
        [common, "\nThe rules by which the scenario was made:", *rules, _fill(REVIEWER, names)]
    )
    return texts


@lru_cache(maxsize=1)
def prompts_version() -> str:
    """Changes whenever a prompt or the vocabulary does."""
    return version_of(prompts())


def _common(part: str, path: str) -> str:
    common = prompt_file(__package__, "common")
    return common.substitute(part=part, path=path, data_rule=data_rule())


def _fill(name: str, words: Mapping[str, str]) -> str:
    return "\n" + prompt_file(__package__, name).substitute(words)


def _words(table: Callable[[Iterable[StrEnum]], str]) -> dict[str, str]:
    """What fills the places in the prompts; ``table`` shows words that are to be defined."""
    words = {name: indent(table(members), "  ") for name, members in _DEFINED.items()}
    words |= {name: listed(members) for name, members in _NAMED.items()}
    words["arm_counts"] = ", ".join(
        f"`{kind}` {low}" if low == high else f"`{kind}` {low} to {high}"
        for kind, (low, high) in ARM_COUNTS.items()
    )
    return words
