"""The grounds that two ways share, of any two: worked out once for as long as the ways are kept."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from scegen.measures.bodies import body_table
from scegen.measures.conflict_areas import area_table
from scegen.motion.model import Path
from scegen.scenario.bodies import Body


class Ground(NamedTuple):
    """Ground that two use: where either's front comes onto it and its rear is off it, m.

    One whose path ends inside is never off it (inf).
    """

    enter_m: float
    leave_m: float
    other_enters_m: float
    other_leaves_m: float


class _Ways:
    """Two paths and whose they are; the same only as the same objects: comparing takes long."""

    def __init__(self, one: Path, body: Body, other: Path, other_body: Body) -> None:
        self.paths, self.bodies = (one, other), (body, other_body)
        self.same = id(one), id(body), id(other), id(other_body)

    def __hash__(self) -> int:
        return hash(self.same)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Ways) and self.same == other.same


def grounds(one: Path, body: Body, other: Path, other_body: Body) -> tuple[Ground, ...]:
    """All grounds that two ways share, in the order of the paths (see ``conflict_areas``)."""
    return _found(_Ways(one, body, other, other_body))


@lru_cache(maxsize=512)
def _found(ways: _Ways) -> tuple[Ground, ...]:
    table = area_table(ways.paths, body_table(ways.bodies, friction=1.0), [(0, 1)])
    edges = zip(table.enter_m.tolist(), table.leave_m.tolist(), strict=True)
    return tuple(Ground(come[0], go[0], come[1], go[1]) for come, go in edges)
