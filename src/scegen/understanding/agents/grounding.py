"""What every field of the agents' answers rests on: words that the text has, or a reason."""

import re
from collections.abc import Iterable, Iterator

from pydantic import BaseModel

from scegen.scenario.acts import Act
from scegen.scenario.evidence import Evidence, EvidenceSource
from scegen.scenario.functional import Hazard, Participant
from scegen.scenario.outcome import Outcome
from scegen.scenario.things import Thing
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.replies import Basis, Reply

_ALWAYS = frozenset({"junction.kind", "junction.arms", "junction.control", "junction.driving_side"})
"""Junction fields that always get a line, said or not, as the offline reader gives them."""
_WHOLE = {"participants": 2, "objects": 2, "acts": 2, "outcome": 1}
"""How many steps lead to the whole of somebody or something, for which its kind stands."""


def grounds(description: str, replies: Iterable[Reply]) -> tuple[list[Evidence], tuple[str, ...]]:
    """Evidence for every field that is filled, and doubts about quotes that are none."""
    evidence, doubts = [], []
    for reply in replies:
        given: dict[str, Basis] = {}
        for basis in reply.basis:
            given.setdefault(_path(reply, basis.field), basis)
        for path, is_default in dict(_fields(reply)).items():
            item = _grounded(description, path, given.get(path), is_default=is_default)
            evidence.append(item)
            quoted = given[path].words if path in given else None
            if quoted and item.source is not EvidenceSource.STATED:
                doubts.append(f'{path}: the model quoted "{quoted}", which the text does not have')
    return evidence, tuple(doubts)


def _path(reply: Reply, field: str) -> str:
    """A field's path, however the model wrote it.

    Its beginning may be missing, a number stand in brackets, or for an id; hazards are named by
    kind alone.
    """
    steps = re.sub(r"\[(\w+)\]", r".\1", field).split(".")
    parts = reply.parts()
    if steps[0] not in parts:
        homes = (name for name, part in parts.items() if hasattr(part, steps[0]))
        steps = [next(homes, next(iter(parts))), *steps]
    part = parts[steps[0]]
    if isinstance(part, tuple) and len(steps) > 1 and steps[1].isdigit():
        one = part[int(steps[1])] if int(steps[1]) < len(part) else None
        steps[1] = str(getattr(one, "id", getattr(one, "kind", steps[1])))
    if len(steps) == _WHOLE.get(steps[0]):
        steps.append("kind")
    kept = {"hazards": 2, "spacings": 2, "relations": 2}.get(steps[0], len(steps))
    return ".".join(steps[:kept])


def _fields(reply: Reply) -> Iterator[tuple[str, bool]]:
    """Paths of all fields that need a ground, and whether each has its default value."""
    for name, part in reply.parts().items():
        if isinstance(part, Outcome):
            yield from _said(name, part, set())
        elif isinstance(part, BaseModel):
            yield from _filled(name, part)
        else:
            for number, one in enumerate(part or ()):
                yield from _of_one(name, number, one)


def _of_one(name: str, number: int, one: BaseModel) -> Iterator[tuple[str, bool]]:
    """The same of one in a list."""
    if isinstance(one, Participant):
        yield from _of_participant(one)
    elif isinstance(one, Hazard):
        yield f"{name}.{one.kind}", False
    elif isinstance(one, Act | Thing):
        yield from _said(f"{name}.{one.id}", one, {"id", "participant", "called"})
    else:
        yield f"{name}.{number}", False


def _said(place: str, model: BaseModel, whole: set[str]) -> Iterator[tuple[str, bool]]:
    """What is filled beside the fields that need no ground."""
    for path, is_default in _filled(place, model):
        if not is_default and path.rsplit(".", 1)[1] not in whole:
            yield path, False


def _of_participant(participant: Participant) -> Iterator[tuple[str, bool]]:
    place = f"participants.{participant.id}"
    yield f"{place}.kind", participant.kind is Participant.model_fields["kind"].default
    yield f"{place}.role", participant.role is Participant.model_fields["role"].default
    for path, is_default in _filled(place, participant):
        if path not in {f"{place}.kind", f"{place}.role", f"{place}.id"}:
            yield path, is_default


def _filled(place: str, model: BaseModel) -> Iterator[tuple[str, bool]]:
    for name, info in type(model).model_fields.items():
        is_default = not info.is_required() and getattr(model, name) == info.default
        path = f"{place}.{name}"
        if path in _ALWAYS or not is_default:
            yield path, is_default


def _grounded(description: str, path: str, basis: Basis | None, *, is_default: bool) -> Evidence:
    """Stated if the words are really there; otherwise concluded, or a default."""
    quote = find_quote(description, basis.words) if basis else None
    if quote is not None and basis is not None:
        return Evidence(
            field=path,
            source=EvidenceSource.STATED,
            text=quote.text,
            start=quote.start,
            end=quote.end,
            reason=basis.reason or None,
        )
    if basis is not None and basis.words:
        reason = f'the model rests it on words that the text does not have: "{basis.words}"'
    elif basis is not None and basis.reason:
        reason = basis.reason
    elif is_default:
        return Evidence(field=path, source=EvidenceSource.DEFAULT, reason="not said")
    else:
        reason = "concluded by the model, which named no words"
    return Evidence(field=path, source=EvidenceSource.INFERRED, reason=reason)
