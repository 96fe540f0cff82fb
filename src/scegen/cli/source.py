"""The functional scenario that an argument names or tells."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scegen.errors import InputError

if TYPE_CHECKING:
    from scegen.cli.llm import Listener
    from scegen.scenario.functional import FunctionalScenario


def functional_of(text_or_path: str, listener: Listener | None = None) -> FunctionalScenario:
    """The functional scenario that an argument names or tells."""
    from scegen.pipeline.source import resolve_source
    from scegen.scenario.functional import FunctionalScenario

    source = resolve_source(text_or_path, listener) if listener else resolve_source(text_or_path)
    if not isinstance(source, FunctionalScenario):
        raise InputError(
            f"is a {source.level} scenario, not a description or a functional one",
            where=text_or_path,
            hint="name the functional.yaml from which it was made",
        )
    return source
