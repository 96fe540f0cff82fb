"""esmini's CSV log as one movement per entity."""

import csv
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

COLUMNS = ("Current_Speed", "World_Position_X", "World_Position_Y", "World_Heading_Angle")


class RecordingError(Exception):
    """The log is not what esmini 3.6 writes. Never leaves the package."""


@dataclass(frozen=True)
class Movement:
    """What an entity did, step by step; ``point`` is x + iy of its reference point.

    ``heading_rad`` is that of its body, in no particular turn.
    """

    entity: str
    time_s: NDArray[np.float64]
    point: NDArray[np.complex128]
    speed_mps: NDArray[np.float64]
    heading_rad: NDArray[np.float64]

    def when(self, step: int) -> str:
        """How findings name one of its steps."""
        return f"{self.entity} t = {self.time_s[step]:.2f} s"


def read_recording(text: str) -> list[Movement]:
    """Read the log; the rows of all entities stand side by side.

    Raises:
        RecordingError: no header, no rows, or rows that do not fit the header.
    """
    rows = [[cell.strip() for cell in row] for row in csv.reader(text.splitlines())]
    at = next((i for i, row in enumerate(rows) if row and row[0].startswith("Index")), None)
    if at is None or at + 1 >= len(rows):
        raise RecordingError("esmini logged no step")
    header, body = rows[at], rows[at + 1 :]
    width = max(len(row) for row in body)
    starts = [i for i, name in enumerate(header) if "Entity_Name" in name and i < width]
    try:
        times = np.array([float(row[1]) for row in body])
        return [_movement(header, body, times, start) for start in starts]
    except (ValueError, IndexError, StopIteration) as failure:
        raise RecordingError(f"a row of esmini's log cannot be read: {failure}") from failure


def _movement(
    header: list[str], body: list[list[str]], times: NDArray[np.float64], start: int
) -> Movement:
    speed, x, y, heading = (
        next(i for i in range(start, len(header)) if name in header[i]) for name in COLUMNS
    )
    return Movement(
        entity=body[0][start],
        time_s=times,
        point=np.array([complex(float(row[x]), float(row[y])) for row in body]),
        speed_mps=np.array([float(row[speed]) for row in body]),
        heading_rad=np.array([float(row[heading]) for row in body]),
    )
