"""How alike two scenarios are, and how critical one is: numbers between 0 and 1.

Distance is Gower's (Biometrics 27, 1971): the mean, over all features, of how far two values lie
apart: of words 0 or 1, of numbers the difference as a share of the range of all rows. Where one of
two has no value it counts as far as can be; where neither has one, as alike.

Criticality asks for two things at once, as each alone misleads (at crossings a small time to
collision is often one of two who miss each other by far): that they close in, by time to collision
or the braking it takes, and that they come near, by post-encroachment time or distance. It is the
mean of both; a contact is 1. Each measure is scaled by the usual threshold (see the files of
``scegen.measures``): TTC 1.5 s, DRAC 3.4 m/s², PET 1 s, and a distance of 1 m.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scegen.campaign.rows import Row
from scegen.enumeration.choosing.sampling import Codes, codes_of
from scegen.motion.batch.arrays import Floats

WORDS = ("junction", "arms", "control", "kinds", "movements", "seen", "conflict", "right_of_way",
         "hazards", "avoidable")  # fmt: skip
NUMBERS = ("participants", "ego_speed_mps", "other_speed_mps",
           "pet_s", "distance_m", "ttc_s", "headway_s", "drac_mps2", "impact_mps")  # fmt: skip
CRITICAL_TTC_S, CRITICAL_PET_S, CRITICAL_DISTANCE_M, CRITICAL_DRAC_MPS2 = 1.5, 1.0, 1.0, 3.4
NEARLY_THE_SAME = 0.005
"""Scenarios with the same words and numbers that differ by less, on the mean, are one."""


@dataclass(frozen=True)
class Features:
    """Rows as numbers: ``words`` (n, w) codes, ``numbers`` (n, m) in shares of their ranges."""

    words: Codes
    numbers: Floats

    @classmethod
    def of(cls, rows: Sequence[Row]) -> Features:
        """The features of some rows."""
        told = ([row[name] for name in WORDS] for row in rows)
        words = codes_of([tuple(v) if isinstance(v, list) else v for v in row] for row in told)
        columns = []
        for name in NUMBERS:
            values = numbers_of(rows, name)
            known = values[np.isfinite(values)]
            span = float(np.ptp(known)) if len(known) else 0.0
            columns.append((values - known.min()) / span if span > 0.0 else values * 0.0)
        return cls(words, np.column_stack(columns))

    def distances(self, row: int) -> Floats:
        """From one row to all (n,)."""
        apart = np.abs(self.numbers - self.numbers[row])
        mine, theirs = np.isfinite(self.numbers[row]), np.isfinite(self.numbers)
        apart = np.where(mine & theirs, apart, np.where(mine ^ theirs, 1.0, 0.0))
        differ = (self.words != self.words[row]).sum(axis=1)
        features = self.words.shape[1] + self.numbers.shape[1]
        total: Floats = (differ + apart.sum(axis=1)) / features
        return total

    def most_different(self, count: int, first: int) -> list[int]:
        """Rows, each as far as can be from all before it, from ``first`` on."""
        chosen, near = [first], self.distances(first)
        while len(chosen) < min(count, len(near)):
            chosen.append(int(near.argmax()))
            near = np.minimum(near, self.distances(chosen[-1]))
        return chosen

    def alike(self) -> list[list[int]]:
        """Groups of rows that are nearly the same as the first of them, largest first."""
        same_words: dict[bytes, list[int]] = {}
        for row, codes in enumerate(self.words):
            same_words.setdefault(codes.tobytes(), []).append(row)
        groups = []
        for rows in same_words.values():
            left = np.array(rows)
            part = Features(self.words[left], self.numbers[left])
            free = np.ones(len(left), dtype=np.bool_)
            for place in range(len(left)):
                if not free[place]:
                    continue
                near = free & (part.distances(place) < NEARLY_THE_SAME)
                free &= ~near
                if near.sum() > 1:
                    groups.append([int(row) for row in left[near]])
        return sorted(groups, key=lambda group: (-len(group), group))


def criticality(rows: Sequence[Row]) -> Floats:
    """How critical every row is (n,), from 0 to 1."""
    ttc, pet = numbers_of(rows, "ttc_s"), numbers_of(rows, "pet_s")
    closing = np.fmax(
        np.exp(-ttc / CRITICAL_TTC_S),
        1.0 - np.exp(-numbers_of(rows, "drac_mps2") / CRITICAL_DRAC_MPS2),
    )
    near = np.fmax(
        np.exp(-np.maximum(pet, 0.0) / CRITICAL_PET_S),
        np.exp(-numbers_of(rows, "distance_m") / CRITICAL_DISTANCE_M),
    )
    score = (np.nan_to_num(closing) + np.nan_to_num(near)) / 2
    return np.where(np.isfinite(numbers_of(rows, "contact_s")), 1.0, score)


def numbers_of(rows: Sequence[Row], column: str) -> Floats:
    """A column as numbers; nan where there is none."""
    return np.array([row[column] for row in rows], dtype=np.float64)
