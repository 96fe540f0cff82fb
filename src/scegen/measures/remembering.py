"""What two ways have in common is asked again and again by those who judge one scenario.

Speeds change from one candidate or trial to the next, ways hardly ever: an answer that rests on
nothing but paths, bodies and numbers is kept by their content.
"""

from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import ParamSpec, TypeVar

from scegen.motion.model import Path

P = ParamSpec("P")
R = TypeVar("R")
MOST = 512
"""Answers that are kept of each function: enough for a scenario with ten participants."""


def remembered(function: Callable[P, R]) -> Callable[P, R]:
    """The function, which gives the answer that it gave before to the same question.

    Nobody may change an answer.
    """
    kept: OrderedDict[tuple[object, ...], R] = OrderedDict()
    lock = Lock()

    @wraps(function)
    def answer(*asked: P.args, **_: P.kwargs) -> R:
        question = tuple(part.digest if isinstance(part, Path) else part for part in asked)
        with lock:
            if question in kept:
                kept.move_to_end(question)
                return kept[question]
        found = function(*asked, **_)
        with lock:
            kept[question] = found
            if len(kept) > MOST:
                kept.popitem(last=False)
        return found

    return answer
