"""Campaigns need libraries of their extra: said in one place if they are not there."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from scegen.errors import MissingToolError

_OF_EXTRA = {"duckdb", "joblib", "pyarrow"}


@contextmanager
def of_extra() -> Iterator[None]:
    """What is done here needs the extra ``campaign``.

    Raises:
        MissingToolError: it is not installed.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        name = (error.name or "").partition(".")[0]
        if name not in _OF_EXTRA:
            raise
        raise MissingToolError(
            f"campaigns need {name}", hint="pip install 'ml-scegen[campaign]'"
        ) from error
