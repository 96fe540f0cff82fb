"""The page of one browser window: five steps over one piece of work."""

import asyncio
from collections import Counter
from functools import partial

from nicegui import ui
from nicegui.elements.mixins.text_element import TextElement

from scegen.errors import ScegenError
from scegen.report.one_file import asset
from scegen.report.player.bundle import player_css
from scegen.report.theme import css
from scegen.scenario.wording import counted
from scegen.web.elements import button, clickable, mark, node
from scegen.web.steps.choose import Choose
from scegen.web.steps.danger import Danger
from scegen.web.steps.describe import Describe
from scegen.web.steps.opening import Opening
from scegen.web.steps.step import StepView
from scegen.web.steps.take_away import TakeAway
from scegen.web.steps.watch import Watch
from scegen.web.work import Work

_ELEMENTS = "scegen.web.elements"
_TICK_S = 0.3
"""How often the seconds of what is under way are told; changes are drawn at once."""
_STEPS: dict[str, tuple[str, type[StepView]]] = {
    "describe": ("Describe", Describe),
    "choose": ("Choose", Choose),
    "danger": ("Make dangerous", Danger),
    "watch": ("Watch", Watch),
    "take": ("Take away", TakeAway),
}
"""By name: the label and the view of each."""


class Page:
    """The frame, the step that is shown, and what is drawn again when the work has changed."""

    def __init__(self, work: Work) -> None:
        self._work = work
        self._seen: Counter[str] = Counter()
        self._step = ""
        self._view: StepView | None = None
        self._due = False
        self._marks: dict[str, tuple[TextElement, TextElement]] = {}

    def build(self) -> None:
        """Make the elements."""
        ui.add_head_html(
            f"<style>{css()}{player_css()}{asset(_ELEMENTS, 'page.css')}</style>"
            f"<script>{asset(_ELEMENTS, 'page.js')}</script>"
        )
        ui.context.client.on_exception(self._complain)
        with node("header", "topbar"):
            node("a", "brand", "ML-SceGen", href="/", aria_label="ML-SceGen, start page")
            with node("nav", "steps", aria_label="Steps"):
                for number, (name, (label, _)) in enumerate(_STEPS.items(), start=1):
                    with clickable("stepmark", partial(self.go, name)) as made:
                        node("span", "stepmark-number", str(number))
                        node("span", "stepmark-label", label)
                        self._marks[name] = (made, node("span", "stepmark-note"))
            with node("div", "topbar-end"):
                self._place = node("span", "place")
                button("Open", Opening(self._work, self.go).show, "quiet")
                node(
                    "button",
                    "button quiet round",
                    "◐",
                    type="button",
                    aria_label="Light or dark",
                    data_tip="Light or dark",
                ).on("click", js_handler="() => scegenTheme()")
        self._stage = node("main", "workspace")
        self.go(self._work.step)
        ui.timer(_TICK_S, self._tick)
        ui.context.client.on_delete(self._work.listen(self._soon))

    def _soon(self) -> None:
        """Draw when what is being done now is done, once for all that it changes."""
        if not self._due:
            self._due = True
            asyncio.get_running_loop().call_soon(self._tick)

    def go(self, step: str) -> None:
        """Show a step."""
        self._work.step = step
        if step == self._step:
            return
        self._step = step
        self._stage.clear()
        _, view = _STEPS[step]
        with self._stage:
            self._view = view(self._work, self.go)
            self._view.build()
        self._seen = Counter(self._work.revision)
        self._show_marks()

    def _tick(self) -> None:
        self._due = False
        if self._work.step != self._step:
            self.go(self._work.step)
            return
        now = self._work.revision
        changed = {part for part, count in now.items() if count != self._seen[part]}
        if self._view is not None and (changed or self._work.working):
            self._seen = Counter(now)
            with self._stage:
                self._view.refresh(changed)
            self._show_marks()

    def _show_marks(self) -> None:
        """What has come of each step, beside its name."""
        work = self._work
        notes = dict.fromkeys(self._marks, "")
        if work.functional is not None:
            notes["describe"] = counted(len(work.functional.participants), "participant")
        if work.listing is not None and work.listing.certificate is not None:
            notes["choose"] = f"{len(work.picked)} of {work.listing.certificate.count:,}"
        if work.busy("making"):
            notes["danger"] = "searching"
        made = work.made.scenarios if work.made is not None else ()
        if made:
            notes["watch"] = f"{len(made)} made"
        possible = {
            "describe": True,
            "choose": work.listing is not None,
            "danger": work.functional is not None or work.given is not None,
            "watch": bool(made),
            "take": bool(made),
        }
        for name, (shown, note) in self._marks.items():
            note.text = notes[name]
            here = name == self._step
            mark(shown, "here", on=here)
            shown.props.set_bool("disabled", not possible[name] and not here)
            shown.props.set_optional("aria-current", "step" if here else None)
        self._place.text = work.folder.name if work.folder is not None else ""

    def _complain(self, error: Exception) -> None:
        """What a click could not do, in words; anything unexpected stays on the terminal."""
        if isinstance(error, ScegenError):
            ui.notify(error.render(), type="warning", position="bottom", multi_line=True)
        else:
            ui.notify("Something went wrong; see the server's terminal.", type="negative")
