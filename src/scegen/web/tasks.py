"""The long work of the page, each a function that runs in a process of its own.

They call what the command line calls, with the same arguments.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from scegen.concretization import concretize
from scegen.enumeration import LIST_LIMIT, open_listing
from scegen.enumeration.choosing.covering import smallest_cover
from scegen.enumeration.choosing.sampling import diverse_sample
from scegen.errors import InfeasibleError
from scegen.llm import LlmSettings, Session, Usage
from scegen.measures import warm_kernels
from scegen.pipeline.generate import generate
from scegen.pipeline.options import Options
from scegen.pipeline.place import scenario_file
from scegen.pipeline.playing import has_screen, play
from scegen.pipeline.rendering import rendered
from scegen.pipeline.source import Source
from scegen.report.player.scene import scene_of
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario, LogicalSet
from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.scenario.wording import counted, covering
from scegen.understanding import ParseReport, read, report_on, report_on_contradiction
from scegen.understanding.agents import understand_in
from scegen.web.jobs import Teller
from scegen.web.made import Made, MadeScenario, read_made
from scegen.web.uploads import read_upload

_PART = 40
"""So many scenarios are handed over at once while they are listed."""


@dataclass(frozen=True, slots=True)
class Understood:
    """A description, understood, with what became of its words.

    ``functional`` is None where the text contradicts itself; ``trouble`` says how. ``speaker`` is
    who understood it, ``notes`` what is to be said about that, ``usage`` what it took.
    """

    report: ParseReport
    functional: FunctionalScenario | None
    trouble: str | None = None
    speaker: str = "offline reader"
    notes: tuple[str, ...] = ()
    usage: Usage | None = None


def understand(text: str, models: LlmSettings | None, tell: Teller) -> Understood:
    """Read a description; by language models if there are settings for them."""
    tell.progress("understanding")
    try:
        if models is None:
            functional = read(text)
            return Understood(report_on(functional), functional)
        session = Session(models)
        heard = understand_in(session, text, tell.progress)
    except InfeasibleError as error:
        return Understood(report_on_contradiction(text, error), None, error.render())
    notes = [fault.in_words() for fault in heard.faults]
    notes += [f"{o.about}: {o.problem}" for o in heard.objections]
    return Understood(
        report_on(heard.functional, heard.disagreements),
        heard.functional,
        None,
        heard.speaker,
        (*notes, *heard.notes),
        heard.usage,
    )


def enumerate_all(
    functional: FunctionalScenario,
    reduction: Reduction,
    arms: ArmsMode,
    rules: RuleFile | None,
    tell: Teller,
) -> LogicalSet:
    """List all logical scenarios, handing them over as they are found; the set comes without."""
    tell.progress("enumerating")
    listing = open_listing(
        functional, reduction=reduction, arms=arms, limit=LIST_LIMIT, rules=rules
    )
    tell.part(listing.certificate())
    scenarios: list[LogicalScenario] = []
    for scenario in listing:
        scenarios.append(scenario)
        if len(scenarios) == _PART:
            tell.part(tuple(scenarios))
            scenarios.clear()
    tell.part(tuple(scenarios))
    return LogicalSet(
        functional=functional,
        reduction=reduction,
        arms=arms,
        certificate=listing.certificate(),
        notes=listing.notes,
        scenarios=(),
    )


def cover(
    scenarios: tuple[LogicalScenario, ...], functional: FunctionalScenario, tell: Teller
) -> tuple[tuple[int, ...], str]:
    """The fewest scenarios that hold every meeting, by number, and whether no fewer do."""
    tell.progress("choosing the fewest that cover every meeting")
    found = smallest_cover(scenarios, functional)
    proof = "no fewer do" if found.proved else "fewer may do"
    note = f"{covering(len(found.scenarios))}; {proof}"
    return tuple(s.index for s in found.scenarios), note


def sample(
    scenarios: tuple[LogicalScenario, ...], functional: FunctionalScenario, size: int, tell: Teller
) -> tuple[tuple[int, ...], str]:
    """So many scenarios that differ as much as possible, by number."""
    tell.progress("choosing scenarios that differ")
    found = diverse_sample(scenarios, functional, size)
    note = f"{counted(len(found), 'scenario')}, as far apart as possible"
    return tuple(s.index for s in found), note


def make(source: Source, folder: Path, options: Options, tell: Teller) -> bool:
    """All stages after the choice, into the folder; whether all that was asked for holds."""
    return generate(source, folder, options, tell.progress).ok


def look(folder: Path, tell: Teller) -> Made:
    """Read what lies in a folder of the project."""
    tell.progress(f"reading {folder.name}")
    return read_made(folder)


def render_one(concrete: ConcreteScenario, ending: str, tell: Teller) -> bytes:
    """A scenario as a moving picture."""
    return rendered(concrete, ending, watch=lambda numbers: _counted(list(numbers), tell))


def _counted(numbers: list[int], tell: Teller) -> Iterator[int]:
    for done, number in enumerate(numbers):
        tell.progress(f"drawing picture {done + 1} of {len(numbers)}")
        yield number


def play_one(folder: Path, name: str, tell: Teller) -> int:
    """Play a scenario in esmini, in a window where there is a screen; its exit code."""
    tell.progress("playing in esmini" if has_screen() else "playing in esmini, without a screen")
    file = scenario_file(folder, "scenario.xosc", name)
    return play(file, window=has_screen()).returncode


def take_in(name: str, content: bytes, tell: Teller) -> Source | str:
    """Read a file from the browser."""
    tell.progress(f"reading {name[-80:]}")
    return read_upload(name, content)


def warm(_: Teller) -> None:
    """Who asks for it first has everything loaded, and after an installation compiled."""
    warm_kernels()


def film(made: MadeScenario, whole: Made, tell: Teller) -> bytes:
    """The scene as found and, where a search has changed it, as it was first laid: JSON.

    The object holds ``scene``, ``before`` (or null) and ``environment``.
    """
    tell.progress("drawing the movement")
    before = None
    if made.proof is not None and made.proof.changed:
        first = whole.given or _first_timing(whole.functional, made.concrete)
        before = None if first is None else scene_of(first, made.proof, first=True)
    data = {
        "scene": scene_of(made.concrete, made.proof),
        "before": before,
        "environment": made.concrete.environment.model_dump(mode="json"),
    }
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode()


def _first_timing(
    functional: FunctionalScenario | None, found: ConcreteScenario
) -> ConcreteScenario | None:
    """What the search began from, by the same call; None if it cannot be laid any more."""
    if functional is None:
        return None
    try:
        return concretize(functional, found.logical, seed=found.seed)
    except InfeasibleError:
        return None
