"""A concrete.yaml edited by hand is held against the description that it came from, anew."""

import json
from dataclasses import replace

import pytest

from scegen.errors import InputError
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.pipeline.source import Origin, origin_of, resolve_source
from scegen.scenario.files import to_yaml
from scegen.scenario.proof import Proof
from scegen.understanding import read

SENTENCE = "The ego follows a car at 90 km/h. The car brakes with 5 m/s2 to 30 km/h."
QUICK = Options(depth=CheckDepth.NONE)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    out = tmp_path_factory.mktemp("made") / "out"
    assert generate(read(SENTENCE), out, QUICK).ok
    return out


def edited(made, tmp_path, **speeds):
    """The concrete scenario of ``made`` in a copy of its place, with other speeds."""
    (file,) = made.glob("scenarios/*/concrete.yaml")
    concrete = resolve_source(str(file))
    people = tuple(
        p.model_copy(update={"speed_mps": speeds.get(p.id, p.speed_mps)})
        for p in concrete.participants
    )
    place = tmp_path / "scenarios" / file.parent.name / file.name
    place.parent.mkdir(parents=True)
    place.write_text(to_yaml(concrete.model_copy(update={"participants": people})))
    for name in ("functional.yaml", "logical.json"):
        (tmp_path / name).write_bytes((made / name).read_bytes())
    proof = file.with_name("proof.json")
    place.with_name("proof.json").write_bytes(proof.read_bytes())
    return str(place)


def remade(source, out):
    return generate(resolve_source(source), out, QUICK, origin=origin_of(source))


def test_what_was_not_edited_holds_again_and_keeps_its_folder(made, tmp_path):
    result = remade(edited(made, tmp_path / "in"), tmp_path / "out")
    assert result.ok
    for name in ("functional.yaml", "logical.json", "gallery.svg"):
        assert (tmp_path / "out" / name).read_bytes() == (made / name).read_bytes()
    (old,), (new,) = (
        [Proof.model_validate_json(p.read_bytes()) for p in out.glob("scenarios/*/proof.json")]
        for out in (made, tmp_path / "out")
    )
    assert new.target == old.target
    assert [(c.id, c.holds) for c in new.claims] == [(c.id, c.holds) for c in old.claims]
    assert not new.changed


def test_an_edit_that_breaks_a_statement_is_found_out(made, tmp_path):
    result = remade(edited(made, tmp_path / "in", ego=20.0), tmp_path / "out")
    assert not result.ok
    (proof,) = result.proofs.values()
    assert any("ego drives 90 km/h" in claim.statement for claim in proof.missed)
    told = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert told["scenarios"][0]["claims"]["hold"] < told["scenarios"][0]["claims"]["asked"]


def test_who_is_described_must_take_part(made, tmp_path):
    source = edited(made, tmp_path / "in")
    alone = resolve_source(source)
    with pytest.raises(InputError, match="car_1 is described, but does not take part"):
        generate(
            alone.model_copy(update={"participants": (alone.ego,), "hazards": ()}),
            tmp_path / "out",
            replace(QUICK),
            origin=origin_of(source),
        )


def test_numbers_without_a_description_stay_as_they_are(made, tmp_path):
    source = tmp_path / "concrete.yaml"
    (file,) = made.glob("scenarios/*/concrete.yaml")
    source.write_bytes(file.read_bytes())
    assert origin_of(str(source)) == Origin() == origin_of("The ego drives.")
    assert remade(str(source), tmp_path / "out").proofs == {}
    assert not (tmp_path / "out" / "logical.json").exists()
