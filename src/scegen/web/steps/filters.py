"""Filters as chips: each writes a part of the expression that ``--where`` takes too."""

from collections import Counter
from dataclasses import dataclass
from functools import partial

from nicegui.element import Element

from scegen.scenario.logical import Drive, LogicalScenario
from scegen.web.choice import Listing
from scegen.web.elements import Entry, clickable, mark, node, tell
from scegen.web.work import Work


@dataclass(frozen=True, slots=True)
class Facet:
    """A group of values of which any may hold.

    ``terms`` holds the condition of each value, ``found`` counts the scenarios of each.
    """

    label: str
    terms: dict[str, str]
    found: Counter[str]


class Filters:
    """The facets of one listing and the expression that they add up to."""

    def __init__(self, work: Work, listing: Listing, facets: Element, expression: Element) -> None:
        self._work = work
        self._facets = facets_of(listing)
        self._on: set[tuple[str, str]] = set()
        self._chips: dict[tuple[str, str], Element] = {}
        names = {p.id for p in listing.functional.participants}
        with facets:
            for facet in self._facets:
                self._build(facet, names)
        with expression:
            self._entry = Entry(
                work.where,
                self._typed,
                label="where",
                hint="conflicts(crossing) >= 2",
                wide=True,
                tip="Any expression of --where; the chips above write it",
            )
            self._trouble = node("div", "problem", role="alert")
        self.refresh()

    def refresh(self) -> None:
        """Show the expression and what is wrong with it."""
        self._entry.show(value=self._work.where, wrong=self._work.where_trouble is not None)
        tell(self._trouble, self._work.where_trouble)

    def _build(self, facet: Facet, names: set[str]) -> None:
        with node("div", "facet"):
            node("span", "facet-label", facet.label)
            with node("span", "chips"):
                for value, term in facet.terms.items():
                    key = (facet.label, term)
                    toggle = partial(self._toggle, key)
                    with clickable("tag", toggle, aria_pressed="false") as chip:
                        node("span", "", value if value in names else value.replace("_", " "))
                        node("span", "tag-count", f"{facet.found[value]}")
                    self._chips[key] = chip

    def _toggle(self, key: tuple[str, str]) -> None:
        self._on ^= {key}
        self._mark()
        self._work.filter(self._written())

    def _typed(self, text: str) -> None:
        """An expression of one's own takes the place of the chips."""
        self._on.clear()
        self._mark()
        self._work.filter(str(text or ""))

    def _mark(self) -> None:
        for key, chip in self._chips.items():
            on = key in self._on
            mark(chip, "on", on=on)
            chip.props["aria-pressed"] = "true" if on else "false"

    def _written(self) -> str:
        parts = []
        for facet in self._facets:
            chosen = [t for t in facet.terms.values() if (facet.label, t) in self._on]
            if chosen:
                either = " or ".join(chosen)
                parts.append(f"({either})" if len(chosen) > 1 else either)
        return " and ".join(parts)


def facets_of(listing: Listing) -> list[Facet]:
    """What the scenarios of a listing differ in: turns, meetings, and who gives way."""
    functional, scenarios = listing.functional, listing.scenarios
    names = [p.id for p in functional.participants]
    facets = [_turns(name, scenarios) for name in names]
    kinds: Counter[str] = Counter()
    yielding: Counter[str] = Counter()
    for scenario in scenarios:
        kinds.update({c.kind.value for c in scenario.conflicts})
        yielding.update({c.yields for c in scenario.conflicts if c.yields})
    facets.append(Facet("conflicts", {k: f"conflicts({k}) >= 1" for k in sorted(kinds)}, kinds))
    facets.append(Facet("gives way", {n: f"yields({n})" for n in names if yielding[n]}, yielding))
    stuck = sum(bool(s.deadlock) for s in scenarios)
    facets.append(Facet("deadlock", {"possible": "deadlock"}, Counter({"possible": stuck})))
    every = len(scenarios)
    return [f for f in facets if len(f.terms) > 1 or 0 < f.found.total() < every]


def _turns(name: str, scenarios: list[LogicalScenario]) -> Facet:
    found: Counter[str] = Counter()
    for scenario in scenarios:
        assignment = scenario.assignment(name)
        if isinstance(assignment, Drive):
            found[assignment.turn.value] += 1
    return Facet(name, {turn: f"{name}.turn == {turn}" for turn in sorted(found)}, found)
