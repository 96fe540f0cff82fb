"""How dangerous a scenario is, and a search that makes its dangers happen and proves it."""

from scegen.criticality.proposals.offline import OfflineProposer
from scegen.criticality.proposals.proposal import Proposal, Proposed, Proposer, Situation
from scegen.criticality.raising.raising import Raised, prove_as_it_is, raise_criticality

__all__ = [
    "OfflineProposer",
    "Proposal",
    "Proposed",
    "Proposer",
    "Raised",
    "Situation",
    "prove_as_it_is",
    "raise_criticality",
]
