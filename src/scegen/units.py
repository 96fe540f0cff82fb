"""Conversion to SI at the edges: inside the program every quantity is in SI units.

Factors are exact by definition (NIST SP 811, appendix B). A units library would take 0.2 s to
load and 0.2 s to build its registry, of the 3 s that a whole run may take.
"""

from scegen.errors import VocabularyError

SPEED_UNITS_MPS = {
    "m/s": 1.0,
    "km/h": 1000 / 3600,
    "mph": 1609.344 / 3600,
    "ft/s": 0.3048,
    "knot": 1852 / 3600,
}
"""Metres per second in one of each unit."""

UNITS: dict[str, dict[str, float]] = {
    "speed": SPEED_UNITS_MPS,
    "length": {
        "m": 1.0, "km": 1000.0, "cm": 0.01, "ft": 0.3048, "in": 0.0254, "yd": 0.9144,
        "mile": 1609.344, "car length": 4.5,
    },
    "time": {"s": 1.0, "ms": 0.001, "min": 60.0},
    "acceleration": {"m/s2": 1.0, "g": 9.80665, "ft/s2": 0.3048},
    "percentage": {"%": 1.0},
}  # fmt: skip
"""Dimension -> unit -> how much of m/s, m, s, m/s², percent one of it is."""


_OF_FIELDS = {
    "_mps2": "m/s²", "_mps": "m/s", "_deg": "°", "_m": "m", "_s": "s", "_percent": "%",
}  # fmt: skip


def parted(field: str) -> tuple[str, str | None]:
    """What a field is called without the unit at its end, and that unit; None if it has none."""
    for ending, unit in _OF_FIELDS.items():
        if field.endswith(ending):
            return field.removesuffix(ending), unit
    return field, None


def speed_mps(value: float, unit: str) -> float:
    """A speed in metres per second.

    Args:
        value: the number as written.
        unit: one of ``SPEED_UNITS_MPS``.

    Raises:
        VocabularyError: ``unit`` is not a unit of speed.
    """
    if unit not in SPEED_UNITS_MPS:
        known = ", ".join(SPEED_UNITS_MPS)
        raise VocabularyError(f"{unit!r} is not a unit of speed", hint=f"use one of {known}")
    return value * SPEED_UNITS_MPS[unit]
