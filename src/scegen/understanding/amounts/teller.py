"""What those who read amounts have in common."""

from __future__ import annotations

from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.happenings import Happenings
from scegen.understanding.semantics.context import Context


class Teller:
    """Reads a part of what a text tells of.

    Args:
        text: the text with its clauses.
        context: the scenario in the making.
        happenings: what the text tells of; what is read is added.
    """

    def __init__(self, text: Sentences, context: Context, happenings: Happenings) -> None:
        self._text = text
        self._context = context
        self._happenings = happenings
