"""The parameter agent: a language model proposes the numbers, the offline rules if it cannot.

The only place of criticality that asks language models.
"""

from scegen.criticality.agent.agent import ParameterAgent

__all__ = ["ParameterAgent"]
