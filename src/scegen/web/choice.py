"""The logical scenarios of a piece of work: listed as they are found, narrowed, chosen from."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from scegen.enumeration.choosing.coverage import Meeting, meetings
from scegen.enumeration.choosing.ranking import richest_first
from scegen.enumeration.choosing.where import where as where_test
from scegen.errors import InputError
from scegen.pipeline.picking import pick
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import Certificate, LogicalScenario, LogicalSet
from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.web import tasks
from scegen.web.jobs import Job, Jobs, Task
from scegen.web.undertakings import Undertakings

LONGEST_RULES = 20_000
"""Characters."""


@dataclass
class Listing:
    """The logical scenarios, as far as they are listed; ``met`` is who meets whom in each."""

    functional: FunctionalScenario
    reduction: Reduction
    arms: ArmsMode
    certificate: Certificate | None = None
    notes: tuple[str, ...] = ()
    scenarios: list[LogicalScenario] = field(default_factory=list)
    whole: bool = False
    _by_index: dict[int, LogicalScenario] = field(default_factory=dict)
    met: dict[int, frozenset[Meeting]] = field(default_factory=dict)

    def add(self, scenarios: Iterable[LogicalScenario]) -> None:
        """Take in more; who meets whom in them is worked out now, not when it is looked at."""
        for scenario in scenarios:
            self.scenarios.append(scenario)
            self._by_index.setdefault(scenario.index, scenario)
            self.met[scenario.index] = meetings(self.functional, scenario)

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

    def scenario(self, index: int) -> LogicalScenario:
        """The scenario of this number.

        Raises:
            InputError: there is none.
        """
        if index not in self._by_index:
            raise InputError(f"there is no scenario {index}")
        return self._by_index[index]

    def known(self, indices: Iterable[int]) -> list[LogicalScenario]:
        """The scenarios of these numbers, without those that are not listed (yet, or any more)."""
        return [self._by_index[index] for index in indices if index in self._by_index]

    def matching(self, where: str, scenarios: Iterable[LogicalScenario]) -> list[int]:
        """The numbers of those for which an expression holds; of all if it is empty.

        Raises:
            InputError: it is no expression.
        """
        holds = where_test(self.functional, where) if where else None
        return [s.index for s in scenarios if holds is None or holds(s)]


class Choice(Undertakings):
    """The functional scenario, all its logical ones, and which of them are chosen.

    ``suggested``: nobody has chosen; what is marked is what is tried first, and another may be
    made if it shows better what was said.
    """

    def __init__(self, jobs: Jobs) -> None:
        super().__init__(jobs)
        self.functional: FunctionalScenario | None = None
        self.reduction, self.arms = Reduction.EXACT, ArmsMode.DISTINCT
        self.rules = ""
        self.listing: Listing | None = None
        self.where = ""
        self.where_trouble: str | None = None
        self.shown: list[int] = []
        self.picked: list[int] = []
        self.suggested = False
        self.choice_note: str | None = None

    def list_all(self) -> None:
        """List all logical scenarios of the functional one."""
        if self.functional is None:
            return
        self.cancel("choosing")
        self.listing = Listing(self.functional, self.reduction, self.arms)
        self.where, self.where_trouble, self.picked, self.shown = "", None, [], []
        self.choice_note, self.suggested = None, False
        self._begin(
            "listing",
            self._listed,
            tasks.enumerate_all,
            self.functional,
            self.reduction,
            self.arms,
            self.rule_file,
            partly=self._take_parts,
        )
        self._changed("listing", "choice", "edition")

    def count_as(self, reduction: Reduction, arms: ArmsMode) -> None:
        """List again, under another notion of which assignments are one scenario."""
        if (reduction, arms) != (self.reduction, self.arms):
            self.reduction, self.arms = reduction, arms
            self.list_all()

    def keep_rules(self, text: str) -> None:
        """List again, only what keeps these rules; the same language as ``--rules``.

        Raises:
            InputError: they are too long.
        """
        if len(text) > LONGEST_RULES:
            raise InputError(f"rules of more than {LONGEST_RULES:,} characters are not taken")
        if text.strip() != self.rules:
            self.rules = text.strip()
            self.list_all()

    @property
    def rule_file(self) -> RuleFile | None:
        """The rules that every scenario is to keep, if there are any."""
        return RuleFile(f"{self.rules}\n") if self.rules else None

    def filter(self, expression: str) -> None:
        """Show the scenarios for which an expression holds; the same language as ``--where``."""
        self.where, self.where_trouble = expression.strip(), None
        if self.listing is not None:
            try:
                self.shown = self.listing.matching(self.where, self.listing.scenarios)
            except InputError as error:
                hint = f" {error.hint}" if error.hint else ""
                self.where_trouble = f"{error.message}.{hint}"
        self._changed("choice")

    def choose(self, indices: list[int], note: str | None = None) -> None:
        """Make these, in the order in which they were chosen; what is not listed is left out."""
        known = {s.index for s in self.listing.scenarios} if self.listing else set()
        self.picked = [i for i in dict.fromkeys(indices) if i in known]
        self.choice_note, self.suggested = note, False
        self._changed("choice")

    def choose_covering(self) -> None:
        """Choose the fewest of those shown that hold every meeting of them."""
        self._choose_by(tasks.cover)

    def choose_diverse(self, size: int) -> None:
        """Choose so many of those shown that differ as much as possible."""
        self._choose_by(tasks.sample, size)

    def _choose_by(self, task: Task, *more: object) -> None:
        if self.listing is not None and self.shown:
            shown = tuple(self.listing.scenario(i) for i in self.shown)
            self._begin("choosing", self._chosen, task, shown, self.listing.functional, *more)

    @property
    def edition(self) -> int:
        """A number that changes whenever the list begins anew."""
        return self.revision["edition"]

    def _listed(self, job: Job) -> None:
        if self.listing is None:
            return
        head: LogicalSet = job.result
        self.listing.certificate, self.listing.notes = head.certificate, head.notes
        self.listing.whole = True
        if not self.picked and self.listing.scenarios:
            self.picked = [pick(self.listing.logical(), None)[0].index]
            self.suggested = True
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
            self.listing.add(part)
            where = "" if self.where_trouble else self.where
            self.shown.extend(self.listing.matching(where, part))
        if parts:
            self._changed("listing", "choice")

    def _chosen(self, job: Job) -> None:
        indices, note = job.result
        self.choose(list(indices), note)

    def richest(self) -> LogicalScenario | None:
        """The first that is chosen, or of those shown the richest in conflicts."""
        if self.listing is None:
            return None
        functional = self.listing.functional
        shown = self.listing.known(self.picked[:1] or self.shown)
        return min(shown, key=lambda s: richest_first(s, functional), default=None)
