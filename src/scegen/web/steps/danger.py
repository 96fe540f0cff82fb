"""Step 3: what is to happen, the search for it, and what it found."""

import re
from collections.abc import Sequence
from enum import StrEnum
from functools import partial
from typing import Any

from scegen.criticality.target import AVOIDED, BANDS, COLLISION, NEAR_MISS
from scegen.measures.registry import measure_named
from scegen.pipeline.options import CheckDepth, EgoMode, OscVersion
from scegen.pipeline.raising import NO_SEARCH
from scegen.scenario.wording import counted
from scegen.web.elements import Entry, button, choice, clickable, drawn, mark, node
from scegen.web.jobs import Step
from scegen.web.pictures import tile_picture
from scegen.web.steps.outcome import outcome_cards
from scegen.web.steps.step import Activity, StepView, form_of, show_form

_TARGETS = {
    "": ("As described", "what the text tells, else a near miss where one can be"),
    NEAR_MISS: ("Near miss", "as close as in a serious conflict, and nobody touches"),
    COLLISION: ("Collision", "the pair touches"),
    AVOIDED: ("Avoided", "nobody touches anybody"),
    "band": ("A measure", "in a band of your own"),
    NO_SEARCH: ("No search", "the first numbers that keep what was said"),
}
_USUAL = {
    "pet": (0.3, 1.0),
    "ttc": (0.5, 1.5),
    "distance": (0.2, 1.0),
    "headway": (0.3, 0.8),
    "drac": (3.0, 6.0),
}
_CHOICES: tuple[tuple[str, type[StrEnum], str, str | None], ...] = (
    ("osc", OscVersion, "OpenSCENARIO", None),
    ("ego", EgoMode, "ego", "external: your own driver steers the ego"),
    ("depth", CheckDepth, "checks", "full adds the ASAM checkers; none leaves all out"),
)
"""Options that are one of some words: name, words, label and tip."""
_BAND = re.compile(r"([a-z]+)=(.+)\.\.(.+)")
_NUMBERS = re.compile(r"[0-9.,]+")
_MOST_TILES, _MOST_STEPS = 24, 12


class Danger(StepView):
    """The demands on the left, the chosen scenarios and what came of them on the right."""

    def build(self) -> None:
        """Make the elements."""
        work = self._work
        with node("div", "danger"):
            with node("section", "pane demands", aria_label="Target and hazards"):
                node("h1", "", "Make it dangerous")
                self._targets = node("div", "targets", role="radiogroup", aria_label="Target")
                self._band = node("div", "band-box")
                self._hazards = form_of(work, ("hazards", "outcome"))
                with node("details", "more-options"):
                    node("summary", "", "Files and search")
                    self._more()
            with node("section", "pane results", aria_label="Search"):
                with node("div", "lead"):
                    self._title = node("h1")
                    with node("div", "row"):
                        self._watch = button("Watch", lambda: self._go("watch"), "primary")
                        self._make = button("Search", work.make, "primary")
                self._activity = Activity(work, "making", "looking")
                self._steps = node("ol", "log", aria_label="Progress")
                self._chosen = node("div", "strip")
                self._results = node("div", "cards")
        self.refresh({"form", "options", "choice", "made", "making"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if changed & {"options"}:
            self._show_targets()
        if changed & {"form"}:
            show_form(self._hazards, self._work)
        if changed & {"choice", "listing"}:
            self._show_chosen()
        if changed & {"making", "looking", "choice", "listing", "made", "form"}:
            self._show_head()
            self._show_log()
        if changed & {"made", "form", "choice"}:
            self._results.clear()
            with self._results:
                outcome_cards(self._work)

    def _show_targets(self) -> None:
        target = self._work.options.target or ""
        kind = "band" if "=" in target else target
        self._targets.clear()
        with self._targets:
            for word, (label, told) in _TARGETS.items():
                here = word == kind
                with clickable(
                    "target on" if here else "target",
                    partial(self._aim, word),
                    role="radio",
                    aria_checked="true" if here else "false",
                ):
                    node("strong", "", label)
                    node("span", "soft", told)
        self._band.clear()
        match = _BAND.fullmatch(target)
        self._band.set_visibility(match is not None)
        if match is None:
            return
        measure, low, high = match.groups()
        with self._band:
            Entry(
                measure,
                lambda word: self._set_band(str(word), *_USUAL[str(word)]),
                label="measure",
                options=choice([(name, name.upper() if len(name) < 5 else name) for name in BANDS]),
            )
            least, most = BANDS[measure]
            unit = measure_named(measure).unit.replace("s2", "s²")
            ends = {"kind": "number", "unit": unit, "min": least, "max": most, "step": "any"}
            Entry(low, lambda v: self._set_band(measure, v, high), label="from", **ends)
            Entry(high, lambda v: self._set_band(measure, low, v), label="to", **ends)

    def _set_word(self, option: str, words: type[StrEnum], value: str) -> None:
        self._work.set_options(**{option: words(value)})

    def _aim(self, word: str) -> None:
        if word == "band":
            self._set_band("pet", *_USUAL["pet"])
        else:
            self._work.set_options(target=word or None)

    def _set_band(self, measure: str, low: Any, high: Any) -> None:  # noqa: ANN401 - as typed
        self._work.set_options(target=f"{measure}={float(low):g}..{float(high):g}")

    def _more(self) -> None:
        work, options = self._work, self._work.options
        with node("div", "grid"):
            Entry(
                options.seed,
                lambda v: work.set_options(seed=_whole(v, 0)),
                kind="number",
                label="seed",
                min=0,
                step=1,
                tip="The same seed gives the same bytes",
            )
            Entry(
                options.solutions,
                lambda v: work.set_options(solutions=max(1, _whole(v, 1))),
                kind="number",
                label="solutions",
                min=1,
                max=20,
                step=1,
                tip="Different ways to reach the target",
            )
            for name, words, label, tip in _CHOICES:
                Entry(
                    getattr(options, name).value,
                    partial(self._set_word, name, words),
                    label=label,
                    options=choice([(word.value, word.value) for word in words]),
                    tip=tip,
                )

    def _show_chosen(self) -> None:
        work = self._work
        self._chosen.clear()
        if work.listing is None:
            return
        with self._chosen:
            for index in work.picked[:_MOST_TILES]:
                one = work.listing.scenario(index)
                drawn(tile_picture(one, work.listing.functional), "paper small")
            if len(work.picked) > _MOST_TILES:
                node("p", "soft", f"and {len(work.picked) - _MOST_TILES} more")

    def _show_head(self) -> None:
        work = self._work
        busy = work.busy("making") or work.busy("looking")
        ready = work.given is not None or bool(work.picked)
        count = len(work.picked)
        fresh = work.made is not None and bool(work.made.scenarios) and not work.stale
        self._title.text = counted(count, "scenario") if count else "Given numbers"
        self._make.text = "Search again" if fresh else "Search"
        self._make.props.set_bool("disabled", busy or not ready)
        mark(self._make, "secondary", on=fresh)
        self._watch.set_visibility(fresh and not busy)
        self._chosen.set_visibility(not fresh or busy)
        self._results.set_visibility(not busy)

    def _show_log(self) -> None:
        job = self._work.under_way.get("making")
        self._steps.clear()
        if job is None or not job.under_way:
            return
        with self._steps:
            for step in told_once(job.steps)[-_MOST_STEPS:]:
                with node("li", ""):
                    node("span", "log-time", f"{step.after_s:5.1f} s")
                    node("span", "", step.text)


def told_once(steps: Sequence[Step]) -> list[Step]:
    """Of steps that follow one another and differ in numbers alone, the last."""
    kept: list[Step] = []
    for step in steps:
        alike = kept and _NUMBERS.sub("", kept[-1].text) == _NUMBERS.sub("", step.text)
        kept[-1:] = [step] if alike else [*kept[-1:], step]
    return kept


def _whole(value: Any, otherwise: int) -> int:  # noqa: ANN401 - as typed
    return int(value) if isinstance(value, int | float) and value >= 0 else otherwise
