"""Conversion to SI at the edges: inside the program every quantity is in SI units."""

from __future__ import annotations

from functools import lru_cache

import pint

from scegen.errors import VocabularyError

_ALIASES = {
    "km/h": "kilometer / hour",
    "kmh": "kilometer / hour",
    "kph": "kilometer / hour",
    "mph": "mile / hour",
    "m/s": "meter / second",
    "mps": "meter / second",
    "ft/s": "foot / second",
    "knots": "knot",
}
_DIMENSIONS = {"speed": "[length] / [time]", "length": "[length]", "time": "[time]"}


@lru_cache(maxsize=1)
def registry() -> pint.UnitRegistry[float]:
    """The unit registry, built when first needed (it takes 0.2 s)."""
    return pint.UnitRegistry(cache_folder=None)


@lru_cache(maxsize=256)
def _factor(unit: str, dimension: str) -> float:
    name = _ALIASES.get(unit.strip().lower(), unit)
    try:
        quantity = registry().Quantity(1.0, name)
        fits = quantity.check(_DIMENSIONS[dimension])
    except Exception as error:  # pint raises many kinds, tokenize.TokenError among them
        msg = f"{unit!r} is not a unit"
        raise VocabularyError(msg, hint="Use for example km/h, mph, m/s, m, ft or s.") from error
    if not fits:
        msg = f"{unit!r} is not a unit of {dimension}"
        raise VocabularyError(msg)
    return float(quantity.to_base_units().magnitude)


def speed_mps(value: float, unit: str) -> float:
    """A speed in metres per second.

    Args:
        value: the number as written.
        unit: its unit, for example ``km/h``, ``mph``, ``m/s``, ``knot``.

    Raises:
        VocabularyError: if ``unit`` is not a unit of speed.
    """
    return value * _factor(unit, "speed")


def length_m(value: float, unit: str) -> float:
    """A length in metres.

    Args:
        value: the number as written.
        unit: its unit, for example ``m``, ``km``, ``ft``, ``mile``.

    Raises:
        VocabularyError: if ``unit`` is not a unit of length.
    """
    return value * _factor(unit, "length")


def time_s(value: float, unit: str) -> float:
    """A duration in seconds.

    Args:
        value: the number as written.
        unit: its unit, for example ``s``, ``min``, ``ms``.

    Raises:
        VocabularyError: if ``unit`` is not a unit of time.
    """
    return value * _factor(unit, "time")
