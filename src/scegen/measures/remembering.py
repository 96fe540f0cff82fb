"""What two ways have in common is asked again and again by those who judge one scenario.

Speeds change from one candidate or trial to the next, ways hardly ever: an answer that rests on
nothing but two paths and two bodies is kept by their content.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import TypeVar

from scegen.measures.bodies import Body
from scegen.motion.model import Path

R = TypeVar("R")
MOST = 512
"""Answers that are kept of each function: enough for a scenario with ten participants."""


def remembered(
    function: Callable[[Path, Path, Body, Body], R],
) -> Callable[[Path, Path, Body, Body], R]:
    """The function, which gives the answer that it gave before to the same question.

    Nobody may change an answer.
    """
    kept: OrderedDict[tuple[bytes, bytes, Body, Body], R] = OrderedDict()
    lock = Lock()

    @wraps(function)
    def answer(first: Path, second: Path, a: Body, b: Body) -> R:
        question = (first.digest, second.digest, a, b)
        with lock:
            if question in kept:
                kept.move_to_end(question)
                return kept[question]
        found = function(first, second, a, b)
        with lock:
            kept[question] = found
            if len(kept) > MOST:
                kept.popitem(last=False)
        return found

    return answer
