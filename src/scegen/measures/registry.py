"""The measures as data: name, unit, which direction is worse, and of whom."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Worse(StrEnum):
    """Which direction of a measure is more dangerous."""

    SMALLER = "smaller"
    LARGER = "larger"


class Subject(StrEnum):
    """Of whom a value is: a pair, each of a pair (last axis), or a triple with an occluder."""

    PAIR = "pair"
    EACH = "each"
    OCCLUSION = "occlusion"


@dataclass(frozen=True, slots=True)
class Measure:
    """A measure.

    ``name`` is the one in files and commands, ``field`` that of ``evaluation.Summary``, ``unit``
    is SI ("1" for none), ``defined_by`` the module below ``scegen.measures`` that
    defines it. nan means undefined, never "harmless" or "critical".
    """

    name: str
    field: str
    unit: str
    worse: Worse
    subject: Subject
    defined_by: str
    title: str


MEASURES: tuple[Measure, ...] = (
    Measure(
        "distance",
        "distance_m",
        "m",
        Worse.SMALLER,
        Subject.PAIR,
        "distance",
        "smallest distance between the bodies",
    ),
    Measure(
        "contact_time",
        "contact_s",
        "s",
        Worse.SMALLER,
        Subject.PAIR,
        "contact",
        "time of the first contact",
    ),
    Measure(
        "ttc",
        "ttc_s",
        "s",
        Worse.SMALLER,
        Subject.PAIR,
        "time_to_collision",
        "smallest two-dimensional time to collision",
    ),
    Measure(
        "pet",
        "pet_s",
        "s",
        Worse.SMALLER,
        Subject.PAIR,
        "post_encroachment",
        "smallest post-encroachment time",
    ),
    Measure(
        "headway",
        "headway_s",
        "s",
        Worse.SMALLER,
        Subject.PAIR,
        "headway",
        "smallest time headway",
    ),
    Measure(
        "drac",
        "drac_mps2",
        "m/s2",
        Worse.LARGER,
        Subject.PAIR,
        "drac",
        "highest deceleration rate to avoid a crash",
    ),
    Measure(
        "required_braking",
        "required_mps2",
        "m/s2",
        Worse.LARGER,
        Subject.EACH,
        "required_braking",
        "highest required deceleration",
    ),
    Measure(
        "brake_threat",
        "brake_threat",
        "1",
        Worse.LARGER,
        Subject.EACH,
        "required_braking",
        "highest ratio of required to available deceleration",
    ),
    Measure(
        "impact_speed",
        "impact_mps",
        "m/s",
        Worse.LARGER,
        Subject.PAIR,
        "impact",
        "relative speed at the first contact",
    ),
    Measure(
        "delta_v",
        "delta_v_mps",
        "m/s",
        Worse.LARGER,
        Subject.EACH,
        "impact",
        "change of velocity in the impact",
    ),
    Measure(
        "injury",
        "injury",
        "1",
        Worse.LARGER,
        Subject.EACH,
        "injury",
        "probability of at least one serious injury (MAIS 3 or more)",
    ),
    Measure(
        "occlusion",
        "occluded_s",
        "s",
        Worse.LARGER,
        Subject.OCCLUSION,
        "occlusion",
        "longest time without line of sight",
    ),
    Measure(
        "sight_time",
        "sight_s",
        "s",
        Worse.LARGER,
        Subject.OCCLUSION,
        "occlusion",
        "time at which the line of sight comes back",
    ),
)


def measure_named(name: str) -> Measure:
    """The measure of this name; KeyError if there is none."""
    for measure in MEASURES:
        if measure.name == name:
            return measure
    raise KeyError(name)
