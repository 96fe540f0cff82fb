"""Parameters of a logical scenario: ranges that concretization chooses from."""

from collections.abc import Iterator

from scegen.scenario.model import CheckedModel


class ParameterRange(CheckedModel):
    """A parameter that concretization may choose within ``[low, high]``; ``name`` ends in its unit.

    ``name`` is of whom and what: ``<participant>.speed_mps``, ``<act>.rate_mps2`` (and every other
    quantity of an act; of what sets it off, ``<act>.when.gap_m``), ``spacing_<number>.<measure>``
    in the order of the spacings, from 0, ``outcome.impact_percent``, ``<participant>.length_m``.
    ``reason`` says where the range comes from, ``stated`` where the text gives it.
    """

    name: str
    low: float
    high: float
    default: float
    reason: str

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if not self.low <= self.default <= self.high:
            yield f"{self.name}: default {self.default:g} outside [{self.low:g}, {self.high:g}]"
