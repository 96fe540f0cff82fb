"""The grounds that two ways share, of any two: worked out once for as long as the ways are kept."""

from typing import NamedTuple

from scegen.measures.bodies import body_table
from scegen.measures.conflict_areas import area_table
from scegen.measures.remembering import remembered
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


@remembered
def grounds(one: Path, body: Body, other: Path, other_body: Body) -> tuple[Ground, ...]:
    """All grounds that two ways share, in the order of the paths (see ``conflict_areas``)."""
    table = area_table((one, other), body_table((body, other_body), friction=1.0), [(0, 1)])
    edges = zip(table.enter_m.tolist(), table.leave_m.tolist(), strict=True)
    return tuple(Ground(come[0], go[0], come[1], go[1]) for come, go in edges)
