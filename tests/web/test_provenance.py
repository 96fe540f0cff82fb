"""Names are changed where they are names, and nowhere else."""

from scegen.scenario.files import from_data
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding import read
from scegen.web.provenance import renamed

TEXT = (
    "The ego follows car_1 at 20 m. The car brakes with 5 m/s2. A child runs out from behind a "
    "parked van. The ego collides with the child."
)


def test_a_name_changes_wherever_it_names_and_back():
    before = read(TEXT)
    for name in (p.id for p in before.participants):
        data = renamed(before, name, "somebody")
        after = from_data(FunctionalScenario, data, where="form")
        assert [p.id for p in after.participants].count("somebody") == 1
        assert from_data(FunctionalScenario, renamed(after, "somebody", name), where="") == before
        named = after.model_dump_json(exclude={"evidence", "description"})
        assert name == "ego" or f'"{name}"' not in named
        assert not [item.field for item in after.evidence if f".{name}." in item.field]


def test_a_role_of_the_same_word_is_no_name():
    after = from_data(FunctionalScenario, renamed(read(TEXT), "ego", "me"), where="form")
    assert after.ego.id == "me"
    assert not [item.field for item in after.evidence if ".ego." in item.field]
