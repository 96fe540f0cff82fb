"""The one place that speaks to numba's decorators: typed, strict, cached safely.

Numba's decorators carry no types; :func:`kernel` hands back the function with its own type, so
that calls of kernels are checked like any other call. Kernels follow IEEE arithmetic (no
reassociation, no threads): the same input gives the same bits in every run.

Numba's cache looks only at the file of a function, not at the files of the kernels that are
compiled into it; an edited callee would go on living in its callers. The cache folder therefore
carries a fingerprint of all files with kernels that a function may have been built from.
"""

import hashlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import numba

from scegen.loading import stand_ins

# For numpy.cov and functions of C, which no kernel calls.
with stand_ins({"scipy.linalg": None, "cffi": None}):
    import numba.core.typing.cffi_utils
    import numba.np.arraymath

_P = ParamSpec("_P")
_R = TypeVar("_R")
_PACKAGE = Path(__file__).parents[2]
_MARK = "kernel\ndef "
_config: Any = numba.config  # its settings are made at run time, unseen by type checkers


def kernel(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Compile a function on its first call and keep the machine code for later processes.

    Division by zero gives inf or nan as in numpy, not an exception.
    """
    return _compiled(function, inline=False)


def inner_kernel(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """A kernel that is always compiled into its callers: for what runs once per time step.

    A call that is left standing costs more than such a kernel's work, because every array in its
    arguments is handed over as seven and more numbers.
    """
    return _compiled(function, inline=True)


def _compiled(function: Callable[_P, _R], *, inline: bool) -> Callable[_P, _R]:
    with _cache_folder(Path(function.__code__.co_filename)):
        compiled = numba.njit(cache=True, fastmath=False, error_model="numpy", forceinline=inline)(
            function
        )
    return cast("Callable[_P, _R]", compiled)


@contextmanager
def _cache_folder(source: Path) -> Iterator[None]:
    """Let numba keep what it compiles from ``source`` under the fingerprint of its sources.

    Where the folder cannot be written, numba falls back to its own choice by itself.
    """
    before = _config.CACHE_DIR
    root = Path(before) if before else Path(__file__).parent / "__pycache__"
    _config.CACHE_DIR = str(root / f"kernels-{_fingerprint(_package_of(source))}")
    try:
        yield
    finally:
        _config.CACHE_DIR = before


def _package_of(source: Path) -> Path:
    """The folder directly below the package that holds ``source``; elsewhere, its own folder."""
    for folder in source.parents:
        if folder.parent == _PACKAGE:
            return folder
    return source.parent


@cache
def _fingerprint(folder: Path) -> str:
    """Digest of all files with kernels in this folder and beside this one."""
    digest = hashlib.sha256(numba.__version__.encode())
    for path in sorted({*folder.rglob("*.py"), *Path(__file__).parent.glob("*.py")}):
        text = path.read_bytes()
        if _MARK.encode() in text or b"NamedTuple" in text:
            digest.update(str(path).encode() + text)
    return digest.hexdigest()[:16]
