"""Whether reading a description again gives the same scenario, and the same judgement."""

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from scegen.scenario.functional import FunctionalScenario, Participant

Facts = Mapping[str, Hashable]


@dataclass(slots=True)
class FieldStability:
    """Of so many descriptions: the same value in all runs, and the same judgement in all runs.

    ``judged`` counts the descriptions whose label has the field.
    """

    cases: int = 0
    identical: int = 0
    judged: int = 0
    equally_judged: int = 0


@dataclass(slots=True)
class Stability:
    """How far the ``runs`` over a description agree: as a ``whole``, and by field."""

    runs: int = 1
    whole: FieldStability = field(default_factory=FieldStability)
    fields: dict[str, FieldStability] = field(default_factory=dict)

    def add(self, readings: Sequence[tuple[Facts, Mapping[str, bool]]]) -> None:
        """Adds a description, if it was read in every run."""
        if self.runs < 2 or len(readings) < self.runs:
            return
        facts, fields = [f for f, _ in readings], [j for _, j in readings]
        _count(self.whole, facts, fields)
        for name in sorted({*(n for f in facts for n in f), *(n for j in fields for n in j)}):
            one = self.fields.setdefault(name, FieldStability())
            judged = [j[name] for j in fields] if all(name in j for j in fields) else []
            _count(one, [f.get(name) for f in facts], judged)

    def to_data(self) -> dict[str, Any] | None:
        """As data that JSON can hold; None where there is one run only."""
        if self.runs < 2:
            return None
        fields = {name: asdict(one) for name, one in sorted(self.fields.items())}
        return {"runs": self.runs, **asdict(self.whole), "fields": fields}


def _count(one: FieldStability, values: Sequence[object], judged: Sequence[object]) -> None:
    one.cases += 1
    one.identical += all(value == values[0] for value in values)
    if judged:
        one.judged += 1
        one.equally_judged += all(value == judged[0] for value in judged)


def facts(scenario: FunctionalScenario | None) -> Facts:
    """What a scenario says, by field, but for names and what it rests on; nothing of None."""
    if scenario is None:
        return {}
    junction = scenario.junction
    who = {p.id: _person(p) for p in scenario.participants}
    who |= {thing.id: (thing.kind.value,) for thing in scenario.objects}
    others = [_person(p) for p in scenario.participants if p is not scenario.ego]
    return {
        "junction": junction.kind,
        "arms": junction.arms,
        "control": junction.control,
        "road": junction.model_dump_json(exclude={"kind", "arms", "control"}),
        "actors": tuple(sorted((p.kind.value, p.parked) for p in scenario.participants)),
        "ego": _person(scenario.ego),
        "others": tuple(sorted(others)),
        "relations": tuple(
            sorted(
                (who[r.participant], who[r.reference], _set(r.approaches))
                for r in scenario.relations
            )
        ),
        "hazards": tuple(
            sorted(
                (
                    h.kind.value,
                    tuple(sorted(who[n] for n in h.by)),
                    tuple(sorted(who[n] for n in h.to)),
                )
                for h in scenario.hazards
            )
        ),
        "environment": scenario.environment.model_dump_json(),
    }


def _person(p: Participant) -> tuple[str, ...]:
    """All but the name, in an order that can be sorted."""
    speed = "" if p.speed_mps is None else f"{p.speed_mps.low:.2f}-{p.speed_mps.high:.2f}"
    entries = ",".join(str(arm) for arm in sorted(p.entries))
    said = (p.kind.value, p.role.value, str(p.parked), _set(p.approaches), _set(p.maneuvers))
    return (*said, entries, speed)


def _set(values: frozenset[Any]) -> str:
    return ",".join(sorted(str(value) for value in values))
