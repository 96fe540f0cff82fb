"""Labels of a film: each keeps to one side of what it names and gives way where two would meet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scegen.motion.model import Array
from scegen.report.drawing import letters
from scegen.report.raster import text_width
from scegen.report.theme import Theme

_SIZE, _HEIGHT, _APART = 12.5, 17.0, 5.0
_SIDES = ((0.0, -1.0), (0.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0),
          (1.0, 0.0), (-1.0, 0.0))  # fmt: skip
_ON_LABEL, _ON_BODY, _OUTSIDE = 4.0, 1.0, 2.0


@dataclass(frozen=True)
class MovingLabels:
    """For each name, the rectangle of its label in every picture (pictures, 4), and if shown.

    Rectangles are left, top, right, bottom in pixels; the ego's label always has its way.
    """

    where: Mapping[str, Array]
    shown: Mapping[str, NDArray[np.bool_]]
    ego: str

    @classmethod
    def arranged(
        cls, words: Mapping[str, str], boxes: Mapping[str, Array], size: tuple[int, int], ego: str
    ) -> MovingLabels:
        """A side for each label, so that the fewest pictures have labels in each other's way.

        ``words`` are the longest that each label will say, the most telling first; ``boxes``
        (pictures, 4) what they name, as in :class:`MovingLabels`. The ego's label is bold.
        """
        where: dict[str, Array] = {}
        shown: dict[str, NDArray[np.bool_]] = {}
        for name, longest in words.items():
            width = text_width(longest, _SIZE, bold=name == ego)
            options = [_beside(boxes[name], width, side) for side in _SIDES]
            costs = [
                sum(_ON_LABEL * _meet(option, other).sum() for other in where.values())
                + sum(_ON_BODY * _meet(option, at).sum() for at in boxes.values())
                + _OUTSIDE * _leaves(option, size).sum()
                for option in options
            ]
            best = options[int(np.argmin(costs))]
            free = ~_leaves(best, size)
            for other, taken in where.items():
                free &= ~(_meet(best, taken) & shown[other])
            where[name], shown[name] = best, free
        return cls(where, shown, ego)

    def drawn(self, number: int, words: Mapping[str, str], theme: Theme) -> str:
        """The labels of one picture."""
        parts, ink, rim = [], theme.text, theme.halo
        for name, rectangles in self.where.items():
            if not self.shown[name][number]:
                continue
            left, _, right, bottom = rectangles[number].tolist()
            x, y, bold = (left + right) / 2, bottom - 4.5, name == self.ego
            parts.append(
                letters(words[name], x, y, _SIZE, ink, bold=bold, halo=rim, text_anchor="middle")
            )
        return "".join(parts)


def _beside(boxes: Array, width: float, side: tuple[float, float]) -> Array:
    x, y = (boxes[:, 0] + boxes[:, 2]) / 2, (boxes[:, 1] + boxes[:, 3]) / 2
    wide, high = boxes[:, 2] - boxes[:, 0], boxes[:, 3] - boxes[:, 1]
    x = x + side[0] * ((wide + width) / 2 + _APART)
    y = y + side[1] * ((high + _HEIGHT) / 2 + _APART - 2.0 * abs(side[0]))
    half, rise = width / 2, _HEIGHT / 2
    return np.column_stack((x - half, y - rise, x + half, y + rise))


def _meet(a: Array, b: Array) -> NDArray[np.bool_]:
    met: NDArray[np.bool_] = np.all((a[:, :2] < b[:, 2:]) & (b[:, :2] < a[:, 2:]), axis=1)
    return met


def _leaves(a: Array, size: tuple[int, int]) -> NDArray[np.bool_]:
    left: NDArray[np.bool_] = np.any((a[:, :2] < 0) | (a[:, 2:] > size), axis=1)
    return left
