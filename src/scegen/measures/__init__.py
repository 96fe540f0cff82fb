"""Surrogate measures of how critical a movement is, and the bodies and ways that they look at.

One measure a file; ``registry`` lists them as data. Each says what it measures, in which unit,
which direction is worse, after whom and where it holds; it has a kernel for one moment, one for
the worst over time, and one over whole batches. ``build_tables`` prepares what depends on paths and
bodies only; ``evaluate`` simulates and measures candidates, ``measure`` measures movements that
exist.
"""

from scegen.measures.evaluation import Summary, evaluate, measure
from scegen.measures.registry import MEASURES, Measure, Subject, measure_named
from scegen.measures.tables import Tables, build_tables
from scegen.measures.warming import warm_kernels

__all__ = [
    "MEASURES",
    "Measure",
    "Subject",
    "Summary",
    "Tables",
    "build_tables",
    "evaluate",
    "measure",
    "measure_named",
    "warm_kernels",
]
