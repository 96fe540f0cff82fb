"""Transcripts: every exchange with a model as a file, from which a run can be repeated.

A folder holds ``run.json`` (the description, the models, the version of the prompts) and one
``CHAIN-AGENT-NUMBER.json`` an exchange, with what was sent, what came back, and what it cost.
No header is ever written, so no key is.
"""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, TypeVar

from pydantic import ValidationError

from scegen.errors import InputError
from scegen.llm.faults import Fault
from scegen.llm.usage import Usage
from scegen.scenario.model import FrozenModel

RUN_FILE = "run.json"
M = TypeVar("M", bound=FrozenModel)


class Run(FrozenModel):
    """What a transcript is of."""

    transcript: Literal[1] = 1
    prompts: str
    description: str
    models: tuple[str, ...]
    url: str | None = None


class Exchange(FrozenModel):
    """One question to a model, and its answer or why there was none."""

    model: str
    agent: str
    number: int
    request: tuple[Any, ...]
    response: Any = None
    fault: Fault | None = None
    usage: Usage = Usage()


class Recorder:
    """Writes exchanges into a folder that was empty before.

    Raises:
        InputError: the folder holds something, or cannot be written.
    """

    def __init__(self, folder: Path, run: Run) -> None:
        self._folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
            if any(folder.iterdir()):
                raise InputError(
                    "is not empty", where=f"--llm-record {folder}", hint="name a new folder"
                )
        except OSError as error:
            raise InputError.unwritable(
                error, f"--llm-record {folder}", "name another folder"
            ) from error
        self._write(RUN_FILE, run)

    def keep(self, chain: int, exchange: Exchange) -> None:
        """Write one exchange."""
        self._write(_name(chain, exchange.agent, exchange.number), exchange)

    def _write(self, name: str, content: FrozenModel) -> None:
        text = json.dumps(content.model_dump(mode="json"), indent=2, ensure_ascii=False) + "\n"
        try:
            # a lone surrogate cannot be written as UTF-8; the escape means the same in JSON
            (self._folder / name).write_bytes(text.encode("utf-8", "backslashreplace"))
        except OSError as error:
            raise InputError.unwritable(
                error, f"--llm-record {self._folder}", "name another folder"
            ) from error


class Recording:
    """Reads a folder that a :class:`Recorder` wrote.

    Raises:
        InputError: it is no such folder.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.run = self._read(RUN_FILE, Run, "is no folder of --llm-record: it lacks run.json")

    def require_same(self, *, description: str, prompts: str, models: tuple[str, ...]) -> None:
        """Refuse a recording of something else.

        Raises:
            InputError: says what differs.
        """
        for differs, what in (
            (self.run.description != description, "another description"),
            (self.run.prompts != prompts, "another version of the prompts"),
            (bool(models) and self.run.models != models, "other models"),
        ):
            if differs:
                raise self._unusable(f"was recorded with {what}")

    def exchange(self, chain: int, agent: str, number: int, words: object) -> Exchange:
        """One exchange.

        ``chain`` is the model's place among those asked, ``number`` that of the agent's request,
        both from 1; ``words`` is what is asked now, as :func:`words_of` gives it.

        Raises:
            InputError: it was not recorded, was about something else, or cannot be read.
        """
        name = _name(chain, agent, number)
        found = self._read(
            name, Exchange, f"lacks {name}: other options, the run was cut short, or scegen changed"
        )
        if words_of(found.request) != words:
            raise self._unusable(
                f"{name} answers another question: other options were given, or scegen changed"
            )
        return found

    def _read(self, name: str, kind: type[M], missing: str) -> M:
        try:
            return kind.model_validate_json((self._folder / name).read_bytes())
        except OSError as error:
            raise self._unusable(missing) from error
        except ValidationError as error:
            raise self._unusable(f"{name} is damaged") from error

    def _unusable(self, why: str) -> InputError:
        return InputError(
            why, where=f"--llm-replay {self._folder}", hint="record the run again with --llm-record"
        )


def words_of(request: Sequence[Any]) -> list[Any]:
    """What a request says, without the times and chance names that differ from run to run."""
    said = []
    for message in request:
        said.append(message.get("instructions"))
        said += [
            [part.get("part_kind"), part.get("content"), part.get("args")]
            for part in message.get("parts", ())
        ]
    return said


def _name(chain: int, agent: str, number: int) -> str:
    return f"{chain}-{agent}-{number}.json"
