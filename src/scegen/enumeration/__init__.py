"""From a functional scenario to every distinct logical scenario, by answer set programming."""

from scegen.enumeration.enumerate import (
    MAX_LISTED,
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
)
from scegen.enumeration.plain import plain_crossing

__all__ = [
    "MAX_LISTED",
    "count_scenarios",
    "enumerate_scenarios",
    "iterate_scenarios",
    "plain_crossing",
]
