"""Step 1: the description, what was understood, and the form to correct it."""

import json
from collections.abc import Iterable
from typing import Any

from scegen.report.evidence import STANDS_FOR
from scegen.scenario.wording import counted
from scegen.understanding import MAX_CHARACTERS, Finding, Standing, passages
from scegen.web.elements import Description, button, dotted, drawn, mark, node, tell
from scegen.web.pictures import junction, tile_picture
from scegen.web.steps.opening import entry_row
from scegen.web.steps.step import Activity, StepView, form_of, show_form
from scegen.web.work import Work

_SECTIONS = ("participants", "acts", "spacings", "hazards", "outcome", "objects", "junction",
             "environment", "relations", "groups")  # fmt: skip
EXAMPLES = {
    "Left turn": "The ego turns left at a four-way intersection while an oncoming truck goes "
    "straight and a pedestrian crosses the road it turns into.",
    "Hard braking": "The ego follows a car at 100 km/h with a headway of 1.5 s. The car brakes "
    "with 5 m/s2 to 40 km/h.",
    "Hidden child": "A child runs out from behind a parked van, 20 m ahead of the ego, which "
    "drives 30 km/h.",
    "Red light": "At a four-way intersection with traffic lights, a van from the right runs the "
    "red light as the ego goes straight at 50 km/h.",
    "Every way": "Four cars meet at an uncontrolled four-way intersection.",
}
_PROMISE = (
    "One sentence becomes every distinct traffic scenario that it can mean, and moving traffic in "
    "OpenDRIVE and OpenSCENARIO, in which every statement of it is checked."
)
_RECENT = 4


class Describe(StepView):
    """The text on the left, the form in the middle, the plan on the right."""

    def build(self) -> None:
        """Make the elements."""
        with node("div", "describe") as self._whole:
            with node("section", "pane words", aria_label="Description"):
                node("h1", "", "Describe a driving situation")
                node("p", "promise", _PROMISE)
                self._text = Description(
                    longest=MAX_CHARACTERS,
                    placeholder="In plain English: who drives where, what happens, how fast.",
                )
                self._text.when(draft=self._draft, submit=self._work.understand)
                with node("div", "row"):
                    self._button = node("button", "button primary", "Understand", type="button")
                    self._button.on(
                        "click", js_handler=f"() => getElement({self._text.id}).submit()"
                    )
                    node("span", "hint", "Ctrl + Enter")
                self._activity = Activity(self._work, "understanding", "opening", "looking")
                self._examples = node("div", "examples-list")
                self._recent = node("div", "recent")
                self._found = node("div", "found")
                self._model = node("div", "model-box")
            with node("section", "pane fields", aria_label="What was understood"):
                self._form = form_of(self._work, _SECTIONS)
                self._wrong = node("div", "problem", role="alert")
            with node("section", "pane plan", aria_label="Plan"):
                self._plan = node("div", "plan-box")
        self._build_examples()
        self._show_all()

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if changed & {"text", "form"}:
            self._show_all()
        elif changed & {"listing", "choice"}:
            self._show_plan()

    def _draft(self, text: str) -> None:
        self._work.draft = text[:MAX_CHARACTERS]

    def _build_examples(self) -> None:
        with self._examples:
            for name, text in EXAMPLES.items():
                with node("button", "tag example", type="button", data_tip=text) as example:
                    node("strong", "", name)
                    node("span", "", text)
                example.on(
                    "click", js_handler=f"() => getElement({self._text.id}).put({json.dumps(text)})"
                )
        entries = self._work.project.entries()[:_RECENT]
        if entries:
            with self._recent:
                node("h2", "", "Go on with")
                for entry in entries:
                    entry_row(entry, self._work.open)

    def _show_all(self) -> None:
        work = self._work
        self._text.show(value=work.draft, spans=_spans(work))
        blank = work.functional is None and work.report is None
        mark(self._whole, "blank", on=blank)
        mark(self._button, "secondary", on=work.functional is not None)
        self._show_found()
        self._model.clear()
        with self._model:
            model_line(self._work)
        show_form(self._form, work)
        tell(self._wrong, work.form_trouble)
        self._show_plan()

    def _show_found(self) -> None:
        """Counts by standing, then what needs a look: assumptions, contradictions, the rest."""
        self._found.clear()
        report, understood = self._work.report, self._work.understood
        if report is None:
            return
        with self._found:
            if understood is not None and understood.trouble is not None:
                node("div", "problem", understood.trouble, role="alert")
            if understood is not None and self._work.models is not None:
                node("p", "note", f"understood by {understood.speaker}")
            with node("ul", "legend"):
                for standing in Standing:
                    count = len(report.of(standing))
                    if count:
                        with node("li", "", data_tip=STANDS_FOR[standing]):
                            dotted(standing, f"{count} {standing}")
            for standing in (Standing.CONTRADICTED, Standing.UNSUPPORTED):
                for finding in report.of(standing):
                    with node("div", "remark"):
                        words = f"“{finding.words}” " if finding.words else ""
                        dotted(standing, f"{words}{finding.reason or standing}")
            assumed = report.of(Standing.ASSUMED)
            if assumed:
                with node("details", "assumptions", open=True):
                    node("summary", "", counted(len(assumed), "assumption"))
                    for alike in _alike(assumed):
                        self._assumption(alike)
            for note in understood.notes if understood else ():
                node("p", "note", note)

    def _assumption(self, alike: list[Finding]) -> None:
        paths = [finding.field or "" for finding in alike]
        who, what = _named(paths)
        first = alike[0]
        with node("div", "remark"):
            button(
                "✓",
                lambda: self._work.confirm(*paths),
                "small round",
                aria_label=f"Confirm {', '.join(paths)}",
                data_tip="Right so: it counts as meant",
            )
            with node("div", ""):
                node("span", "", f"{who} › {what}{f' = {first.value}' if first.value else ''} ")
                node("span", "soft", first.reason or "")

    def _show_plan(self) -> None:
        work = self._work
        self._plan.clear()
        listing = work.listing
        with self._plan:
            if listing is None or work.functional is None:
                node("p", "empty", "Here the junction appears, with everybody's way.")
                return
            trouble = work.trouble("listing")
            if trouble is not None:
                node("div", "problem", trouble.render(), role="alert")
                drawn(junction(work.functional), "paper")
                return
            certificate = listing.certificate
            if certificate is None:
                node("p", "empty", "counting …")
                return
            with node("div", "tally"):
                figure, what = counted(certificate.count, "distinct scenario").split(maxsplit=1)
                node("span", "figure", figure)
                node("span", "", what)
            node("p", "soft", f"of {counted(certificate.total, 'assignment')}")
            button("See them all", lambda: self._go("choose"), "primary wide")
            picture = junction(work.functional)
            if (richest := work.richest()) is not None:
                picture = tile_picture(richest, listing.functional)
            drawn(picture, "paper")


def _alike(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Findings that say the same of several participants, together."""
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for finding in findings:
        head, *rest = (finding.field or "").split(".")
        what = ".".join(rest[1:]) if head == "participants" else finding.field
        groups.setdefault((head, what, finding.value, finding.reason), []).append(finding)
    return list(groups.values())


def _named(paths: list[str]) -> tuple[str, str]:
    """Whom some paths of fields are about, and which field it is, in words."""
    parts = [path.split(".") for path in paths]
    if parts[0][0] == "participants" and len(parts[0]) > 2:
        return ", ".join(p[1] for p in parts), " › ".join(parts[0][2:]).replace("_", " ")
    return parts[0][0], " › ".join(parts[0][1:]).replace("_", " ")


def _spans(work: Work) -> list[dict[str, Any]]:
    """The description cut where its standing changes."""
    if work.report is None or work.report.text != work.draft:
        return []
    return [
        {
            "text": work.report.text[s.start : s.end],
            "kind": s.standing.value if s.standing else "",
            "fields": [f.field for f in s.findings if f.field],
            "tip": "\n".join(dict.fromkeys(_told(f) for f in s.findings)),
        }
        for s in passages(work.report)
    ]


def _told(finding: Finding) -> str:
    """What came of words, in a line."""
    field = (finding.field or "").replace("_", " ").replace(".", " › ")
    value = f"{field} = {finding.value}" if finding.value else field
    return ": ".join(part for part in (finding.standing, value, finding.reason or "") if part)


def model_line(work: Work) -> None:
    """Which models are asked, and what they have cost; of keys only whether there is one."""
    models = work.models
    with node("footer", "model"):
        if models is None:
            dotted("held", "offline reader")
            node("span", "soft", "no language model; start with --llm to ask one")
            return
        for name, has_key in models.keys().items():
            found = "key found" if has_key else "no key in the environment"
            dotted("held" if has_key else "failed", f"{name}: {found}")
        limit = models.settings.budget.cost_usd
        bound = "" if limit is None else f", of at most {limit:.2f} USD"
        node("span", "soft", f"so far {models.used.in_words()}{bound}")
