"""Keeps the evidence: for each field the words, or the reason, on which it rests."""

from __future__ import annotations

from typing import Any

from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.understanding.entity import Basis
from scegen.understanding.words.tokens import Token

_FIELDS = set(Evidence.model_fields)
_NOT_SAID: dict[str, Any] = dict.fromkeys(("text", "start", "end", "reason"))


class Proofs:
    """The evidence of a scenario in the making."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self._text = text
        self._tokens = tokens
        self._slips = [k for k, token in enumerate(tokens) if token.slip]
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
        told = {"field": name, "source": EvidenceSource.DEFAULT, **_NOT_SAID}
        if basis is None:
            told["reason"] = default or "not said"
        elif reason := self._reason(basis):
            told |= {"source": EvidenceSource.INFERRED, "reason": reason}
        else:
            told["source"] = EvidenceSource.STATED
        if basis is not None and basis.i is not None and basis.j is not None:
            start, end = self.span(basis.i, basis.j)
            told |= {"text": self._text[start:end], "start": start, "end": end}
        self._found.append(Evidence.from_valid(told, _FIELDS))

    def _reason(self, basis: Basis) -> str:
        """Why a field has its value, misspelt words among those that it rests on included."""
        first, end = basis.i or 0, basis.j or 0
        slips = [self._tokens[k] for k in self._slips if first <= k < end]
        if not slips:
            return basis.reason or ""
        read = [f"'{t.text}' is read as '{t.low}'" for t in slips]
        return "; ".join([basis.reason, *read] if basis.reason else read)
