"""What every step of the page is."""

from collections.abc import Callable, Sequence

from scegen.web.elements import Form, button, node, tell
from scegen.web.form import form_spec, standings
from scegen.web.jobs import JobState
from scegen.web.pictures import PAGE
from scegen.web.work import Work

Go = Callable[[str], None]
"""Shows another step, by name."""


class StepView:
    """A step while it is shown; ``go`` shows another one."""

    def __init__(self, work: Work, go: Go) -> None:
        self._work, self._go = work, go

    def build(self) -> None:
        """Make its elements in the present slot."""
        raise NotImplementedError

    def refresh(self, changed: set[str]) -> None:
        """Draw again what has changed, by the parts of the work's revision."""
        raise NotImplementedError


def form_of(work: Work, sections: Sequence[str]) -> Form:
    """A form of these sections, in which the work is changed."""
    form = Form(spec=form_spec(), sections=sections)
    form.when(
        edit=work.edit,
        rename=lambda names: work.rename(*names),
        forget=work.forget,
        confirm=work.confirm,
    )
    return form


def show_form(form: Form, work: Work) -> None:
    """Put the functional scenario into a form, which is there if that is."""
    functional = work.functional
    form.set_visibility(functional is not None)
    if functional is not None:
        form.show(
            scenario=functional.model_dump(mode="json"),
            standings=standings(work.report),
            colours=PAGE.colours((p.id for p in functional.participants), functional.ego.id),
            wrong=work.form_trouble,
        )


class Activity:
    """A line that says what is being done, how long it has taken, and lets it be cancelled.

    Of the ``kinds`` of jobs that it tells of, the one to be told first comes first.
    """

    def __init__(self, work: Work, *kinds: str) -> None:
        self._work, self._kinds = work, kinds
        with node("div", "activity", role="status", aria_live="polite") as self._line:
            node("span", "spinner")
            self._text = node("span", "activity-text")
            button("Cancel", self._cancel, "small")
        self._problem = node("div", "problem", role="alert")
        self.refresh()

    def refresh(self) -> None:
        """Say what is under way now."""
        jobs = [self._work.under_way.get(kind) for kind in self._kinds]
        job = next((job for job in jobs if job is not None and job.under_way), None)
        self._line.set_visibility(job is not None)
        if job is not None:
            step = job.steps[-1].text if job.steps else "waiting"
            waiting = job.state is JobState.WAITING
            said = "waiting for its turn" if waiting else step
            self._text.text = f"{said} · {job.seconds:.0f} s"
        troubles = [self._work.trouble(kind) for kind in self._kinds]
        wrong = [t.render() for t in troubles if t is not None]
        tell(self._problem, wrong[0] if wrong else None)

    def _cancel(self) -> None:
        self._work.cancel(*self._kinds)
        self.refresh()
