"""Who works: processes of this machine (joblib), or a cluster (Ray). Neither decides anything."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from socket import create_connection
from typing import Any, TypeVar

from scegen.errors import InputError, MissingToolError

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
    ) -> Iterator[R]:
        """What ``work`` gives for every task, as it comes.

        ``prepare`` runs first where the work is done; ``enlist`` instead of it, with the id of this
        process, in those that are ours alone.

        Raises:
            WorkerLostError: a worker died, by whatever cause.
            MissingToolError: the engine is not installed.
            InputError: the cluster cannot be reached.
        """
        if not tasks:
            return iter(())
        if self.engine is Engine.RAY:
            return _by_ray(self, work, tasks, prepare)
        if self.workers == 1:
            prepare()
            return map(work, tasks)
        return _by_joblib(self.workers, work, tasks, enlist)


def _by_joblib(
    workers: int, work: Callable[[T], R], tasks: Sequence[T], enlist: Callable[[int], None]
) -> Iterator[R]:
    from joblib import Parallel, delayed  # noqa: PLC0415 - of the extra
    from joblib.externals.loky.process_executor import (  # noqa: PLC0415
        TerminatedWorkerError,
    )

    pool = Parallel(
        n_jobs=workers,
        backend="loky",
        return_as="generator_unordered",
        batch_size=1,
        pre_dispatch="2 * n_jobs",
        initializer=enlist,
        initargs=(os.getpid(),),
    )
    results = pool(delayed(work)(task) for task in tasks)
    try:
        yield from results
    except TerminatedWorkerError as error:
        raise WorkerLostError(str(error)) from error
    finally:
        results.close()


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
    try:
        import ray  # noqa: PLC0415 - of another extra, and it takes a second to load
    except ModuleNotFoundError as error:
        raise MissingToolError(
            "the engine ray needs Ray", hint="pip install 'ml-scegen[cluster]'"
        ) from error
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
