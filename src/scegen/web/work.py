"""One person's work in one browser: what was understood, listed, chosen and made.

It lives on the server, so that a reload loses nothing; everything here runs in the server's loop,
long work in :mod:`scegen.web.jobs`.
"""

from dataclasses import replace
from pathlib import Path
from typing import Any

from scegen.checking.subject import FUNCTIONAL_FILE
from scegen.errors import InputError, ScegenError
from scegen.pipeline.folder import digest
from scegen.pipeline.options import Options
from scegen.pipeline.picking import pick
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import from_data, to_yaml
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet
from scegen.understanding import ParseReport, report_on
from scegen.web import tasks
from scegen.web.choice import Choice, Listing
from scegen.web.jobs import Job, Jobs
from scegen.web.made import Made, MadeScenario
from scegen.web.models import Models
from scegen.web.project import Project, changed_outside, keep
from scegen.web.provenance import carried_over, confirmed, renamed, without


class Work(Choice):
    """The state of one browser session.

    Its parts are ``text``, ``form``, ``listing``, ``choice``, ``options``, ``made``, ``watched``,
    ``pictures`` and ``step``.
    """

    def __init__(self, project: Project, jobs: Jobs, models: Models | None) -> None:
        super().__init__(jobs)
        self.project, self.models = project, models
        self.step = "describe"
        self.draft = ""
        self.report: ParseReport | None = None
        self.understood: tasks.Understood | None = None
        self.form_trouble: str | None = None
        self.options = Options()
        self.given: LogicalSet | ConcreteScenario | None = None
        self.folder: Path | None = None
        self.kept: str | None = None
        self.made: Made | None = None
        self.made_of: FunctionalScenario | None = None
        self.watched: str | None = None
        self.films: dict[str, bytes] = {}
        self.pictures: dict[str, bytes] = {}
        self.played: int | None = None

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
        new, old = self._of_form(data), self.functional
        if new is None:
            return
        if old is not None:
            evidence = carried_over(old, new)
            new = new.but(
                description=old.description, unsupported=old.unsupported, evidence=evidence
            )
        self.take(new)

    def forget(self, name: str) -> None:
        """Take out a participant, an object or an act, and whatever cannot be without it."""
        if self.functional is not None:
            self.edit(without(self.functional.model_dump(mode="json"), name))

    def rename(self, old: str, new: str) -> None:
        """Give a participant, an object or an act another name, wherever it is named."""
        if self.functional is None or new == old:
            return
        found = self._of_form(renamed(self.functional, old, new))
        if found is not None:
            self.take(found)

    def _of_form(self, data: dict[str, Any]) -> FunctionalScenario | None:
        """The functional scenario that a form holds; None, and why not, if that is none."""
        try:
            return from_data(FunctionalScenario, data, where="form")
        except ScegenError as error:
            self.form_trouble = error.message
            self._changed("form")
            return None

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
        self.understood, self.report = found, found.report
        if self.models is not None and found.usage is not None:
            self.models.spend(found.usage)
        self._begin_anew()
        if found.functional is not None:
            self.take(found.functional)
        else:
            self.functional, self.listing = None, None
            self._changed("form", "listing", "choice")
        self._changed("text")

    def _begin_anew(self) -> None:
        """What comes now has no folder and no rules yet."""
        self.folder = self.kept = None
        self.rules = ""

    def _taken_in(self, job: Job) -> None:
        self.understood = None
        self._begin_anew()
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
        about = (logical.functional, logical.reduction, logical.arms)
        self.listing = Listing(*about, logical.certificate, logical.notes, whole=True)
        self.listing.add(scenarios)
        self.shown = [s.index for s in scenarios]
        self.picked = [pick(logical, None)[0].index] if scenarios else []
        self.suggested = True
        self._changed("listing", "choice", "edition")

    def _take_concrete(self, concrete: ConcreteScenario) -> None:
        """Go on with numbers from a file: nothing is enumerated."""
        self.draft = concrete.description
        self.functional = self.report = self.listing = None
        self.given = concrete
        self.step = "danger"
        self._changed("form", "text", "listing", "choice", "step")

    def list_all(self) -> None:
        """List all logical scenarios of the functional one, whatever list was given before."""
        self.given = None
        super().list_all()

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
        named = listed and not self.suggested
        picked = ",".join(str(i) for i in self.picked) if named else None
        options = replace(self.options, pick=picked, force=True)
        if self.given is None:
            options = replace(
                options, reduction=self.reduction, arms=self.arms, rules=self.rule_file
            )
        self.cancel("making", "opening")
        self._own_folder()
        self.made_of = self.functional
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
            self._begin("filming", self._filmed, tasks.film, made, self.made)

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
        made: Made = job.result
        self._show(made)
        if self.suggested and made.scenarios:
            self.picked = [made.scenarios[0].concrete.logical.index]
            self._changed("choice")
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
        self.made_of = made.functional
        self.understood = None
        if made.functional is not None:
            self.draft = made.functional.description
            self.reduction, self.arms, self.rules = made.reduction, made.arms, made.rules
            self.kept = digest((made.folder / FUNCTIONAL_FILE).read_bytes())
            self.take(made.functional)
        elif made.scenarios:
            self._take_concrete(made.given or made.scenarios[0].concrete)
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

    @property
    def stale(self) -> bool:
        """Whether what was made is not what the form says now."""
        return self.functional is not None and self.made_of != self.functional
