"""Reader and agents combined: where they differ on a stated fact, both are shown and one kept.

Whoever reads the words of a fact as something else, or rests the fact on other words, keeps its
reading: the agents know better whose a word is. Only of what rests on the same words, or where the
agents pass them over, the reader's value stands: it knows better what a word or a number means.
"""

from scegen.scenario.environment import Environment
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.agents.comparing import compare_hazards, compare_people
from scegen.understanding.agents.deciding import EVERYBODYS, Decider
from scegen.understanding.agents.numbers import compare_numbers
from scegen.understanding.agents.quoting import find_quote
from scegen.understanding.agents.stated import Words, miscounted, words_of
from scegen.understanding.report.parse_report import Disagreement

_SHAPE = (
    "kind",
    "arms",
    "arm_angles_deg",
    "lanes",
    "ring_lanes",
    "crosswalks",
    "carriageway",
    "strips",
    "bend",
)
"""Fields of a junction that only fit together."""
_JUNCTION = (
    "kind",
    "arms",
    "lanes",
    "ring_lanes",
    "speed_limit_mps",
    "lane_width_m",
    "driving_side",
    "control",
    "carriageway",
    "strips",
    "bend",
)
_NUMBERS = frozenset({"arms", "lanes", "ring_lanes", "speed_limit_mps", "lane_width_m"})


def combine(
    agents: FunctionalScenario, reader: FunctionalScenario
) -> tuple[FunctionalScenario, list[Disagreement]]:
    """The combined scenario, valid whatever the two said, and what they do not agree on.

    Args:
        agents: the agents' scenario.
        reader: the offline reader's.
    """
    decider = Decider(agents, reader)
    for name in _JUNCTION:
        _junction(decider, name)
    for name in Environment.model_fields:
        _environment(decider, name)
    if not _counts(decider):
        # participants taken over from the reader agree with it in everything
        compare_people(decider)
        compare_hazards(decider)
        compare_numbers(decider)
    return decider.scenario, decider.disagreements


def _junction(decider: Decider, name: str) -> None:
    path = f"junction.{name}"
    reader, agents = decider.reader.junction, decider.scenario.junction
    words = words_of(decider.reader, path)
    theirs, ours = getattr(reader, name), getattr(agents, name)
    if words is None or theirs == ours:
        return
    number = name in _NUMBERS and bool(words.numbers)
    if name == "arms" and not number:
        return  # it only follows from the kind, which is compared by itself
    names = _SHAPE if name in _SHAPE else (name,)
    update = {n: getattr(reader, n) for n in names}
    if name == "arms" and reader.kind is not agents.kind:
        alone = {"arms": theirs, "arm_angles_deg": (), "lanes": ()}
        update = alone if decider.updated({"junction": alone}) else update
    decider.decide(path, words, theirs, ours, {"junction": update}, number=number)


def _environment(decider: Decider, name: str) -> None:
    path = f"environment.{name}"
    words = words_of(decider.reader, path)
    theirs = getattr(decider.reader.environment, name)
    ours = getattr(decider.scenario.environment, name)
    if words is not None and theirs != ours:
        decider.decide(path, words, theirs, ours, {"environment": {name: theirs}})


def _counts(decider: Decider) -> bool:
    """Fewer of a kind than the text counts: the reader's participants replace the agents'."""
    reader = decider.reader
    objections = miscounted(reader, decider.scenario)
    if not objections:
        return False
    replaced = {name: getattr(reader, name) for name in EVERYBODYS}
    words = find_quote(reader.description, objections[0].words) or Words("", 0, 0)
    theirs, ours = _tally(reader), _tally(decider.scenario)
    decider.decide("participants", words, theirs, ours, replaced, number=True)
    return decider.scenario.participants == reader.participants


def _tally(scenario: FunctionalScenario) -> str:
    kinds = [str(p.kind) for p in scenario.participants]
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
