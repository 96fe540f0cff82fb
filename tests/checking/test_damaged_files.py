"""Whatever is done to a file, the check ends with a verdict and no traceback."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lxml import etree

from scegen.checking.opendrive import check_opendrive
from scegen.checking.openscenario import check_openscenario

VALUES = ("", "-1", "0", "7", "1e308", "-3.5", "nan", "x", "start", "junction", "driving", "1e-9")

damages = st.lists(
    st.tuples(
        st.sampled_from(["drop", "set", "unset", "double", "empty"]),
        st.integers(min_value=1, max_value=10_000),
        st.integers(min_value=0, max_value=20),
        st.sampled_from(VALUES),
    ),
    min_size=1,
    max_size=4,
)
settled = settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])


def damaged(content: bytes, steps) -> bytes:
    root = etree.fromstring(content)
    for how, which, attribute, value in steps:
        elements = [e for e in root.iter() if isinstance(e.tag, str)][1:]
        if not elements:
            break
        element = elements[which % len(elements)]
        names = sorted(element.attrib)
        if how == "drop":
            element.getparent().remove(element)
        elif how == "double":
            element.getparent().append(etree.fromstring(etree.tostring(element)))
        elif how == "empty":
            element.clear()
        elif names and how == "set":
            element.set(names[attribute % len(names)], value)
        elif names:
            del element.attrib[names[attribute % len(names)]]
    return etree.tostring(root)


@settled
@given(damages)
def test_damaged_roads(four_way, steps):
    check_opendrive("road.xodr", damaged(four_way, steps))


@settled
@given(damages)
def test_damaged_scenarios(good_folder, steps):
    road = check_opendrive("road.xodr", (good_folder / "road.xodr").read_bytes()).network
    content = damaged((good_folder / "scenario.xosc").read_bytes(), steps)
    check_openscenario("scenario.xosc", content, road_file="road.xodr", network=road)


@settled
@given(st.binary(max_size=200))
def test_bytes_that_are_no_xml(content):
    check_opendrive("road.xodr", content)
    check_openscenario("scenario.xosc", content, road_file=None)
