"""Loads the frames: what a number means by the words it stands with, what a verb is as an act."""

from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from scegen.scenario.acts import ActKind
from scegen.understanding.lexicon import loader

_BESIDE = ("before", "next", "named")
"""Where one phrase of all these has to be."""


@dataclass(frozen=True, slots=True)
class AmountFrame:
    """One row of ``amounts.yaml``: a role with what must stand around the number."""

    dimension: str
    role: str
    named: tuple[str, ...] = ()
    before: tuple[str, ...] = ()
    next: tuple[str, ...] = ()
    near: tuple[str, ...] = ()
    verb: frozenset[str] = frozenset()
    unless: tuple[str, ...] = ()
    most: float | None = None
    ends: bool = False
    instead: str | None = None
    cues: tuple[frozenset[str], ...] = ()
    """With which words its phrases begin: of each set, one stands around the number."""


@cache
def read(name: str) -> Any:  # noqa: ANN401 - the shape differs from file to file
    """What a file of this package holds."""
    return loader.read(name, __package__)


@cache
def amounts(dimension: str) -> tuple[AmountFrame, ...]:
    """All rows of what numbers of a dimension mean, in their order."""
    return tuple(_frame(row) for row in read("amounts") if row["dimension"] == dimension)


@cache
def cues(dimension: str, *roles: str) -> frozenset[str]:
    """Words of which one stands around a number that plays one of some roles."""
    rows = [row for row in amounts(dimension) if row.role in roles]
    return frozenset().union(*(words for row in rows for words in row.cues))


def _frame(row: dict[str, Any]) -> AmountFrame:
    told = {name: tuple(said) if isinstance(said, list) else said for name, said in row.items()}
    phrases = [row.get("near", ()), [p for n in _BESIDE for p in row.get(n, ())]]
    cues = tuple(frozenset(phrase.split()[0] for phrase in some) for some in phrases if some)
    return AmountFrame(**told | {"verb": frozenset(row.get("verb", ())), "cues": cues})


@lru_cache(maxsize=1)
def acts() -> dict[str, ActKind]:
    """Verb -> the act that it is, or mostly is."""
    found: dict[str, ActKind] = {}
    for row in read("acts")["done"]:
        name, *verbs = row["if"][0].split()
        if name == "event" and "act" in row:
            found = dict.fromkeys(verbs, ActKind(row["act"])) | found
    return found


@lru_cache(maxsize=1)
def always_acts() -> frozenset[str]:
    """The verbs that no way says already: what they tell of is an act, or is not there at all."""
    told = (r["if"][0].split() for r in read("acts")["done"] if "always" in r)
    return frozenset(verb for name, *verbs in told if name == "event" for verb in verbs)
