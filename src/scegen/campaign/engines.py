"""Who works: processes of this machine (joblib), or a cluster (Ray). Neither decides anything."""

import os
import threading
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from multiprocessing import resource_tracker
from signal import SIG_BLOCK, SIG_SETMASK, SIGINT, getsignal, pthread_sigmask, raise_signal, signal
from socket import create_connection
from threading import ExceptHookArgs, current_thread, main_thread
from typing import Any, TypeVar
from warnings import catch_warnings

from scegen.errors import InputError, of_extra

T = TypeVar("T")
R = TypeVar("R")
_ANSWERS_IN_S = 10.0


class Engine(StrEnum):
    """Who runs the work."""

    JOBLIB = "joblib"
    RAY = "ray"


class WorkerLostError(Exception):
    """A worker has died; what it was at is not done."""


@dataclass(frozen=True, slots=True)
class Workforce:
    """How many workers, of which engine; ``address`` is that of a Ray cluster, None starts one."""

    engine: Engine = Engine.JOBLIB
    workers: int = 1
    address: str | None = None

    def each(
        self,
        work: Callable[[T], R],
        tasks: Sequence[T],
        prepare: Callable[[], None],
        enlist: Callable[[int], None],
    ) -> Generator[R, None, None]:
        """What ``work`` gives for every task, as it comes; who is at work ends when it is closed.

        ``prepare`` runs first where the work is done; ``enlist`` instead of it, with the id of this
        process, in those that are ours alone.

        Raises:
            WorkerLostError: a worker died, by whatever cause.
            MissingToolError: the engine is not installed.
            InputError: the cluster cannot be reached.
        """
        if not tasks:
            return
        if self.engine is Engine.RAY:
            yield from _by_ray(self, work, tasks, prepare)
        elif self.workers == 1:
            prepare()
            yield from map(work, tasks)
        else:
            yield from _by_joblib(self.workers, work, tasks, enlist)


def _by_joblib(
    workers: int, work: Callable[[T], R], tasks: Sequence[T], enlist: Callable[[int], None]
) -> Iterator[R]:
    from joblib import Parallel, delayed  # noqa: PLC0415 - of the extra
    from joblib.externals.loky.process_executor import TerminatedWorkerError  # noqa: PLC0415

    pool = Parallel(
        n_jobs=workers,
        backend="loky",
        return_as="generator_unordered",
        batch_size=1,
        pre_dispatch="2 * n_jobs",
        initializer=enlist,
        initargs=(os.getpid(),),
    )
    try:
        with ExitStack() as end:
            with _uninterrupted():
                results = end.enter_context(_closed(pool(delayed(work)(task) for task in tasks)))
            for result in results:  # noqa: UP028 - so that it is not this loop that ends them
                yield result
    except TerminatedWorkerError as error:
        raise WorkerLostError(str(error)) from error


@contextmanager
def _closed(results: Generator[R, None, None]) -> Iterator[Iterator[R]]:
    """Results, and nobody at work after them."""
    try:
        yield results
    finally:
        with catch_warnings(action="ignore"), _unheard():  # that some were still at work
            results.close()


@contextmanager
def _unheard() -> Iterator[None]:
    """Loky's thread looks for work that it has just thrown away, once its workers are killed."""
    before = threading.excepthook

    def heard(error: ExceptHookArgs) -> None:
        thread = error.thread
        if error.exc_type is not KeyError or not thread or thread.name != "ExecutorManagerThread":
            before(error)

    threading.excepthook = heard
    try:
        yield
    finally:
        threading.excepthook = before


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Ctrl-C waits until all workers are there and known, and is left to this process by them."""
    resource_tracker.ensure_running()  # as it starts it lets Ctrl-C through
    caught: list[int] = []
    before = getsignal(SIGINT)
    here = current_thread() is main_thread()
    if here:
        signal(SIGINT, lambda number, _: caught.append(number))
    mask = pthread_sigmask(SIG_BLOCK, {SIGINT})  # which those started meanwhile inherit
    try:
        yield
    finally:
        pthread_sigmask(SIG_SETMASK, mask)
        if here:
            signal(SIGINT, before)
        for number in caught:
            raise_signal(number)


def _call(address: str) -> None:
    """Whether anybody is there: Ray itself would try for a quarter of an hour.

    Raises:
        OSError: nobody is.
    """
    host, _, port = address.rpartition("://")[2].rpartition(":")
    if port.isdecimal():
        with create_connection((host, int(port)), _ANSWERS_IN_S):
            pass


@cache
def _once(prepare: Callable[[], None]) -> None:
    prepare()


def _by_ray(
    force: Workforce, work: Callable[[T], R], tasks: Sequence[T], prepare: Callable[[], None]
) -> Iterator[R]:
    with of_extra("cluster", "the engine ray", "ray"):
        import ray  # noqa: PLC0415 - of another extra, and it takes a second to load
    quiet: dict[str, Any] = {"log_to_driver": False, "logging_level": "ERROR"}
    if force.address is None:
        quiet |= {"num_cpus": force.workers, "include_dashboard": False}
    try:
        if force.address is not None:
            _call(force.address)
        ray.init(address=force.address or "local", **quiet)
    except (OSError, ValueError, RuntimeError) as error:
        raise InputError(
            f"no Ray cluster answers: {error}",
            where=f"--address {force.address}",
            hint="ray start --head shows it; one with a token wants RAY_AUTH_MODE=token here, too",
        ) from error

    def prepared(task: T) -> R:
        _once(prepare)
        return work(task)

    # A task that is run again must not run beside the first: the plan is looked at anew instead.
    remote = ray.remote(max_retries=0)(prepared)
    waiting: list[Any] = []
    left = iter(tasks)
    try:
        most = 2 * max(force.workers, int(ray.cluster_resources().get("CPU", 1)))
        while True:
            while len(waiting) < most and (task := next(left, None)) is not None:
                waiting.append(remote.remote(task))
            if not waiting:
                return
            (ready,), waiting = ray.wait(waiting, num_returns=1)
            try:
                yield ray.get(ready)
            except ray.exceptions.RayTaskError as error:
                raise error.as_instanceof_cause() from None
            except ray.exceptions.RayError as error:
                raise WorkerLostError(str(error).partition("\n")[0]) from error
    finally:
        ray.shutdown()
