"""Things in files: where they should be, as large as they should be, and the same in esmini."""

from __future__ import annotations

import shutil

import pytest
from lxml import etree

from scegen.checking import REPLAY, CheckStatus, check_folder
from scegen.checking.environment import esmini
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.files import to_yaml
from scegen.understanding import read

needs_esmini = pytest.mark.skipif(esmini() is None, reason="esmini is not on PATH")
OBSTACLE = "A pallet lies in the ego's lane on a straight road."
HIDES = "A child runs out from behind a kiosk in front of the ego on a straight road."


def write(folder, concrete):
    network = build_network(concrete.road, concrete.name)
    folder.mkdir(exist_ok=True)
    (folder / "road.xodr").write_text(write_opendrive(network))
    paths = build_paths(concrete, network)
    (folder / "scenario.xosc").write_bytes(write_openscenario(concrete, paths))
    (folder / "concrete.yaml").write_text(to_yaml(concrete))
    return folder


def concrete_of(text):
    functional = read(text)
    return concretize(functional, enumerate_scenarios(functional).scenarios[0])


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    return write(tmp_path_factory.mktemp("things") / "s", concrete_of(OBSTACLE))


@pytest.fixture
def folder(good, tmp_path):
    return shutil.copytree(good, tmp_path / "s")


def check(folder):
    return check_folder(folder, ["openscenario", "schema"])


@pytest.mark.parametrize("text", [OBSTACLE, HIDES])
def test_good_files_are_clean(tmp_path, text):
    report = check(write(tmp_path / "s", concrete_of(text)))
    assert report.ok, report.results


def retyped(misc, _):
    misc.set("miscObjectCategory", "tree")


def resized(misc, _):
    misc.find("BoundingBox/Dimensions").set("width", "1.5")


def moved(_, place):
    place.set("x", str(float(place.get("x")) + 0.2))


def turned(_, place):
    place.set("h", str(float(place.get("h")) + 0.3))


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        (retyped, "xosc.object"),
        (resized, "xosc.size"),
        (moved, "xosc.object"),
        (turned, "xosc.object"),
    ],
)
def test_a_thing_that_is_not_as_said_is_noticed(folder, change, rule):
    root = etree.parse(folder / "scenario.xosc").getroot()
    misc = root.find(".//MiscObject")
    name = misc.getparent().get("name")
    change(misc, root.find(f".//Private[@entityRef='{name}']//WorldPosition"))
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    errors = check(folder).result("openscenario").errors
    assert {(e.rule, e.place) for e in errors} == {(rule, name)}


def test_a_thing_that_is_missing_is_noticed(folder):
    root = etree.parse(folder / "scenario.xosc").getroot()
    element = root.find(".//MiscObject").getparent()
    name = element.get("name")
    for gone in (element, root.find(f".//Private[@entityRef='{name}']")):
        gone.getparent().remove(gone)
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    assert "xosc.participants" in {e.rule for e in check(folder).result("openscenario").errors}


def test_an_obstacle_beside_the_road_and_a_screen_on_it_are_noticed(tmp_path):
    obstacle, hides = concrete_of(OBSTACLE), concrete_of(HIDES)
    for concrete, y_m in ((obstacle, 9.0), (hides, 1.75)):
        (thing,) = concrete.objects
        elsewhere = thing.model_copy(update={"x_m": 20.0, "y_m": y_m})
        folder = write(tmp_path / "s", concrete.model_copy(update={"objects": (elsewhere,)}))
        errors = check(folder).result("openscenario").errors
        assert {(e.rule, e.place) for e in errors} == {("xosc.object", thing.id)}


@pytest.mark.esmini
@needs_esmini
@pytest.mark.parametrize("text", [OBSTACLE, HIDES])
def test_esmini_plays_it_without_a_word_and_agrees(tmp_path, text):
    report = check_folder(write(tmp_path / "s", concrete_of(text)), ["esmini", REPLAY])
    for result in report.results:
        # That nobody touches anybody is the search's business, not concretization's.
        said = [f for f in result.findings if f.rule != "esmini.contact"]
        assert (result.status, said) == (CheckStatus.PASSED, []), result


@pytest.mark.esmini
@needs_esmini
def test_a_contact_with_it_is_one_in_esmini_too(tmp_path):
    concrete = concrete_of(OBSTACLE)
    on = concrete.ego.model_copy(update={"speed_program": ()})
    folder = write(tmp_path / "s", concrete.model_copy(update={"participants": (on,)}))
    result = check_folder(folder, [REPLAY]).result(REPLAY)
    assert result.status is CheckStatus.PASSED, result.findings
    assert "1 contacts" in result.detail


@pytest.mark.esmini
@needs_esmini
def test_a_thing_elsewhere_than_predicted_is_noticed(folder):
    root = etree.parse(folder / "scenario.xosc").getroot()
    name = root.find(".//MiscObject").getparent().get("name")
    moved(None, root.find(f".//Private[@entityRef='{name}']//WorldPosition"))
    (folder / "scenario.xosc").write_bytes(etree.tostring(root))
    report = check_folder(folder, ["esmini", REPLAY])
    assert {e.rule for r in report.results for e in r.errors} == {
        "esmini.standing",
        "replay.position",
    }
