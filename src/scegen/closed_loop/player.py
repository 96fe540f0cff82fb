"""esmini's library as a simulation: the scenario file is played, the ego is reported to it.

The file must leave the ego to the outside (``scegen generate --ego external``): it is placed by
Init and has no event of its own. In every step its pose and speed are reported first, which keeps
esmini from moving it, and then the others move. Triggers that look at the ego's place or speed
thus see it one step earlier than in our own simulation; those that look at how far it has come do
not. The library knows one scenario at a time.
"""

import ctypes
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.closed_loop.running import State
from scegen.errors import InputError, MissingToolError
from scegen.motion.trigger_steps import STEP_S

LIBRARY_VARIABLE = "SCEGEN_ESMINI_LIBRARY"
"""Names the file of esmini's library, instead of looking for it beside esmini."""
_NAMES = ("libesminiLib.so", "libesminiLib.dylib", "esminiLib.dll")
_SUCCESS = 0


def esmini_library() -> Path | None:
    """The file of esmini's library: the one that is named, else one near the esmini on PATH."""
    named = os.environ.get(LIBRARY_VARIABLE)
    if named:
        return Path(named) if Path(named).is_file() else None
    player = esmini()
    if player is None:
        return None
    folders = [player.parent, player.resolve().parent]
    places = [place for folder in folders for place in (folder, folder.parent / "lib")]
    found = (place / name for place in places for name in _NAMES)
    return next((path for path in found if path.is_file()), None)


class _State(ctypes.Structure):
    """The beginning of esmini's ``SE_ScenarioObjectState``; the rest is not looked at."""

    _fields_ = (
        ("id", ctypes.c_int),
        ("model_id", ctypes.c_int),
        ("controller", ctypes.c_int),
        ("timestamp", ctypes.c_double),
        ("x", ctypes.c_double),
        ("y", ctypes.c_double),
        ("z", ctypes.c_double),
        ("h", ctypes.c_double),
        ("p", ctypes.c_double),
        ("r", ctypes.c_double),
        ("road", ctypes.c_uint32),
        ("junction", ctypes.c_uint32),
        ("t", ctypes.c_double),
        ("lane", ctypes.c_int),
        ("offset", ctypes.c_double),
        ("s", ctypes.c_double),
        ("speed", ctypes.c_double),
        ("rest", ctypes.c_char * 512),
    )


class PlayerSimulation:
    """Plays a scenario file through esmini's library.

    Args:
        scenario: the file.
        ego: id of the entity that is driven from outside.
        dt_s: time step.

    Raises:
        MissingToolError: the library is not there.
        InputError: esmini does not take the file, or knows no such entity.
    """

    def __init__(self, scenario: Path, ego: str, dt_s: float = STEP_S) -> None:
        found = esmini_library()
        if found is None:
            raise MissingToolError(
                "esmini's library is not beside the esmini on PATH",
                where=LIBRARY_VARIABLE,
                hint=f"name libesminiLib in {LIBRARY_VARIABLE}, or {ESMINI_HINT}",
            )
        self.dt_s = dt_s
        self._steps = 0
        self._library = _loaded(found)
        self._log = tempfile.TemporaryDirectory(prefix="scegen-esmini-")
        self._library.SE_SetLogFilePath(str(Path(self._log.name, "log.txt")).encode())
        if self._library.SE_Init(str(scenario.absolute()).encode(), 0, 0, 0, 0) != _SUCCESS:
            self.close()
            raise InputError("esmini does not play the file", where=str(scenario))
        self._ids = self._named()
        if ego not in self._ids:
            self.close()
            raise InputError(f"has no entity {ego!r}", where=str(scenario))
        self._ego = self._ids[ego]

    @property
    def time_s(self) -> float:
        """The present time."""
        return self._steps * self.dt_s

    @property
    def states(self) -> Mapping[str, State]:
        """Everybody at the present time."""
        return {name: self._state(number) for name, number in self._ids.items()}

    def step(self, ego: State) -> None:
        """Go one step on."""
        self._library.SE_ReportObjectPosXYH(self._ego, ego.x_m, ego.y_m, ego.heading_rad)
        self._library.SE_ReportObjectSpeed(self._ego, ego.speed_mps)
        self._library.SE_StepDT(self.dt_s)
        self._steps += 1

    def close(self) -> None:
        """End the play; another can begin."""
        self._library.SE_Close()
        self._log.cleanup()

    def _named(self) -> dict[str, int]:
        numbers = [self._library.SE_GetId(n) for n in range(self._library.SE_GetNumberOfObjects())]
        return {self._library.SE_GetObjectName(n).decode(): n for n in numbers}

    def _state(self, number: int) -> State:
        state = _State()
        self._library.SE_GetObjectState(number, ctypes.byref(state))
        return State(state.x, state.y, state.h, state.speed)


def _loaded(path: Path) -> ctypes.CDLL:
    library = ctypes.CDLL(str(path))
    real, text, number = ctypes.c_double, ctypes.c_char_p, ctypes.c_int
    library.SE_SetLogFilePath.argtypes = [text]
    library.SE_Init.argtypes = [text, number, number, number, number]
    library.SE_StepDT.argtypes = [real]
    library.SE_ReportObjectPosXYH.argtypes = [number, real, real, real]
    library.SE_ReportObjectSpeed.argtypes = [number, real]
    library.SE_GetObjectName.argtypes = [number]
    library.SE_GetObjectName.restype = text
    library.SE_LogToConsole.argtypes = [ctypes.c_bool]
    library.SE_LogToConsole(False)
    return library
