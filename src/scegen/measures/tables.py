"""All that the measures know beside the movements: bodies, pairs, lanes shared, conflict areas."""

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from scegen.measures.bodies import body_table
from scegen.measures.conflict_areas import AreaTable, area_table
from scegen.measures.following import FollowTable, follow_table
from scegen.motion.batch.arrays import Floats, Ints
from scegen.motion.model import Path
from scegen.scenario.bodies import Body


class Tables(NamedTuple):
    """Made once per scenario; candidates share it, because they share the paths.

    ``bodies`` (participant, field of ``Body``); ``pairs`` (p, 2) are the indices of the
    participants measured against each other; ``occlusions`` (q, 3) are observer, target and
    occluder.
    """

    bodies: Floats
    pairs: Ints
    following: FollowTable
    areas: AreaTable
    occlusions: Ints


def build_tables(
    paths: Sequence[Path],
    bodies: Sequence[Body],
    *,
    pairs: Sequence[tuple[int, int]] | None = None,
    others: Sequence[tuple[int, int]] = (),
    occlusions: Sequence[tuple[int, int, int]] = (),
    friction: float = 1.0,
) -> Tables:
    """The scene of participants with these paths and bodies.

    ``paths`` are in the order of the program, ``bodies`` one each. ``pairs`` are measured against
    each other, everybody against everybody if None; of ``others`` only distance and contact are
    asked, because where lanes are shared and ways cross takes long. Of ``occlusions`` (observer,
    target, occluder) it is asked whether the last hides the second. ``friction`` is the coefficient
    between tyre and road; 1 on dry asphalt.
    """
    table = body_table(bodies, friction=friction)
    chosen = list(combinations(range(len(paths)), 2)) if pairs is None else list(pairs)
    following, areas = follow_table(paths, table, chosen), area_table(paths, table, chosen)
    nowhere = np.full((len(others), 2), -1, dtype=np.int64)
    return Tables(
        bodies=table,
        pairs=np.array([*chosen, *others], dtype=np.int64).reshape(-1, 2),
        following=following._replace(first=np.vstack([following.first, nowhere])),
        areas=areas._replace(first=np.append(areas.first, np.full(len(others), areas.first[-1]))),
        occlusions=np.array(list(occlusions), dtype=np.int64).reshape(-1, 3),
    )
