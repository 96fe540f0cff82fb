"""A law: whatever way a number is told, it lands in the field of its meaning or is reported.

The grid crosses ways to tell of a number with whose it is and the situation; the right field is
known by construction.
"""

from itertools import count, product
from pathlib import Path

import pytest
import yaml

from scegen.scenario.model import Interval
from scegen.understanding import read

GRID = yaml.safe_load((Path(__file__).parent / "number_grid.yaml").read_text("utf-8"))
REACHED = 0.98
KINDS = ("van", "truck", "car", "motorcycle", "bus")
WALKERS = ("pedestrian", "child", "cyclist")
FIELDS = {
    "speed": {"speed_mps"},
    "target_speed": {"target_speed_mps"},
    "deceleration": {"rate_mps2"},
    "acceleration": {"rate_mps2"},
    "lateral_offset": {"lateral_offset_m"},
    "impact_point": {"impact_percent"},
    "duration": {"duration_s"},
    "delay": {"delay_s"},
    "trigger_distance": {"distance_m", "gap_m"},
    "distance_driven": {"distance_m"},
    "speed_limit": {"speed_limit_mps"},
    "visibility": {"visual_range_m"},
    "radius": {"radius_m"},
    "friction": {"friction"},
    "gap": {"gap_m"},
    "trigger_gap": {"gap_m"},
    "headway": {"headway_s"},
    "trigger_headway": {"headway_s"},
    "ttc": {"ttc_s"},
    "trigger_ttc": {"ttc_s"},
    "lateral_gap": {"lateral_gap_m"},
    "overlap": {"overlap_percent"},
}


def _upper(words):
    return words[:1].upper() + words[1:]


def _cells():
    turn = count()
    for cell in GRID["cells"]:
        for form in cell["forms"]:
            k = next(turn)
            told = GRID["situations"][cell["situations"][k % len(cell["situations"])]]
            opening = told[k % len(told)]
            kind, walker = KINDS[k % len(KINDS)], WALKERS[k % len(WALKERS)]
            other = "the " + (walker if "{walker}" in opening else kind)
            x, y = (other, "the ego") if cell["who"] == "other" else ("the ego", other)
            written, value = cell["values"][k % len(cell["values"])]
            said = form.format(X=_upper(x), x=x, Y=_upper(y), y=y, V=_upper(written), v=written)
            text = f"{opening.format(o=kind, walker=walker)} {said}"
            low, high = value if isinstance(value, list) else (value, value)
            yield cell, text, written, low, high


def _values(part, who, name=""):
    """Every number with the name of its field, or of its measure, and whose it is."""
    if isinstance(part, Interval):
        yield name, part.low, part.high, who
    elif isinstance(part, int | float) and not isinstance(part, bool | str):
        yield name, part, part, who
    elif isinstance(part, tuple):
        for each in part:
            yield from _values(each, who, name)
    elif hasattr(part, "model_fields_set"):
        measure = getattr(part, "measure", None)
        who = getattr(part, "participant", None) or getattr(part, "id", None) or who
        for field, value in part:
            if field not in {"evidence", "unsupported"}:
                yield from _values(value, who, measure if measure and field == "value" else field)


def _is(low, high, found, meaning):
    """Whether a value is the one that was said; about it, or the middle of its range."""
    ends = sorted((abs(found[1]), abs(found[2])))
    near = 0.06 * high + 0.011
    exact = abs(ends[0] - low) <= near and abs(ends[1] - high) <= near
    about = ends[0] - near <= low <= high <= ends[1] + near and ends[1] - ends[0] <= 0.25 * high
    middle = meaning in {"visibility", "radius", "friction"}
    middle = middle and abs(ends[0] - (low + high) / 2) <= near
    return exact or about or middle or (meaning == "impact_point" and abs(100 - ends[1] - low) < 1)


def _lands(cell, text, written, low, high):
    """``field``, ``reported``, or what went wrong."""
    scenario = read(text)
    egos = {p.id for p in scenario.participants if p.role == "ego"}
    found = [f for f in _values(scenario, None) if str(f[0]) in FIELDS[cell["meaning"]]]
    held = [f for f in found if _is(low, high, f, cell["meaning"])]
    whose = {f[3] in egos for f in held}
    wanted = {"ego": {True}, "other": {False}, "both": {True, False}}.get(cell["who"])
    if held and (wanted is None or wanted <= whose):
        return "field"
    left_out = [u.text for u in scenario.unsupported if any(c.isdigit() for c in u.text)]
    reported = any(each in written or written in each for each in left_out)
    if not held and reported:
        return "reported"
    return f"whose: {held}" if held else "read as something else, or lost"


def _several():
    for cell in GRID["several"]:
        told, forms = cell["told"], cell["forms"]
        for k, form in enumerate(forms):
            other, third = KINDS[k % len(KINDS)], KINDS[(k + 1) % len(KINDS)]
            named = {"o": other, "p": third, "O": _upper(other), "P": _upper(third)}
            opening = told[k % len(told)]
            yield f"{opening} {form}".strip().format(**named), cell["is"], other, third


def _strays(text, wanted, other, third):
    """What of several numbers is not where it belongs, and what is where none does."""
    scenario = read(text)
    names = {"ego": "ego", "other": other, "third": third}
    names |= {f"{one} {two}": {names[one], names[two]} for one in names for two in names}
    kind = {p.id: "ego" if p.role == "ego" else p.kind.value for p in scenario.participants}
    apart = scenario.spacings
    pairs = {(s.participant, s.value.low): {kind[s.participant], kind[s.reference]} for s in apart}
    fields = {field: meaning for meaning, named in FIELDS.items() for field in named}
    found = [f for f in _values(scenario, None) if f[0] in fields and f[2]]
    lost, used = [], []
    for meaning, whose in wanted.items():
        for who, value in whose.items():
            low, high = value if isinstance(value, list) else (value, value)
            held = [f for f in found if f[0] in FIELDS[meaning] and _is(low, high, f, meaning)]
            held = [f for f in held if names[who] in (kind.get(f[3]), pairs.get((f[3], f[1])))]
            used += held
            lost += [] if held else [(meaning, who, value)]
    return lost, [f for f in found if f not in used]


def _numbers(text):
    """What is told of those who take part, by field."""
    fields = {field for named in FIELDS.values() for field in named}
    own = fields - {"visual_range_m", "radius_m", "friction", "speed_limit_mps"}
    return sorted(f[:3] for f in _values(read(text), None) if f[0] in own)


@pytest.fixture(scope="module")
def landed():
    return [(_lands(*cell), cell[1]) for cell in _cells()]


def test_every_number_is_in_its_field_or_reported(landed):
    assert [one for one in landed if one[0] not in {"field", "reported"}] == []


def test_of_several_numbers_each_is_in_its_field_and_nowhere_else():
    strays = {text: _strays(text, *rest) for text, *rest in _several()}
    assert {text: found for text, found in strays.items() if found != ([], [])} == {}


def test_what_is_said_of_something_else_is_nobodys():
    other = GRID["elsewhere"]
    texts = {t: [f"{t} {form}" for form in other["sentences"]] for t in other["told"]}
    for told, phrase in product(other["in"], other["phrases"]):
        texts.setdefault(told.format(""), []).append(told.format(f" {phrase}"))
    base = {told: _numbers(told) for told in texts}
    strays = [t for told, every in texts.items() for t in every if _numbers(t) != base[told]]
    assert strays == []


def test_nearly_every_number_is_in_its_field(landed):
    assert sum(where == "field" for where, _ in landed) >= REACHED * len(landed)
