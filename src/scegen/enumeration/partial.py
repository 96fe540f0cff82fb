"""Participants next to each other in the description, and what they do: parts of many scenarios.

A listing runs through its last participants while the first stay as they are. So scenarios are
joined from two parts, and what one has to say, alone or against another's share, is said once.
"""

from __future__ import annotations

from itertools import chain

from scegen.enumeration.sharing import Kept, Share
from scegen.scenario.logical import Assignment, Conflict
from scegen.scenario.parameters import ParameterRange


class PartialScenario:
    """The shares of some participants.

    ``met`` are their conflicts with one who is listed before all of them, ``offsets`` their
    arrivals against the ego, ``line`` those who may be in a deadlock.
    """

    __slots__ = ("assignments", "line", "met", "offsets", "pairs", "rows", "shares", "speeds")

    def __init__(self, shares: tuple[Share, ...]) -> None:
        self.shares = shares
        self.assignments: tuple[Assignment, ...] = tuple([share.assignment for share in shares])
        self.speeds = tuple([share.speed for share in shares if share.speed is not None])
        self.line = tuple([share for share in shares if share.may_be_stuck])
        self.rows = [_met(first, shares[place:]) for place, first in enumerate(shares, start=1)]
        self.pairs = tuple(chain.from_iterable(self.rows))
        self.met: Kept[Share, tuple[Conflict, ...]] = Kept(lambda first: _met(first, shares))
        self.offsets: Kept[Share, tuple[ParameterRange, ...]] = Kept(self._offsets)

    def conflicts_before(self, back: PartialScenario) -> tuple[Conflict, ...]:
        """All pairs whose paths meet, here and in the part behind, by first and by second."""
        found: list[Conflict] = []
        met = back.met
        for share, row in zip(self.shares, self.rows, strict=True):
            found += row
            found += met[share]
        found += back.pairs
        return tuple(found)

    def _offsets(self, ego: Share) -> tuple[ParameterRange, ...]:
        offsets = [ego.offsets[share] for share in self.shares if share is not ego]
        return tuple([offset for offset in offsets if offset is not None])


def _met(first: Share, others: tuple[Share, ...]) -> tuple[Conflict, ...]:
    conflicts = first.conflicts
    return tuple([found for other in others if (found := conflicts[other]) is not None])
