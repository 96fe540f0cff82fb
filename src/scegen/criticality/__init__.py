"""How critical a movement is: measures, and their evaluation for thousands of candidates.

``build_scene`` prepares what depends on paths and bodies only; ``evaluate`` simulates and
measures candidates, ``measure`` measures movements that exist.
"""

from scegen.criticality.evaluation import Summary, evaluate, measure
from scegen.criticality.measures.registry import MEASURES, Measure, Subject, Worse, measure_named
from scegen.criticality.scene import Scene, build_scene
from scegen.criticality.warming import warm_kernels

__all__ = [
    "MEASURES",
    "Measure",
    "Scene",
    "Subject",
    "Summary",
    "Worse",
    "build_scene",
    "evaluate",
    "measure",
    "measure_named",
    "warm_kernels",
]
