"""From a functional scenario to every distinct logical scenario, by answer set programming."""

from scegen.enumeration.enumerate import (
    Listing,
    count_scenarios,
    enumerate_scenarios,
    iterate_scenarios,
    open_listing,
)
from scegen.enumeration.plain import plain_crossing
from scegen.enumeration.ruled import MAX_LISTED

__all__ = [
    "MAX_LISTED",
    "Listing",
    "count_scenarios",
    "enumerate_scenarios",
    "iterate_scenarios",
    "open_listing",
    "plain_crossing",
]
