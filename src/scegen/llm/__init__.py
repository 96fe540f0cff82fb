"""Language models of any provider: one string names one; every request is bounded and recorded.

Needs the extra ``llm``. This package imports without it; :func:`require_llm` says how to get it.
"""

from scegen.llm.budget import Budget
from scegen.llm.extra import INSTALL_LLM, require_llm
from scegen.llm.faults import Fault, FaultKind, LlmError
from scegen.llm.naming import PROVIDERS, ModelName, parse_models
from scegen.llm.session import Session
from scegen.llm.settings import Limits, LlmSettings
from scegen.llm.usage import Usage

__all__ = [
    "INSTALL_LLM",
    "PROVIDERS",
    "Budget",
    "Fault",
    "FaultKind",
    "Limits",
    "LlmError",
    "LlmSettings",
    "ModelName",
    "Session",
    "Usage",
    "parse_models",
    "require_llm",
]
