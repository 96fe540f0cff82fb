"""The options about language models, and what is said about them on the terminal."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, get_type_hints

import typer

from scegen.cli.console import say, warn
from scegen.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from scegen.llm import LlmSettings, Session
    from scegen.scenario.functional import FunctionalScenario
    from scegen.scenario.proof import Proof
    from scegen.understanding.agents import Understanding

ModelOption = Annotated[
    str | None,
    typer.Option(
        "--llm",
        metavar="MODEL",
        help="Understand (and in generate, choose numbers) with a language model, such as "
        "deepseek:deepseek-chat; several with commas are tried in order, then the offline rules.",
    ),
]
UrlOption = Annotated[str | None, typer.Option("--llm-url", help="Any OpenAI-compatible endpoint.")]
BudgetOption = Annotated[
    str | None,
    typer.Option("--llm-budget", help="The most to use: 20000 (tokens), 0.10usd, or 20k,0.10usd."),
]
TimeoutOption = Annotated[
    float | None,
    typer.Option("--llm-timeout", min=0.1, help="Seconds to wait for one answer (default 90)."),
]
RecordOption = Annotated[
    Path | None,
    typer.Option("--llm-record", metavar="DIR", help="Write transcripts into this new folder."),
]
ReplayOption = Annotated[
    Path | None,
    typer.Option("--llm-replay", metavar="DIR", help="Repeat a recorded run, without network."),
]


class Asked(NamedTuple):
    """The options about language models, as they were given."""

    llm: ModelOption = None
    llm_url: UrlOption = None
    llm_budget: BudgetOption = None
    llm_timeout: TimeoutOption = None
    llm_record: RecordOption = None
    llm_replay: ReplayOption = None

    def settings(self, runs: str = "run.json") -> LlmSettings | None:
        """What they say as settings; None if no language model is asked for.

        ``runs`` is a pattern: which files of the folder to replay tell what was recorded.
        """
        for name in ("llm_url", "llm_budget", "llm_timeout", "llm_record"):
            if getattr(self, name) is None:
                continue
            option = f"--{name.replace('_', '-')}"
            if self.llm_replay is not None:
                # a recording brings its own address, and costs nothing
                raise InputError("has no meaning with --llm-replay", where=option)
            if self.llm is None:
                raise InputError("needs --llm", where=option, hint="name a model with --llm")
        if self.llm is None and self.llm_replay is None:
            return None
        from scegen.llm import Budget, LlmSettings, parse_models, require_llm
        from scegen.llm.budget import parse_budget
        from scegen.llm.naming import require_url
        from scegen.llm.settings import Limits
        from scegen.llm.transcript import Recording

        require_llm()
        address = require_url(self.llm_url) if self.llm_url is not None else None
        if self.llm_replay is not None:
            recorded = sorted(file.parent for file in self.llm_replay.glob(runs))
            address = Recording((recorded or [self.llm_replay])[0]).run.url
        patience = self.llm_timeout
        return LlmSettings(
            models=parse_models(self.llm, url=address) if self.llm is not None else (),
            url=address,
            budget=parse_budget(self.llm_budget) if self.llm_budget is not None else Budget(),
            record=self.llm_record,
            replay=self.llm_replay,
            limits=Limits() if patience is None else Limits().patient(patience),
        )


def asks_models(command: Callable[..., None]) -> Callable[..., None]:
    """A command of which the last parameter, ``models``, stands for all these options."""
    options = get_type_hints(Asked, include_extras=True)
    own = signature(command, eval_str=True)
    *others, models = own.parameters.values()

    @wraps(command)
    def run(**given: Any) -> None:  # noqa: ANN401 - whatever the command takes
        asked = Asked(**{name: given.pop(name) for name in options})
        command(**given, models=asked)

    shown = (models.replace(name=n, annotation=a, default=None) for n, a in options.items())
    run.__signature__ = own.replace(parameters=[*others, *shown])  # type: ignore[attr-defined]
    return run


class Listener:
    """Understands descriptions, with language models if they are asked for.

    The last ``text`` is remembered, and what models made of it; their ``session`` goes on to the
    stages after it.
    """

    def __init__(self, settings: LlmSettings | None, progress: Callable[[str], None]) -> None:
        self.session: Session | None = None
        self.understanding: Understanding | None = None
        self.text = ""
        self._progress = progress
        if settings is not None:
            from scegen.llm import Session

            self.session = Session(settings)

    def __call__(self, text: str) -> FunctionalScenario:
        """The functional scenario of a description."""
        self.text = text
        if self.session is None:
            from scegen.understanding import read

            return read(text)
        from scegen.understanding.agents import understand_in

        self.understanding = understand_in(self.session, text, self._progress)
        return self.understanding.functional

    def tell(self) -> None:
        """Which models spoke, what went wrong, what was not agreed on, and what it took."""
        if self.session is None:
            return
        if self.understanding is None:
            say("the source is a scenario file: no language model was asked to understand it")
            return
        for fault in self.understanding.faults:
            warn(fault.in_words())
            if fault.hint:
                say(f"  {fault.hint}")
        if self.understanding.fell_back:
            warn("no language model gave a usable answer: the offline reader understood the text")
        for item in self.understanding.disagreements:
            say(
                f'disagreement on {item.field} ("{item.words}"): reader {item.reader}, '
                f"agents {item.agents}; kept: {item.kept} ({item.reason})"
            )
        for note in self.understanding.notes:
            say(note)
        usage = self.understanding.usage.in_words()
        say(f"understood by {self.understanding.speaker}: {usage}")


def tell_proposals(session: Session, proofs: Iterable[Proof]) -> None:
    """Who proposed numbers, what kept others from it, and what the run took in all."""
    advices = [proof.advice for proof in proofs if proof.advice is not None]
    for note in dict.fromkeys(note for advice in advices for note in advice.notes):
        warn(note)
    for speaker in dict.fromkeys(advice.speaker for advice in advices):
        own = [advice for advice in advices if advice.speaker == speaker]
        say(
            f"numbers proposed by {speaker}: {sum(a.accepted for a in own)} taken, "
            f"{sum(a.replaced for a in own)} replaced, {sum(a.dropped for a in own)} dropped"
        )
    if not advices:
        say("no numbers had to be proposed: everything happens already, or nothing would help")
    say(f"language models in all: {session.usage.in_words()}")
