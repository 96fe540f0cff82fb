"""A driver from outside in a scenario, step by step, and what it made of the danger."""

from scegen.checking.esmini.recording import Movement
from scegen.closed_loop.careful import CarefulDriver
from scegen.closed_loop.own import OwnSimulation
from scegen.closed_loop.player import PlayerSimulation, esmini_library
from scegen.closed_loop.running import Danger, Driver, Simulation, State, drive, judged

__all__ = [
    "CarefulDriver",
    "Danger",
    "Driver",
    "Movement",
    "OwnSimulation",
    "PlayerSimulation",
    "Simulation",
    "State",
    "drive",
    "esmini_library",
    "judged",
]
