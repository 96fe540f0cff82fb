"""On which strip beside the lanes the words put somebody, and animals that take part."""

import pytest

from scegen.understanding.reader import read


@pytest.mark.parametrize(
    ("text", "kind", "strip", "parked"),
    [
        ("The ego overtakes a cyclist in the bike lane.", "bicycle", "cycle_lane", False),
        ("A girl jogs along the sidewalk towards the ego.", "pedestrian", "pavement", False),
        ("A man waits at the bus stop as the ego passes.", "pedestrian", "pavement", False),
        ("The ego drives past a bus that stands at a bus stop.", "bus", "bus_stop", True),
        ("A bus at its stop pulls out in front of the ego.", "bus", "bus_stop", True),
        ("A van is parked on the cycle lane; the ego passes it.", "van", "cycle_lane", True),
        ("A lorry broke down on the hard shoulder; the ego passes.", "truck", "hard_shoulder",
         True),
        ("The bus in front pulls up at a stop.", "bus", None, False),
        ("A child steps off the pavement in front of the ego.", "pedestrian", None, False),
    ],
)  # fmt: skip
def test_who_is_on_a_strip(text, kind, strip, parked):
    found = read(text)
    (who,) = [p for p in found.participants if p.kind == kind and p.id != "ego"]
    assert (who.strip, who.parked) == (strip, parked)
    assert strip is None or strip in found.junction.strips
    proved = {e.field for e in found.evidence if e.text is not None}
    assert (f"participants.{who.id}.strip" in proved) == (strip is not None)


def test_what_is_not_built_at_a_junction_is_said():
    found = read("At a crossroads the ego turns right; a cyclist on the cycle lane goes straight.")
    assert not found.junction.strips
    assert any("cycle lane" in u.text for u in found.unsupported)


@pytest.mark.parametrize("where", ["on the pavement", "at the bus stop", "at the edge of the road"])
def test_what_is_not_built_beside_a_ramp_is_said(where):
    text = f"A pedestrian stands {where} while the ego merges from a slip road."
    scenario = read(text)
    assert scenario.junction.auxiliary is not None
    assert not scenario.junction.strips
    assert any(u.text in where and "ramp" in (u.instead or "") for u in scenario.unsupported)


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("A dog sprints across in front of the braking ego.", {"animal": "cross"}),
        ("Two deer run onto the road from the left.", {"large_animal": "cross"}),
        ("A cow stands in the ego's lane.", {"large_animal": "stay"}),
    ],
)
def test_animals_take_part(text, kinds):
    found = read(text)
    animals = [p for p in found.participants if "animal" in p.kind]
    assert {p.kind.value: next(iter(p.maneuvers)).value for p in animals} == kinds
    crossing = {h.kind.value for h in found.hazards if h.kind == "crossing_animal"}
    assert bool(crossing) == ("cross" in kinds.values())


def test_who_is_parked_in_a_bay_stands_there_before_it_pulls_out():
    found = read("A van parked in a parking bay pulls out before the ego.")
    (van,) = [p for p in found.participants if p.role != "ego"]
    assert (van.parked, van.strip, van.maneuvers) == (True, "parking", {"straight"})
