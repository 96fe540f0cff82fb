"""What can be opened: work in the project folder, and files from this computer."""

from collections.abc import Callable

from nicegui import ui
from nicegui.events import UploadEventArguments

from scegen.web.elements import button, clickable, node
from scegen.web.project import Entry
from scegen.web.steps.step import Go
from scegen.web.uploads import LARGEST_FILE
from scegen.web.work import Work


class Opening:
    """A dialogue with the project's folders and a way to bring a file."""

    def __init__(self, work: Work, go: Go) -> None:
        self._work, self._go = work, go
        self._dialog = ui.dialog().classes("opening")

    def show(self) -> None:
        """Open it, with what lies in the folder now."""
        self._dialog.clear()
        with self._dialog, node("div", "sheet"):
            with node("div", "sheet-head"):
                node("h2", "", "Open")
                button("×", self._dialog.close, "quiet round", aria_label="Close")
            upload = ui.upload(
                on_upload=self._taken,
                on_rejected=lambda: ui.notify(
                    f"Files of at most {LARGEST_FILE / 1e6:.0f} MB are taken.", type="warning"
                ),
                max_file_size=LARGEST_FILE,
                max_files=1,
                auto_upload=True,
            ).classes("upload")
            button(
                "A file of this computer …",
                lambda: upload.run_method("pickFiles"),
                "secondary wide",
                data_tip="functional.yaml, logical.json, concrete.yaml, a text, or a zip from here",
            )
            entries = self._work.project.entries()
            node("p", "soft", f"Project folder {self._work.project.root.name}")
            if not entries:
                node("p", "empty", "Nothing has been made in this folder yet.")
            with node("ul", "entries"):
                for entry in entries:
                    with node("li", ""):
                        entry_row(entry, self._open)
        self._dialog.open()

    def _open(self, name: str) -> None:
        self._dialog.close()
        self._work.open(name)
        self._go("describe")

    async def _taken(self, event: UploadEventArguments) -> None:
        content = await event.file.read()
        self._dialog.close()
        self._work.take_in(event.file.name, content)
        self._go("describe")


def entry_row(entry: Entry, chosen: Callable[[str], object]) -> None:
    """One folder of the project, to be clicked."""
    with clickable("entry-open", lambda: chosen(entry.name)):
        node("strong", "", entry.name)
        node("span", "", entry.description)
        node("span", "soft", f"{entry.scenarios} made" if entry.scenarios else "not made yet")
