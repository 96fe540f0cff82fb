"""The base of every scenario type: frozen, closed, and the same bytes in YAML and JSON."""

from collections.abc import Iterable, Iterator
from enum import Enum
from math import inf
from typing import Annotated, Any, Self, TypeVar

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, PlainSerializer, model_validator

T = TypeVar("T", bound=Enum)


class FrozenModel(BaseModel):
    """Immutable, hashable where its fields are, refuses unknown fields."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)

    @classmethod
    def from_valid(cls, fields: dict[str, Any], names: set[str]) -> Self:
        """An instance of all its fields, each already valid: nothing is checked or copied.

        For the thousandfold: what ``model_construct`` makes, by the way that pickle takes, in a
        quarter of the time. ``names`` are those of all fields and are shared, not copied.
        """
        made = cls.__new__(cls)
        object.__setattr__(made, "__dict__", fields)
        object.__setattr__(made, "__pydantic_fields_set__", names)
        object.__setattr__(made, "__pydantic_extra__", None)
        object.__setattr__(made, "__pydantic_private__", None)
        return made

    def but(self, **changes: object) -> Self:
        """The same but for some fields, of which nothing is checked."""
        return self.model_copy(update=changes)


class CheckedModel(FrozenModel):
    """One whose fields have to fit together, too."""

    def misfits(self) -> Iterator[str]:
        """What does not fit, in words; the first of these is told."""
        raise NotImplementedError

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        for misfit in self.misfits():
            raise ValueError(misfit)
        return self


def _in_order(values: Iterable[Any]) -> list[Any]:
    """Sets are written in the order of the vocabulary, so that files never differ by chance."""

    def position(value: Any) -> int:  # noqa: ANN401 - enum members or ints
        return list(type(value)).index(value) if isinstance(value, Enum) else int(value)

    return sorted(values, key=position)


VocabularySet = Annotated[frozenset[T], PlainSerializer(_in_order, return_type=list[Any])]
"""A set of vocabulary members, serialised as a list in vocabulary order."""

ArmSet = Annotated[frozenset[int], PlainSerializer(_in_order, return_type=list[int])]
"""A set of arm numbers, serialised in rising order."""

Identifier = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$", max_length=40)]
"""Names of participants: lower case, usable as file, XML and ASP constants."""


class Interval(CheckedModel):
    """A closed range of a quantity in SI units; ``low == high`` is an exact statement.

    In files a plain number stands for the range of that one value.
    """

    low: float
    high: float

    @model_validator(mode="before")
    @classmethod
    def _of_one_value(cls, data: Any) -> Any:  # noqa: ANN401 - whatever a file holds
        number = isinstance(data, int | float) and not isinstance(data, bool)
        return {"low": data, "high": data} if number else data

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if self.low > self.high:
            yield f"low {self.low:g} lies above high {self.high:g}"

    def __str__(self) -> str:
        """As a file shows it: one number where it is exact."""
        return f"{self.low:g}" if self.exact else f"{self.low:g} to {self.high:g}"

    @property
    def middle(self) -> float:
        """The value half way."""
        return (self.low + self.high) / 2

    @property
    def exact(self) -> bool:
        """Whether it holds one value only."""
        return self.low == self.high

    def clip(self, value: float) -> float:
        """The nearest value inside the range."""
        return min(max(value, self.low), self.high)


def between(least: float, most: float) -> AfterValidator:
    """Of a range that some field holds: nothing of it lies outside these two."""

    def inside(said: Interval) -> Interval:
        if not least <= said.low <= said.high <= most:
            allowed = f"between {least:g} and {most:g}" if most < inf else f"at least {least:g}"
            raise ValueError(f"it is {allowed}, not {said}")
        return said

    return AfterValidator(inside)


Magnitude = Annotated[Interval, between(0.0, inf)]
"""A range of what has no sign: a speed, a time, a way."""


def middles(*said: Interval | None) -> tuple[float | None, ...]:
    """The values half way; None where nothing is said."""
    return tuple(None if each is None else each.middle for each in said)
