"""Exceptions of the libraries as faults: which kind, in which words, and whether they may pass."""

import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from http import HTTPStatus

from pydantic_ai.exceptions import (
    ContentFilterError,
    ModelAPIError,
    ModelConnectionError,
    ModelHTTPError,
    ModelQuotaExceededError,
    ModelTimeoutError,
    OutputTokenLimitExceeded,
    UnexpectedModelBehavior,
)

from scegen.llm.client import AnswerTooLargeError
from scegen.llm.faults import Fault, FaultKind, LlmError
from scegen.llm.keys import blot

_LONGEST_QUOTE = 200
_KINDS = {
    HTTPStatus.UNAUTHORIZED: FaultKind.AUTHENTICATION,
    HTTPStatus.FORBIDDEN: FaultKind.AUTHENTICATION,
    HTTPStatus.NOT_FOUND: FaultKind.NOT_FOUND,
    HTTPStatus.TOO_MANY_REQUESTS: FaultKind.RATE_LIMIT,
    HTTPStatus.REQUEST_TIMEOUT: FaultKind.TIMEOUT,
    HTTPStatus.REQUEST_ENTITY_TOO_LARGE: FaultKind.TOO_LARGE,
}
_PASSING = {
    FaultKind.RATE_LIMIT,
    FaultKind.SERVER,
    FaultKind.TIMEOUT,
    FaultKind.CONNECTION,
    FaultKind.NO_ANSWER,
}


@dataclass(frozen=True, slots=True)
class Trouble:
    """A fault, whether trying again can help, and how long the server asks to wait."""

    fault: Fault
    passing: bool
    wait_s: float | None = None


def trouble_of(error: Exception, key: str) -> Trouble:
    """What an exception from a request means."""
    if isinstance(error, ModelHTTPError):
        return _of_status(error, key)
    if any(isinstance(cause, AnswerTooLargeError) for cause in _chain(error)):
        return _trouble(FaultKind.TOO_LARGE, "its answer is too long to be one")
    if isinstance(error, TimeoutError | ModelTimeoutError):
        return _trouble(FaultKind.TIMEOUT, "gave no answer in time")
    if isinstance(error, ModelConnectionError):
        return _trouble(FaultKind.CONNECTION, f"could not be reached: {_root(error, key)}")
    undecodable = any(isinstance(cause, ValueError) for cause in _chain(error))
    if isinstance(error, ModelAPIError) and not undecodable:
        return _trouble(FaultKind.REJECTED, f"refused the request: {_quote(error.message, key)}")
    return _trouble(FaultKind.NO_ANSWER, f"sent something that is no answer: {_root(error, key)}")


def fault_of_run(error: Exception, key: str) -> Fault:
    """What an exception from an agent's whole conversation means."""
    if isinstance(error, LlmError):
        return error.fault
    if isinstance(error, ContentFilterError):
        return Fault(kind=FaultKind.REFUSED, message=f"refused: {_quote(error.message, key)}")
    if isinstance(error, OutputTokenLimitExceeded):
        return Fault(
            kind=FaultKind.TOO_LARGE, message="its answer was cut off at the limit of tokens"
        )
    if isinstance(error, UnexpectedModelBehavior):
        return Fault(
            kind=FaultKind.INVALID,
            message=f"no valid answer after every correction: {_root(error, key)}",
        )
    return trouble_of(error, key).fault


def _of_status(error: ModelHTTPError, key: str) -> Trouble:
    status = error.status_code
    kind = FaultKind.SERVER if status >= HTTPStatus.INTERNAL_SERVER_ERROR else FaultKind.REJECTED
    kind = _KINDS.get(HTTPStatus(status), kind) if status in set(HTTPStatus) else kind
    said = _quote(_said(error.body), key)
    message = f"answered with HTTP status {status}" + (f": {said}" if said else "")
    if error.retry_after is not None:
        message += f" (asks to wait {error.retry_after:g} s)"
    passing = kind in _PASSING and not isinstance(error, ModelQuotaExceededError)
    return Trouble(Fault(kind=kind, message=message), passing, error.retry_after)


def _trouble(kind: FaultKind, message: str) -> Trouble:
    return Trouble(Fault(kind=kind, message=message), passing=kind in _PASSING)


def _said(body: object) -> str:
    """The words of a provider's error, wherever it puts them."""
    if isinstance(body, dict):
        for name in ("error", "message", "detail"):
            if name in body:
                return _said(body[name])
    return body if isinstance(body, str) else ""


def _chain(error: BaseException) -> Iterator[BaseException]:
    seen: set[int] = set()
    here: BaseException | None = error
    while here is not None and id(here) not in seen:
        seen.add(id(here))
        yield here
        here = here.__cause__ or here.__context__


def _root(error: Exception, key: str) -> str:
    """What the system says of an exception; without that the innermost words."""
    causes = [cause for cause in _chain(error) if str(cause)]
    words = [str(c) for c in causes if isinstance(c, OSError)] or [str(c) for c in causes]
    return _quote(words[-1] if words else type(error).__name__, key)


def _quote(text: str, key: str) -> str:
    """Foreign words, on one line, short, and without control characters or the key."""
    plain = "".join(" " if unicodedata.category(c).startswith("C") else c for c in blot(text, key))
    line = " ".join(plain.split())
    return line if len(line) <= _LONGEST_QUOTE else line[:_LONGEST_QUOTE] + "…"
