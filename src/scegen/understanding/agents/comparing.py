"""Participants and dangers of reader and agents, compared one by one where both mean the same."""

from collections import Counter
from typing import Any

from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Role
from scegen.understanding.agents.deciding import EVERYBODYS, Decider, close, shown
from scegen.understanding.agents.stated import Words, words_of
from scegen.understanding.report.parse_report import Kept

_SAID = ("kind", "parked", "maneuvers", "approaches", "speed_mps")
_NAMING = ("kind", "role", "speed_mps", "maneuvers", "approaches")
"""Fields whose words tell participants apart, the surest first."""


def pairs(reader: FunctionalScenario, agents: FunctionalScenario) -> dict[str, str]:
    """Reader's participant -> the agents' one whom the same words name; only where that is sure.

    Args:
        reader: the offline reader's scenario.
        agents: the agents'.
    """
    found: dict[str, str] = {}
    for name in _NAMING:
        found |= _by_words(reader, agents, name, found)
    for kind in dict.fromkeys(p.kind for p in reader.participants):
        left = [p for p in reader.participants if p.kind is kind and p.id not in found]
        ours = [p for p in agents.participants if p.kind is kind and p.id not in found.values()]
        # of whom the same is said, it does not matter who is who
        said = {p.model_copy(update={"id": "alike", "role": Role.OTHER}) for p in left}
        if len(left) == len(ours) and len(said) == 1:
            in_turn = (
                sorted(people, key=lambda p: p.role is not Role.EGO) for people in (left, ours)
            )
            found |= {p.id: q.id for p, q in zip(*in_turn, strict=True)}
    return found


def _by_words(
    reader: FunctionalScenario, agents: FunctionalScenario, name: str, known: dict[str, str]
) -> dict[str, str]:
    """Pairs of whom the same words say the same thing, and of nobody else."""
    candidates = {
        p.id: [
            q.id
            for q in agents.participants
            if q.id not in known.values()
            and (q.kind is p.kind or name == "kind")
            and _overlap(_naming(reader, p, name), _naming(agents, q, name))
        ]
        for p in reader.participants
        if p.id not in known
    }
    claimed = Counter(one for names in candidates.values() for one in names)
    return {
        one: names[0]
        for one, names in candidates.items()
        if len(names) == 1 and claimed[names[0]] == 1
    }


def _naming(scenario: FunctionalScenario, one: Participant, name: str) -> Words | None:
    return words_of(scenario, f"participants.{one.id}.{name}")


def _overlap(one: Words | None, other: Words | None) -> bool:
    return one is not None and other is not None and one.overlaps(other)


def compare_people(decider: Decider) -> None:
    """Kinds, what they do, where they come from, speeds in numbers, and who is missing."""
    reader = decider.reader
    paired = pairs(reader, decider.scenario)
    missing: set[Words] = set()
    for theirs in reader.participants:
        ours = paired.get(theirs.id)
        if ours is None:
            _missing(decider, theirs, missing)
            _somebodys_speed(decider, theirs, missing)
        else:
            for name in _SAID:
                # positions are seen by the ego: with another ego they are others
                if name != "approaches" or paired.get(reader.ego.id) == decider.scenario.ego.id:
                    _said(decider, theirs, ours, name)
    _ego(decider, paired.get(reader.ego.id))


def _said(decider: Decider, theirs: Participant, ours: str, name: str) -> None:
    proof = f"participants.{theirs.id}.{name}"
    words = words_of(decider.reader, proof)
    value, held = getattr(theirs, name), getattr(decider.scenario.participant(ours), name)
    number = isinstance(value, Interval)
    if words is None or value == held or (number and not words.numbers):
        return
    if isinstance(held, Interval) and close(value, held):
        return
    people = decider.scenario.participants
    changed = (p.model_copy(update={name: value}) if p.id == ours else p for p in people)
    update = {"participants": tuple(changed)}
    path = f"participants.{ours}.{name}"
    decider.decide(path, words, value, held, update, number=number, proof=proof)


def _missing(decider: Decider, theirs: Participant, told: set[Words]) -> None:
    """Somebody whom the text names, and no participant of the agents can be."""
    words = words_of(decider.reader, f"participants.{theirs.id}.kind")
    if words is None or words in told:
        return
    scenario = decider.scenario
    quoted = [words_of(scenario, f"participants.{p.id}.kind") for p in scenario.participants]
    there = sum(p.kind is theirs.kind for p in scenario.participants)
    named = sum(p.kind is theirs.kind for p in decider.reader.participants)
    if there >= named or any(q is not None and q.overlaps(words) for q in quoted):
        return
    told.add(words)
    reason = "nobody of the agents' rests on these words, nor are fewer listed than are counted"
    decider.note("participants", words, f"{named} {theirs.kind}", f"{there}", Kept.AGENTS, reason)


def _somebodys_speed(decider: Decider, theirs: Participant, told: set[Words]) -> None:
    """A speed of one of several of a kind: shown, unless one of the agents' has it."""
    path, speed = f"participants.{theirs.id}.speed_mps", theirs.speed_mps
    words = words_of(decider.reader, path)
    if words is None or speed is None or not words.numbers or words in told:
        return
    alike = (p.speed_mps for p in decider.scenario.participants if p.kind is theirs.kind)
    held = [one for one in alike if one is not None]
    if not any(close(one, speed) for one in held):
        told.add(words)
        said = tuple(dict.fromkeys(shown(one) for one in held))
        decider.note(path, words, speed, said, Kept.AGENTS, "it is not clear whose speed it is")


def _ego(decider: Decider, ours: str | None) -> None:
    """Who the text calls the ego; all positions are seen by it, so all are the reader's then."""
    reader, scenario = decider.reader, decider.scenario
    words = words_of(reader, f"participants.{reader.ego.id}.role")
    if words is None or ours is None or ours == scenario.ego.id:
        return
    replaced: dict[str, Any] = {name: getattr(reader, name) for name in EVERYBODYS}
    decider.decide(
        f"participants.{ours}.role",
        words,
        Role.EGO,
        scenario.participant(ours).role,
        replaced,
        proof=f"participants.{reader.ego.id}.role",
    )


def compare_hazards(decider: Decider) -> None:
    """Dangers that the reader finds stated: shown where the agents name another, or none.

    What is a danger needs more of the text than its own words, and the agents are asked for it.
    """
    names = pairs(decider.reader, decider.scenario)
    for theirs in decider.reader.hazards:
        path = f"hazards.{theirs.kind}"
        words = words_of(decider.reader, path)
        if words is None:
            continue
        alike = [h for h in decider.scenario.hazards if h.kind is theirs.kind]
        renamed = _renamed(theirs, names)
        said = _told(renamed or theirs)
        if not alike:
            other, reason = _read_as(decider, words)
            decider.note(path, words, said, other, Kept.AGENTS, reason)
        elif (
            renamed is not None
            and renamed.by
            and all(h.by and not {*h.by} & {*renamed.by} for h in alike)
        ):
            ours = "; ".join(_told(h) for h in alike)
            reason = "the agents know better whose it is"
            decider.note(path, words, said, ours, Kept.AGENTS, reason)


def _read_as(decider: Decider, words: Words) -> tuple[str | None, str]:
    """The danger that the agents find in words of the text, if any, as a reason to keep it."""
    scenario = decider.scenario
    for other in dict.fromkeys(h.kind for h in scenario.hazards):
        quoted = words_of(scenario, f"hazards.{other}")
        if quoted is not None and quoted.overlaps(words):
            return other, f'the agents read the words "{quoted.text}" as {other}'
    return None, "the agents, asked for every danger, name none here"


def _renamed(hazard: Hazard, names: dict[str, str]) -> Hazard | None:
    """The reader's danger with the agents' names for its participants; None if one has none."""
    if any(name not in names for name in (*hazard.by, *hazard.to)):
        return None
    by, to = (tuple(names[n] for n in group) for group in (hazard.by, hazard.to))
    return Hazard(kind=hazard.kind, by=by, to=to)


def _told(hazard: Hazard) -> str:
    return f"{hazard.kind} by {', '.join(hazard.by)}" if hazard.by else str(hazard.kind)
