"""Phrases around a name: "sits on the lead car's bumper" is "sits on its bumper", of whom it says.

The lexicon has such phrases with a gap for a possessive word. Where a name stands in the gap, the
verb ends before it and the name is its object.
"""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token

_FARTHEST = 8
GENITIVES = frozenset({"'s", "'"})


def around_somebody(tokens: list[Token], term: Term) -> tuple[Term, int, int] | None:
    """The verb before a name, and from where to where the phrase goes on behind the name.

    Args:
        tokens: of the text.
        term: the word as it reads alone.
    """
    if term.cat not in {"verb", "prep", "locus", "unknown"}:
        return None
    for end in range(term.i + 2, min(term.i + _FARTHEST, len(tokens))):
        if tokens[end].kind == "punct":
            return None
        if tokens[end].low in GENITIVES:
            break
    else:
        return None
    its = replace(tokens[end], text="its", low="its", kind="word", forms=(("its", "base"),))
    owned = longest_match(tokens, end + 1) if end + 1 < len(tokens) else None
    if owned is None or (owned.has("place") and owned.get("place").value != "flank"):
        return None  # "leaves the van's lane" reads as it stands
    for opening in range(term.i + 1, end - 1):
        if tokens[opening].low not in word_list("whose"):
            continue
        match = longest_match([*tokens[:opening], its, *tokens[end + 1 :]], term.i)
        if match is not None and match.j > opening + 1 and match.has("verb"):
            entry = match.get("verb")
            verb = Term("verb", entry.value, term.i, opening, match.form, entry.data)
            return verb, end, match.j + end - opening
    return None
