"""Step 2: all logical scenarios, narrowed and chosen from."""

from collections import Counter
from html import escape
from typing import Any

from scegen.enumeration.choosing.coverage import Meeting
from scegen.enumeration.user_rules import VOCABULARY
from scegen.report.tile import TILE_WIDTH, tile_height
from scegen.scenario.glossary import meaning_of
from scegen.scenario.vocabulary import ArmsMode, Reduction
from scegen.scenario.wording import counted
from scegen.web.choice import LONGEST_RULES
from scegen.web.elements import Entry, Gallery, Handler, Rules, button, choice, drawn, mark, node
from scegen.web.steps.filters import Filters
from scegen.web.steps.step import Activity, Go, StepView
from scegen.web.work import Work

_DIVERSE = 8


class Choose(StepView):
    """The filters on the left, the tiles in the middle, coverage on the right."""

    def __init__(self, work: Work, go: Go) -> None:
        super().__init__(work, go)
        self._filters: Filters | None = None
        self._only = False
        self._told: tuple[int, bool] | None = None

    def build(self) -> None:
        """Make the elements."""
        work = self._work
        with node("div", "choose"):
            with node("section", "pane filters", aria_label="Filters"):
                node("h2", "", "Narrow")
                self._facets = node("div", "facets")
                self._expression = node("div", "expression")
                self._rules = Rules(
                    words=[{"form": w.form, "means": w.means} for w in VOCABULARY.values()],
                    longest=LONGEST_RULES,
                )
                self._rules.when(keep=lambda text: work.keep_rules(str(text)))
                node("h2", "", "Count as one")
                with node("div", "counting"):
                    _notion(
                        "reduction",
                        work.reduction,
                        lambda w: work.count_as(Reduction(w), work.arms),
                    )
                    _notion("arms", work.arms, lambda w: work.count_as(work.reduction, ArmsMode(w)))
            with node("section", "pane tiles", aria_label="Scenarios"):
                with node("div", "lead"):
                    self._title = node("h1")
                    with node("div", "row"):
                        button(
                            "All shown",
                            lambda: work.choose(work.shown),
                            "small",
                            data_tip="Choose every scenario that is shown",
                        )
                        button("None", lambda: work.choose([]), "small")
                        self._chosen_only = button("Chosen", self._turn, "small")
                        button(
                            "Pick for coverage",
                            work.choose_covering,
                            "small",
                            data_tip="The fewest that hold every meeting of those shown",
                        )
                        button(
                            f"{_DIVERSE} that differ",
                            lambda: work.choose_diverse(_DIVERSE),
                            "small",
                            data_tip="As far from one another as possible",
                        )
                        self._next = button("", lambda: self._go("danger"), "primary")
                self._certificate = node("p", "certificate soft")
                self._activity = Activity(work, "listing", "choosing")
                ratio = tile_height(work.functional) / TILE_WIDTH if work.functional else 1.2
                self._gallery = Gallery(source="/tiles", ratio=ratio)
                self._gallery.when(pick=self._pick, only=lambda index: work.choose([int(index)]))
            with node("section", "pane covered", aria_label="Coverage"):
                node("h2", "", "Coverage of the choice")
                self._coverage = node("div", "coverage")
        self.refresh({"listing", "choice"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if changed & {"listing", "choice"}:
            self._rules.show(value=self._work.rules)
            self._show_head()
            self._show_tiles()
            self._show_filters()
            if not self._work.busy("listing"):
                self._show_coverage()

    def _turn(self) -> None:
        """Show the chosen ones alone, or all again."""
        self._only = not self._only
        self._show_tiles()

    def _show_tiles(self) -> None:
        work = self._work
        self._only = self._only and bool(work.picked)
        mark(self._chosen_only, "on", on=self._only)
        self._chosen_only.props(f"aria-pressed={'true' if self._only else 'false'}")
        self._chosen_only.text = f"Chosen ({len(work.picked)})"
        shown = sorted(work.picked) if self._only else work.shown
        self._gallery.show(indices=shown, picked=work.picked, edition=work.edition)

    def _pick(self, what: dict[str, Any]) -> None:
        picked = list(self._work.picked)
        if "toggle" in what:
            index = int(what["toggle"])
            picked = [i for i in picked if i != index] if index in picked else [*picked, index]
        else:
            picked += [int(i) for i in what.get("add", [])]
        self._work.choose(picked)

    def _show_head(self) -> None:
        work, listing = self._work, self._work.listing
        chosen = len(work.picked)
        self._next.text = f"Make {chosen} dangerous" if chosen else "Choose at least one"
        self._next.props.set_bool("disabled", not chosen)
        if listing is None or listing.certificate is None:
            failed = self._work.trouble("listing") is not None
            self._title.text = "No scenarios" if failed else "Counting …"
            self._certificate.text = ""
            return
        claim = listing.certificate
        shown = f"{len(work.shown):,} shown of " if work.where else ""
        self._title.text = f"{shown}{counted(claim.count, 'scenario')}"
        parts = [counted(claim.total, "assignment"), claim.method]
        if claim.group_order:
            parts.append(f"symmetry of order {claim.group_order:,}: {claim.symmetry}")
        if listing.whole and claim.looked_at == claim.total:
            parts.append("the class sizes add up to the total")
        self._certificate.text = " · ".join([*parts, *listing.notes])
        self._certificate.props["data-tip"] = "\n".join([*parts, *listing.notes])

    def _show_filters(self) -> None:
        listing = self._work.listing
        if listing is None or self._told == (self._work.edition, listing.whole):
            if self._filters is not None:
                self._filters.refresh()
            return
        self._told = (self._work.edition, listing.whole)
        self._facets.clear()
        self._expression.clear()
        self._filters = Filters(self._work, listing, self._facets, self._expression)

    def _show_coverage(self) -> None:
        """Every possible meeting, and in how many of the chosen scenarios it happens."""
        work, listing = self._work, self._work.listing
        self._coverage.clear()
        if listing is None:
            return
        possible: Counter[Meeting] = Counter()
        chosen: Counter[Meeting] = Counter()
        picked = set(work.picked)
        for scenario in listing.scenarios:
            held = listing.met[scenario.index]
            possible.update(held)
            if scenario.index in picked:
                chosen.update(held)
        with self._coverage:
            if work.choice_note:
                node("p", "note", work.choice_note)
            covered = sum(1 for meeting in possible if chosen[meeting])
            with node("div", "tally"):
                node("span", "figure", f"{covered}")
                node("span", "", f"of {counted(len(possible), 'meeting')}")
            if not possible:
                return
            node("progress", "meter", value=covered, max=len(possible), aria_label="covered")
            rows = sorted(possible, key=lambda m: (bool(chosen[m]), -possible[m], m))
            # one element for all rows: several hundred of them would be felt at every click
            drawn("".join(_row(m, chosen[m], possible[m]) for m in rows), "meetings", "ul")


def _row(meeting: Meeting, chosen: int, possible: int) -> str:
    """A meeting as a line of the list."""
    state = "" if chosen else ' class="missing"'
    count = f'<span class="meeting-count">{chosen}/{possible}</span>'
    return f"<li{state}>{count}<span>{escape(meeting.in_words())}</span></li>"


def _notion(label: str, present: Reduction | ArmsMode, changed: Handler) -> None:
    """A choice among the words of a list, each with its definition."""
    words = type(present)
    Entry(
        present.value,
        changed,
        label=label,
        options=choice([(str(w), str(w)) for w in words]),
        tip="; ".join(f"{w}: {meaning_of(w).text}" for w in words),
    )
