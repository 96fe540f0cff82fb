"""The options about language models, and what is said about them on the terminal."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scegen.cli.console import say, warn
from scegen.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

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


def llm_settings(
    model: str | None,
    url: str | None,
    budget: str | None,
    timeout: float | None,
    record: Path | None,
    replay: Path | None,
    *,
    runs: str = "run.json",
) -> LlmSettings | None:
    """The options as settings; None if no language model is asked for.

    Args:
        model: of ``--llm``, and so on.
        url: the same.
        budget: the same.
        timeout: the same, in seconds.
        record: the same.
        replay: the same.
        runs: which files of the folder to replay tell what was recorded, as a pattern.
    """
    given = {
        "--llm-url": url,
        "--llm-budget": budget,
        "--llm-timeout": timeout,
        "--llm-record": record,
    }
    if model is None and replay is None:
        for option, value in given.items():
            if value is not None:
                raise InputError("needs --llm", where=option, hint="name a model with --llm")
        return None
    if replay is not None:
        # a recording brings its own address, and costs nothing
        for option, value in given.items():
            if value is not None:
                raise InputError("has no meaning with --llm-replay", where=option)
    from scegen.llm import Budget, LlmSettings, parse_models, require_llm
    from scegen.llm.budget import parse_budget
    from scegen.llm.naming import require_url
    from scegen.llm.settings import Limits
    from scegen.llm.transcript import Recording

    require_llm()
    address = require_url(url) if url is not None else None
    if replay is not None:
        recorded = sorted(file.parent for file in replay.glob(runs))
        address = Recording((recorded or [replay])[0]).run.url
    return LlmSettings(
        models=parse_models(model, url=address) if model is not None else (),
        url=address,
        budget=parse_budget(budget) if budget is not None else Budget(),
        record=record,
        replay=replay,
        limits=Limits() if timeout is None else Limits().patient(timeout),
    )


class Listener:
    """Understands descriptions with language models, and remembers the last understanding.

    ``session`` goes on to the stages after it.
    """

    def __init__(self, settings: LlmSettings, progress: Callable[[str], None]) -> None:
        from scegen.llm import Session

        self.session = Session(settings)
        self._progress = progress
        self.understanding: Understanding | None = None

    def __call__(self, text: str) -> FunctionalScenario:
        """The functional scenario of a description."""
        from scegen.understanding.agents import understand_in

        self.understanding = understand_in(self.session, text, self._progress)
        return self.understanding.functional


def tell(understanding: Understanding | None) -> None:
    """Who spoke, what went wrong, what was not agreed on, and what it took."""
    if understanding is None:
        say("the source is a scenario file: no language model was asked to understand it")
        return
    for fault in understanding.faults:
        warn(fault.in_words())
        if fault.hint:
            say(f"  {fault.hint}")
    if understanding.fell_back:
        warn("no language model gave a usable answer: the offline reader understood the text")
    for item in understanding.disagreements:
        say(
            f'disagreement on {item.field} ("{item.words}"): reader {item.reader}, '
            f"agents {item.agents}; kept: {item.kept} ({item.reason})"
        )
    for note in understanding.notes:
        say(note)
    say(f"understood by {understanding.speaker}: {understanding.usage.in_words()}")


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
