"""Understanding by language models: agents for the parts, a reviewer, and the offline reader.

Imports without the extra ``llm``; :func:`understand` needs it.
"""

from scegen.understanding.agents.result import (
    READER,
    Disagreement,
    Kept,
    Objection,
    Part,
    Understanding,
)
from scegen.understanding.agents.understand import understand, understand_in

__all__ = [
    "READER",
    "Disagreement",
    "Kept",
    "Objection",
    "Part",
    "Understanding",
    "understand",
    "understand_in",
]
