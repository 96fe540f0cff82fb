"""Which language models are asked, whether they can be, and what they have cost."""

from __future__ import annotations

from scegen.web.elements import node
from scegen.web.work import Work


def model_line(work: Work) -> None:
    """One line; keys are never shown, only whether there is one."""
    models = work.models
    with node("footer", "model"):
        if models is None:
            node("span", "dot held")
            node("span", "", "offline reader")
            node("span", "soft", "no language model; start with --llm to ask one")
            return
        for name, has_key in models.keys().items():
            node("span", f"dot {'held' if has_key else 'failed'}")
            node("span", "", f"{name}: {'key found' if has_key else 'no key in the environment'}")
        limit = models.settings.budget.cost_usd
        bound = "" if limit is None else f", of at most {limit:.2f} USD"
        node("span", "soft", f"so far {models.used.in_words()}{bound}")
