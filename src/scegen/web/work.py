"""One person's work in one browser: what was understood, listed, chosen and made.

It lives on the server, so that a reload loses nothing; everything here runs in the server's loop,
long work in :mod:`scegen.web.jobs`.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from scegen.enumeration.choosing.ranking import richest_first
from scegen.enumeration.choosing.where import where as where_test
from scegen.errors import InputError, ScegenError
from scegen.pipeline.folder import digest
from scegen.pipeline.options import Options
from scegen.pipeline.picking import pick
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import from_data, to_json, to_yaml
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Certificate, LogicalScenario, LogicalSet
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.understanding import ParseReport, report_on
from scegen.web import tasks
from scegen.web.jobs import Job, Jobs, JobState, Task, Trouble
from scegen.web.made import Made, MadeScenario
from scegen.web.models import Models
from scegen.web.project import FUNCTIONAL_FILE, GIVEN_FILE, Project, changed_outside, keep
from scegen.web.provenance import carried_over, confirmed, without


@dataclass
class Listing:
    """The logical scenarios, as far as they are listed."""

    functional: FunctionalScenario
    reduction: Reduction
    arms: ArmsMode
    certificate: Certificate | None = None
    notes: tuple[str, ...] = ()
    scenarios: list[LogicalScenario] = field(default_factory=list)
    whole: bool = False

    def logical(self) -> LogicalSet:
        """The set as it is in a file."""
        if self.certificate is None:
            raise InputError("nothing is listed yet")
        return LogicalSet(
            functional=self.functional,
            reduction=self.reduction,
            arms=self.arms,
            certificate=self.certificate,
            notes=self.notes,
            scenarios=tuple(self.scenarios),
        )


class Work:
    """The state of one browser session.

    ``revision`` counts the changes of each part, so that every open page can tell what to draw
    again: ``text``, ``form``, ``listing``, ``choice``, ``making``, ``made``, ``step``.
    """

    def __init__(self, project: Project, jobs: Jobs, models: Models | None) -> None:
        self.project, self.jobs, self.models = project, jobs, models
        self.revision: Counter[str] = Counter()
        self.step = "describe"
        self.draft = ""
        self.report: ParseReport | None = None
        self.understood: tasks.Understood | None = None
        self.functional: FunctionalScenario | None = None
        self.edited = False
        self.form_trouble: str | None = None
        self.reduction, self.arms = Reduction.EXACT, ArmsMode.DISTINCT
        self.listing: Listing | None = None
        self.where = ""
        self.where_trouble: str | None = None
        self.shown: list[int] = []
        self.picked: list[int] = []
        self.choice_note: str | None = None
        self.options = Options()
        self.given: LogicalSet | ConcreteScenario | None = None
        self.folder: Path | None = None
        self.kept: str | None = None
        self.made: Made | None = None
        self.made_with: Options | None = None
        self.made_of: FunctionalScenario | None = None
        self.watched: str | None = None
        self.films: dict[str, bytes] = {}
        self.pictures: dict[str, bytes] = {}
        self.played: int | None = None
        self.under_way: dict[str, Job] = {}
        self._loop = asyncio.get_running_loop()
        self._listeners: list[Callable[[], None]] = []

    # -- describing ---------------------------------------------------------------------------

    def understand(self, text: str) -> None:
        """Read a description anew; what was corrected by hand is read over."""
        self.draft = text
        self.cancel("listing", "choosing", "making")
        models = self.models.settings_of_a_run() if self.models is not None else None
        self._begin("understanding", self._understood, tasks.understand, text, models)

    def take_in(self, name: str, content: bytes) -> None:
        """Begin from a file."""
        self._begin("understanding", self._taken_in, tasks.take_in, name, content)

    def edit(self, data: dict[str, Any]) -> None:
        """Change the functional scenario to what the form says, if that is one."""
        try:
            new = from_data(FunctionalScenario, data, where="form")
        except ScegenError as error:
            self.form_trouble = error.message
            self._changed("form")
            return
        old = self.functional
        if old is not None:
            new = new.model_copy(
                update={
                    "description": old.description,
                    "evidence": carried_over(old, new),
                    "unsupported": old.unsupported,
                }
            )
        self.edited = True
        self.take(new)

    def forget(self, name: str) -> None:
        """Take out a participant, an object or an act, and whatever cannot be without it."""
        if self.functional is not None:
            self.edit(without(self.functional.model_dump(mode="json"), name))

    def confirm(self, *paths: str) -> None:
        """What was assumed of fields is meant."""
        if self.functional is not None:
            for path in paths:
                self.functional = confirmed(self.functional, path)
            self.report = report_on(self.functional)
            self._changed("form", "text")

    def take(self, functional: FunctionalScenario) -> None:
        """Go on with this functional scenario: its scenarios are listed at once."""
        self.functional, self.form_trouble, self.given = functional, None, None
        self.report = report_on(functional)
        self._changed("form", "text")
        self.list_all()

    def _understood(self, job: Job) -> None:
        found: tasks.Understood = job.result
        self.understood, self.report, self.edited = found, found.report, False
        if self.models is not None and found.usage is not None:
            self.models.spend(found.usage)
        self.folder = self.kept = None
        if found.functional is not None:
            self.take(found.functional)
        else:
            self.functional, self.listing = None, None
            self._changed("form", "listing", "choice")
        self._changed("text")

    def _taken_in(self, job: Job) -> None:
        self.understood = None
        self.folder = self.kept = None
        if isinstance(job.result, str):
            self.understand(job.result)
        elif isinstance(job.result, FunctionalScenario):
            self.draft = job.result.description
            self.take(job.result)
        elif isinstance(job.result, LogicalSet):
            self._take_listed(job.result)
        else:
            self._take_concrete(job.result)

    def _take_listed(self, logical: LogicalSet) -> None:
        """Go on with the logical scenarios of a file, and with no others."""
        self.draft = logical.functional.description
        self.reduction, self.arms = logical.reduction, logical.arms
        self.take(logical.functional)
        self.cancel("listing")
        self.given = logical
        scenarios = list(logical.scenarios)
        self.listing = Listing(
            logical.functional,
            logical.reduction,
            logical.arms,
            logical.certificate,
            logical.notes,
            scenarios,
            whole=True,
        )
        self.shown = [s.index for s in scenarios]
        self.picked = [pick(logical, None)[0].index] if scenarios else []
        self._changed("listing", "choice", "edition")

    def _take_concrete(self, concrete: ConcreteScenario) -> None:
        """Go on with numbers from a file: nothing is enumerated."""
        self.draft = concrete.description
        self.functional = self.report = self.listing = None
        self.given = concrete
        self.step = "danger"
        self._changed("form", "text", "listing", "choice", "step")

    # -- choosing -----------------------------------------------------------------------------

    def list_all(self) -> None:
        """List all logical scenarios of the functional one."""
        if self.functional is None:
            return
        self.cancel("choosing")
        self.listing = Listing(self.functional, self.reduction, self.arms)
        self.where, self.where_trouble, self.picked, self.shown = "", None, [], []
        self.choice_note = None
        self._begin(
            "listing",
            self._listed,
            tasks.enumerate_all,
            self.functional,
            self.reduction,
            self.arms,
        )
        self._changed("listing", "choice", "edition")

    def count_as(self, reduction: Reduction, arms: ArmsMode) -> None:
        """List again, under another notion of which assignments are one scenario."""
        if (reduction, arms) != (self.reduction, self.arms):
            self.reduction, self.arms = reduction, arms
            self.list_all()

    def filter(self, expression: str) -> None:
        """Show the scenarios for which an expression holds; the same language as ``--where``."""
        self.where, self.where_trouble = expression.strip(), None
        if self.listing is not None:
            try:
                self.shown = self._matching(self.listing.scenarios)
            except InputError as error:
                hint = f" {error.hint}" if error.hint else ""
                self.where_trouble = f"{error.message}.{hint}"
        self._changed("choice")

    def choose(self, indices: list[int], note: str | None = None) -> None:
        """Make these, in the order in which they were chosen; what is not listed is left out."""
        known = {s.index for s in self.listing.scenarios} if self.listing else set()
        self.picked = [i for i in dict.fromkeys(indices) if i in known]
        self.choice_note = note
        self._changed("choice")

    def choose_covering(self) -> None:
        """Choose the fewest of those shown that hold every meeting of them."""
        if self.listing is not None and self.shown:
            chosen = tuple(self.scenario(i) for i in self.shown)
            functional = self.listing.functional
            self._begin("choosing", self._chosen, tasks.cover, chosen, functional)

    def choose_diverse(self, size: int) -> None:
        """Choose so many of those shown that differ as much as possible."""
        if self.listing is not None and self.shown:
            chosen = tuple(self.scenario(i) for i in self.shown)
            functional = self.listing.functional
            self._begin("choosing", self._chosen, tasks.sample, chosen, functional, size)

    def scenario(self, index: int) -> LogicalScenario:
        """The listed scenario of this number.

        Raises:
            InputError: there is none.
        """
        listed = self.listing.scenarios if self.listing else []
        if 0 <= index < len(listed) and listed[index].index == index:
            return listed[index]
        for candidate in listed:
            if candidate.index == index:
                return candidate
        raise InputError(f"there is no scenario {index}")

    @property
    def edition(self) -> int:
        """A number that changes whenever the list begins anew."""
        return self.revision["edition"]

    def _matching(self, scenarios: list[LogicalScenario]) -> list[int]:
        if not self.where or self.listing is None:
            return [s.index for s in scenarios]
        holds = where_test(self.listing.functional, self.where)
        return [s.index for s in scenarios if holds(s)]

    def _listed(self, job: Job) -> None:
        self._take_parts(job)
        if self.listing is None:
            return
        head: LogicalSet = job.result
        self.listing.certificate, self.listing.notes = head.certificate, head.notes
        self.listing.whole = True
        if not self.picked and self.listing.scenarios:
            self.picked = [pick(self.listing.logical(), None)[0].index]
        self._changed("listing", "choice")

    def _take_parts(self, job: Job) -> None:
        """Scenarios that were handed over since the last time."""
        parts, job.parts = job.parts, []
        if self.listing is None:
            return
        for part in parts:
            if isinstance(part, Certificate):
                self.listing.certificate = part
                continue
            self.listing.scenarios.extend(part)
            self.shown.extend(self._matching(list(part)))
        if parts:
            self._changed("listing", "choice")

    def _chosen(self, job: Job) -> None:
        indices, note = job.result
        self.choose(list(indices), note)

    # -- making -------------------------------------------------------------------------------

    def set_options(self, **changes: Any) -> None:  # noqa: ANN401 - fields of Options
        """Change how scenarios are made."""
        self.options = replace(self.options, **changes)
        self._changed("options")

    def make(self) -> None:
        """Make the chosen scenarios: numbers, search, files, checks.

        Raises:
            InputError: nothing is chosen, or the folder cannot be written.
        """
        source = self.given or self.functional
        listed = self.functional is not None
        if source is None or (listed and not self.picked):
            raise InputError("choose at least one scenario first")
        picked = ",".join(str(i) for i in self.picked) if listed else None
        options = replace(self.options, pick=picked, force=True)
        if self.given is None:
            options = replace(options, reduction=self.reduction, arms=self.arms)
        self.cancel("making", "opening")
        self._own_folder()
        self.made_with, self.made_of = options, self.functional
        self._begin("making", self._finished, tasks.make, source, self.folder, options)
        self._changed("making")

    def open(self, name: str) -> None:
        """Go on with work that lies in the project, whoever made it."""
        folder = self.project.folder(name)
        self.cancel_all()
        self.folder = folder
        self._begin("opening", self._opened, tasks.look, folder)

    def watch(self, name: str) -> None:
        """Show one of the scenarios that were made."""
        made = self._made(name)
        self.watched = name
        self._changed("watched")
        if self.made is not None and name not in self.films:
            self._begin("filming", self._filmed, tasks.film_one, made, self.made.functional)

    def play(self, name: str) -> None:
        """Play one of the scenarios that were made in esmini, on the server's screen."""
        self._made(name)
        if self.made is not None:
            self.played = None
            self._begin("playing", self._played, tasks.play_one, self.made.folder, name)

    def render(self, name: str, ending: str) -> None:
        """Make a moving picture of one of the scenarios."""
        concrete = self._made(name).concrete

        def done(job: Job) -> None:
            self.pictures[f"{name}.{ending}"] = job.result
            self._changed("pictures")

        self._begin("rendering", done, tasks.render_one, concrete, ending)

    def _made(self, name: str) -> MadeScenario:
        for made in self.made.scenarios if self.made else ():
            if made.name == name:
                return made
        raise InputError("no such scenario has been made")

    def _filmed(self, job: Job) -> None:
        if self.watched is not None:
            self.films[self.watched] = job.result
            self._changed("watched")

    def _played(self, job: Job) -> None:
        self.played = int(job.result)

    def _finished(self, _: Job) -> None:
        if self.folder is not None:
            if self.functional is not None:
                self.kept = digest(to_yaml(self.functional).encode())
            self._begin("looking", self._looked, tasks.look, self.folder)

    def _looked(self, job: Job) -> None:
        self._show(job.result)
        self._changed("making")

    def _show(self, made: Made) -> None:
        """What lies in the folder now is what can be watched and taken away."""
        self.made, self.films, self.pictures, self.played = made, {}, {}, None
        self._changed("made")
        if made.scenarios:
            self.watch(made.scenarios[0].name)

    def _opened(self, job: Job) -> None:
        made: Made = job.result
        self._show(made)
        self.made_with, self.made_of = None, made.functional
        self.understood, self.edited = None, False
        if made.functional is not None:
            self.draft = made.functional.description
            self.reduction, self.arms = made.reduction, made.arms
            self.kept = digest((made.folder / FUNCTIONAL_FILE).read_bytes())
            self.take(made.functional)
        self.step = "watch" if made.scenarios else "describe"
        self._changed("made", "step")

    def _own_folder(self) -> None:
        """A folder for what is made; a new one if somebody else has written to the old one."""
        if self.folder is None or changed_outside(self.folder, self.kept):
            self.folder = self.project.new_folder(self.draft)
            self.kept = None
        if self.functional is not None:
            content = to_yaml(self.functional).encode()
            keep(self.folder, FUNCTIONAL_FILE, content)
            self.kept = digest(content)
        if self.given is not None:
            keep(self.folder, GIVEN_FILE, to_json(self.given).encode())
        else:
            (self.folder / GIVEN_FILE).unlink(missing_ok=True)

    @property
    def stale(self) -> bool:
        """Whether what was made is not what the form says now."""
        return self.functional is not None and self.made_of != self.functional

    # -- jobs ---------------------------------------------------------------------------------

    def cancel(self, *kinds: str) -> None:
        """End work that is under way."""
        for kind in kinds:
            self.jobs.cancel(self.under_way.get(kind))

    def cancel_all(self) -> None:
        """End everything that is under way."""
        self.cancel(*self.under_way)

    @property
    def working(self) -> bool:
        """Whether anything is under way."""
        return any(job.under_way for job in self.under_way.values())

    def busy(self, kind: str) -> bool:
        """Whether work of a kind is under way."""
        job = self.under_way.get(kind)
        return job is not None and job.under_way

    def trouble(self, kind: str) -> Trouble | None:
        """Why the last work of a kind failed, if it did."""
        job = self.under_way.get(kind)
        return job.trouble if job is not None and job.state is JobState.FAILED else None

    def _begin(
        self, kind: str, done: Callable[[Job], None], task: Task, *arguments: object
    ) -> None:
        self.cancel(kind)

        def told(job: Job) -> None:
            self._loop.call_soon_threadsafe(self._hear, kind, job, done)

        self.under_way[kind] = self.jobs.start(kind, told, task, *arguments)
        self._changed(kind)

    def _hear(self, kind: str, job: Job, done: Callable[[Job], None]) -> None:
        if self.under_way.get(kind) is not job:
            return  # something newer has taken its place
        if kind == "listing" and job.under_way:
            self._take_parts(job)
        if job.state is JobState.DONE and job.result is not None:
            done(job)
            job.result = None
        self._changed(kind)

    def listen(self, listener: Callable[[], None]) -> Callable[[], None]:
        """Call this after every change; returns how to stop."""
        self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    def _changed(self, *parts: str) -> None:
        self.revision.update(parts)
        for listener in self._listeners:
            listener()


def by_richness(work: Work) -> list[int]:
    """The scenarios that are shown, the richest in conflicts first."""
    if work.listing is None:
        return []
    functional = work.listing.functional
    shown = [work.scenario(i) for i in work.shown]
    return [s.index for s in sorted(shown, key=lambda s: richest_first(s, functional))]
