"""Targets: what a search is to reach, as a word or a range of a measure.

near-miss: nobody touches anybody, and the pair comes as close as in a serious conflict, by one
of several measures (``claims.near_miss``), after a lead-in (``search.lead_in``). avoided: nobody
touches anybody, and nothing more.
"""

import re
from dataclasses import dataclass

from scegen.claims.near_miss import NEAR_MISS as BANDS_OF_A_NEAR_MISS
from scegen.claims.near_miss import Band
from scegen.errors import InputError

COLLISION, NEAR_MISS, AVOIDED = "collision", "near-miss", "avoided"


@dataclass(frozen=True, slots=True)
class Target:
    """What to reach: one of ``choices``, each a set of bands that must hold together.

    Without choices, it is enough that nobody touches. The first band of a choice is reported.
    ``contact`` says whether the pair must (True) or must not (False) touch; None leaves it open.
    """

    text: str
    choices: tuple[tuple[Band, ...], ...]
    contact: bool | None


BANDS: dict[str, tuple[float, float]] = {
    "pet": (-5.0, 20.0),
    "ttc": (0.0, 20.0),
    "distance": (0.0, 100.0),
    "headway": (0.0, 20.0),
    "drac": (0.0, 20.0),
}
"""Measures that a band can be asked for, and the widest range that makes sense."""


def asks_for_measure(target: Target) -> bool:
    """Whether somebody asked for a range of a measure, instead of a word for how it ends."""
    return target.text not in {COLLISION, NEAR_MISS, AVOIDED}


_PATTERN = re.compile(r"\s*([a-z]+)\s*=\s*(-?[0-9.]+)\s*\.\.\s*(-?[0-9.]+)\s*")


def parse_target(text: str) -> Target:
    """A target from its text: ``near-miss``, ``collision`` or ``pet=0.3..1.0`` and the like.

    Raises:
        InputError: it is none, or its range is empty or out of reach.
    """
    word = text.strip().lower()
    if word == NEAR_MISS:
        return Target(word, BANDS_OF_A_NEAR_MISS, contact=False)
    if word == AVOIDED:
        return Target(word, (), contact=False)
    if word == COLLISION:
        return Target(word, ((Band("distance", 0.0, 0.0),),), contact=True)
    match = _PATTERN.fullmatch(word)
    if match is None or match[1] not in BANDS:
        raise InputError(
            f"{text!r} is no target",
            where="--target",
            hint="near-miss, collision, avoided, none, or a range: "
            + ", ".join(f"{name}=A..B" for name in BANDS),
        )
    try:
        low, high = float(match[2]), float(match[3])
    except ValueError as error:
        raise InputError(f"{text!r} has no numbers", where="--target") from error
    least, most = BANDS[match[1]]
    if not least <= low < high <= most:
        raise InputError(
            f"{low:g}..{high:g} is no range within {least:g}..{most:g}",
            where="--target",
            hint="a range needs a lower and a higher end: no search meets one exact value",
        )
    touching = match[1] != "drac" and match[1] != "headway" and low <= 0.0
    return Target(word, ((Band(match[1], low, high),),), contact=None if touching else False)
