"""Rows of data: every word of them means something, and the first row that fits holds."""

import re
from importlib.resources import files
from pathlib import Path

import pytest
import yaml

import scegen.understanding
from scegen.scenario.acts import ActKind
from scegen.scenario.outcome import BodySide, OutcomeKind
from scegen.scenario.vocabulary import HazardKind, Maneuver
from scegen.understanding import read
from scegen.understanding.amounts.reading import rows as figures
from scegen.understanding.lexicon import load
from scegen.understanding.semantics.conditions import condition
from scegen.understanding.semantics.patterns import listed
from scegen.understanding.semantics.rows import _row, families

READER = Path(scegen.understanding.__file__).parent
FRAMES = files("scegen.understanding.frames")
KINDS = (
    "acts", "constructions", "dangers", "movements", "nouns", "omissions", "positions", "standing",
)  # fmt: skip


def rows():
    for kind in KINDS:
        data = yaml.safe_load((FRAMES / f"{kind}.yaml").read_text(encoding="utf-8"))
        for names, found in data.items():
            yield from (
                (f"{kind}.{name.strip()}", row) for name in names.split(",") for row in found
            )


def verbs(node):
    for entry in node.entries:
        if entry.cat == "verb":
            yield entry.value
    for following in node.following.values():
        yield from verbs(following)


def test_families_that_rows_lead_to_exist():
    assert {f for _, row in rows() for f in row.get("then", ())} <= families().rows.keys()


def test_every_fact_means_something_and_is_asked_for():
    facts = yaml.safe_load((FRAMES / "facts.yaml").read_text(encoding="utf-8"))
    sources = [p for p in READER.rglob("*") if p.suffix in {".py", ".yaml"}]
    words = re.findall(r"\w+", "".join(path.read_text(encoding="utf-8") for path in sources))
    for name in facts:
        assert condition(name) is not None
        assert words.count(name) > 1, name


def test_every_measure_that_has_a_field_has_rows():
    data = yaml.safe_load((FRAMES / "amounts.yaml").read_text(encoding="utf-8"))
    of_the_road = {"limit", "friction", "sight", "radius"}
    told = {row["role"] for row in data if row["dimension"] != "contact"} - of_the_road - {"other"}
    assert {f"figures.{role}" for role in told} == figures().rows.keys()


def test_every_family_is_reached():
    asked = {f for _, row in rows() for f in row.get("then", ())}
    source = "".join(path.read_text(encoding="utf-8") for path in READER.rglob("*.py"))
    asked |= set(re.findall(r'"((?:[a-z]+)\.[a-z_]+)"', source))
    known = set(verbs(load().root))
    assert not {
        f
        for f in families().rows
        if f not in asked and f.partition(".")[2] not in known | {"tailgate"}
    }


def test_events_that_rows_name_are_in_the_lexicon():
    known = set(verbs(load().root)) | {"unknown", "overtake", "tailgate", "see", "reply"}
    known |= {act.value for act in ActKind}  # "told" is asked of acts
    named = {
        word
        for _, row in rows()
        for text in row.get("if", ())
        if text.startswith("event ") and " or " not in text
        for word in listed(text.removeprefix("event "))
    }
    assert named <= known


@pytest.mark.parametrize(
    ("row", "named"),
    [
        ({"hazzard": "cut_in"}, "hazzard"),
        ({"if": ["purple"]}, "purple"),
        ({"if": ["some drivers+purple"]}, "purple"),
        ({"hazard": "cut_in", "by": "neighbours"}, "neighbours"),
    ],
)
def test_a_word_that_means_nothing_is_refused(row, named):
    with pytest.raises(KeyError, match=f"somewhere.*{named}"):
        _row(row, "somewhere")


@pytest.mark.parametrize("text", ["The car ahead does not move.", "The van ahead did not budge."])
def test_who_does_not_move_stays(text):
    other = next(p for p in read(text).participants if p.id != "ego")
    assert other.maneuvers == {Maneuver.STAY}


def test_a_part_of_one_in_a_part_of_another_is_contact():
    outcome = read("The van buries its front in the ego's left side at a crossroads.").outcome
    assert outcome is not None
    assert outcome.kind is OutcomeKind.COLLISION
    assert outcome.struck is BodySide.LEFT


def test_the_more_specific_row_holds():
    def kinds(text):
        return {h.kind for h in read(text).hazards}

    assert kinds("The car ahead brakes.") == {HazardKind.HARD_BRAKING}
    assert kinds("The car ahead brakes gently.") == set()
    assert kinds("The car ahead brakes too late.") == {HazardKind.DELAYED_BRAKING}


def test_what_numbers_say_is_a_condition_of_dangers():
    def kinds(text):
        return {h.kind for h in read(text).hazards}

    text = "The ego follows a car at 80 km/h with a headway of 2 s. The car decelerates at {} m/s²."
    assert kinds(text.format(7)) == {HazardKind.HARD_BRAKING}
    assert kinds(text.format(2)) == set()
    text = "A van follows the ego at 80 km/h with a headway of {} s."
    assert kinds(text.format(0.5)) == {HazardKind.TAILGATING}
    assert kinds(text.format(1.5)) == set()
    text = "Ego at 130 km/h in the left lane; a van at 110 km/h changes over from the right lane"
    text += " with {} m clearance."
    assert kinds(text.format(20)) == {HazardKind.CUT_IN}
    assert kinds(text.format(80)) == set()
    text = "The ego follows a car at 50 km/h, 20 m behind it. It accelerates at {} m/s² to 80 km/h."
    assert kinds(text.format(4)) == {HazardKind.SUDDEN_ACCELERATION}
    assert kinds(text.format(1)) == set()
