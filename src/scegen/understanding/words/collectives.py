"""Nouns that only gather others: "a steady stream of cars", "the flow of traffic"."""

from __future__ import annotations

from dataclasses import replace

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_DESCRIBING = frozenset({"unknown", "inert", "label", "manner", "noted", "state", "verb"})
_TOLD = frozenset({"manner", "state", "verb", "noted"})
_MOST_ADJECTIVES = 3
_OPENERS = frozenset({"det", "possessive"})


def gather(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """The terms with such a noun and its "of" made part of the words before the noun after it."""
    found: list[Term] = []
    k = 0
    while k < len(terms):
        merged = _gathered(terms, k, tokens)
        if merged is None:
            found.append(terms[k])
            k += 1
            continue
        described: list[Term] = []
        while found and _adjective(found[-1]) and _opened(found):
            described.insert(0, found.pop())
        opener = found.pop() if found and found[-1].cat in _OPENERS else None
        start = opener.i if opener is not None else terms[k].i
        definite = opener is not None and (opener.cat == "possessive" or opener.value == "def")
        if terms[k + 2].cat == "num":  # "a jam of six cars" tells what the six do
            if terms[k].data.get("stands") and _stands(terms[k + 2 :]):
                found.append(Term("state", "stationary", start, merged))
            k += 2
            continue
        kind = ("det", "def") if definite else ("quant", "vague")
        told = [t for t in described if t.cat in _TOLD]  # "a slow convoy of lorries" is slow
        found.append(Term(*kind, start, told[0].i if told else merged))
        found += told[:-1] + ([replace(told[-1], j=merged)] if told else [])
        k += 2
    return found


def _gathered(terms: list[Term], k: int, tokens: list[Token]) -> int | None:
    """Where the words end that only gather; None if the term does nothing of the kind."""
    term = terms[k]
    if k + 2 >= len(terms) or terms[k + 1].value != "of" or term.cat in {"verb", "quant"}:
        return None
    following = terms[k + 2 : k + 2 + _MOST_ADJECTIVES]
    noun = tokens[term.i].base in word_list("gathering") and term.j - term.i == 1
    jam = term.data.get("stands") or (following[0].cat == "num" and "mass" in term.data)
    if not (noun or jam):
        return None
    for after in following:
        if after.cat == "actor":
            return terms[k + 1].j
        if after.cat not in {*_DESCRIBING, "dir", "quant", *(["num"] if jam else [])}:
            return None
    return None


def _stands(after: list[Term]) -> bool:
    """Whether the next verb lets a jam stand: "a jam of six cars crawls" does not."""
    verb = next((t for t in after if t.cat in {"verb", "punct"}), None)
    return verb is None or verb.value not in {"crawl", "move", "slow"}


def _adjective(term: Term) -> bool:
    """A participle may be one, no verb of a clause."""
    return term.cat in _DESCRIBING and (term.cat != "verb" or term.premod or term.form == "ing")


def _opened(found: list[Term]) -> bool:
    """Whether an article stands before the adjectives at the end."""
    before = (t for t in reversed(found[-1 - _MOST_ADJECTIVES :]) if t.cat not in _DESCRIBING)
    opener = next(before, None)
    return opener is not None and opener.cat in _OPENERS
