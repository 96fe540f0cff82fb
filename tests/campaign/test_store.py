"""A file is whole or not there; equal contents are kept once; what was changed is seen."""

import errno
import os

import pyarrow as pa
import pytest

from scegen.campaign.rows import table_of
from scegen.campaign.store import Store, StoreError, sound, write_whole


@pytest.fixture
def full(monkeypatch):
    """A disk without room: what is written never arrives."""

    def refuse(_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", refuse)


def test_on_a_full_disk_nothing_is_left(tmp_path, full):
    with pytest.raises(StoreError, match="No space left") as told:
        write_whole(tmp_path / "sub" / "file", b"content")
    assert "goes on" in told.value.render()
    assert not list((tmp_path / "sub").iterdir())


def test_what_was_there_stays_on_a_full_disk(tmp_path, full):
    (tmp_path / "file").write_bytes(b"old")
    with pytest.raises(StoreError):
        write_whole(tmp_path / "file", b"new")
    assert (tmp_path / "file").read_bytes() == b"old"


def test_equal_contents_are_kept_once(tmp_path):
    store = Store(tmp_path)
    name = store.put(b"road", "xodr")
    assert store.put(b"road", "xodr") == name
    assert list(store.objects()) == [name]
    assert store.get(name) == b"road"
    assert sound(store.object_path(name))
    store.object_path(name).write_bytes(b"raod")
    assert not sound(store.object_path(name))


def test_a_batch_is_named_after_its_content(tmp_path):
    store = Store(tmp_path)
    path = store.write_batch(table_of([{"key": "a", "status": "failed"}]))
    assert store.batches() == [path]
    assert sound(path)
    path.write_bytes(path.read_bytes()[:-1])
    assert not sound(path)


def test_a_plan_is_found_by_its_key(tmp_path):
    store = Store(tmp_path)
    store.write_plan("abc", pa.table({"key": ["1"]}))
    path = store.plans()["abc"]
    assert sound(path)
    path.write_bytes(b"")
    assert not sound(path)


def test_what_was_left_unfinished_is_removed(tmp_path):
    store = Store(tmp_path)
    name = store.put(b"road", "xodr")
    left = store.object_path(name).with_name("x.123.part")
    left.write_bytes(b"ro")
    assert list(store.objects()) == [name]
    store.tidy()
    assert not left.exists()
