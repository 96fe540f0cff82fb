"""From a functional scenario to every distinct logical scenario, by answer set programming."""

from scegen.enumeration.enumerate import (
    LIST_LIMIT,
    Listing,
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    open_listing,
)
from scegen.enumeration.plain import plain_crossing

__all__ = [
    "LIST_LIMIT",
    "Listing",
    "count_scenarios",
    "enumerate_scenarios",
    "iterate_scenarios",
    "open_listing",
    "plain_crossing",
]
