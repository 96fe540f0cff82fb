"""The output folder is written whole or not at all, and nobody's edits are lost."""

import json
import resource
from pathlib import Path

import pytest

from scegen.errors import InputError
from scegen.pipeline.folder import digest, record, replace_content, require_usable


def make(folder: Path, **files: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        (folder / name).write_text(content)
    return folder


def made_by_us(folder: Path, **files: str) -> Path:
    make(folder, **files)
    hashes = {name: digest(content.encode()) for name, content in files.items()}
    (folder / "summary.json").write_text(json.dumps({"files": hashes}))
    return folder


def test_new_and_empty_folders_are_usable(tmp_path):
    require_usable(tmp_path / "a" / "b", force=False)
    require_usable(make(tmp_path / "empty"), force=False)
    assert not (tmp_path / "a").exists()


def test_our_own_unchanged_output_may_be_replaced(tmp_path):
    require_usable(made_by_us(tmp_path / "out", road="x"), force=False)


def test_an_edited_file_is_named_and_kept(tmp_path):
    out = made_by_us(tmp_path / "out", road="x")
    (out / "road").write_text("edited by hand")
    with pytest.raises(InputError, match="road was changed since it was made"):
        require_usable(out, force=False)
    require_usable(out, force=True)


def test_an_added_file_is_named(tmp_path):
    out = made_by_us(tmp_path / "out", road="x")
    make(out, notes="mine")
    with pytest.raises(InputError, match="notes was not made by scegen"):
        require_usable(out, force=False)


@pytest.mark.parametrize("summary", [None, "not json", "[]", "{}"])
def test_a_foreign_folder_is_refused(tmp_path, summary):
    out = make(tmp_path / "out", thesis="years of work")
    if summary is not None:
        (out / "summary.json").write_text(summary)
    with pytest.raises(InputError, match="was not made by scegen generate"):
        require_usable(out, force=False)


def test_a_file_in_the_way_is_refused(tmp_path):
    (tmp_path / "out").write_text("a file")
    with pytest.raises(InputError, match="is a file"):
        require_usable(tmp_path / "out", force=True)
    with pytest.raises(InputError, match="cannot be written"):
        require_usable(tmp_path / "out" / "deeper", force=True)


def test_a_place_where_nothing_can_be_made_is_refused():
    with pytest.raises(InputError, match="cannot be written"):
        require_usable(Path("/proc/scegen"), force=False)


def test_content_is_replaced_by_name_and_the_rest_stays(tmp_path):
    out = make(tmp_path / "out", report="old", notes="mine")
    make(out / "scenarios", stale="old")
    staged = make(tmp_path / "staged", report="new")
    make(staged / "scenarios", fresh="new")
    replace_content(out, staged)
    assert (out / "report").read_text() == "new"
    assert (out / "notes").read_text() == "mine"
    assert [p.name for p in (out / "scenarios").iterdir()] == ["fresh"]
    assert not [p for p in out.iterdir() if p.name.startswith(".")]


def test_a_failure_half_way_puts_everything_back(tmp_path, monkeypatch):
    out = make(tmp_path / "out", a="old a", b="old b")
    staged = make(tmp_path / "staged", a="new a", b="new b")
    rename = Path.rename

    def fails_at_new_b(self: Path, target: Path) -> Path:
        if self.name == "b" and self.parent.name == "new":
            raise OSError(28, "No space left on device")
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", fails_at_new_b)
    with pytest.raises(InputError, match="No space left"):
        replace_content(out, staged)
    monkeypatch.undo()
    assert (out / "a").read_text() == "old a"
    assert (out / "b").read_text() == "old b"
    assert sorted(p.name for p in out.iterdir()) == ["a", "b"]


def test_a_folder_that_was_not_there_is_removed_after_a_failure(tmp_path, monkeypatch):
    staged = make(tmp_path / "staged", a="new a")

    def fails(self: Path, target: Path) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "rename", fails)
    with pytest.raises(InputError):
        replace_content(tmp_path / "out", staged)
    assert not (tmp_path / "out").exists()


def test_nothing_of_an_earlier_scenario_is_left(tmp_path):
    out = made_by_us(tmp_path / "out", report="old", logical="old")
    (out / "scenarios").mkdir()
    (out / "scenarios" / "road").write_text("old")
    listed = json.loads((out / "summary.json").read_text())
    listed["files"]["scenarios/road"] = digest(b"old")
    listed["files"]["../escape"] = digest(b"")
    (out / "summary.json").write_text(json.dumps(listed))
    make(out, notes="mine")
    (tmp_path / "escape").write_text("not ours")
    replace_content(out, make(tmp_path / "staged", report="new"))
    assert sorted(p.name for p in out.iterdir()) == ["notes", "report", "summary.json"]
    assert (tmp_path / "escape").exists()


def test_a_failure_while_removing_puts_everything_back(tmp_path, monkeypatch):
    out = made_by_us(tmp_path / "out", report="old", stale="old")
    rename = Path.rename

    def fails_at_stale(self: Path, target: Path) -> Path:
        if self.name == "stale":
            raise OSError(28, "No space left on device")
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", fails_at_stale)
    with pytest.raises(InputError, match="No space left"):
        replace_content(out, make(tmp_path / "staged", report="new"))
    monkeypatch.undo()
    assert (out / "report").read_text() == (out / "stale").read_text() == "old"


def test_a_recorded_picture_is_ours_until_somebody_changes_it(tmp_path):
    out = made_by_us(tmp_path / "out", road="x")
    scenario = make(out / "scenarios" / "one", film="picture")
    with pytest.raises(InputError, match="was not made by scegen"):
        require_usable(out, force=False)
    record(scenario / "film")
    require_usable(out, force=False)
    (scenario / "film").write_text("drawn over")
    with pytest.raises(InputError, match="scenarios/one/film was changed"):
        require_usable(out, force=False)
    record(make(tmp_path / "elsewhere", film="picture") / "film")  # nothing to tell
    assert [p.name for p in (tmp_path / "elsewhere").iterdir()] == ["film"]


def test_a_full_disk_is_told_and_leaves_nothing(tmp_path):
    staged = make(tmp_path / "staged", report="longer than there is room for")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (8, before[1]))
    try:
        with pytest.raises(InputError, match=r"cannot be written: .*File too large"):
            replace_content(tmp_path / "out", staged)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert not (tmp_path / "out").exists()
