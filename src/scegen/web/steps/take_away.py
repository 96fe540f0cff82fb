"""Step 5: files to take along, the command that makes them again, and what was checked."""

from functools import partial
from urllib.parse import quote

from scegen.checking.environment import esmini
from scegen.pipeline.command import command_line
from scegen.pipeline.folder import made_files
from scegen.pipeline.playing import has_screen
from scegen.pipeline.rendering import GIF, MP4, has_video
from scegen.report.cinema import VIDEO_HINT
from scegen.web.elements import button, node
from scegen.web.made import Made
from scegen.web.steps.outcome import outcome_cards
from scegen.web.steps.step import Activity, StepView

_COPY = "() => navigator.clipboard.writeText(document.getElementById('again').textContent)"
MODEL_SPOKE = (
    "A language model took part in this run; numbers that it proposed come again only from its "
    "recording (--llm-record, --llm-replay)."
)
_LEVELS = {
    "functional.yaml": "functional: what was understood",
    "logical.json": "logical: who enters and leaves where",
    "concrete.yaml": "concrete: every number",
    "proof.json": "proof: every statement and danger",
    "road.xodr": "OpenDRIVE",
    "scenario.xosc": "OpenSCENARIO",
    "scenario-esmini.xosc": "the same with lights that esmini shows",
    "preview.png": "picture",
    "report.html": "report, opens offline",
    "gallery.svg": "all logical scenarios",
    "summary.json": "what was made, with digests",
    "given.json": "the numbers that the search began from",
    "rules.lp": "the rules that the scenarios keep",
}


class TakeAway(StepView):
    """Downloads on the left, what was checked on the right."""

    def build(self) -> None:
        """Make the elements."""
        with node("div", "take"):
            with node("section", "pane", aria_label="Files"):
                self._files = node("div", "files")
            with node("section", "pane results", aria_label="Checks"):
                node("h2", "", "What was checked")
                self._activity = Activity(self._work, "making", "looking", "playing", "rendering")
                self._doings = node("div", "doings")
                self._cards = node("div", "cards")
        self.refresh({"made"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if changed & {"made", "pictures", "playing"}:
            self._show_doings()
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

    def _show_doings(self) -> None:
        """For each scenario: pictures that move, and the reference player."""
        work = self._work
        self._doings.clear()
        with self._doings:
            for made in work.made.scenarios if work.made else ():
                with node("div", "doing"):
                    node("span", "name", made.name)
                    for ending in (GIF, MP4) if has_video() else (GIF,):
                        self._picture(made.name, ending)
                    if esmini() is not None:
                        button(
                            "Play in esmini",
                            partial(work.play, made.name),
                            "small",
                            data_tip=None if has_screen() else "No screen here: without a window",
                        )
            if not has_video():
                node("p", "note", f"MP4 needs imageio-ffmpeg: {VIDEO_HINT}")
            if work.played is not None:
                said = f"ended with exit code {work.played}" if work.played else "played to its end"
                node("p", "note", f"esmini: {said}")

    def _picture(self, name: str, ending: str) -> None:
        file = f"{name}.{ending}"
        if file in self._work.pictures:
            address = f"/download/picture?name={quote(file)}"
            node("a", "button small", f"Save {ending.upper()}", href=address, download=file)
            return
        button(f"Make {ending.upper()}", lambda: self._work.render(name, ending), "small")

    def _build_files(self, made: Made) -> None:
        node("h1", "", "Take it away")
        file = f"{made.folder.name}.zip"
        node("a", "button primary wide", f"Download {file}", href="/download/zip", download=file)
        node("p", "soft", f"In the project folder: {made.folder.name}/")
        command = command_line(made.summary, "again")
        if command is not None:
            node("h2", "", "The same files again, byte for byte")
            with node("div", "command"):
                node("code", "", command, id="again")
                node("button", "button small", "Copy", type="button").on("click", js_handler=_COPY)
            if "llm" in made.summary:
                node("p", "note", MODEL_SPOKE)
        node("h2", "", "Files")
        names = sorted(made_files(made.folder), key=lambda name: (name.count("/"), name))
        with node("ul", "file-list"):
            for name in [*names, "summary.json"]:
                with node("li", ""):
                    node("a", "", name, href=f"/download/file?name={name}", download=True)
                    node("span", "soft", _LEVELS.get(name.rsplit("/", 1)[-1], ""))
