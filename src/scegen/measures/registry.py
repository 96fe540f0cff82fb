"""The measures as data: name, unit, which direction is worse, and of whom."""

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


MEASURES: tuple[Measure, ...] = (
    Measure("distance", "distance_m", "m", Worse.SMALLER, Subject.PAIR, "distance"),
    Measure("contact_time", "contact_s", "s", Worse.SMALLER, Subject.PAIR, "contact"),
    Measure("ttc", "ttc_s", "s", Worse.SMALLER, Subject.PAIR, "time_to_collision"),
    Measure("pet", "pet_s", "s", Worse.SMALLER, Subject.PAIR, "post_encroachment"),
    Measure("headway", "headway_s", "s", Worse.SMALLER, Subject.PAIR, "headway"),
    Measure("drac", "drac_mps2", "m/s2", Worse.LARGER, Subject.PAIR, "drac"),
    Measure(
        "required_braking", "required_mps2", "m/s2", Worse.LARGER, Subject.EACH, "required_braking"
    ),
    Measure("brake_threat", "brake_threat", "1", Worse.LARGER, Subject.EACH, "required_braking"),
    Measure("impact_speed", "impact_mps", "m/s", Worse.LARGER, Subject.PAIR, "impact"),
    Measure("delta_v", "delta_v_mps", "m/s", Worse.LARGER, Subject.EACH, "impact"),
    Measure("injury", "injury", "1", Worse.LARGER, Subject.EACH, "injury"),
    Measure("occlusion", "occluded_s", "s", Worse.LARGER, Subject.OCCLUSION, "occlusion"),
    Measure("sight_time", "sight_s", "s", Worse.LARGER, Subject.OCCLUSION, "occlusion"),
)


_BY_NAME = {measure.name: measure for measure in MEASURES}


def measure_named(name: str) -> Measure:
    """The measure of this name; KeyError if there is none."""
    return _BY_NAME[name]
