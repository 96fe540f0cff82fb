"""The validator: what is proposed exists, is a number, lies in its bounds, and can be driven.

As in the source paper, an invalid value of a parameter that exists is replaced by a random one
that is valid; nothing can replace a parameter that does not exist.
"""

from collections.abc import Callable, Sequence
from functools import cached_property
from math import isfinite

import numpy as np

from scegen.criticality.proposals.parameters import Parameter
from scegen.criticality.proposals.proposal import Proposal
from scegen.motion.batch.arrays import Floats
from scegen.scenario.concrete import Change, Rejected

VALIDATOR = "validator"
_DRAWS = 12
_LONGEST_SHOWN = 60

Hindrances = Callable[[Floats], frozenset[str]]
"""Why values of all variables (n,) cannot be driven; nothing: they can."""


class Validator:
    """Judges proposals for one scenario.

    ``origin`` (n,) are the values of all variables now, inside their bounds. Hindrances that the
    scenario has already are not held against anybody.
    """

    def __init__(
        self, parameters: Sequence[Parameter], origin: Floats, hindrances: Hindrances
    ) -> None:
        self._parameters = {p.name: p for p in parameters}
        self._origin = origin
        self._hindrances = hindrances

    @cached_property
    def _known(self) -> frozenset[str]:
        """Hindrances that the scenario has already."""
        return self._hindrances(self._origin)

    def validate(
        self, proposals: Sequence[Proposal], by: str, rng: np.random.Generator
    ) -> tuple[tuple[Change, ...], Floats]:
        """What becomes of every proposal; the same generator gives the same.

        Of two that contradict each other, the first stands; ``rng`` draws what replaces invalid
        ones, of which a change is the validator's. Also all values with each one and those before
        it (proposals, n).
        """
        why_not = self.judge(proposals)
        x = self._origin.copy()
        for proposal, why in zip(proposals, why_not, strict=True):
            if why is None:
                x[self._parameters[proposal.parameter].column] = float(proposal.value)
        standing = {p.parameter for p, why in zip(proposals, why_not, strict=True) if why is None}
        # Replacements keep to what stands; provenance tells the proposals in their own order.
        replaced: dict[int, float | None] = {}
        for n, (proposal, why) in enumerate(zip(proposals, why_not, strict=True)):
            if why is None:
                continue
            parameter = self._parameters.get(proposal.parameter)
            replaced[n] = None
            if parameter is not None and proposal.parameter not in standing:
                standing.add(proposal.parameter)
                replaced[n] = self._drawn(x, parameter, rng)
                if replaced[n] is not None:
                    x[parameter.column] = replaced[n]
        return self._changes(proposals, why_not, replaced, by)

    def _changes(
        self,
        proposals: Sequence[Proposal],
        why_not: Sequence[str | None],
        replaced: dict[int, float | None],
        by: str,
    ) -> tuple[tuple[Change, ...], Floats]:
        rows = np.tile(self._origin, (len(proposals), 1))
        changes = []
        for n, (proposal, why) in enumerate(zip(proposals, why_not, strict=True)):
            parameter = self._parameters.get(proposal.parameter)
            before = None if parameter is None else round(float(rows[n, parameter.column]), 3)
            after = float(proposal.value) if why is None else replaced[n]
            if parameter is not None and after is not None:
                rows[n:, parameter.column] = after
            rejected = None
            reason = one_line(proposal.reason)
            if why is not None:
                rejected = Rejected(by=by, value=shown(proposal.value), why=why)
                reason = "a random valid value instead" if after is not None else "left as it was"
                reason += f"; {by} wanted: {one_line(proposal.reason)}"
            changes.append(
                Change(
                    parameter=one_line(proposal.parameter),
                    by=by if why is None else VALIDATOR,
                    before=before,
                    after=None if after is None else round(after, 3),
                    reason=reason,
                    rejected=rejected,
                )
            )
        return tuple(changes), rows

    def judge(self, proposals: Sequence[Proposal]) -> list[str | None]:
        """Why each of some proposals cannot stand; None if it can."""
        why = self._alone(proposals)
        x = self._origin.copy()
        sound = [
            (n, self._parameters[p.parameter].column, float(p.value))
            for n, p in enumerate(proposals)
            if why[n] is None
        ]
        for _, column, value in sound:
            x[column] = value
        if not sound or not self._fresh(x):
            return why
        # Together they do not work: take them one by one, and leave out what spoils it.
        x = self._origin.copy()
        for n, column, value in sound:
            tried = x.copy()
            tried[column] = value
            if fresh := self._fresh(tried):
                others = " with the values before it" if (x != self._origin).any() else ""
                why[n] = f"does not work{others}: {'; '.join(sorted(fresh))}"
            else:
                x = tried
        return why

    def _alone(self, proposals: Sequence[Proposal]) -> list[str | None]:
        """Why each is wrong whatever the scenario is."""
        taken: dict[str, float] = {}
        why: list[str | None] = []
        for proposal in proposals:
            problem = self._wrong(proposal)
            if problem is None and proposal.parameter in taken:
                problem = f"was set to {taken[proposal.parameter]:g} before, by the same proposer"
            if problem is None:
                taken[proposal.parameter] = float(proposal.value)
            why.append(problem)
        return why

    def _wrong(self, proposal: Proposal) -> str | None:
        parameter, value = self._parameters.get(proposal.parameter), proposal.value
        if parameter is None:
            return "there is no such parameter"
        if isinstance(value, bool) or not isinstance(value, int | float):
            return "is not a number"
        # integers may be too long to be floats
        if abs(value) > 1e300 or not isfinite(value):
            return "is not a finite number"
        if not parameter.low <= value <= parameter.high:
            return f"lies outside {parameter.low:g} to {parameter.high:g} {parameter.unit}"
        return None

    def _fresh(self, x: Floats) -> frozenset[str]:
        """Hindrances that the scenario did not have before."""
        return self._hindrances(x) - self._known

    def _drawn(self, x: Floats, parameter: Parameter, rng: np.random.Generator) -> float | None:
        """A random value that goes with the others; None if none was found."""
        for _ in range(_DRAWS):
            value = parameter.inside(float(rng.uniform(parameter.low, parameter.high)))
            tried = x.copy()
            tried[parameter.column] = value
            if not self._fresh(tried):
                return value
        return None


def shown(value: object) -> str:
    """A proposed value, whatever it is, on one short line."""
    text = f"{value:g}" if isinstance(value, float) else _text(value)
    return text if len(text) <= _LONGEST_SHOWN else text[:_LONGEST_SHOWN] + "…"


def _text(value: object) -> str:
    """As text; an integer with thousands of digits has none in Python."""
    if isinstance(value, int) and abs(value) > 10**_LONGEST_SHOWN:
        return f"an integer of {value.bit_length()} bits"
    return one_line(str(value))


def one_line(text: str) -> str:
    """Somebody's words without control characters and line breaks."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())
