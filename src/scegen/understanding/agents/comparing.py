"""Participants and dangers of reader and agents, compared one by one where both mean the same."""

from __future__ import annotations

from collections import Counter
from typing import Any

from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.vocabulary import ParticipantKind, Role
from scegen.understanding.agents.deciding import EVERYBODYS, Decider, close, shown
from scegen.understanding.agents.stated import Words, words_of
from scegen.understanding.report.disagreement import Kept

_SAID = ("kind", "parked", "maneuvers", "approaches")
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
    ours = [p for p in agents.participants if p.id not in found.values()]
    left = [p for p in reader.participants if p.id not in found]
    for p in left:
        alike = [q for q in ours if q.kind is p.kind]
        peers = [q for q in left if q.kind is p.kind]
        if len(alike) == len(peers) == 1:
            found[p.id] = alike[0].id
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
            and _overlap(reader, p.id, agents, q.id, name)
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


def _overlap(
    reader: FunctionalScenario, theirs: str, agents: FunctionalScenario, ours: str, name: str
) -> bool:
    one = words_of(reader, f"participants.{theirs}.{name}")
    other = words_of(agents, f"participants.{ours}.{name}")
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
        else:
            for name in _SAID:
                # positions are seen by the ego: with another ego they are others
                if name != "approaches" or paired.get(reader.ego.id) == decider.scenario.ego.id:
                    _said(decider, theirs, ours, name)
    _speeds(decider, paired)
    _ego(decider, paired.get(reader.ego.id))


def _said(decider: Decider, theirs: Participant, ours: str, name: str) -> None:
    words = words_of(decider.reader, f"participants.{theirs.id}.{name}")
    value, held = getattr(theirs, name), getattr(decider.scenario.participant(ours), name)
    if words is not None and value != held:
        _take(decider, theirs.id, ours, name, words, value, held)


def _take(
    decider: Decider,
    theirs: str,
    ours: str,
    name: str,
    words: Words,
    value: object,
    held: object,
    *,
    number: bool = False,
) -> None:
    participants = tuple(
        p.model_copy(update={name: value}) if p.id == ours else p
        for p in decider.scenario.participants
    )
    decider.decide(
        f"participants.{ours}.{name}",
        words,
        value,
        held,
        {"participants": participants},
        number=number,
        proof=f"participants.{theirs}.{name}",
    )


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


def _speeds(decider: Decider, paired: dict[str, str]) -> None:
    """Speeds in numbers, of those whom the text gives them to."""
    groups: dict[tuple[Words, ParticipantKind], list[Participant]] = {}
    for theirs in decider.reader.participants:
        words = words_of(decider.reader, f"participants.{theirs.id}.speed_mps")
        if words is not None and words.numbers:
            groups.setdefault((words, theirs.kind), []).append(theirs)
    for (words, kind), group in groups.items():
        alike = [p for p in decider.scenario.participants if p.kind is kind]
        peers = [p for p in decider.reader.participants if p.kind is kind]
        known = [(p.id, paired[p.id]) for p in group if p.id in paired]
        if group == peers and len(group) == len(alike):
            # all of a kind are as fast: it does not matter who is who
            known = [(p.id, q.id) for p, q in zip(group, alike, strict=True)]
        for one, ours in known:
            _speed(decider, one, ours, words)
        if not known:
            _somebodys(decider, group[0], alike, words)


def _speed(decider: Decider, theirs: str, ours: str, words: Words) -> None:
    speed = decider.reader.participant(theirs).speed_mps
    held = decider.scenario.participant(ours).speed_mps
    if speed is not None and (held is None or not close(held, speed)):
        _take(decider, theirs, ours, "speed_mps", words, speed, held, number=True)


def _somebodys(
    decider: Decider, theirs: Participant, alike: list[Participant], words: Words
) -> None:
    """A speed of one of several of a kind: shown, unless one of the agents' has it."""
    speed, held = theirs.speed_mps, [p.speed_mps for p in alike if p.speed_mps is not None]
    if speed is None or any(close(one, speed) for one in held):
        return
    said = tuple(dict.fromkeys(shown(one) for one in held))
    reason = "it is not clear whose speed it is"
    path = f"participants.{theirs.id}.speed_mps"
    decider.note(path, words, speed, said, Kept.AGENTS, reason)


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
    """Dangers that the text states: added where the agents are silent on their words."""
    names = pairs(decider.reader, decider.scenario)
    for theirs in decider.reader.hazards:
        path = f"hazards.{theirs.kind}"
        words = words_of(decider.reader, path)
        if words is None:
            continue
        alike = [h for h in decider.scenario.hazards if h.kind is theirs.kind]
        renamed = _renamed(theirs, names)
        if not alike:
            _unnamed(decider, path, words, theirs, renamed)
        elif renamed is not None and len(alike) == 1 and _blames_others(renamed, alike[0]):
            hazards = tuple(renamed if h is alike[0] else h for h in decider.scenario.hazards)
            said = _told(renamed), _told(alike[0])
            decider.decide(path, words, *said, {"hazards": hazards})


def _unnamed(
    decider: Decider, path: str, words: Words, theirs: Hazard, renamed: Hazard | None
) -> None:
    """A danger that the agents do not have: another reading of its words stands, silence not."""
    scenario = decider.scenario
    for other in dict.fromkeys(h.kind for h in scenario.hazards):
        quoted = words_of(scenario, f"hazards.{other}")
        if quoted is not None and quoted.overlaps(words):
            reason = f'the agents read the words "{quoted.text}" as {other}'
            decider.note(path, words, _told(theirs), other, Kept.AGENTS, reason)
            return
    if renamed is None:
        reason = "it is not clear whom of the agents' participants it concerns"
        decider.note(path, words, _told(theirs), None, Kept.AGENTS, reason)
        return
    update = {"hazards": (*scenario.hazards, renamed)}
    decider.decide(path, words, _told(renamed), None, update)


def _renamed(hazard: Hazard, names: dict[str, str]) -> Hazard | None:
    """The reader's danger with the agents' names for its participants; None if one has none."""
    if any(name not in names for name in (*hazard.by, *hazard.to)):
        return None
    by, to = (tuple(names[n] for n in group) for group in (hazard.by, hazard.to))
    return Hazard(kind=hazard.kind, by=by, to=to)


def _blames_others(one: Hazard, other: Hazard) -> bool:
    return bool(one.by and other.by) and not {*one.by} & {*other.by}


def _told(hazard: Hazard) -> str:
    return f"{hazard.kind} by {', '.join(hazard.by)}" if hazard.by else str(hazard.kind)
