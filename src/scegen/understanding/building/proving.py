"""Keeps the evidence: for each field the words, or the reason, on which it rests."""

from __future__ import annotations

from scegen.scenario.functional import Evidence
from scegen.scenario.vocabulary import EvidenceSource
from scegen.understanding.draft import Basis
from scegen.understanding.words.tokens import Token


class Proofs:
    """The evidence of a scenario in the making."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self._text = text
        self._tokens = tokens
        self._found: list[Evidence] = []

    @property
    def evidence(self) -> tuple[Evidence, ...]:
        """All evidence so far, in the order in which it was given."""
        return tuple(self._found)

    def span(self, i: int, j: int) -> tuple[int, int]:
        """Characters covered by tokens ``i`` to ``j - 1``."""
        return self._tokens[i].start, self._tokens[j - 1].end

    def add(self, name: str, basis: Basis | None, default: str | None = None) -> None:
        """Adds the evidence of one field.

        Args:
            name: the field.
            basis: its words or the reason for it; None if the text does not say.
            default: why it has its value if the text does not say.
        """
        if basis is None:
            self._found.append(
                Evidence(field=name, source=EvidenceSource.DEFAULT, reason=default or "not said")
            )
            return
        reason = "; ".join(filter(None, (basis.reason, self._slips(basis)))) or None
        source = EvidenceSource.INFERRED if reason else EvidenceSource.STATED
        start = end = text = None
        if basis.i is not None and basis.j is not None:
            start, end = self.span(basis.i, basis.j)
            text = self._text[start:end]
        self._found.append(
            Evidence(field=name, source=source, text=text, start=start, end=end, reason=reason)
        )

    def _slips(self, basis: Basis) -> str:
        """Misspelt words among those that a field rests on."""
        words = self._tokens[basis.i : basis.j] if basis.i is not None else []
        return "; ".join(f"'{t.text}' is read as '{t.low}'" for t in words if t.slip)
