"""Which language models are asked, whether they can be, and what they have cost."""

from __future__ import annotations

import os

from scegen.errors import InputError
from scegen.llm.keys import key_for
from scegen.web.elements import node
from scegen.web.work import Work


def model_line(work: Work) -> None:
    """One line; keys are never shown, only whether there is one."""
    settings = work.models
    with node("footer", "model"):
        if settings is None:
            node("span", "dot held")
            node("span", "", "offline reader")
            node("span", "soft", "no language model; start with --llm to ask one")
            return
        for name in settings.models:
            ready = True
            try:
                key_for(name, os.environ, url=settings.url)
            except InputError:
                ready = False
            node("span", f"dot {'held' if ready else 'failed'}")
            node("span", "", f"{name}: {'key found' if ready else 'no key in the environment'}")
        limit = settings.budget.cost_usd
        bound = f" of {limit:.2f}" if limit is not None else ""
        node("span", "soft", f"cost so far {work.cost_usd:.4f}{bound} USD")
