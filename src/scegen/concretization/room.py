"""How concretization says to itself that the arms must be longer."""

from __future__ import annotations


class NeedsLongerArms(Exception):  # noqa: N818 - a signal between two parts, not an error
    """The arms are ``metres`` too short for the plan; caught by ``concretize``."""

    def __init__(self, metres: float, who: str) -> None:
        self.metres = metres
        self.who = who
        super().__init__(f"{who} needs {metres:.0f} m more")
