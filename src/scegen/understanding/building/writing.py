"""Acts, spacings, things and the outcome of the scenario, and the evidence of every field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from scegen.scenario.acts import (
    Act,
    AfterAct,
    AfterDistance,
    AfterStart,
    BeforeJunction,
    When,
    WhenMeasure,
)
from scegen.scenario.bodies import BODIES
from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.model import Interval
from scegen.scenario.outcome import Outcome
from scegen.scenario.spacings import Measure, Spacing
from scegen.scenario.things import Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Amount, Doing, Happenings, Trigger
from scegen.understanding.words.tokens import Token


@dataclass(frozen=True, slots=True)
class Writer:
    """Writes what the text tells of, once everybody has a name."""

    happenings: Happenings
    ego: Entity
    proofs: Proofs
    lane_width_m: float

    def acts(self) -> tuple[Act, ...]:
        """All acts in the order of the text."""
        for entity, basis in self.happenings.speeds_again:
            self.proofs.add(f"participants.{entity.name}.speed_mps", basis)
        return tuple(self._act(doing) for doing in self.happenings.acts)

    def _act(self, doing: Doing) -> Act:
        path = f"acts.{doing.name}"
        self.proofs.add(f"{path}.kind", doing.basis)
        amounts = dict(doing.amounts)
        if (over := amounts.pop("over_line_m", None)) is not None:
            said, usual = doing.entity.sizes.get("width_m"), BODIES[doing.entity.kind].width_m
            room = (self.lane_width_m - (said.value.middle if said else usual)) / 2
            value = Interval(low=over.value.low + room, high=over.value.high + room)
            basis = over.basis.because(f"from the middle of its lane, {room:.2f} m from the line")
            amounts["lateral_m"] = Amount(value, basis)
        values = {name: amount.value for name, amount in amounts.items()}
        for name, amount in amounts.items():
            self.proofs.add(f"{path}.{name}", amount.basis)
        if doing.side is not None:
            self.proofs.add(f"{path}.side", doing.side_basis or doing.basis)
        if doing.into is not None:
            self.proofs.add(f"{path}.into", doing.into_basis or doing.basis)
        when = self._when(doing.when) if doing.when is not None else None
        if doing.when is not None and when is not None:
            self.proofs.add(f"{path}.when", doing.when.basis)
        return Act(
            id=doing.name,
            participant=doing.entity.name,
            kind=doing.kind,
            side=doing.side,
            into=doing.into.name if doing.into is not None else None,
            when=when,
            **values,
        )

    def _when(self, trigger: Trigger) -> When | None:
        delay = trigger.amount.value if trigger.amount is not None else None
        value, since = delay or STILL, trigger.since
        whose = trigger.entity.name if trigger.entity is not None else None
        if trigger.kind == "start":
            return AfterStart(delay_s=value)
        if trigger.kind == "junction":
            return BeforeJunction(participant=whose, distance_m=value)
        if trigger.kind == "driven":
            return AfterDistance(participant=whose, distance_m=value)
        if trigger.act is not None and trigger.act.name:
            return AfterAct(act=trigger.act.name, since=since, delay_s=delay)
        if trigger.measure is None or whose is None:
            return None
        other = (trigger.reference or self.ego).name
        return WhenMeasure(measure=trigger.measure, participant=whose, reference=other, value=value)

    def spacings(self) -> tuple[Spacing, ...]:
        """All spacings in the order of the text."""
        found: list[Spacing] = []
        for apart in self.happenings.spacings:
            if apart.reference is apart.entity and apart.measure is not Measure.LATERAL_OFFSET_M:
                continue
            self.proofs.add(f"spacings.{len(found)}", apart.amount.basis)
            found.append(
                Spacing(
                    participant=apart.entity.name,
                    reference=apart.reference.name,
                    measure=apart.measure,
                    value=apart.amount.value,
                    at=apart.at if isinstance(apart.at, str) else apart.at.name,
                    since=apart.since,
                    side=apart.side,
                )
            )
        return tuple(found)

    def outcome(self) -> Outcome | None:
        """How it ends, if that is said."""
        ending = self.happenings.ending
        if ending is None:
            return None
        self.proofs.add("outcome.kind", ending.basis)
        if ending.impact is not None:
            self.proofs.add("outcome.impact_percent", ending.impact.basis)
        if ending.struck is not None:
            self.proofs.add("outcome.struck", ending.struck_basis or ending.basis)
        return Outcome(
            kind=ending.kind,
            # the ego first, so that the same pair is always written the same way
            between=tuple(e.name for e in sorted(ending.between, key=lambda e: not e.ego)),
            impact_percent=ending.impact.value if ending.impact is not None else None,
            struck=ending.struck,
        )

    def objects(self) -> tuple[Thing, ...]:
        """The things on and beside the road."""
        found = []
        for item in self.happenings.items:
            self.proofs.add(f"objects.{item.name}.kind", item.basis)
            if item.side_basis is not None:
                self.proofs.add(f"objects.{item.name}.side", item.side_basis)
            if item.blocked_basis is not None:
                self.proofs.add(f"objects.{item.name}.in_way_of", item.blocked_basis)
            for name, amount in item.sizes.items():
                self.proofs.add(f"objects.{item.name}.{name}", amount.basis)
            found.append(
                Thing(
                    id=item.name,
                    kind=item.kind,
                    in_way_of=(item.blocked or self.ego).name if item.blocks else None,
                    hides=tuple(e.name for e in item.hides),
                    side=item.side,
                    called=item.called,
                    **{name: amount.value for name, amount in item.sizes.items()},
                )
            )
        return tuple(found)


_FIELDS = set(Evidence.model_fields)
_NOT_SAID: dict[str, Any] = dict.fromkeys(("text", "start", "end", "reason"))


class Proofs:
    """The evidence of a scenario in the making."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self._text = text
        self._tokens = tokens
        self._slips = [k for k, token in enumerate(tokens) if token.slip]
        self.evidence: list[Evidence] = []

    def span(self, i: int, j: int) -> tuple[int, int]:
        """Characters covered by tokens ``i`` to ``j - 1``."""
        return self._tokens[i].start, self._tokens[j - 1].end

    def add(self, name: str, basis: Basis | None, default: str | None = None) -> None:
        """Adds the evidence of one field: its words or the reason for it.

        ``default``: why it has its value if the text does not say.
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
        self.evidence.append(Evidence.from_valid(told, _FIELDS))

    def _reason(self, basis: Basis) -> str:
        """Why a field has its value, misspelt words among those that it rests on included."""
        first, end = basis.i or 0, basis.j or 0
        slips = [self._tokens[k] for k in self._slips if first <= k < end]
        if not slips:
            return basis.reason or ""
        read = [f"'{t.text}' is read as '{t.low}'" for t in slips]
        return "; ".join([basis.reason, *read] if basis.reason else read)
