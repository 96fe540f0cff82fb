"""Whoever makes it, in whatever order, whatever happens meanwhile: the same rows, each once."""

import inspect
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections import Counter
from contextlib import suppress
from pathlib import Path

import numpy as np
import psutil
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from campaigns import TEXTS, Notes, campaign, make
from command import PROGRAM, SOURCE, as_process

from scegen.campaign.engines import Engine, WorkerLostError, Workforce
from scegen.campaign.examining import examine
from scegen.campaign.order import Described
from scegen.campaign.rows import OBJECT_COLUMNS, SECONDS
from scegen.campaign.running import batches_of, run_campaign
from scegen.campaign.store import Store, StoreError
from scegen.campaign.verifying import verify
from scegen.errors import InputError


def rows_of(folder):
    """All that is the same whoever made it, in the order of keys."""
    table = pq.read_table(Store(folder).table)
    return table.select([n for n in table.column_names if not n.startswith(SECONDS)])


def whole(folder):
    found, problems = verify(folder)
    return not found.bad and not problems


def test_one_row_for_each_scenario_and_each_failure(first):
    folder, finished = first
    rows = rows_of(folder).to_pylist()
    assert len(rows) == finished.counted.rows
    assert Counter(row["status"] for row in rows)["failed"] == finished.counted.failed == 1
    (failed,) = (row for row in rows if row["status"] == "failed")
    assert failed["description"] == "weather"
    assert failed["stage"] == "understand"
    assert "does not describe" in failed["reason"]
    for row in rows:
        if row["status"] == "made":
            assert set(dict(row["checks"]).values()) == {"passed"}
            assert row["claims"] == row["claims_held"] > 0
            assert {row["road"], row["scenario"]} <= set(Store(folder).objects())
    assert whole(folder)


@pytest.mark.parametrize("engine", list(Engine))
def test_two_workers_of_any_engine_give_the_same_rows(first, tmp_path, engine):
    if engine is Engine.RAY:
        pytest.importorskip("ray")
    notes = Notes()
    finished = make(campaign(), tmp_path / "two", Workforce(engine, 2), notes)
    assert finished.digest == first[1].digest
    assert rows_of(tmp_path / "two").equals(rows_of(first[0]))
    assert set(Store(tmp_path / "two").objects()) == set(Store(first[0]).objects())
    assert not notes.told


@pytest.fixture
def cluster(tmp_path):
    """A Ray cluster of this machine alone, with a token, and its address."""
    pytest.importorskip("ray")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = tmp_path / "token"
    token.write_text("0123456789" * 4)
    own = {"RAY_AUTH_MODE": "token", "RAY_AUTH_TOKEN_PATH": str(token)}
    head = ["--head", f"--port={port}", "--num-cpus=2", "--include-dashboard=false", "--block"]
    log = tmp_path / "ray.log"
    with log.open("w") as said:
        started = subprocess.Popen(
            [Path(sys.executable).with_name("ray"), "start", *head, "--disable-usage-stats"],
            env=os.environ | own,
            stdout=said,
            stderr=said,
            start_new_session=True,
        )
    until(lambda: "Ray runtime started" in log.read_text(), started)
    yield f"127.0.0.1:{port}", own
    os.killpg(started.pid, signal.SIGKILL)
    started.wait()


def test_a_cluster_gives_the_same_rows(first, cluster, tmp_path):
    address, own = cluster
    told = campaign().model_dump_json(by_alias=True)
    (tmp_path / "run.json").write_text(told, encoding="utf-8")
    order = [tmp_path / "run.json", "-o", tmp_path / "c", "--engine", "ray", "--address", address]
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, "campaign", *map(str, order)],
        env={**os.environ, **own, "PYTHONPATH": SOURCE},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1, done.stderr  # one of the descriptions is none
    assert rows_of(tmp_path / "c").equals(rows_of(first[0]))


def test_order_and_company_change_nothing(first, tmp_path):
    lonely = {"lead": TEXTS["lead"], "other": TEXTS["left"]}
    make(campaign(dict(reversed(lonely.items()))), tmp_path / "c")
    before = {row["key"]: row for row in rows_of(first[0]).to_pylist()}
    for row in rows_of(tmp_path / "c").to_pylist():
        known = before[row["key"]]
        for column in row:
            if column not in {"description", "row_digest"}:
                assert row[column] == known[column], column


def test_the_same_description_is_made_once(tmp_path):
    notes = Notes()
    finished = make(
        campaign({"a": TEXTS["lead"], "b": TEXTS["lead"]}, count=1), tmp_path / "c", notes=notes
    )
    assert finished.counted.rows == 1
    assert "b says the same as a" in notes.told[0]


def test_sweeps_and_concretizations_multiply(tmp_path):
    speeds, unknown = {"from": 40, "to": 50, "step": 10}, {"values": [1]}
    order = campaign(
        {"lead": TEXTS["lead"]},
        count=1,
        concretizations=2,
        sweep={"ego.speed_kph": speeds, "brake.nothing_s": unknown},
    )
    finished = make(order, tmp_path / "c")
    assert (finished.counted.rows, finished.counted.failed) == (2, 2)
    order = order.model_copy(update={"sweep": {"ego.speed_kph": order.sweep["ego.speed_kph"]}})
    make(order, tmp_path / "d")
    rows = rows_of(tmp_path / "d").to_pylist()
    points = Counter(dict(row["sweep"])["ego.speed_kph"] for row in rows)
    assert points == {40.0: 2, 50.0: 2}
    for row in rows:
        assert row["ego_speed_mps"] == pytest.approx(
            dict(row["sweep"])["ego.speed_kph"] / 3.6, abs=0.14
        )


def test_nothing_is_made_twice(copied):
    before = copied.batches()
    finished = make(campaign(), copied.folder)
    assert finished.fresh == 0
    assert copied.batches() == before


def test_another_order_does_not_mix_with_the_first(copied):
    with pytest.raises(InputError, match="differs in seed"):
        make(campaign(seed=1), copied.folder)


def test_a_folder_of_something_else_is_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(InputError, match="holds no campaign"):
        make(campaign(), tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["letter.txt"]


def damages():
    def cut(path):
        path.write_bytes(path.read_bytes()[:-7])

    def turn(path):
        content = bytearray(path.read_bytes())
        content[len(content) // 2] ^= 1
        path.write_bytes(content)

    return [cut, turn, Path.unlink]


@pytest.mark.parametrize("damage", damages(), ids=lambda damage: damage.__name__)
@pytest.mark.parametrize("what", ["batch", "object", "plan"])
def test_what_is_broken_is_named_and_made_again(first, copied, damage, what):
    if what == "batch":
        broken = copied.batches()[0]
    elif what == "plan":
        broken = min(copied.plans().values())
    else:
        broken = copied.object_path(min(n for n in copied.objects() if n.endswith("xosc")))
    damage(broken)
    found, problems = verify(copied.folder)
    told = "\n".join([*found.in_words(), *problems])
    assert told
    assert str(broken) in told or not broken.exists()
    notes = Notes()
    finished = make(campaign(), copied.folder, notes=notes)
    assert finished.digest == first[1].digest
    assert broken.exists() or what == "batch"
    assert whole(copied.folder)


def test_a_row_that_was_changed_is_seen(copied):
    """Even where somebody names the file after its new content."""
    path = copied.batches()[0]
    table = pq.read_table(path)
    index = table.schema.get_field_index("claims_held")
    forged = table.set_column(index, "claims_held", pa.array([0] * len(table), pa.int64()))
    path.unlink()
    copied.write_batch(forged)
    found, _ = verify(copied.folder)
    assert any("is not what was made" in line for line in found.in_words())


def test_rows_that_are_there_twice_are_seen(first, copied):
    table = pq.read_table(copied.batches()[0])
    copied.write_batch(table.slice(0, 1))
    found, _ = verify(copied.folder)
    assert any("there already" in line for line in found.in_words())
    assert make(campaign(), copied.folder).digest == first[1].digest
    assert whole(copied.folder)


def test_a_disk_that_fills_loses_only_what_is_under_way(first, tmp_path, monkeypatch):
    written = []
    write = Store.write_batch

    def refuse(store, table):
        if written:
            raise StoreError("cannot be written: No space left on device")
        written.append(write(store, table))

    order = campaign()
    monkeypatch.setattr(Store, "write_batch", refuse)
    with pytest.raises(StoreError, match="No space"):
        make(order, tmp_path / "c")
    monkeypatch.setattr(Store, "write_batch", write)
    kept = pq.read_table(written[0]).num_rows
    finished = make(order, tmp_path / "c")
    assert finished.fresh == finished.counted.rows - kept
    assert finished.digest == first[1].digest


@pytest.fixture
def disk(tmp_path):
    """A disk in memory, and what makes it of another size, in bytes."""
    place = tmp_path / "disk"
    place.mkdir()

    def sized(size, *options):
        told = ",".join([*options, f"size={size}"])
        return subprocess.run(
            ["mount", "-t", "tmpfs", "-o", told, "tmpfs", place], capture_output=True, check=False
        )

    if shutil.which("mount") is None or sized(2**16).returncode:
        pytest.skip("nothing can be mounted here")
    yield place, lambda size: sized(size, "remount").check_returncode()
    subprocess.run(["umount", place], check=True)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_on_a_disk_that_is_really_full_nothing_is_lost(first, disk, share):
    place, resize = disk
    resize(int(share * sum(f.stat().st_blocks for f in first[0].rglob("*") if f.is_file()) * 512))
    with pytest.raises(StoreError, match="No space"):
        make(campaign(), place / "c")
    resize(2**28)
    assert make(campaign(), place / "c").digest == first[1].digest
    assert whole(place / "c")


def test_batches_hold_every_item_once():
    class Work:
        def __init__(self, number, cost_s):
            self.number, self.cost_s, self.plan = number, cost_s, Path(f"p{number % 3}")

    rng = np.random.default_rng(4)
    works = [Work(n, rng.uniform(0.01, 3.0)) for n in range(200)]
    batches = batches_of(works, 16, 2)
    made = [(path, n) for batch in batches for path, numbers in batch for n in numbers]
    assert sorted(made) == sorted((work.plan, work.number) for work in works)
    assert max(sum(len(numbers) for _, numbers in batch) for batch in batches) <= 16


def die(_):
    os.kill(os.getpid(), signal.SIGKILL)


def nothing(*_):
    pass


def test_a_worker_that_dies_is_told():
    with pytest.raises(WorkerLostError):
        list(Workforce(Engine.JOBLIB, 2).each(die, [1, 2], nothing, nothing))


def until(holds, process):
    """Wait for something; the process may end before."""
    while not holds() and process.poll() is None:
        time.sleep(0.02)


def batch_count(folder):
    return len(list(folder.glob("batches/*.parquet")))


def test_kill_9_at_any_moment_loses_nothing(started, order_file, tmp_path):
    folder = tmp_path / "killed"
    rng = np.random.default_rng(11)
    for wanted in (1, 2):
        process = started(order_file, "-o", folder, "--workers", "1")
        until(lambda: batch_count(folder) >= wanted, process)  # noqa: B023 - at once
        time.sleep(rng.uniform(0.0, 0.3))
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    last = started(order_file, "-o", folder, "--workers", "1")
    out, err = last.communicate()
    assert "Traceback" not in err
    assert last.returncode == 1, err  # one of the descriptions is none
    assert re.fullmatch(r"\d+ scenarios, 1 of them failed\n", out)
    assert whole(folder)
    keys = rows_of(folder).column("key").to_pylist()
    assert len(keys) == len(set(keys)) == int(out.split()[0])


def workers_of(pid):
    """The worker processes of a process, by their name."""
    workers = set()
    for child in psutil.Process(pid).children():
        with suppress(psutil.NoSuchProcess):  # it ended meanwhile
            if any("LokyProcess" in word for word in child.cmdline()):
                workers.add(child.pid)
    return workers


def goes_on(process, order_file, folder, started):
    """An interrupted campaign ends with what is finished, and the same command does the rest."""
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate()
    assert "Traceback" not in err
    if process.returncode == 130:  # unless all was made before
        assert "the same command goes on" in err
        assert not out
    assert not psutil.pid_exists(process.pid)
    found = examine(Store(folder), list(Store(folder).plans()))
    assert not found.bad
    last = started(order_file, "-o", folder, "--workers", "1")
    last.communicate()
    assert last.returncode == 1
    assert whole(folder)
    return err


@pytest.mark.parametrize("noticed", [True, False])
def test_a_dying_worker_and_ctrl_c_lose_nothing(started, order_file, tmp_path, noticed):
    folder = tmp_path / "c"
    process = started(order_file, "-o", folder, "--workers", "2")
    until(lambda: batch_count(folder) >= 1, process)
    before = workers_of(process.pid)
    os.kill(min(before), signal.SIGKILL)  # others come once that has been noticed
    if noticed:
        until(lambda: workers_of(process.pid) and not workers_of(process.pid) & before, process)
        known = batch_count(folder)
        until(lambda: batch_count(folder) > known + 1, process)
    err = goes_on(process, order_file, folder, started)
    assert not noticed or "a worker died" in err


def test_ctrl_c_while_workers_begin_is_silent(started, order_file, tmp_path):
    process = started(order_file, "-o", tmp_path / "c", "--workers", "2")
    until(lambda: workers_of(process.pid), process)
    goes_on(process, order_file, tmp_path / "c", started)


INTERRUPTED = f"""
import os, psutil, signal, threading, time
from contextlib import suppress
from scegen.campaign.engines import Engine, Workforce

{inspect.getsource(workers_of)}

class Interrupting(list):
    def __iter__(self):
        for n, task in enumerate(super().__iter__()):
            yield task
            if n == len(self) // 2:
                os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job ignores it
heard = []
threading.excepthook = heard.append
for _ in range(20):
    try:
        list(Workforce(Engine.JOBLIB, 2).each(time.sleep, Interrupting([0.5] * 4), int, abs))
    except KeyboardInterrupt:
        if workers_of(os.getpid()):
            raise SystemExit("somebody is still at work")
    else:
        raise SystemExit("it went on")
raise SystemExit(str(heard) if heard else 0)
"""


def test_ctrl_c_while_tasks_are_handed_out_is_silent(tmp_path):
    """Loky's own thread loses a race then, one time in four."""
    done = as_process([], tmp_path, os.environ, INTERRUPTED)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("step", ["planning", "making"])
def test_nobody_works_on_after_ctrl_c_between_two_results(tmp_path, monkeypatch, step):
    """Even where somebody still holds what was raised."""

    def interrupted(_, done, *rest):
        if done > 0:
            raise KeyboardInterrupt

    monkeypatch.setattr(Notes, step, interrupted)
    with pytest.raises(KeyboardInterrupt) as raised:
        make(campaign(), tmp_path / "c", Workforce(Engine.JOBLIB, 2))
    assert not workers_of(os.getpid())
    assert raised.value


def test_every_object_is_named_by_a_row_or_a_plan(first):
    folder = first[0]
    rows = rows_of(folder)
    named = {n for c in OBJECT_COLUMNS for n in rows.column(c).to_pylist() if n}
    assert named == set(Store(folder).objects())


def test_a_description_from_a_file_that_is_not_there_is_told(tmp_path):
    order = campaign().model_copy(
        update={"descriptions": (Described(id="x", file=str(tmp_path / "no.yaml")),)}
    )
    with pytest.raises(InputError, match="cannot be read"):
        run_campaign(order, tmp_path / "c", Workforce(), Notes())
