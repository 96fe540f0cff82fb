"""Whose work is whose: one for each browser, found by its cookie."""

from collections import OrderedDict
from collections.abc import Callable

from scegen.web.work import Work

MOST_SESSIONS = 100
"""Beyond so many, the work that was left longest ago is forgotten (what it made stays on disk)."""


class Sessions:
    """The work of all browsers, begun for a new one."""

    def __init__(self, begin: Callable[[], Work]) -> None:
        self._begin = begin
        self._works: OrderedDict[str, Work] = OrderedDict()

    def of(self, session: str) -> Work:
        """The work of a browser; begun if there is none yet."""
        if session not in self._works:
            self._works[session] = self._begin()
        self._works.move_to_end(session)
        while len(self._works) > MOST_SESSIONS:
            idle = next((key for key, work in self._works.items() if not work.working), None)
            self._works.pop(idle or next(iter(self._works))).cancel_all()
        return self._works[session]

    def known(self, session: str) -> Work | None:
        """The work of a browser, if there is any."""
        return self._works.get(session)
