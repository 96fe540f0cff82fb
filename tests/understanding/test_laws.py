"""Laws that hold for every text."""

from hypothesis import given, settings
from hypothesis import strategies as st

from scegen.errors import ScegenError
from scegen.scenario.evidence import EvidenceSource
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding import passages, read, report_on
from scegen.understanding.words.tokens import tokenize

WORDS = tuple(
    word
    for line in (
        "the a an one another two both other ego car cars vehicle bus truck pedestrian cyclist it",
        "which who and or but while when to from in on of with by not no turns turning left right",
        "straight crosses stops suddenly brakes overtakes merges approaches parked oncoming slow",
        "fast intersection roundabout T road lane exits 5 70 km/h mph forcing trying 's , . ; ( )",
        "behind ahead in front of red light stop sign rain night all directions vehicles 1 2 A B é",
    )
    for word in line.split()
)
SENTENCES = st.lists(st.sampled_from(WORDS), min_size=1, max_size=40).map(" ".join)


def attempt(text: str) -> FunctionalScenario | None:
    try:
        return read(text)
    except ScegenError:
        return None


@given(st.text(max_size=300))
def test_tokens_keep_their_place(text):
    for token in tokenize(text):
        assert text[token.start : token.end] == token.text


@settings(max_examples=300)
@given(st.one_of(SENTENCES, st.text(max_size=200)))
def test_any_text_gives_a_scenario_or_a_clear_error(text):
    scenario = attempt(text)
    if scenario is None:
        return
    for item in scenario.evidence:
        if item.start is not None:
            assert text[item.start : item.end] == item.text
        assert item.source is EvidenceSource.STATED or item.reason
    for left in scenario.unsupported:
        assert text[left.start : left.end] == left.text
    cut = passages(report_on(scenario))
    assert "".join(text[one.start : one.end] for one in cut) == text


@settings(max_examples=100)
@given(SENTENCES)
def test_every_field_has_evidence(text):
    scenario = attempt(text)
    if scenario is None:
        return
    proven = {item.field for item in scenario.evidence}
    assert {"junction.kind", "junction.arms", "junction.control", "junction.lanes"} <= proven
    for p in scenario.participants:
        wanted = {"kind", "role"}
        wanted |= {n for n in ("approaches", "maneuvers", "entries", "parked") if getattr(p, n)}
        assert {f"participants.{p.id}.{name}" for name in wanted} <= proven
    assert {f"hazards.{h.kind}" for h in scenario.hazards} <= proven
    assert {f"relations.{k}" for k in range(len(scenario.relations))} <= proven


@settings(max_examples=50)
@given(SENTENCES)
def test_reading_is_deterministic(text):
    first, second = attempt(text), attempt(text)
    assert first == second


MANEUVERS = {Maneuver.LEFT: Maneuver.RIGHT, Maneuver.RIGHT: Maneuver.LEFT}
APPROACHES = {Approach.LEFT: Approach.RIGHT, Approach.RIGHT: Approach.LEFT}


@given(
    turn=st.sampled_from(["turns left", "makes a left turn", "is turning to the left"]),
    side=st.sampled_from(["from the left", "from the left side", "on the left front"]),
    who=st.sampled_from(["A van", "Another car", "The adversarial truck"]),
)
def test_left_and_right_mirror(turn, side, who):
    text = f"The ego {turn} at an intersection. {who} {side} goes straight."
    here, there = read(text), read(text.replace("left", "right"))
    for p, q in zip(here.participants, there.participants, strict=True):
        assert {MANEUVERS.get(m, m) for m in p.maneuvers} == q.maneuvers
        assert {APPROACHES.get(a, a) for a in p.approaches} == q.approaches
