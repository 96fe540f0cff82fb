"""A word that the reader does not know costs no fact: it is reported, and all else is read."""

import json
import re
from pathlib import Path

import pytest

from scegen.understanding import read

SAID = Path(__file__).with_name("said.jsonl")
EVERY = 6
"""Of so many sentences one is tried."""
MOST_LOST = 0.01
"""So many of the insertions may change something: what is grammatical is not known to a test."""
_WHO = r"(van|lorry|truck|bus|taxi|cyclist|pedestrian|child|motorcycle|tractor)"
_DOES = r"(drives|brakes|turns|follows|crosses|hits|overtakes|stands|swerves|comes|passes|runs)"
_RATE = r"(\d+ (?:km/h|m/s²|m/s|mph))"
INSERTIONS = [
    (rf"\b([Aa]|[Tt]he|[Oo]ur) {_WHO}\b", r"\1 brindled \2"),
    (rf"\b([Aa]|[Tt]he|[Oo]ur) {_WHO}\b", r"\1 two-tone and mud-spattered \2"),
    (rf"\bat {_RATE}", r"at an unwavering \1"),
    (rf"\bto {_RATE}", r"to a measly \1"),
    (r"\bwith (\d+ m/s²)", r"with a whopping \1"),
    (rf"\b(ego|{_WHO}) {_DOES}\b", r"\1 haughtily \3"),
    (rf"\b(ego|{_WHO}) {_DOES}\b", r"\1, as luck would have it, \3"),
    (rf"\b(ego|{_WHO}) {_DOES}\b", r"\1 (see annex B) \3"),
    (rf"\b(ego|{_WHO}) {_DOES} (at|in|on|behind|from)\b", r"\1 \3 morosely \4"),
    (rf"\b(ego|{_WHO}) {_DOES} (at|in|on|behind|from)\b", r"\1 \3, per protocol, \4"),
    (rf"\b(ego|{_WHO}) {_DOES} (at|in|on|behind|from)\b", r"\1 \3 (cf. table 3) \4"),
    (r"(?<=[a-z])\.(?= |$)", r" (not to scale)."),
    (r"(?<=[a-z]), (?=[a-z])", r" (as agreed), "),
]


def facts(text):
    """What is read, but for the words that it rests on."""
    read_as = read(text).model_dump(mode="json", exclude={"description", "evidence", "unsupported"})
    return json.loads(json.dumps(read_as), object_hook=_without_words)


def _without_words(data):
    return {k: v for k, v in data.items() if k not in {"start", "end", "text", "words"}}


def test_whatever_is_put_between_nothing_is_lost():
    texts = [json.loads(line)["text"] for line in SAID.open(encoding="utf-8")][::EVERY]
    tried, lost = 0, []
    for text in (t for t in texts if "\n" not in t):
        base = facts(text)
        for pattern, instead in INSERTIONS:
            said = re.sub(pattern, instead, text, count=1)
            if said != text:
                tried += 1
                lost += [] if facts(said) == base else [said]
    assert tried > 1000
    assert len(lost) <= MOST_LOST * tried, lost


@pytest.mark.parametrize(
    ("text", "left_out"),
    [
        ("A [brindled ]van brakes.", ["brindled"]),
        ("A van [bloopily ]brakes.", ["bloopily"]),
        ("The ego follows a van at [an unwavering ]60 km/h.", ["unwavering"]),
        ("The ego passes a cyclist with [a scant ]0.8 m of space.", ["scant"]),
        ("The ego passes a cyclist with half a [puce ]metre between them.", ["puce"]),
        ("The ego is first in a [bespoke ]convoy of three trucks.", ["bespoke"]),
        ("The truck ahead moves over and reveals a [tatty ]stopped one.", ["tatty"]),
        ("A [mud-spattered ]van brakes.", ["mud-spattered"]),
        ("[Per protocol, ]a van brakes.", ["protocol"]),
        ("A van[, dingy as ever,] brakes.", ["dingy"]),
        ("A van comes[ (see annex B)] from the left at a crossroads.", ["annex B"]),
        ("The ego[, by the way,] brakes.", []),
        ("[For the record, ]the ego brakes.", []),
        ("A [gaudy, ramshackle ]lorry stops.", ["gaudy", "ramshackle"]),
        ("A coach drives ahead of the ego at [a steady ]50 km/h.", []),
        ("A coach drives ahead of the ego at [an unvarying ]50 km/h.", []),
    ],
)
def test_it_is_reported_and_costs_nothing(text, left_out):
    said, base = text.replace("[", "").replace("]", ""), re.sub(r"\[.*?\]", "", text)
    assert facts(said) == facts(base)
    assert [u.text for u in read(said).unsupported] == left_out


@pytest.mark.parametrize(
    "text",
    [
        "A moose 20 m ahead of the ego.",
        "The ego follows a moose 20 m ahead.",
        "A moose following cars stops.",
        "The moose cut the corner in front of the ego.",
        "A moose parked behind a van.",
        "The ego hits a moose standing on the road.",
    ],
)
def test_an_unknown_noun_is_no_adjective(text):
    assert "moose" in {u.text.split()[-1] for u in read(text).unsupported} or any(
        "moose" in (e.text or "") for e in read(text).evidence
    )


def test_what_is_measured_is_not_guessed():
    scenario = read("The ego drives behind a van. The design speed is 100 km/h.")
    assert all(p.speed_mps is None for p in scenario.participants)
