"""What a scenario says of amounts, acts and things, in as few words as can be compared."""

from typing import Any

from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.model import Interval

_KPH = 3.6


def number(value: Interval, factor: float = 1.0) -> Any:
    """One number, or two for a range, rounded."""
    low, high = round(value.low * factor, 2), round(value.high * factor, 2)
    return low if low == high else [low, high]


def compact(scenario: FunctionalScenario) -> dict[str, Any]:
    """Participants, acts, spacings, outcome and things; speeds in km/h, empty fields left out."""
    found: dict[str, Any] = {
        "participants": {p.id: _participant(p) for p in scenario.participants},
        "acts": [_act(a) for a in scenario.acts],
        "spacings": [
            {
                "of": [s.participant, s.reference],
                s.measure.value: number(s.value),
                "at": s.at,
                **({"at_rest": True} if s.since == "end" else {}),
                **({"side": s.side.value} if s.side else {}),
            }
            for s in scenario.spacings
        ],
        "objects": [
            {
                "kind": o.kind.value,
                **({"in_way_of": o.in_way_of} if o.in_way_of else {}),
                **({"hides": list(o.hides)} if o.hides else {}),
                **({"side": o.side.value} if o.side else {}),
            }
            for o in scenario.objects
        ],
    }
    if scenario.outcome is not None:
        found["outcome"] = {
            "kind": scenario.outcome.kind.value,
            "between": list(scenario.outcome.between),
        }
        if scenario.outcome.impact_percent is not None:
            found["outcome"]["impact_percent"] = number(scenario.outcome.impact_percent)
        if scenario.outcome.struck is not None:
            found["outcome"]["struck"] = scenario.outcome.struck.value
    return {key: value for key, value in found.items() if value}


def _participant(p: Any) -> dict[str, Any]:
    values = {
        "approaches": sorted(a.value for a in p.approaches),
        "maneuvers": sorted(m.value for m in p.maneuvers),
        "lanes": sorted(p.lanes),
        "parked": p.parked,
        "circulating": p.circulating,
        "unresponsive": p.unresponsive,
        "kph": number(p.speed_mps, _KPH) if p.speed_mps is not None else None,
    }
    said = {key: value for key, value in values.items() if value is not False}
    return {key: value for key, value in said.items() if value is not None and value != []}


def _act(act: Any) -> dict[str, Any]:
    values: dict[str, Any] = {"who": act.participant, "does": act.kind.value}
    for name, value in act:
        if name in {"id", "participant", "kind", "when"} or value is None:
            continue
        if name == "target_speed_mps":
            values["to_kph"] = number(value, _KPH)
        elif isinstance(value, Interval):
            values[name] = number(value)
        else:
            values[name] = str(getattr(value, "value", value))
    if act.when is not None:
        values["when"] = {
            name: number(v) if isinstance(v, Interval) else str(getattr(v, "value", v))
            for name, v in act.when
            if v is not None
            if not (isinstance(v, Interval) and v.high == 0)
        }
    return values
