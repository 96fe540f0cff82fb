"""Long work in processes of its own.

It never holds up the page, tells how far it is, and ends at once when it is cancelled.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import StrEnum
from multiprocessing.connection import Connection
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from time import monotonic
from typing import Any

from scegen.errors import ScegenError

try:
    import resource
except ModuleNotFoundError:  # not on every system
    resource = None  # type: ignore[assignment]

_LONGEST_STEPS = 200
MOST_MEMORY = 4 << 30
"""Bytes that one job may take, where the system can hold it to that."""


class JobState(StrEnum):
    """How far a job is."""

    WAITING = "waiting"
    RUNNING = "running"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True, slots=True)
class Step:
    """Something that a job said, so many seconds after it began."""

    text: str
    after_s: float


class Teller:
    """The end of a job inside its process, through which it tells how far it is."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection

    def progress(self, text: str) -> None:
        """Tell what is being done now."""
        self._connection.send(("step", text))

    def part(self, part: object) -> None:
        """Hand over a part of the result before the whole is there."""
        self._connection.send(("part", part))


Task = Callable[..., Any]
"""A function at the top of a module; its last argument is a :class:`Teller`."""


@dataclass(eq=False)
class Job:
    """One piece of long work.

    ``told`` is called from another thread, whenever something has changed.
    """

    what: str
    told: Callable[[Job], None]
    state: JobState = JobState.WAITING
    steps: list[Step] = field(default_factory=list)
    parts: list[Any] = field(default_factory=list)
    result: Any = None
    trouble: ScegenError | None = None
    began: float = field(default_factory=monotonic)
    took_s: float | None = None
    process: BaseProcess | None = None

    @property
    def under_way(self) -> bool:
        """Whether it has not ended."""
        return self.state in {JobState.WAITING, JobState.RUNNING}

    @property
    def seconds(self) -> float:
        """How long it has taken until now, or until its end."""
        return monotonic() - self.began if self.took_s is None else self.took_s

    def end(self, state: JobState) -> None:
        """Note the end, once."""
        if self.under_way:
            self.took_s = self.seconds
            self.state = state
            self.told(self)


class Jobs:
    """All jobs of a server, with ``more`` modules loaded; so many run at once, others wait."""

    def __init__(self, *more: str, at_once: int | None = None) -> None:
        self._turn = threading.BoundedSemaphore(at_once or max(2, os.cpu_count() or 2))
        self._context = _context("scegen.web.tasks", *more)
        self._running: set[Job] = set()

    def start(self, what: str, told: Callable[[Job], None], task: Task, *arguments: object) -> Job:
        """Begin; the job is returned at once."""
        job = Job(what, told)
        threading.Thread(
            target=self._follow, args=(job, task, arguments), name=what, daemon=True
        ).start()
        return job

    def cancel(self, job: Job | None) -> None:
        """End a job now, if it has not ended; what it was making is lost."""
        if job is None or not job.under_way:
            return
        job.end(JobState.CANCELLED)
        if job.process is not None:
            job.process.kill()

    def close(self) -> None:
        """End everything."""
        for job in list(self._running):
            self.cancel(job)

    def _follow(self, job: Job, task: Task, arguments: tuple[object, ...]) -> None:
        with self._turn:
            if not job.under_way:
                return
            ours, theirs = self._context.Pipe(duplex=False)
            process = self._context.Process(  # type: ignore[attr-defined]
                target=_work, args=(theirs, task, arguments), daemon=True
            )
            process.start()
            theirs.close()
            job.process = process
            self._running.add(job)
            if job.under_way:
                job.state = JobState.RUNNING
                self._listen(job, ours)
            process.kill()
            process.join()
            self._running.discard(job)

    def _listen(self, job: Job, connection: Connection) -> None:
        """Until the process has said its last word, or has none any more."""
        while job.under_way:
            try:
                kind, value = connection.recv()
            except (EOFError, OSError):
                if job.under_way:
                    job.trouble = ScegenError(
                        "The work ended without a result.", hint="See the server's terminal."
                    )
                    job.end(JobState.FAILED)
                return
            if kind == "step":
                del job.steps[:-_LONGEST_STEPS]
                job.steps.append(Step(value, job.seconds))
                job.told(job)
            elif kind == "part":
                job.parts.append(value)
                job.told(job)
            elif kind == "done":
                job.result = value
                job.end(JobState.DONE)
            else:
                job.trouble = value
                job.end(JobState.FAILED)


def _context(*modules: str) -> BaseContext:
    """Processes that have modules loaded already, where the system can fork such."""
    if "forkserver" in multiprocessing.get_all_start_methods():
        context = multiprocessing.get_context("forkserver")
        context.set_forkserver_preload(list(modules))
        return context
    return multiprocessing.get_context("spawn")


def _work(connection: Connection, task: Task, arguments: tuple[object, ...]) -> None:
    """In the process: do it, and say what came of it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server ends its jobs itself
    if resource is not None:
        resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEMORY, MOST_MEMORY))
    try:
        connection.send(("done", task(*arguments, Teller(connection))))
    except MemoryError:
        message = f"This takes more than {MOST_MEMORY >> 30} GB of memory."
        connection.send(("failed", ScegenError(message, hint="Ask for less.")))
    except ScegenError as error:
        connection.send(("failed", error))
    except Exception:  # noqa: BLE001 - the page must hear of whatever it is
        traceback.print_exc(file=sys.stderr)
        message = "Something went wrong that should not have."
        connection.send(("failed", ScegenError(message, hint="See the server's terminal.")))
