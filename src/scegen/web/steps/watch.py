"""Step 4: the scenario as it moves."""

from __future__ import annotations

from scegen.web.elements import button, node
from scegen.web.steps.step import Activity, Go
from scegen.web.work import Work


class Watch:
    """The player of the scenario that is chosen among those made."""

    def __init__(self, work: Work, go: Go) -> None:
        self._work, self._go = work, go

    def build(self) -> None:
        """Make the elements."""
        with node("div", "watch"):
            with node("div", "lead"):
                self._title = node("h1")
                button("Take away", lambda: self._go("take"), "primary")
            self._activity = Activity(self._work, "making", "looking", "opening")
            self._stage = node("div", "player-box")
        self.refresh({"made"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        made = self._work.made
        if "made" in changed and made is not None:
            self._title.text = made.folder.name
