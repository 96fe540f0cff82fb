"""The project folder: names, what others changed, and what is taken away."""

import zipfile
from io import BytesIO

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")
from scegen.checking.subject import FUNCTIONAL_FILE
from scegen.errors import InputError
from scegen.pipeline.folder import digest
from scegen.web.project import Project, changed_outside, keep, zipped


def test_folders_are_named_after_the_description_and_never_shared(tmp_path):
    project = Project(tmp_path / "project")
    names = [project.new_folder("../../A <b>car</b>; stops\0").name for _ in range(2)]
    assert names == ["a-b-car-b-stops", "a-b-car-b-stops-2"]
    assert project.new_folder("…").name == "scenario"


@pytest.mark.parametrize("name", ["..", "/etc", "../project", "", "a/../../b"])
def test_only_what_is_listed_can_be_opened(tmp_path, name):
    project = Project(tmp_path / "project")
    folder = project.new_folder("a car")
    keep(folder, FUNCTIONAL_FILE, b"description: a car\n")
    assert [entry.name for entry in project.entries()] == ["a-car"]
    with pytest.raises(InputError, match="no such work"):
        project.folder(name)


def test_links_out_of_the_project_are_not_followed(tmp_path):
    project = Project(tmp_path / "project")
    project.new_folder("a car")
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / FUNCTIONAL_FILE).write_text("secret")
    (project.root / "link").symlink_to(outside)
    assert "link" not in {entry.name for entry in project.entries()}


def test_what_others_write_is_noticed(tmp_path):
    keep(tmp_path, FUNCTIONAL_FILE, b"one")
    assert not changed_outside(tmp_path, digest(b"one"))
    (tmp_path / FUNCTIONAL_FILE).write_bytes(b"two")
    assert changed_outside(tmp_path, digest(b"one"))
    keep(tmp_path, FUNCTIONAL_FILE, b"one")
    (tmp_path / "notes.txt").write_text("mine")
    assert changed_outside(tmp_path, digest(b"one"))


def test_the_zip_holds_what_was_made_and_the_same_bytes_each_time(tmp_path):
    folder = tmp_path / "work"
    folder.mkdir()
    (folder / "functional.yaml").write_text("x")
    (folder / "notes.txt").write_text("not made here")
    listed = '{"files": {"functional.yaml": "0", "../secret": "0"}}'
    (folder / "summary.json").write_text(listed)
    (tmp_path / "secret").write_text("no")
    first = zipped(folder, "# read me")
    assert first == zipped(folder, "# read me")
    names = zipfile.ZipFile(BytesIO(first)).namelist()
    assert sorted(names) == ["work/README.md", "work/functional.yaml", "work/summary.json"]
