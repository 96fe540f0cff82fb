"""What is made is kept whole, and workers do not outlive who employs them."""

import os
import signal
import subprocess
import sys
import time

import psutil
import pyarrow.parquet as pq
from campaigns import campaign, make
from command import SOURCE

from scegen.campaign.report.scenario import files_of
from scegen.campaign.store import Store
from scegen.pipeline.export import LAMPS_FILE, SCENARIO_FILE

EMPLOYER = """
import os, time
from scegen.campaign.engines import Engine, Workforce
from scegen.campaign.making import enlist, warm

for worker in Workforce(Engine.JOBLIB, 2).each(lambda _: os.getpid(), range(4), warm, enlist):
    print(worker, flush=True)
print("idle", flush=True)
time.sleep(600)
"""
PATIENCE_S = 60.0


def test_workers_that_wait_for_work_end_with_their_employer(tmp_path):
    employer = subprocess.Popen(
        [sys.executable, "-c", EMPLOYER],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": SOURCE},
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        told = [line.strip() for line in iter(employer.stdout.readline, "idle\n")]
        workers = {int(worker) for worker in told}
        assert len(told) == 4
        assert all(lives(worker) for worker in workers)
        employer.kill()
        employer.wait()
        until_s = time.monotonic() + PATIENCE_S
        while any(lives(worker) for worker in workers):
            assert time.monotonic() < until_s, "a worker is left behind"
            time.sleep(0.1)
    finally:
        if employer.poll() is None:
            os.killpg(employer.pid, signal.SIGKILL)
            employer.wait()
        employer.stdout.close()


def test_a_worker_whose_employer_was_gone_before_it_began_ends_too(tmp_path):
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    late = f"import time; from scegen.campaign.making import enlist; enlist({gone.pid})"
    done = subprocess.run(
        [sys.executable, "-c", f"{late}; time.sleep({PATIENCE_S})"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": SOURCE},
        timeout=PATIENCE_S,
        check=False,
    )
    assert done.returncode == 1


def lives(pid):
    """Whether a process runs; one that nobody has taken note of is none."""
    try:
        return psutil.Process(pid).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def test_a_scenario_with_lights_keeps_the_file_with_the_lamps_too(tmp_path):
    text = (
        "At a four-way intersection with traffic lights a truck from the left runs the red light "
        "while the ego goes straight on."
    )
    make(campaign({"red": text}, count=1, concretizations=1), tmp_path / "made")
    store = Store(tmp_path / "made")
    (row,) = pq.read_table(store.table).to_pylist()
    assert (row["status"], row["reason"]) == ("made", None)
    assert {SCENARIO_FILE, LAMPS_FILE} <= set(files_of(store, row))
