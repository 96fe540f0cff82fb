"""Step 5: files to take along, the command that makes them again, and what was checked."""

from __future__ import annotations

from scegen.pipeline.command import command_line
from scegen.web.elements import node
from scegen.web.made import Made
from scegen.web.project import made_files
from scegen.web.steps.outcome import outcome_cards
from scegen.web.steps.step import Activity, Go
from scegen.web.work import Work

_COPY = "() => navigator.clipboard.writeText(document.getElementById('again').textContent)"
_LEVELS = {
    "functional.yaml": "functional: what was understood",
    "logical.json": "logical: who enters and leaves where",
    "concrete.yaml": "concrete: every number",
    "proof.json": "proof: every statement and danger",
    "road.xodr": "OpenDRIVE",
    "scenario.xosc": "OpenSCENARIO",
    "preview.png": "picture",
    "report.html": "report, opens offline",
    "gallery.svg": "all logical scenarios",
    "summary.json": "what was made, with digests",
}


class TakeAway:
    """Downloads on the left, what was checked on the right."""

    def __init__(self, work: Work, go: Go) -> None:
        self._work, self._go = work, go

    def build(self) -> None:
        """Make the elements."""
        with node("div", "take"):
            with node("section", "pane", aria_label="Files"):
                self._files = node("div", "files")
            with node("section", "pane results", aria_label="Checks"):
                node("h2", "", "What was checked")
                self._activity = Activity(self._work, "making", "looking", "playing")
                self._cards = node("div", "cards")
        self.refresh({"made"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if "made" not in changed:
            return
        self._files.clear()
        self._cards.clear()
        made = self._work.made
        if made is None:
            return
        with self._files:
            self._build_files(made)
        with self._cards:
            outcome_cards(self._work)

    def _build_files(self, made: Made) -> None:
        node("h1", "", "Take it away")
        node("a", "button primary wide", f"Download {made.folder.name}.zip", href="/download/zip",
             download=f"{made.folder.name}.zip")  # fmt: skip
        node("p", "soft", f"In the project folder: {made.folder.name}/")
        node("h2", "", "The same files again, byte for byte")
        with node("div", "command"):
            node("code", "", again(self._work), id="again")
            node("button", "button small", "Copy", type="button").on("click", js_handler=_COPY)
        node("h2", "", "Files")
        names = sorted(made_files(made.folder), key=lambda name: (name.count("/"), name))
        with node("ul", "file-list"):
            for name in [*names, "summary.json"]:
                with node("li", ""):
                    node("a", "", name, href=f"/download/file?name={name}", download=True)
                    node("span", "soft", _LEVELS.get(name.rsplit("/", 1)[-1], ""))


def again(work: Work) -> str:
    """The command that makes these files again, to be run beside the functional scenario."""
    if work.made is None:
        return ""
    options = work.made_with or work.made.options()
    source = "functional.yaml" if work.made.functional is not None else "concrete.yaml"
    return command_line(options, source, "again")
