"""The nouns that participants are called by."""

from __future__ import annotations

from scegen.understanding.chunks import Mention
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token


def called(mention: Mention, tokens: list[Token]) -> set[str]:
    """The nouns of a mention that say more than "vehicle" or "person".

    Args:
        mention: a mention with nouns.
        tokens: the tokens of the text.
    """
    nouns = {_word(head, tokens) for head in mention.heads}
    brands = {f"brand:{_word(h, tokens)}" for h in mention.heads if h.data.get("brand")}
    return (nouns | brands) - word_list("everybody")


def _word(head: Term, tokens: list[Token]) -> str:
    return " ".join(tokens[k].forms[-1][0] for k in range(head.i, head.j))
