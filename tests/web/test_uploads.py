"""Files from a browser: what is taken, and what is refused with which words."""

import io
import zipfile

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")
from scegen.errors import InputError
from scegen.scenario.files import to_yaml
from scegen.understanding import read
from scegen.web.uploads import LARGEST_FILE, read_upload

FUNCTIONAL = read("The ego turns left at a four-way intersection.")
YAML = to_yaml(FUNCTIONAL).encode()


def zipped(**files):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name.replace("__", "/").replace("_dot_", "."), data)
    return content.getvalue()


def test_every_level_and_a_text_are_taken():
    assert read_upload("functional.yaml", YAML) == FUNCTIONAL
    assert read_upload("a.txt", b"A car stops.") == "A car stops."
    assert read_upload("work.zip", zipped(work__functional_dot_yaml=YAML)) == FUNCTIONAL


BOMB = "\n".join(
    ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    + [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 12)]
)


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("big.yaml", b"x" * (LARGEST_FILE + 1), "larger than"),
        ("bomb.yaml", BOMB.encode(), "aliases repeat"),
        ("deep.yaml", b"[" * 5000, "nested too deeply"),
        ("run.yaml", b"!!python/object/apply:os.system [echo]", "not valid YAML"),
        ("picture.png", b"\x89PNG", "neither a scenario file nor a text"),
        ("binary.txt", b"\xff\xfe\x00", "UTF-8"),
        ("broken.zip", b"PK\x03\x04nothing", "no zip file"),
        ("empty.zip", zipped(readme="x"), "holds none of"),
        ("bomb.zip", zipped(functional_dot_yaml=b"0" * 50_000_000), "unpacks to more than"),
    ],
)
def test_what_cannot_be_used_is_refused_with_a_reason(name, content, said):
    with pytest.raises(InputError, match=said) as refused:
        read_upload(name, content)
    assert name in refused.value.render()


def test_names_lead_nowhere():
    found = read_upload("../../etc/functional.yaml", YAML)
    assert found == FUNCTIONAL
    with pytest.raises(InputError) as refused:
        read_upload("../../../etc/passwd", b"x")
    assert "etc" not in refused.value.render()
    inner = zipped(**{"..__..__functional_dot_yaml": YAML})
    assert read_upload("slip.zip", inner) == FUNCTIONAL
