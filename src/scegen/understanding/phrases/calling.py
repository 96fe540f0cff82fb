"""The nouns that participants are called by, and which of them tell participants apart."""

from __future__ import annotations

from scegen.understanding.chunks import Mention
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_BODIES = (
    "body_sedan",
    "body_suv",
    "body_hatchback",
    "body_taxi",
    "body_coupe",
    "body_estate",
    "body_minivan",
    "body_limousine",
)
"""Lists of words for cars that are not each other."""


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


def contradict(known: set[str], said: set[str]) -> bool:
    """``the sedan`` is not the SUV, ``the Honda`` is not the Ford.

    Args:
        known: nouns by which somebody has been called.
        said: nouns of a further mention.
    """
    brands = [{n for n in nouns if n.startswith("brand:")} for nouns in (known, said)]
    if brands[0] and brands[1] and not brands[0] & brands[1]:
        return True
    bodies = [
        {k for k, body in enumerate(_BODIES) if word_list(body) & nouns} for nouns in (known, said)
    ]
    return bool(bodies[0] and bodies[1]) and not bodies[0] & bodies[1]
