"""What is under way for one person, by kind, and who is told when something has changed."""

import asyncio
from collections import Counter
from collections.abc import Callable

from scegen.errors import ScegenError
from scegen.web.jobs import Job, Jobs, JobState, Task


class Undertakings:
    """Jobs by kind, the newest of each, heard in the server's loop.

    ``revision`` counts the changes of each part, so that every open page can tell what to draw
    again; the kinds of jobs are parts too.
    """

    def __init__(self, jobs: Jobs) -> None:
        self.jobs = jobs
        self.revision: Counter[str] = Counter()
        self.under_way: dict[str, Job] = {}
        self._loop = asyncio.get_running_loop()
        self._listeners: list[Callable[[], None]] = []

    def cancel(self, *kinds: str) -> None:
        """End work that is under way."""
        for kind in kinds:
            self.jobs.cancel(self.under_way.get(kind))

    def cancel_all(self) -> None:
        """End everything that is under way."""
        self.cancel(*self.under_way)

    @property
    def working(self) -> bool:
        """Whether anything is under way."""
        return any(job.under_way for job in self.under_way.values())

    def busy(self, kind: str) -> bool:
        """Whether work of a kind is under way."""
        job = self.under_way.get(kind)
        return job is not None and job.under_way

    def trouble(self, kind: str) -> ScegenError | None:
        """Why the last work of a kind failed, if it did."""
        job = self.under_way.get(kind)
        return job.trouble if job is not None and job.state is JobState.FAILED else None

    def _begin(
        self,
        kind: str,
        done: Callable[[Job], None],
        task: Task,
        *arguments: object,
        partly: Callable[[Job], None] = lambda _: None,
    ) -> None:
        """Begin a job in place of the last one of its kind.

        ``done`` is called with it when it has a result, ``partly`` whenever it tells something.
        """
        self.cancel(kind)

        def told(job: Job) -> None:
            self._loop.call_soon_threadsafe(self._hear, kind, job, done, partly)

        self.under_way[kind] = self.jobs.start(kind, told, task, *arguments)
        self._changed(kind)

    def _hear(
        self, kind: str, job: Job, done: Callable[[Job], None], partly: Callable[[Job], None]
    ) -> None:
        if self.under_way.get(kind) is not job:
            return  # something newer has taken its place
        partly(job)
        if job.state is JobState.DONE and job.result is not None:
            done(job)
            job.result = None
        self._changed(kind)

    def listen(self, listener: Callable[[], None]) -> Callable[[], None]:
        """Call this after every change; returns how to stop."""
        self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    def _changed(self, *parts: str) -> None:
        self.revision.update(parts)
        for listener in self._listeners:
            listener()
