"""Every error that the program raises on purpose, as one tree.

    ScegenError
    ├── InputError              the user's input cannot be used        exit code 2
    │   ├── NotTrafficError     the text does not describe traffic
    │   ├── VocabularyError     a word outside the vocabulary, a broken file
    │   └── InfeasibleError     understood, but it cannot exist
    │       ├── RoadInfeasibleError
    │       ├── NoScenarioError
    │       └── MotionInfeasibleError
    └── MissingToolError        a tool outside the package is needed   exit code 3

Messages say what is wrong, where, and what to do about it.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Self


class ScegenError(Exception):
    """Base of all errors with a message for the user.

    Args:
        message: what is wrong, in one sentence.
        where: the file, field or phrase concerned.
        hint: what the user can do about it.
    """

    exit_code = 2

    def __init__(self, message: str, *, where: str | None = None, hint: str | None = None) -> None:
        self.message = message
        self.where = where
        self.hint = hint
        super().__init__(self.render())

    def render(self) -> str:
        """The message with its place and its hint, as printed."""
        text = f"{self.where}: {self.message}" if self.where else self.message
        return f"{text}\n  {self.hint}" if self.hint else text


class InputError(ScegenError):
    """The input cannot be used as it is."""

    @classmethod
    def unwritable(cls, error: OSError, where: object, hint: str | None = None) -> Self:
        """A file or folder that cannot be written, and why the system says so."""
        # who copies a whole tree tells of every file in it: (from, to, why)
        reason = error.strerror or error.args[0][0][-1]
        return cls(f"cannot be written: {reason}", where=str(where), hint=hint)


class NotTrafficError(InputError):
    """The text does not describe a traffic situation."""


class VocabularyError(InputError):
    """A value outside the vocabulary, or a file that does not follow its schema."""


class InfeasibleError(InputError):
    """The request is understood but contradicts itself or geometry."""


class RoadInfeasibleError(InfeasibleError):
    """No road network with these parameters exists; the message gives the reason."""


class NoScenarioError(InfeasibleError):
    """No assignment of entries and movements satisfies the functional scenario."""


class MotionInfeasibleError(InfeasibleError):
    """A participant cannot move as asked on this road."""


class MissingToolError(ScegenError):
    """A program or package outside the installation is needed."""

    exit_code = 3


@contextmanager
def of_extra(extra: str, what: str, *libraries: str, where: str | None = None) -> Iterator[None]:
    """Here is imported ``what`` needs, of the libraries of an extra.

    Raises:
        MissingToolError: one of them is not installed; says how to get it.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        library = (error.name or "").partition(".")[0]
        if library not in libraries:
            raise
        raise MissingToolError(
            f"{what} needs the library {library}, which is not installed",
            where=where,
            hint=f"run: pip install 'ml-scegen[{extra}]'",
        ) from error
