"""What blocks a search is what does not hold in the end, and nothing that does."""

from saying import made, person, said

GAP = {"measure": "gap_m", "value": 60}
CUTS = {"id": "cut", "participant": "car", "kind": "change_lane", "side": "right", "into": "ego"}
LEAVES = {"id": "out", "participant": "ego", "kind": "change_lane", "side": "left"}


def proof_of(*people, **fields):
    """So far apart that nothing the text tells makes it a near miss."""
    return made(said("straight", *people, junction={"lanes": [2, 2]}, **fields), free=False).proof


def test_a_danger_that_its_amounts_decide_blocks_nothing():
    proof = proof_of(
        person("ego"),
        person("car", speed=100, approaches=["adjacent", "left"], maneuvers=["lane_change"]),
        acts=[CUTS],
        spacings=[GAP | {"participant": "car", "reference": "ego", "at": "cut"}],
        hazards=[{"kind": "cut_in", "by": ["car"], "to": ["ego"]}],
    )
    assert proof.missed == ()
    assert proof.blocked_by.startswith("reached by none of")


def test_nor_does_one_that_its_speed_decides_and_a_search_without_open_numbers_says_so():
    proof = proof_of(
        person("ego", speed=90, maneuvers=["lane_change"]),
        person("car", speed=54, approaches=["ahead"], maneuvers=["straight"]),
        acts=[
            LEAVES | {"when": GAP | {"type": "measure", "participant": "ego", "reference": "car"}}
        ],
        hazards=[{"kind": "slow_driving", "by": ["car"], "to": ["ego"]}],
    )
    assert proof.missed == ()
    assert proof.blocked_by == "what is said leaves no number open that could change it"
