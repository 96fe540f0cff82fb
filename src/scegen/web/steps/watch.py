"""Step 4: the scenario as it moves, and what the ego's driver sees."""

from functools import partial
from urllib.parse import quote

from scegen.report.player.bundle import ENTRY
from scegen.web.elements import Cinema, button, clickable, dotted, node
from scegen.web.steps.step import Activity, StepView


class Watch(StepView):
    """The player of the scenario that is chosen among those made."""

    def build(self) -> None:
        """Make the elements."""
        with node("div", "watch"):
            with node("div", "lead"):
                self._tabs = node("div", "tabs", role="tablist", aria_label="Scenarios")
                button("Take away", lambda: self._go("take"), "primary")
            self._activity = Activity(self._work, "making", "looking", "opening", "filming")
            self._cinema = Cinema(script=f"/player/{ENTRY}")
        self.refresh({"made", "watched"})

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed."""
        self._activity.refresh()
        if not changed & {"made", "watched"}:
            return
        work = self._work
        self._tabs.clear()
        with self._tabs:
            for made in work.made.scenarios if work.made else ():
                here = made.name == work.watched
                with clickable(
                    "tag on" if here else "tag",
                    partial(work.watch, made.name),
                    role="tab",
                    aria_selected="true" if here else "false",
                ):
                    dotted(made.state, made.name)
        ready = work.watched if work.watched in work.films else None
        source = f"/film?name={quote(ready)}&edition={work.revision['made']}" if ready else ""
        self._cinema.show(source=source)
