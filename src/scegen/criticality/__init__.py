"""How critical a movement is: measures, their evaluation for thousands of candidates, a search.

``raise_criticality`` makes the dangers of a scenario happen and proves it. ``build_scene``
prepares what depends on paths and bodies only; ``evaluate`` simulates and measures candidates,
``measure`` measures movements that exist.
"""

from scegen.criticality.evaluation import Summary, evaluate, measure
from scegen.criticality.measures.registry import MEASURES, Measure, Subject, Worse, measure_named
from scegen.criticality.proposals.offline import OfflineProposer
from scegen.criticality.proposals.proposal import Proposal, Proposed, Proposer, Situation
from scegen.criticality.scene import Scene, build_scene
from scegen.criticality.search.raising import Raised, raise_criticality
from scegen.criticality.warming import warm_kernels

__all__ = [
    "MEASURES",
    "Measure",
    "OfflineProposer",
    "Proposal",
    "Proposed",
    "Proposer",
    "Raised",
    "Scene",
    "Situation",
    "Subject",
    "Summary",
    "Worse",
    "build_scene",
    "evaluate",
    "measure",
    "measure_named",
    "raise_criticality",
    "warm_kernels",
]
