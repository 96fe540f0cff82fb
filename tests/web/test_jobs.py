"""Long work: it tells how far it is, says why it failed, and ends when it is cancelled."""

import subprocess
import sys
import time
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")
from scegen.understanding import read
from scegen.web import tasks
from scegen.web.jobs import MOST_MEMORY, Jobs, JobState

WAIT_S = 120


@pytest.fixture(scope="module")
def jobs():
    running = Jobs(at_once=2)
    yield running
    running.close()


def ended(job):
    """The job, once it has ended."""
    begin = time.monotonic()
    while job.under_way and time.monotonic() - begin < WAIT_S:
        time.sleep(0.02)
    return job


def nothing(_):
    pass


def test_a_result_comes_back_with_the_steps_to_it(jobs):
    told = []
    job = ended(jobs.start("reading", told.append, tasks.take_in, "a.txt", b"A car stops."))
    assert (job.state, job.result) == (JobState.DONE, "A car stops.")
    assert [step.text for step in job.steps] == ["reading a.txt"]
    assert told
    assert job.seconds == job.seconds  # the clock has stopped


def test_an_error_is_told_in_words(jobs):
    job = ended(jobs.start("reading", nothing, tasks.take_in, "a.png", b"x"))
    assert job.state is JobState.FAILED
    assert "neither a scenario file nor a text" in job.trouble.message
    assert job.trouble.where == "a.png"


def test_what_should_not_happen_tells_nothing_of_the_inside(jobs):
    job = ended(jobs.start("reading", nothing, tasks.take_in, "a.txt", None))
    assert job.state is JobState.FAILED
    assert "TypeError" not in job.trouble.message


def greedy(_):
    return len(bytearray(MOST_MEMORY))


def grows():
    running = Jobs(at_once=1)
    job = ended(running.start("growing", nothing, greedy))
    running.close()
    sys.stdout.write(f"{job.state} {job.trouble.message}\n")


def test_memory_is_bounded():
    """In an interpreter of its own: what earlier tests left behind in this one is not counted."""
    command = [sys.executable, "-c", "import test_jobs; test_jobs.grows()"]
    here = Path(__file__).parent
    done = subprocess.run(command, cwd=here, capture_output=True, text=True, check=False)
    assert done.stdout == f"{JobState.FAILED} This takes more than 4 GB of memory.\n", done.stderr


def test_lists_come_in_parts_and_end_when_cancelled(jobs):
    ten = read("Ten cars meet at an uncontrolled four-way intersection.")
    job = jobs.start("listing", nothing, tasks.enumerate_all, ten, "exact", "distinct", None)
    begin = time.monotonic()
    while not job.steps and time.monotonic() - begin < WAIT_S:
        time.sleep(0.02)
    jobs.cancel(job)
    assert job.state is JobState.CANCELLED
    job.process.join(WAIT_S)
    assert not job.process.is_alive()
